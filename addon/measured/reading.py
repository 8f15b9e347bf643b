"""Which reader a file is for."""

from pathlib import Path

from ..errors import FacetFilmError
from . import tensor_file
from .merl import looks_like_merl, read_merl
from .points import read_points
from .rgl import read_rgl

__all__ = ["SUFFIXES", "read_brdf", "read_brdf_bytes"]

SUFFIXES = (".bsdf", ".binary", ".txt", ".csv", ".dat", ".brdf")
"""Endings of files that hold measured BRDFs, for file choosers."""
LFS = b"version https://git-lfs"
PAGES = (b"<!doctype", b"<html", b"<?xml", b"<head")
LARGEST = 1 << 29


def read_brdf(path):
    """The Measurement in a file, by what it holds and not by its ending.

    Raises FacetFilmError, one sentence, for a file that is not there or cannot be used.
    """
    file = Path(path)
    try:
        if file.stat().st_size > LARGEST:
            raise FacetFilmError("{file!r} is larger than half a gigabyte, which no measured BRDF is.", file=file.name)
        data = file.read_bytes()
    except OSError:
        raise FacetFilmError("The file {file!r} cannot be read.", file=str(path)) from None
    return read_brdf_bytes(data, file.name)


def read_brdf_bytes(data, name):
    """The Measurement in a file's bytes; `name` is what errors call it."""
    head = data[:512].lstrip().lower()
    if head.startswith(LFS):
        raise FacetFilmError("{file!r} is a Git LFS pointer, not the file itself: fetch it with git lfs pull.",
                             file=name)
    if head.startswith(PAGES):
        raise FacetFilmError("{file!r} is a web page, not a measurement: download the file that it links to.",
                             file=name)
    if data.startswith(tensor_file.MAGIC):
        return read_rgl(data, name)
    if name.lower().endswith(".bsdf") and b"\0" in data or tensor_file.MAGIC.startswith(data[:12]):
        raise FacetFilmError("{file!r} is damaged or ends too early: download it again.", file=name)
    if b"\0" in data[:4096] and looks_like_merl(data):
        return read_merl(data, name)
    return read_points(_text(data), name)


def _text(data):
    """The text of a file; "" where it is none."""
    for encoding in ("utf-8-sig", "utf-16"):
        try:
            text = data.decode(encoding)
        except UnicodeDecodeError:
            continue
        if "\0" not in text:
            return text
    return ""
