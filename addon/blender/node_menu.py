"""Our groups in the Add menu of the Shader Editor."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from ..errors import FacetFilmError
from .bake_operator import why_locked
from .groups import node_group
from .settings import chosen_preset, preset_property, search_measured

__all__ = ["CLASSES", "attach", "detach"]

GROUP_ITEMS = (
    ("cook_torrance_fast", "Cook–Torrance Fast", "Facets with native closures; also in EEVEE"),
    ("cook_torrance_exact", "Cook–Torrance Exact", "The published formula, nodes alone"),
    ("cook_torrance_osl", "Cook–Torrance OSL", "The published formula as an OSL script"),
    ("layered_rgb_fast", "Layered RGB Fast", "Thin layer with native closures; also in EEVEE"),
    ("layered_rgb_exact", "Layered RGB Exact", "The published formula, nodes alone"),
    ("layered_rgb_osl", "Layered RGB OSL", "The published formula as an OSL script"),
    ("layer_thickness", "Layer Thickness", "Thickness in nanometres that varies over the surface, with its lower normal"),
    ("fresnel_ramp", "Fresnel Ramp", "Colour of a preset's mirror over the angle, for any shader"),
)
STARTS_NEW_PART = ("layered_rgb_fast", "layer_thickness")


class FACET_FILM_OT_add_group(bpy.types.Operator):
    """Add a node group of Facet & Film; one that the file has already is used again"""

    bl_idname = "facet_film.add_group"
    bl_label = "Add Facet & Film Group"
    bl_options = {"REGISTER", "UNDO"}

    group: bpy.props.EnumProperty(name="Group", items=GROUP_ITEMS, description="Which group to add")
    preset: preset_property(search_measured)

    @classmethod
    def poll(cls, context):
        """Needs a shader node tree of this file in a node editor."""
        space = context.space_data
        tree = space.edit_tree if space is not None and space.type == "NODE_EDITOR" else None
        if tree is None or tree.bl_idname != "ShaderNodeTree":
            cls.poll_message_set(rpt_("Open a material in the Shader Editor first"))
            return False
        if why_locked(space.id) or why_locked(tree):
            cls.poll_message_set(why_locked(space.id) or why_locked(tree))
            return False
        return True

    def invoke(self, context, event):
        """Under the mouse, to be dragged where it belongs, as Blender's own nodes."""
        context.space_data.cursor_location_from_region(event.mouse_region_x, event.mouse_region_y)
        result = self.execute(context)
        if "FINISHED" in result:
            bpy.ops.node.translate_attach_remove_on_cancel("INVOKE_DEFAULT")
        return result

    def execute(self, context):
        """Add the node at the cursor."""
        from ..api import create_fresnel_ramp
        space = context.space_data
        try:
            ramp = self.group == "fresnel_ramp"
            group = create_fresnel_ramp(self.preset) if ramp else node_group(self.group)
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        for other in space.edit_tree.nodes:
            other.select = False
        node = space.edit_tree.nodes.new("ShaderNodeGroup")
        node.node_tree = group
        node.label = group.name
        node.width = 240 if not ramp else 180
        node.location = space.cursor_location
        node.select = True
        space.edit_tree.nodes.active = node
        return {"FINISHED"}


class FACET_FILM_MT_add(bpy.types.Menu):
    """The groups of Facet & Film"""

    bl_idname = "FACET_FILM_MT_add"
    bl_label = "Facet & Film"

    def draw(self, context):
        """An entry a group; the ramp is of the preset chosen in the panel."""
        layout = self.layout
        layout.operator_context = "INVOKE_REGION_WIN"
        settings = context.window_manager.facet_film
        for identifier, name, _ in GROUP_ITEMS:
            if identifier in STARTS_NEW_PART:
                layout.separator()
            operator = layout.operator("facet_film.add_group", text=name)
            operator.group = identifier
            operator.preset = chosen_preset(settings, "cook_torrance")


def draw_entry(self, context):
    """Our entry at the end of the Add menu."""
    tree = context.space_data.edit_tree
    if tree is not None and tree.bl_idname == "ShaderNodeTree":
        self.layout.separator()
        self.layout.menu("FACET_FILM_MT_add", icon="MATERIAL")


CLASSES = (FACET_FILM_OT_add_group, FACET_FILM_MT_add)


def attach():
    """Add the entry."""
    bpy.types.NODE_MT_shader_node_add_all.append(draw_entry)


def detach():
    """Take it out."""
    bpy.types.NODE_MT_shader_node_add_all.remove(draw_entry)
