"""The parts of our node groups, groups themselves: one of each in a file, whatever groups of ours share it."""

import bpy

from .fingerprints import PART_KEY, fingerprint, fingerprint_of_part
from .locked import is_editable
from .pictures import SHOWS, image_in, key_of, note_pictures

__all__ = ["as_marked", "drop_unused_parts", "mark_parts", "merge_parts"]


def mark_parts(trees):
    """Note in parts what they compute, once they are whole, and which of them show an image."""
    trees = list(trees)
    note_pictures(trees)
    for tree in trees:
        tree[PART_KEY] = fingerprint(tree)


def as_marked(trees):
    """{name: fingerprint} of the parts among trees that nobody can have edited yet."""
    return {tree.name: tree[PART_KEY] for tree in trees if PART_KEY in tree}


def merge_parts(known=None):
    """Make one of equal parts in the file: what comes in brings its own. One that someone edited stays by itself.

    known  {name: fingerprint} of parts that are as they were marked

    Those that show images are equal where these are the same.
    """
    found = {}
    for tree in _parts():
        shown = key_of(image_in(tree)) if SHOWS in tree else ""
        found.setdefault((tree[PART_KEY], shown), []).append(tree)
    needless, known = {}, {} if known is None else dict(known)
    for (key, _), trees in found.items():
        same = [tree for tree in trees if fingerprint_of_part(tree, known) == key] if len(trees) > 1 else []
        needless.update({tree: same[0] for tree in same[1:]})
    if needless:
        _replace(needless)
        bpy.data.batch_remove(list(needless))


def _replace(needless):
    """Put other parts, {part: other}, in their places: in groups node by node, which takes a third of Blender's way."""
    for tree in filter(is_editable, bpy.data.node_groups):
        for node in tree.nodes:
            if node.bl_idname == "ShaderNodeGroup" and node.node_tree in needless:
                node.node_tree = needless[node.node_tree]
    for part, other in needless.items():
        if part.users > part.use_fake_user:  # somewhere else, as in a material
            part.user_remap(other)


def drop_unused_parts():
    """Take away the parts that no group has any more."""
    while True:
        unused = [tree for tree in _parts() if tree.users == tree.use_fake_user]
        if not unused:
            return
        bpy.data.batch_remove(unused)


def _parts():
    """Every part in the file that may be changed."""
    return [tree for tree in bpy.data.node_groups if PART_KEY in tree and is_editable(tree)]
