"""The operator that makes a linked material one of this file."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from ..assets.imported import renew
from ..datablocks.groups import merge_groups
from ..datablocks.locked import is_editable, why_locked
from ..datablocks.materials import our_node
from .targets import active_material

__all__ = ["CLASSES"]


class FACET_FILM_OT_make_local(bpy.types.Operator):
    """Make this linked material one of this file, so that it can be changed; all objects that have it keep it"""

    bl_idname = "facet_film.make_local"
    bl_label = "Make Local"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        """Needs a material that is linked."""
        material = active_material(context)
        if material is None or is_editable(material):
            cls.poll_message_set(rpt_("This material belongs to this file already"))
            return False
        if context.object is not None and why_locked(context.object):
            cls.poll_message_set(why_locked(context.object))
            return False
        return True

    def execute(self, context):
        """Localise the material and the groups that only it needs."""
        linked = active_material(context)
        local = localised(linked)
        merge_groups()
        self.report({"INFO"}, rpt_("{:s} belongs to this file now").format(local.name))
        return {"FINISHED"}


def localised(linked):
    """A material of this file in the place of a linked one, wherever that is used, with trees of its own."""
    local = linked.make_local(clear_liboverride=True, clear_asset_data=True)
    for tree in _trees_of(local.node_tree):
        if tree.library is not None:
            tree.make_local()
    if our_node(local) is not None:
        renew(local)
    return local


def _trees_of(tree, seen=None):
    """The groups in a tree and in those, the innermost last."""
    seen = seen if seen is not None else []
    for node in tree.nodes:
        inner = getattr(node, "node_tree", None)
        if inner is not None and inner not in seen:
            seen.append(inner)
            _trees_of(inner, seen)
    return seen


CLASSES = (FACET_FILM_OT_make_local,)
