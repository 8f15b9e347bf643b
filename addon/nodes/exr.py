"""A picture as the bytes of an OpenEXR file in half precision, compressed without loss, as files keep films' tables.

Blender packs what it made itself in single precision and uncompressed, six times as much.  The format: ASWF, OpenEXR
File Layout (openexr.com), scan lines in blocks of 16 with ZIP compression.
"""

import struct
import zlib

import numpy as np

__all__ = ["exr_bytes"]

LINES = 16
MAGIC_AND_VERSION = b"\x76\x2f\x31\x01\x02\x00\x00\x00"
HALF, ZIP, INCREASING = 1, 3, 0


def exr_bytes(pixels):
    """The file of a picture, ``(rows from the bottom, columns, 3 or more)``; what is beyond blue is left out.

    >>> len(exr_bytes(np.zeros((4, 4, 3)))) < 400
    True
    """
    picture = np.asarray(pixels, float)[::-1, :, 2::-1].astype("<f2")  # from the top; channels by the alphabet: B, G, R
    rows, columns = picture.shape[:2]
    blocks = [_block(picture, start) for start in range(0, rows, LINES)]
    head = _head(rows, columns)
    place, offsets = len(head) + 8 * len(blocks), []
    for block in blocks:
        offsets.append(place)
        place += len(block)
    return b"".join([head, struct.pack(f"<{len(offsets)}Q", *offsets), *blocks])


def _block(picture, start):
    """Sixteen scan lines, channel by channel in each, compressed."""
    lines = picture[start:start + LINES]
    raw = np.frombuffer(np.ascontiguousarray(np.moveaxis(lines, 2, 1)).tobytes(), np.uint8)
    halves = np.concatenate([raw[::2], raw[1::2]])
    differences = halves.copy()
    differences[1:] = halves[1:] - halves[:-1] + np.uint8(128)
    packed = zlib.compress(differences.tobytes(), 6)  # a fiftieth larger than by 9, in a fifth of its time
    data = packed if len(packed) < raw.size else raw.tobytes()
    return struct.pack("<ii", start, len(data)) + data


def _head(rows, columns):
    channels = b"".join(name + b"\0" + struct.pack("<iB3xii", HALF, 0, 1, 1) for name in (b"B", b"G", b"R")) + b"\0"
    window = struct.pack("<4i", 0, 0, columns - 1, rows - 1)
    attributes = (("channels", "chlist", channels), ("compression", "compression", bytes([ZIP])),
                  ("dataWindow", "box2i", window), ("displayWindow", "box2i", window),
                  ("lineOrder", "lineOrder", bytes([INCREASING])),
                  ("pixelAspectRatio", "float", struct.pack("<f", 1.0)),
                  ("screenWindowCenter", "v2f", struct.pack("<ff", 0.0, 0.0)),
                  ("screenWindowWidth", "float", struct.pack("<f", 1.0)))
    written = (f"{name}\0{kind}\0".encode() + struct.pack("<i", len(value)) + value for name, kind, value in attributes)
    return MAGIC_AND_VERSION + b"".join(written) + b"\0"
