"""Stamps: what a built product was made of, so that it is built again when any of it has changed, and only then.

A stamp names every source with its hash, and the Blender that built.  The sources are the modules of the extension that
building loaded, whatever they are, and the data that it read.
"""

import hashlib
import json
import sys
from importlib.metadata import version
from pathlib import Path

__all__ = ["blender", "is_current", "loaded_sources", "write"]

ROOT = Path(__file__).resolve().parents[1]


def blender():
    """The Blender of this environment as [major, minor]; without loading it."""
    return [int(part) for part in version("bpy").split(".")[:2]]


def loaded_sources():
    """The files of all modules of the extension and its tools that are loaded."""
    files = {Path(module.__file__) for name, module in list(sys.modules.items())
             if name.partition(".")[0] in ("addon", "tools") and getattr(module, "__file__", None)}
    return {file for file in files if file.is_relative_to(ROOT)}


def write(stamp, sources):
    """Write a stamp of these files.

    stamp    path of the JSON file
    sources  paths inside the checkout
    """
    found = {file.relative_to(ROOT).as_posix(): _hash(file) for file in sources}
    text = json.dumps({"blender": blender(), "sources": dict(sorted(found.items()))}, indent=1) + "\n"
    stamp.write_text(text, encoding="utf-8")


def is_current(stamp):
    """Whether what is stamped is made of the sources as they are, by a Blender no newer than this one."""
    try:
        held = json.loads(stamp.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return False
    same = all(_hash(ROOT / name) == kept for name, kept in held["sources"].items())
    return same and held["blender"] <= blender()


def _hash(file):
    return hashlib.sha256(file.read_bytes()).hexdigest() if file.is_file() else ""
