"""Groups of another version of the extension: what could be updated, and the update, on request."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from .fingerprints import ID_KEY
from .groups import VERSION_KEY, edited, group_of, node_group
from .materials import exchange_group
from .parts import drop_unused_parts
from .pictures import image_in

__all__ = ["Outdated", "outdated_groups", "update"]


class Outdated:
    """A node group of the file that another version of the extension made.

    tree        the bpy.types.NodeTree
    identifier  its id
    found, now  its version, and this extension's
    """

    def __init__(self, tree):
        self.tree, self.identifier = tree, tree[ID_KEY]
        self.found, self.now = tree.get(VERSION_KEY, 0), group_of(tree[ID_KEY]).version

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
    ours = [Outdated(tree) for tree in bpy.data.node_groups if group_of(tree.get(ID_KEY))]
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
    drop_unused_parts()
    return updated, [reason for reason in reasons if reason]


def _replace(group):
    """Exchange one group wherever a node of the file has it."""
    current, count = node_group(group.identifier, image_in(group.tree)), 0
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
    groups = [tree for tree in bpy.data.node_groups if tree.library is None and not group_of(tree.get(ID_KEY))]
    return [owner.node_tree for owner in owners] + groups
