"""The container of the RGL-EPFL database: named arrays in one file, little endian.

"tensor_file" and a zero, two bytes of the version, the number of fields; of
each field its name, the number of its axes, the type, where its values begin,
and the length of each axis.
"""

import struct

import numpy as np

from ..errors import FacetFilmError

__all__ = ["MAGIC", "fields_of", "tensor_bytes"]

MAGIC = b"tensor_file\0"
TYPES = {1: "<u1", 2: "<i1", 3: "<u2", 4: "<i2", 5: "<u4", 6: "<i4", 7: "<u8", 8: "<i8", 9: "<f2", 10: "<f4",
         11: "<f8"}
MOST_AXES = 16


def fields_of(data, name):
    """{field: array} of a tensor file's bytes.

    name  what errors call the file

    Raises FacetFilmError for a file that ends too early or whose header makes no sense.

    >>> fields_of(tensor_bytes({"a": np.arange(6, dtype="<f4").reshape(2, 3)}), "x")["a"].shape
    (2, 3)
    """
    try:
        return dict(_fields(data))
    except (struct.error, UnicodeDecodeError, KeyError, ValueError, OverflowError):
        raise FacetFilmError("{file!r} is damaged or ends too early: download it again.", file=name) from None


def _fields(data):
    _, _, count = struct.unpack_from("<BBI", data, len(MAGIC))
    at = len(MAGIC) + 6
    for _ in range(count):
        (length,) = struct.unpack_from("<H", data, at)
        name = bytes(data[at + 2:at + 2 + length]).decode("utf-8")
        axes, kind, start = struct.unpack_from("<HBQ", data, at + 2 + length)
        if axes > MOST_AXES:
            raise ValueError
        at += 2 + length + 11
        shape = struct.unpack_from(f"<{axes}Q", data, at)
        at += 8 * axes
        size = 1
        for side in shape:
            size *= side
        yield name, np.frombuffer(data, TYPES[kind], size, start).reshape(shape)


def tensor_bytes(fields):
    """The bytes of a tensor file that holds {name: array}."""
    kinds = {np.dtype(kind): number for number, kind in TYPES.items()}
    head = sum(2 + len(name.encode()) + 11 + 8 * value.ndim for name, value in fields.items())
    start = len(MAGIC) + 6 + head
    header, body = [MAGIC, struct.pack("<BBI", 1, 0, len(fields))], []
    for name, value in fields.items():
        raw = np.ascontiguousarray(value).tobytes()
        encoded = name.encode()
        header += [struct.pack("<H", len(encoded)), encoded,
                   struct.pack("<HBQ", value.ndim, kinds[value.dtype], start), struct.pack(f"<{value.ndim}Q",
                                                                                          *value.shape)]
        body.append(raw)
        start += len(raw)
    return b"".join(header + body)
