"""The asset library in the preferences: added by the first click on the picker, and taken off on request."""

import os
from pathlib import Path

import bpy

from .. import compat

__all__ = ["FILE", "FOLDER", "NAME", "OURS", "add", "detach", "is_shown", "ours", "remove"]

NAME = "Facet & Film"
FOLDER = Path(__file__).parents[3] / "node_groups" / "assets"
FILE = FOLDER / "facet_film_assets.blend"
"""Every preset and node group, as tools/build_assets.py makes it: n and k are for the exact conductor Fresnel."""
OURS = str(FILE)
"""What the full path of each asset of ours begins with."""


def _plain(path):
    return os.path.normcase(os.path.normpath(path))


_INSIDE = os.path.join(_plain(FOLDER.parent), "")


def ours():
    """The entries of the preferences that point into this extension."""
    libraries = bpy.context.preferences.filepaths.asset_libraries
    return [library for library in libraries
            if _plain(bpy.path.abspath(library.path)).startswith(_INSIDE)]


def is_shown():
    """Whether the library is among those that Blender shows."""
    return any(compat.is_enabled(library) for library in ours())


def add():
    """Have Blender show the library, and bring in what is dragged from it as materials of the file; whether that
    changed the preferences.
    """
    if is_shown():
        return False
    libraries = bpy.context.preferences.filepaths.asset_libraries
    library = next(iter(ours()), None) or libraries.new(name=NAME, directory=str(FOLDER))
    library.import_method = "APPEND"
    library.use_relative_path = False
    compat.enable(library, True)
    bpy.context.preferences.is_dirty = True
    return True


def remove():
    """Have Blender show it no more.

    Blender 5.1 and later switch an entry off; taken out and added again in one session, 5.2 would show nothing of it.
    """
    for library in ours():
        if not compat.enable(library, False):
            bpy.context.preferences.filepaths.asset_libraries.remove(library)
        bpy.context.preferences.is_dirty = True


def detach():
    """The extension goes: so does what it shows."""
    if is_shown():
        remove()
