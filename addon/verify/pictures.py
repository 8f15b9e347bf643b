"""Pictures for the report as PNG files within the page, written with numpy and zlib alone."""

import base64
import struct
import zlib

import numpy as np

__all__ = ["png", "strip", "data_url"]

HEIGHT = 96
GAP = 4


def strip(picture):
    """Reference, render and difference of a :class:`addon.verify.checks.Picture` side by side, 8 bits sRGB.

    Brightness is scaled alike for reference and render, so that the brightest
    hundredth of the reference is white; the difference is enlarged by its factor.
    """
    white = max(float(np.quantile(picture.reference.max(axis=-1), 0.99)), 1e-6)
    difference = np.abs(picture.render - picture.reference) * picture.times
    parts = [_enlarged(_srgb(part / white)) for part in (picture.reference, picture.render, difference)]
    # Wide pictures, rows of tiles, stand above each other, and square ones side by side.
    axis = 0 if parts[0].shape[1] > 2 * parts[0].shape[0] else 1
    shape = list(parts[0].shape)
    shape[axis] = GAP
    gap = np.full(shape, 255, np.uint8)
    return np.concatenate([parts[0], gap, parts[1], gap, parts[2]], axis=axis)


def png(pixels):
    """The bytes of a PNG file of (rows from the top, columns, 3) of uint8.

    >>> png(np.zeros((2, 2, 3), np.uint8))[:4]
    b'\\x89PNG'
    """
    height, width, _ = pixels.shape
    rows = b"".join(b"\0" + row.tobytes() for row in np.ascontiguousarray(pixels))
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(rows, 9)), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        for kind, data in chunks)


def data_url(pixels):
    """The picture as the address of an image within the page.

    >>> data_url(np.zeros((1, 1, 3), np.uint8))[:22]
    'data:image/png;base64,'
    """
    return "data:image/png;base64," + base64.b64encode(png(pixels)).decode("ascii")


def _srgb(linear):
    linear = np.clip(np.nan_to_num(linear), 0.0, 1.0)
    encoded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1.0 / 2.4) - 0.055)
    return (encoded[::-1] * 255.0 + 0.5).astype(np.uint8)


def _enlarged(pixels):
    """Whole multiples, so that pixels stay square and sharp; rows of tiles get a quarter of the height."""
    tall = HEIGHT // 4 if pixels.shape[1] > 2 * pixels.shape[0] else HEIGHT
    times = max(1, round(tall / pixels.shape[0]))
    return pixels.repeat(times, axis=0).repeat(times, axis=1)
