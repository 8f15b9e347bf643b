"""Reads the packed tables that ``tools/build_tables.py`` writes.

A table is a zip archive of ``about.json`` (source, version, licence, tool),
``index.json`` (what the numbers are) and ``values.f4``: little-endian single
precision numbers, stored as four planes of bytes, which deflate far better
than the numbers themselves.
"""

import functools
import json
import pathlib
import zipfile

import numpy as np

__all__ = ["read", "pack", "DIRECTORY"]

DIRECTORY = pathlib.Path(__file__).parent / "data"
DATE = (1980, 1, 1, 0, 0, 0)  # the same in every build, for the same bytes


@functools.lru_cache(maxsize=None)
def read(name):
    """(about, index, values) of the table with this name: a dict, JSON data, a float32 array ``(N,)``.

    Read on first use, then kept.

    >>> about, index, values = read("cie")
    >>> values.dtype.name, about["licence"]
    ('float32', 'BSD-3-Clause')
    """
    with zipfile.ZipFile(DIRECTORY / f"{name}.table") as archive:
        about, index = (json.loads(archive.read(part)) for part in ("about.json", "index.json"))
        planes = np.frombuffer(archive.read("values.f4"), np.uint8).reshape(4, -1)
    return about, index, np.ascontiguousarray(planes.T).view("<f4").ravel()


def pack(path, about, index, values):
    """Write a table; the same content gives the same bytes."""
    planes = np.asarray(values, "<f4").reshape(-1, 1).view(np.uint8).T
    parts = {"about.json": _text(about, 1), "index.json": _text(index, None), "values.f4": planes.tobytes()}
    with zipfile.ZipFile(path, "w") as archive:
        for part, content in parts.items():
            entry = zipfile.ZipInfo(part, DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.create_system = 3  # the same on every system
            archive.writestr(entry, content, zipfile.ZIP_DEFLATED, 9)


def _text(content, indent):
    separators = None if indent else (",", ":")
    return json.dumps(content, ensure_ascii=False, indent=indent, separators=separators).encode()
