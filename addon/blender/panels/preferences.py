"""The extension's preferences: where its buttons are, what new materials are, the asset library, the verification."""

from pathlib import Path

import bpy
from bpy.app.translations import pgettext_iface as iface_

from .. import assets
from ..settings import DEFAULTS, PACKAGE, finish_property, realisation_property

__all__ = ["CLASSES"]

README = Path(__file__).parents[3] / "README.md"


class FacetFilmPreferences(bpy.types.AddonPreferences):
    """What Preferences, Add-ons shows under Facet & Film."""

    bl_idname = PACKAGE

    realisation: realisation_property()
    finish: finish_property()
    in_headers: bpy.props.BoolProperty(
        name="Headers", default=DEFAULTS.in_headers,
        description="A button in the headers of the 3D Viewport and of the Shader Editor")
    in_menus: bpy.props.BoolProperty(
        name="Menus", default=DEFAULTS.in_menus,
        description="Entries in the Object menu and in the context menus of objects, faces and material slots")
    in_sidebar: bpy.props.BoolProperty(
        name="Sidebar", default=DEFAULTS.in_sidebar, description="A tab in the sidebar of the 3D Viewport")

    def draw(self, context):
        """Where it lives, new materials, the library, and what can be read and checked."""
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        column = layout.column(heading=iface_("Where to Find It"))
        for name in ("in_headers", "in_menus", "in_sidebar"):
            column.prop(self, name)
        column = layout.column()
        column.prop(self, "realisation", text="New Materials Render by")
        column.prop(self, "finish", text="Their Finish")
        self._draw_library(layout.column())
        layout.operator("wm.path_open", text="Read the Documents", icon="HELP").filepath = str(README)
        self._draw_verification(layout.column())

    def _draw_library(self, column):
        if assets.library.is_shown():
            column.operator("facet_film.remove_asset_library", icon="REMOVE")
        else:
            column.operator("facet_film.add_asset_library", icon="ASSET_MANAGER")

    def _draw_verification(self, column):
        from ..operators.verify import progress
        column.label(text="Does this Blender render the published formulas? Find out on this machine:")
        row = column.row()
        row.operator("facet_film.verify", text="Verify on CPU", icon="CHECKMARK").device = "CPU"
        row.operator("facet_film.verify", text="Verify on GPU", icon="CHECKMARK").device = "GPU"
        if progress():
            column.label(text=progress(), translate=False)


CLASSES = (FacetFilmPreferences,)
