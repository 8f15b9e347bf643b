"""Writes files whole or not at all."""

import os
import shutil

from ..errors import FacetFilmError

__all__ = ["write_bytes", "write_text"]


def write_text(path, content):
    """Write UTF-8 text as :func:`write_bytes` writes."""
    return write_bytes(path, content.encode("utf-8"))


def write_bytes(path, content):
    """Write bytes: into a new file beside the target, which then takes the target's name.

    path     of the file; one that exists is replaced

    Returns the path as text.  Raises FacetFilmError where the folder does not
    exist or may not be written to, and for what is no ordinary file; the
    target is then as it was.
    """
    target = _target(path)
    folder, name = os.path.split(target)
    aside = os.path.join(folder, f".{name[:40]}.{os.getpid()}.part")
    try:
        with open(aside, "xb") as file:
            file.write(content)
        if os.path.exists(target):
            shutil.copymode(target, aside)
        os.replace(aside, target)
    except FileExistsError:
        raise FacetFilmError("{file!r} is being written already; remove {aside!r} if it is not.",
                             file=target, aside=aside) from None
    except OSError as error:
        if os.path.exists(aside):
            os.remove(aside)
        why = (error.strerror or "an unknown reason").lower()
        raise FacetFilmError("{file!r} cannot be written: {why}; name another place.", file=target, why=why) from None
    return os.fspath(path)


def _target(path):
    """The absolute path, links followed, of a file that may be written."""
    try:
        given = os.fspath(path)
        target = os.path.realpath(given)
    except (TypeError, ValueError):
        given = target = ""
    if not given or not isinstance(given, str):
        raise FacetFilmError("A file to write is named by its path, not by {path!r}.", path=path)
    if os.path.isdir(target):
        raise FacetFilmError("{file!r} is a folder; name a file in it.", file=given)
    if not os.path.isdir(os.path.dirname(target)):
        raise FacetFilmError("The folder of {file!r} does not exist; make it first, or name another.", file=given)
    if os.path.exists(target) and not (os.path.isfile(target) and os.access(target, os.W_OK)):
        raise FacetFilmError("{file!r} is protected or no ordinary file; name another.", file=given)
    return target
