"""The operator that bakes a preset into one group node."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError
from .. import compat, datablocks
from ..settings import Viewing, preset_property, viewing_of
from .targets import Reasoned

__all__ = ["CLASSES", "takes_presets", "write_preset"]


def takes_presets(node):
    """Whether a node takes presets: one that renders a material of ours, or a ramp."""
    tree = getattr(node, "node_tree", None)
    return _is_ramp(tree) or datablocks.materials.found_in(tree) is not None


def _is_ramp(tree):
    from ..datablocks.ramps import RAMP_ID
    return datablocks.groups.group_id(tree) == RAMP_ID


def write_preset(node, preset, viewing, owner=None):
    """Write a preset into one of our group nodes, with the group that belongs to it; what is plugged in
    stays, and so does the finish.

    owner  the material whose tree it is: its record follows where the node is what it renders with

    Raises FacetFilmError for an unknown preset, and for one whose model lacks the node's realisation.
    """
    from ...api import create_fresnel_ramp
    from ...models.finishing import kept_finish
    from ...models.making import made
    if _is_ramp(node.node_tree):
        node.node_tree = create_fresnel_ramp(preset, **viewing)
        node.label = node.node_tree.name
        return
    _, realisation = datablocks.materials.found_in(node.node_tree)
    record = made(preset=preset, realisation=realisation, renderer=compat.renderer(), viewing=viewing)
    materials = datablocks.materials
    if isinstance(owner, bpy.types.Material) and materials.our_node(owner) == node:
        materials.write(owner, kept_finish(materials.record_of(owner), record))
    else:
        materials.write_node(node.id_data, node, kept_finish(materials.record_of_node(node), record))


class FACET_FILM_OT_apply_to_node(Reasoned, Viewing, bpy.types.Operator):
    """Bake a preset into the selected group node; what is plugged into it stays"""

    bl_idname = "facet_film.apply_to_node"
    bl_label = "Apply to Node"
    bl_options = {"REGISTER", "UNDO"}

    preset: preset_property()

    @staticmethod
    def why_not(context):
        """Needs a node of ours in a tree of this file."""
        node = getattr(context, "active_node", None)
        if not takes_presets(node):
            return rpt_("Select a group node of Facet & Film first")
        return datablocks.locked.why_locked(context.space_data.id) or datablocks.locked.why_locked(node.id_data)

    def execute(self, context):
        """Bake and write the sockets, or change the ramp."""
        try:
            write_preset(context.active_node, self.preset, viewing_of(self), context.space_data.id)
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        self.report({"INFO"}, rpt_("{:s} applied").format(self.preset))
        return {"FINISHED"}


CLASSES = (FACET_FILM_OT_apply_to_node,)
