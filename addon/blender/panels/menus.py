"""Where else people look for a material: headers, menus of objects and slots, a tab of the 3D viewport's sidebar."""

import bpy

from ..settings import preferences
from .card import draw_card

__all__ = ["CLASSES", "attach", "detach"]


def draw_in_header(self, context):
    """A button in the header of the 3D viewport and of the Shader Editor."""
    if preferences().in_headers and _shades(context.space_data):
        self.layout.operator("facet_film.choose", text="", icon="MATERIAL")


def draw_in_menu(self, context):
    """All pictures, and the search."""
    if not preferences().in_menus:
        return
    layout = self.layout
    layout.separator()
    layout.operator_context = "INVOKE_DEFAULT"
    layout.operator("facet_film.choose", icon="MATERIAL")
    layout.operator("facet_film.search", icon="VIEWZOOM")


def draw_in_object_menu(self, context):
    """These, and the common face of two bodies."""
    draw_in_menu(self, context)
    if preferences().in_menus:
        self.layout.operator("facet_film.common_face", icon="SELECT_INTERSECT")


def _shades(space):
    """Whether an editor shows objects or a shader."""
    return space.type == "VIEW_3D" or space.type == "NODE_EDITOR" and space.tree_type == "ShaderNodeTree"


class FACET_FILM_PT_view3d(bpy.types.Panel):
    """The material of the active object"""

    bl_label = "Facet & Film"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Facet & Film"

    @classmethod
    def poll(cls, context):
        """Shown where the preferences ask for it."""
        return preferences().in_sidebar and context.object is not None

    def draw(self, context):
        """The card."""
        draw_card(self.layout, context)


CLASSES = (FACET_FILM_PT_view3d,)
ENTRIES = {
    "VIEW3D_HT_header": draw_in_header, "NODE_HT_header": draw_in_header,
    "VIEW3D_MT_object_context_menu": draw_in_object_menu, "VIEW3D_MT_object": draw_in_object_menu,
    "VIEW3D_MT_edit_mesh_context_menu": draw_in_menu, "MATERIAL_MT_context_menu": draw_in_menu,
}
"""A menu or header of Blender's -> what we add at its end."""


def attach():
    """Add our entries."""
    for name, draw in ENTRIES.items():
        getattr(bpy.types, name).append(draw)


def detach():
    """Take them out."""
    for name, draw in ENTRIES.items():
        getattr(bpy.types, name).remove(draw)
