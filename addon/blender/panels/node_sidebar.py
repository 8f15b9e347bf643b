"""The sidebar tab of the Shader Editor: the material's card, and presets and parameters of the selected group."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from .. import datablocks, panels
from ..operators.apply_to_node import takes_presets
from ..settings import copy_viewing
from .card import draw_card

__all__ = ["CLASSES"]


class _Tab:
    bl_space_type = "NODE_EDITOR"
    bl_region_type = "UI"
    bl_category = "Facet & Film"


class FACET_FILM_PT_node_material(_Tab, bpy.types.Panel):
    """The material that the editor shows"""

    bl_label = "Material"

    @classmethod
    def poll(cls, context):
        """Shown for materials."""
        return context.space_data.tree_type == "ShaderNodeTree" and context.space_data.shader_type == "OBJECT"

    def draw(self, context):
        """The card."""
        draw_card(self.layout, context)


class FACET_FILM_PT_node(_Tab, bpy.types.Panel):
    """Presets of the selected group"""

    bl_label = "Selected Node"

    @classmethod
    def poll(cls, context):
        """Shown in shader trees."""
        return context.space_data.tree_type == "ShaderNodeTree" and context.space_data.edit_tree is not None

    def draw(self, context):
        """A field to type in and Apply, or what to do first."""
        node = context.active_node
        if not takes_presets(node):
            said = rpt_("Select a group of Facet & Film, or add one: Add, Facet & Film")
            panels.drawing.draw_sentence(self.layout, said, "INFO", context.region)
            return
        settings = context.window_manager.facet_film
        self.layout.label(text=node.node_tree.name, icon="NODETREE", translate=False)
        self.layout.prop(settings, "preset", text="", icon="VIEWZOOM")
        operator = self.layout.operator("facet_film.apply_to_node", icon="SHADING_RENDERED")
        operator.preset = settings.preset
        copy_viewing(settings, operator)


class FACET_FILM_PT_node_parameters(_Tab, bpy.types.Panel):
    """Parameters of the selected group"""

    bl_label = "Parameters"

    @classmethod
    def poll(cls, context):
        """Shown for a node of ours."""
        return context.space_data.tree_type == "ShaderNodeTree" and takes_presets(context.active_node)

    def draw(self, context):
        """The sockets."""
        self.layout.enabled = not datablocks.locked.why_locked(context.space_data.id)
        panels.drawing.draw_parameters(self.layout, context.active_node)


CLASSES = (FACET_FILM_PT_node_material, FACET_FILM_PT_node, FACET_FILM_PT_node_parameters)
