"""Files saved by an older version of the extension: what could be updated, and the update, on request."""

import bpy
from bpy.app.translations import pgettext_iface as iface_
from bpy.app.translations import pgettext_rpt as rpt_

from .groups import GROUPS, ID_KEY, VERSION_KEY, edited, group_version, node_group
from .materials import exchange_group

__all__ = ["CLASSES", "Outdated", "outdated_groups", "update"]


class Outdated:
    """A node group of the file that another version of the extension made.

    tree        the bpy.types.NodeTree
    identifier  its id
    found, now  its version, and this extension's
    """

    def __init__(self, tree):
        self.tree, self.identifier = tree, tree[ID_KEY]
        self.found, self.now = tree.get(VERSION_KEY, 0), group_version(tree[ID_KEY])

    @property
    def newer(self):
        """Whether a newer version of the extension made it."""
        return self.found > self.now

    def why_not(self):
        """Why it is left as it is, or an empty text."""
        if self.newer:
            return rpt_("{:s} was made by a newer Facet & Film: install that one to change it").format(self.tree.name)
        if self.tree.library is not None:
            return rpt_("{:s} is linked: update it in {:s}").format(
                self.tree.name, bpy.path.basename(self.tree.library.filepath))
        if edited(self.tree):
            return rpt_("{:s} was edited by hand and stays as it is").format(self.tree.name)
        return ""


def outdated_groups():
    """Every group of ours in the file whose version is not this extension's."""
    ours = [Outdated(tree) for tree in bpy.data.node_groups if tree.get(ID_KEY) in GROUPS]
    return [group for group in ours if group.found != group.now]


def update():
    """Put the current groups in the place of older ones, keeping every value and link.

    Returns (how many nodes were updated, why the other groups were left alone).
    """
    found = outdated_groups()
    reasons = [group.why_not() for group in found]
    replaced = [group for group, reason in zip(found, reasons) if not reason]
    for group in replaced:
        group.tree.name = f"{group.tree.name} version {group.found}"  # its name is the current one's
    updated = sum(_replace(group) for group in replaced)
    _remove_unused()
    return updated, [reason for reason in reasons if reason]


def _replace(group):
    """Exchange one group wherever a node of the file has it."""
    current, count = node_group(group.identifier), 0
    for tree in _trees():
        for node in tree.nodes:
            if node.bl_idname == "ShaderNodeGroup" and node.node_tree == group.tree:
                exchange_group(tree, node, current)
                count += 1
    return count


def _remove_unused():
    """Take away the replaced groups, and then those that only they needed."""
    while True:
        unused = [group.tree for group in outdated_groups()
                  if not group.why_not() and group.tree.users == group.tree.use_fake_user]
        if not unused:
            return
        bpy.data.batch_remove(unused)


def _trees():
    """Every local shader tree that may hold a node of ours."""
    owners = [owner for owner in (*bpy.data.materials, *bpy.data.worlds, *bpy.data.lights)
              if owner.library is None and owner.node_tree is not None]
    groups = [tree for tree in bpy.data.node_groups if tree.library is None and tree.get(ID_KEY) not in GROUPS]
    return [owner.node_tree for owner in owners] + groups


class FACET_FILM_OT_update(bpy.types.Operator):
    """Bring this file's materials by an older Facet & Film up to date; every value and link stays"""

    bl_idname = "facet_film.update"
    bl_label = "Update Materials"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, _context):
        """Off where nothing is of another version."""
        if not outdated_groups():
            cls.poll_message_set(rpt_("Everything in this file is of this version"))
            return False
        return True

    def execute(self, _context):
        """Update, and say what was left alone and why."""
        updated, reasons = update()
        if updated:
            self.report({"INFO"}, rpt_("Nodes updated: {:d}").format(updated))
        for reason in reasons:
            self.report({"WARNING"}, reason)
        return {"FINISHED"} if updated else {"CANCELLED"}


class FACET_FILM_PT_update(bpy.types.Panel):
    """What in this file is of another version of the extension"""

    bl_label = "Another Version"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"
    bl_parent_id = "FACET_FILM_PT_material"

    @classmethod
    def poll(cls, _context):
        """Shown only where there is something to say."""
        return bool(outdated_groups())

    def draw(self, _context):
        """A line a group, and the button."""
        column = self.layout.column(align=True)
        for group in outdated_groups():
            said = iface_("{:s}: version {:d}, now {:d}").format(group.tree.name, group.found, group.now)
            column.label(text=said, icon="FILE_REFRESH", translate=False)
        self.layout.operator("facet_film.update", icon="FILE_REFRESH")


CLASSES = (FACET_FILM_OT_update, FACET_FILM_PT_update)
