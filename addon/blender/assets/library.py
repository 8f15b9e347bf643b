"""The asset library in the preferences: added by a button, and taken off when the extension goes."""

from pathlib import Path

import bpy

__all__ = ["FILE", "FOLDER", "NAME", "detach", "ours"]

NAME = "Facet & Film"
FOLDER = Path(__file__).parents[3] / "node_groups" / "assets"
FILE = FOLDER / "facet_film_assets.blend"
"""Every preset and node group, as tools/build_assets.py makes it: n and k are for the exact conductor Fresnel."""


def ours():
    """The entries of the preferences that point into this extension."""
    libraries = bpy.context.preferences.filepaths.asset_libraries
    return [library for library in libraries
            if library.path and FOLDER.parent in Path(bpy.path.abspath(library.path)).parents]


def detach():
    """Take the library off the preferences again."""
    for library in ours():
        bpy.context.preferences.filepaths.asset_libraries.remove(library)
        bpy.context.preferences.is_dirty = True
