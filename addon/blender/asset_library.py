"""The asset library: offered by a button that adds it to the preferences, and taken off when the extension goes."""

from pathlib import Path

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from . import compat

__all__ = ["CLASSES", "FOLDERS", "NAME", "ROOT", "detach", "folder", "ours"]

NAME = "Facet & Film"
ROOT = Path(__file__).parents[2] / "node_groups"
FOLDERS = {"blender_4.5": "blender-4.5", "blender_5.0": "exact"}
"""Folder -> the conductor Fresnel that its materials are fitted for, as tools/build_assets.py made them."""


def folder():
    """The library for this Blender."""
    formula = compat.conductor_formula()
    return ROOT / next(name for name, fitted_for in FOLDERS.items() if fitted_for == formula)


def ours():
    """The entries of the preferences that point into this extension."""
    libraries = bpy.context.preferences.filepaths.asset_libraries
    return [library for library in libraries if library.path and ROOT in Path(bpy.path.abspath(library.path)).parents]


def detach():
    """Take the library off the preferences again."""
    for library in ours():
        bpy.context.preferences.filepaths.asset_libraries.remove(library)
        bpy.context.preferences.is_dirty = True


class FACET_FILM_OT_add_asset_library(bpy.types.Operator):
    """Add the materials and node groups to the Asset Browser, as a library in Preferences, File Paths"""

    bl_idname = "facet_film.add_asset_library"
    bl_label = "Add Asset Library"

    @classmethod
    def poll(cls, _context):
        """Off where it is there already."""
        if ours():
            cls.poll_message_set(rpt_("The library is in Preferences, File Paths already"))
            return False
        return True

    def execute(self, context):
        """Point the preferences at the folder that came with the extension."""
        context.preferences.filepaths.asset_libraries.new(name=NAME, directory=str(folder()))
        context.preferences.is_dirty = True
        self.report({"INFO"}, rpt_("Open an Asset Browser and choose the library {:s}: drag a material onto an object").format(NAME))
        return {"FINISHED"}


class FACET_FILM_OT_remove_asset_library(bpy.types.Operator):
    """Take the library off the Asset Browser again; what was dragged from it stays"""

    bl_idname = "facet_film.remove_asset_library"
    bl_label = "Remove Asset Library"

    @classmethod
    def poll(cls, _context):
        """Off where it is not there."""
        if not ours():
            cls.poll_message_set(rpt_("The library is not in the preferences"))
            return False
        return True

    def execute(self, _context):
        """Take off every entry that points into this extension."""
        detach()
        self.report({"INFO"}, rpt_("The library {:s} is no longer in the preferences").format(NAME))
        return {"FINISHED"}


class FACET_FILM_PT_asset_library(bpy.types.Panel):
    """The materials and node groups as assets to drag"""

    bl_label = "Asset Library"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"
    bl_parent_id = "FACET_FILM_PT_material"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, _context):
        """One button: add, or remove."""
        if ours():
            self.layout.label(text="In the Asset Browser as Facet & Film", icon="ASSET_MANAGER")
            self.layout.operator("facet_film.remove_asset_library", icon="REMOVE")
        else:
            self.layout.operator("facet_film.add_asset_library", icon="ASSET_MANAGER")


CLASSES = (FACET_FILM_OT_add_asset_library, FACET_FILM_OT_remove_asset_library, FACET_FILM_PT_asset_library)
