"""The operators that open the catalogue: all pictures as a popover, or as a shelf along the 3D viewport."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from .. import assets
from ..panels.shelves import PICKER, SHELF
from .targets import OnObjects

__all__ = ["CLASSES", "forget"]

SHELF_PREVIEW = 96
SOON = 0.1


class FACET_FILM_OT_choose(OnObjects, bpy.types.Operator):
    """Open all materials as pictures: each click puts one on the selected objects, until Esc. The first time this \
adds the library Facet & Film to your preferences"""

    bl_idname = "facet_film.choose"
    bl_label = "Facet & Film Material..."

    def invoke(self, context, _event):
        """Add the library the first time, and open the pictures at the mouse."""
        show_library(self)
        bpy.ops.wm.call_asset_shelf_popover("INVOKE_DEFAULT", name=PICKER)
        return {"FINISHED"}


class FACET_FILM_OT_shelf(bpy.types.Operator):
    """Show or hide a shelf of all materials along the 3D Viewport, to click on or to drag onto objects"""

    bl_idname = "facet_film.shelf"
    bl_label = "Material Shelf"

    @classmethod
    def poll(cls, context):
        """Needs a 3D viewport in Object Mode."""
        if context.mode != "OBJECT" or not views(context):
            cls.poll_message_set(rpt_("The shelf stands in a 3D Viewport in Object Mode"))
            return False
        return True

    def execute(self, context):
        """Show it in every viewport of the window, or hide it where it is shown."""
        shown = any(area.spaces.active.show_region_asset_shelf for area in views(context))
        if not shown:
            show_library(self)
        for area in views(context):
            area.spaces.active.show_region_asset_shelf = not shown
        if not shown and not bpy.app.background:
            bpy.app.timers.register(dress, first_interval=SOON)
        return {"FINISHED"}


def show_library(operator):
    """Add the library to the preferences unless it is there, and say so."""
    if assets.library.add():
        said = rpt_("The asset library {:s} was added to your preferences; the extension's own take it out again")
        operator.report({"INFO"}, said.format(assets.library.NAME))


def views(context):
    """The 3D viewports of the window."""
    return [area for area in context.window.screen.areas if area.type == "VIEW_3D"] if context.window else []


def dress():
    """Give shelves of ours that have just been shown names and size: before they are drawn Blender has none to set."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            region = next((region for region in area.regions if region.type == "ASSET_SHELF"), None)
            if area.type == "VIEW_3D" and region is not None:
                with bpy.context.temp_override(window=window, area=area, region=region):
                    shelf = getattr(bpy.context, "asset_shelf", None)
                    if shelf is not None and shelf.bl_idname == SHELF:
                        shelf.show_names, shelf.preview_size = True, SHELF_PREVIEW
                area.tag_redraw()


def forget():
    """Dress no shelf any more."""
    if bpy.app.timers.is_registered(dress):
        bpy.app.timers.unregister(dress)


CLASSES = (FACET_FILM_OT_choose, FACET_FILM_OT_shelf)
