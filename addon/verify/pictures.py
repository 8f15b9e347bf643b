"""Pictures for the report as PNG files within the page, written with numpy and zlib alone."""

import base64

import numpy as np

from ..bake.srgb import bytes_of
from ..export.png import png

__all__ = ["data_url", "strip"]

HEIGHT = 96
GAP = 4


def strip(picture):
    """Reference, render and difference of a :class:`addon.verify.checks.Picture` side by side, 8 bits sRGB.

    Brightness is scaled alike for reference and render, so that the brightest
    hundredth of the reference is white; the difference is enlarged by its factor.
    """
    white = max(float(np.quantile(picture.reference.max(axis=-1), 0.99)), 1e-6)
    difference = np.abs(picture.render - picture.reference) * picture.times
    parts = [_enlarged(bytes_of(part[::-1] / white)) for part in (picture.reference, picture.render, difference)]
    # Wide pictures, rows of tiles, stand above each other, and square ones side by side.
    axis = 0 if parts[0].shape[1] > 2 * parts[0].shape[0] else 1
    shape = list(parts[0].shape)
    shape[axis] = GAP
    gap = np.full(shape, 255, np.uint8)
    return np.concatenate([parts[0], gap, parts[1], gap, parts[2]], axis=axis)


def data_url(pixels):
    """The picture as the address of an image within the page.

    >>> data_url(np.zeros((1, 1, 3), np.uint8))[:22]
    'data:image/png;base64,'
    """
    return "data:image/png;base64," + base64.b64encode(png(pixels)).decode("ascii")


def _enlarged(pixels):
    """Whole multiples, so that pixels stay square and sharp; rows of tiles get a quarter of the height."""
    tall = HEIGHT // 4 if pixels.shape[1] > 2 * pixels.shape[0] else HEIGHT
    times = max(1, round(tall / pixels.shape[0]))
    return pixels.repeat(times, axis=0).repeat(times, axis=1)
