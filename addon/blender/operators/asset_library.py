"""The operators that add the asset library to the preferences, and take it off."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from .. import assets

__all__ = ["CLASSES"]


class FACET_FILM_OT_add_asset_library(bpy.types.Operator):
    """Add the materials and node groups to the Asset Browser, as a library of your preferences"""

    bl_idname = "facet_film.add_asset_library"
    bl_label = "Add Asset Library"

    @classmethod
    def poll(cls, _context):
        """Off where it is there already."""
        if assets.library.is_shown():
            cls.poll_message_set(rpt_("The library is in your preferences already"))
            return False
        return True

    def execute(self, _context):
        """Point the preferences at the folder that came with the extension."""
        assets.library.add()
        said = rpt_("Open an Asset Browser and choose the library {:s}: drag a material onto an object")
        self.report({"INFO"}, said.format(assets.library.NAME))
        return {"FINISHED"}


class FACET_FILM_OT_remove_asset_library(bpy.types.Operator):
    """Take the library off the Asset Browser again, and with it the pictures to choose from; materials stay"""

    bl_idname = "facet_film.remove_asset_library"
    bl_label = "Remove Asset Library"

    @classmethod
    def poll(cls, _context):
        """Off where it is not there."""
        if not assets.library.is_shown():
            cls.poll_message_set(rpt_("The library is not in the preferences"))
            return False
        return True

    def execute(self, _context):
        """Take off or switch off every entry that points into this extension."""
        assets.library.remove()
        self.report({"INFO"}, rpt_("The library {:s} is no longer shown").format(assets.library.NAME))
        return {"FINISHED"}


CLASSES = (FACET_FILM_OT_add_asset_library, FACET_FILM_OT_remove_asset_library)
