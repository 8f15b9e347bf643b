"""Linear Rec.709 as screens have it, sRGB, and back: IEC 61966-2-1."""

import numpy as np

__all__ = ["bytes_of", "decoded", "encoded", "hex_of"]


def encoded(linear):
    """sRGB in [0, 1] of linear Rec.709 ``(...)``, which is clipped to [0, 1] before.

    >>> encoded([0.0, 0.002, 0.5, 2.0]).round(4).tolist()
    [0.0, 0.0258, 0.7354, 1.0]
    """
    x = np.clip(np.nan_to_num(linear), 0.0, 1.0)
    return np.where(x <= 0.0031308, 12.92 * x, 1.055 * x ** (1.0 / 2.4) - 0.055)


def decoded(srgb):
    """Linear Rec.709 of sRGB ``(...)`` in [0, 1].

    >>> decoded([0.0, 0.0258, 0.7354, 1.0]).round(3).tolist()
    [0.0, 0.002, 0.5, 1.0]
    """
    x = np.asarray(srgb, float)
    return np.where(x <= 0.04045, x / 12.92, ((x + 0.055) / 1.055) ** 2.4)


def bytes_of(linear):
    """The same in whole numbers from 0 to 255, ``(...)`` of uint8.

    >>> bytes_of([0.0, 0.5, 2.0]).tolist()
    [0, 188, 255]
    """
    return np.round(255.0 * encoded(linear)).astype(np.uint8)


def hex_of(linear):
    """#rrggbb of linear Rec.709 ``(3,)``.

    >>> hex_of((1.0, 0.5, 0.0))
    '#ffbc00'
    """
    return "#" + bytes_of(linear).tobytes().hex()
