"""Our groups in the Add menu of the Shader Editor."""

import bpy

from .menus import draw_in_menu

__all__ = ["CLASSES", "attach", "detach"]


class FACET_FILM_MT_add(bpy.types.Menu):
    """The groups of Facet & Film"""

    bl_idname = "FACET_FILM_MT_add"
    bl_label = "Facet & Film"

    def draw(self, context):
        """An entry a group; the ramp is of the preset chosen in the panel."""
        from ..datablocks.menu import parts
        layout = self.layout
        layout.operator_context = "INVOKE_REGION_WIN"
        settings = context.window_manager.facet_film
        for number, part in enumerate(parts()):
            if number:
                layout.separator()
            for identifier, name, _ in part:
                operator = layout.operator("facet_film.add_group", text=name)
                operator.group = identifier
                operator.preset = settings.preset
        draw_in_menu(self, context)


def draw_entry(self, context):
    """Our entry at the end of the Add menu."""
    tree = context.space_data.edit_tree
    if tree is not None and tree.bl_idname == "ShaderNodeTree":
        self.layout.separator()
        self.layout.menu("FACET_FILM_MT_add", icon="MATERIAL")


CLASSES = (FACET_FILM_MT_add,)


def attach():
    """Add the entry."""
    bpy.types.NODE_MT_shader_node_add_all.append(draw_entry)


def detach():
    """Take it out."""
    bpy.types.NODE_MT_shader_node_add_all.remove(draw_entry)
