"""The operator that makes a linked material this file's own, so that it can be changed."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from .. import datablocks
from ..assets.imported import renew
from .targets import active_material

__all__ = ["CLASSES"]


class FACET_FILM_OT_make_local(bpy.types.Operator):
    """Make this linked or overridden material the file's own: changes in its library no longer arrive"""

    bl_idname = "facet_film.make_local"
    bl_label = "Make Local"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        """Needs a material of ours that is linked or overridden, in a slot that takes another."""
        material, target = active_material(context), context.active_object
        ours = material is not None and datablocks.materials.our_node(material) is not None
        if not ours or datablocks.locked.is_editable(material):
            cls.poll_message_set(rpt_("This material is the file's own already"))
            return False
        if target is not None and target.active_material == material and _why_not(target):
            cls.poll_message_set(_why_not(target))
            return False
        return True

    def execute(self, context):
        """Make it local, and put it in the slots where the linked one was."""
        material, target = active_material(context), context.active_object
        local = localised(material)
        if target is not None and target.active_material == material:
            target.active_material = local
        self.report({"INFO"}, rpt_("{:s} is the file's own now").format(local.name))
        return {"FINISHED"}


def localised(material):
    """A material of this file in the place of a linked or overridden one, with groups of this file."""
    local = material.make_local(clear_liboverride=True) or material
    for tree in _trees_in(local.node_tree):
        if tree.library is not None:
            tree.make_local()
    renew(local)
    datablocks.groups.merge_groups()
    return local


def _trees_in(tree, found=None):
    """The groups in a tree and in those."""
    found = [] if found is None else found
    for inner in (getattr(node, "node_tree", None) for node in tree.nodes):
        if inner is not None and inner not in found:
            found.append(inner)
            _trees_in(inner, found)
    return found


def _why_not(target):
    """Why another material cannot be put in the active slot, or an empty text."""
    held_by_data = target.active_material_index < len(target.material_slots) and (
        target.material_slots[target.active_material_index].link == "DATA")
    return datablocks.locked.why_locked(target) or (datablocks.locked.why_locked(target.data) if held_by_data else "")


CLASSES = (FACET_FILM_OT_make_local,)
