"""The sidebar tab of the Shader Editor: presets and parameters of the selected group."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from ..errors import FacetFilmError
from .bake_operator import PanelSettings, why_locked
from .drawing import draw_parameters, draw_sentence
from .groups import group_id
from .materials import MODELS, found_in
from .picker import draw_card
from .ramps import RAMP_ID
from .settings import MODEL_ITEMS, Viewing, chosen_preset, copy_viewing, preset_property, viewing_of

__all__ = ["CLASSES"]


def model_of_node(node):
    """The model whose presets a node takes: those of its group; a ramp takes measured ones. None for others."""
    tree = getattr(node, "node_tree", None)
    if group_id(tree) == RAMP_ID:
        return "cook_torrance"
    found = found_in(tree)
    return found[0] if found else None


class FACET_FILM_OT_apply_to_node(PanelSettings, Viewing, bpy.types.Operator):
    """Bake a preset into the selected group node; what is plugged into it stays"""

    bl_idname = "facet_film.apply_to_node"
    bl_label = "Apply to Node"
    bl_options = {"REGISTER", "UNDO"}

    preset: preset_property()
    model: bpy.props.EnumProperty(name="Model", items=MODEL_ITEMS, options={"HIDDEN"}, description="Reflectance model")

    @classmethod
    def poll(cls, context):
        """Needs a node of ours in a tree of this file."""
        node = getattr(context, "active_node", None)
        reason = "" if model_of_node(node) else rpt_("Select a group node of Facet & Film first")
        if not reason:
            reason = why_locked(context.space_data.id) or why_locked(node.id_data)
        if reason:
            cls.poll_message_set(reason)
        return not reason

    def execute(self, context):
        """Bake and write the sockets, or change the ramp."""
        try:
            write_preset(context.active_node, self.preset, viewing_of(self), context.space_data.id)
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        self.report({"INFO"}, rpt_("{:s} applied").format(self.preset))
        return {"FINISHED"}


def write_preset(node, preset, viewing, owner=None):
    """Write a preset into one of our group nodes; owner's record follows where the node is what it renders with."""
    from .. import api
    from .materials import our_node, rebake
    if group_id(node.node_tree) == RAMP_ID:
        node.node_tree = api.create_fresnel_ramp(preset, **viewing)
        node.label = node.node_tree.name
        return
    model, realisation = found_in(node.node_tree)
    if model == "layered_rgb":
        parameters, record = api.layered_from_preset(preset, {})
    else:
        parameters, record, _ = api.cook_torrance_from_preset(preset, {}, realisation, viewing)
    if isinstance(owner, bpy.types.Material) and our_node(owner) == node:
        rebake(owner, parameters, record)
    else:
        MODELS[model].write(node, parameters)


class _Tab:
    bl_space_type = "NODE_EDITOR"
    bl_region_type = "UI"
    bl_category = "Facet & Film"


class FACET_FILM_PT_node(_Tab, bpy.types.Panel):
    """Presets of the selected group"""

    bl_label = "Preset"

    @classmethod
    def poll(cls, context):
        """Shown in shader trees."""
        return context.space_data.tree_type == "ShaderNodeTree" and context.space_data.edit_tree is not None

    def draw(self, context):
        """The card for the node's model, or what to do first."""
        model = model_of_node(context.active_node)
        if model is None:
            draw_sentence(self.layout, rpt_("Select a group of Facet & Film, or add one: Add, Facet & Film"), "INFO",
                          context.region)
            return
        settings = context.window_manager.facet_film
        self.layout.label(text=context.active_node.node_tree.name, icon="NODETREE", translate=False)
        draw_card(self.layout, settings, lambda column: _draw_apply(column, settings, model), model)


def _draw_apply(layout, settings, model):
    operator = layout.operator("facet_film.apply_to_node", icon="SHADING_RENDERED")
    operator.preset = chosen_preset(settings, model)
    operator.model = model
    copy_viewing(settings, operator)


class FACET_FILM_PT_node_parameters(_Tab, bpy.types.Panel):
    """Parameters of the selected group"""

    bl_label = "Parameters"

    @classmethod
    def poll(cls, context):
        """Shown for a node of ours."""
        return context.space_data.tree_type == "ShaderNodeTree" and model_of_node(context.active_node) is not None

    def draw(self, context):
        """The sockets."""
        self.layout.enabled = not why_locked(context.space_data.id)
        draw_parameters(self.layout, context.active_node)


CLASSES = (FACET_FILM_OT_apply_to_node, FACET_FILM_PT_node, FACET_FILM_PT_node_parameters)
