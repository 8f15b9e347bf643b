"""The operator that adds one of our node groups to a shader."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError
from .. import datablocks
from ..settings import preset_property

__all__ = ["CLASSES"]


def _groups(_self, _context):
    from ..datablocks.menu import group_items
    return group_items()


class FACET_FILM_OT_add_group(bpy.types.Operator):
    """Add a node group of Facet & Film; one that the file has already is used again"""

    bl_idname = "facet_film.add_group"
    bl_label = "Add Facet & Film Group"
    bl_options = {"REGISTER", "UNDO"}

    group: bpy.props.EnumProperty(
        name="Group", items=_groups, description="Which group to add")
    preset: preset_property()

    @classmethod
    def poll(cls, context):
        """Needs a shader node tree of this file in a node editor."""
        space = context.space_data
        tree = space.edit_tree if space is not None and space.type == "NODE_EDITOR" else None
        if tree is None or tree.bl_idname != "ShaderNodeTree":
            cls.poll_message_set(rpt_("Open a material in the Shader Editor first"))
            return False
        if datablocks.locked.why_locked(space.id) or datablocks.locked.why_locked(tree):
            cls.poll_message_set(datablocks.locked.why_locked(space.id) or datablocks.locked.why_locked(tree))
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
        from ...api import create_fresnel_ramp
        from ..datablocks.ramps import RAMP_ID
        space = context.space_data
        try:
            ramp = self.group == RAMP_ID
            group = create_fresnel_ramp(self.preset) if ramp else datablocks.groups.node_group(self.group)
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


CLASSES = (FACET_FILM_OT_add_group,)
