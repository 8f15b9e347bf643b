"""Pictures as PNG files, written with numpy and zlib alone."""

import struct
import zlib

import numpy as np

__all__ = ["png", "srgb"]


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


def srgb(linear):
    """Linear RGB as the 8 bits of sRGB, ``(...)`` uint8.

    >>> srgb(np.array([0.0, 0.5, 2.0])).tolist()
    [0, 188, 255]
    """
    linear = np.clip(np.nan_to_num(linear), 0.0, 1.0)
    encoded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1.0 / 2.4) - 0.055)
    return (encoded * 255.0 + 0.5).astype(np.uint8)
