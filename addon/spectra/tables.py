"""Reads the packed tables that ``tools/build_tables.py`` writes.

A table is a zip archive of ``about.json`` (source, version, licence, tool); of
the parts of its index, what the numbers are: ``NAME/0.jsonl`` and so on hold a
list with one JSON value a line, ``NAME.json`` anything else; and of
``values/0.f4`` and so on: little-endian single precision numbers, stored as
four planes of bytes, which deflate far better than the numbers themselves.  So
one record is read without unpacking the others.
"""

import functools
import io
import json
import pathlib
import zipfile

import numpy as np

__all__ = ["read", "about", "lines", "line", "part", "numbers", "pack", "DIRECTORY"]

DIRECTORY = pathlib.Path(__file__).parent / "data"
DATE = (1980, 1, 1, 0, 0, 0)  # the same in every build, for the same bytes
PAGE = 1 << 8
"""Values in a file of a list."""
CHUNK = 1 << 13
"""Numbers in a file of values."""


@functools.cache
def read(name):
    """(about, index, values) of the table with this name: a dict, a dict of its parts, a float32 array ``(N,)``.

    All of it, which takes a while.  Read on first use, then kept.

    >>> about, index, values = read("cie")
    >>> values.dtype.name, about["licence"]
    ('float32', 'BSD-3-Clause')
    """
    members = _archive(name).namelist()
    lists = dict.fromkeys(member.partition("/")[0] for member in members if member.endswith(".jsonl"))
    index = {found: [json.loads(line) for line in lines(name, found)] for found in lists}
    index |= {member.removesuffix(".json"): part(name, member.removesuffix(".json"))
              for member in members if member.endswith(".json") and member != "about.json"}
    chunks = [_chunk(name, number) for number in range(sum(member.endswith(".f4") for member in members))]
    return about(name), index, np.concatenate(chunks) if chunks else np.empty(0, "<f4")


def about(name):
    """Where a table is from: title, source, version, licence, tool."""
    return part(name, "about")


@functools.cache
def lines(name, part_name):
    """A list of a table's index, each value as JSON text."""
    count = sum(member.startswith(f"{part_name}/") for member in _archive(name).namelist())
    return tuple(line for number in range(count) for line in _page(name, part_name, number))


def line(name, part_name, number):
    """One value of a list of a table's index, unpacking no more than it takes.

    >>> line("cie", "observers", 1)
    '1964'
    """
    return json.loads(_page(name, part_name, number // PAGE)[number % PAGE])


@functools.cache
def _page(name, part_name, number):
    return _archive(name).read(f"{part_name}/{number}.jsonl").decode().split("\n")


@functools.cache
def part(name, part_name):
    """A part of a table's index that is no list."""
    return json.loads(_archive(name).read(f"{part_name}.json"))


def numbers(name, place, count):
    """Some of a table's numbers, float32 ``(count,)``, unpacking no more than it takes.

    >>> bool((numbers("cie", 5, 3) == read("cie")[2][5:8]).all())
    True
    """
    first = place // CHUNK
    chunks = [_chunk(name, number) for number in range(first, (place + count - 1) // CHUNK + 1)]
    found = chunks[0] if len(chunks) == 1 else np.concatenate(chunks)
    return found[place - first * CHUNK:place - first * CHUNK + count]


@functools.cache
def _archive(name):
    # Of a copy: an open file could not be replaced on Windows when the extension is updated.
    return zipfile.ZipFile(io.BytesIO((DIRECTORY / f"{name}.table").read_bytes()))


@functools.cache
def _chunk(name, number):
    planes = np.frombuffer(_archive(name).read(f"values/{number}.f4"), np.uint8).reshape(4, -1)
    return np.ascontiguousarray(planes.T).view("<f4").ravel()


def pack(path, about, index, values=()):
    """Write a table; the same content gives the same bytes."""
    members = {"about.json": _text(about, 1)}
    for name, content in index.items():
        if isinstance(content, list):
            for number, start in enumerate(range(0, len(content), PAGE)):
                members[f"{name}/{number}.jsonl"] = b"\n".join(map(_text, content[start:start + PAGE]))
        else:
            members[f"{name}.json"] = _text(content)
    values = np.asarray(values, "<f4")
    for number, start in enumerate(range(0, len(values), CHUNK)):
        planes = values[start:start + CHUNK].reshape(-1, 1).view(np.uint8).T
        members[f"values/{number}.f4"] = planes.tobytes()
    with zipfile.ZipFile(path, "w") as archive:
        for member, content in members.items():
            entry = zipfile.ZipInfo(member, DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.create_system = 3  # the same on every system
            archive.writestr(entry, content, zipfile.ZIP_DEFLATED, 9)


def _text(content, indent=None):
    separators = None if indent else (",", ":")
    return json.dumps(content, ensure_ascii=False, indent=indent, separators=separators).encode()
