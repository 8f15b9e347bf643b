"""Our node groups in the open file: found again by id and version, so that they never multiply."""

import functools
from pathlib import Path

import bpy

from ... import models
from .fingerprints import ID_KEY, fingerprint, fingerprint_0_1_0
from .locked import is_editable
from .pictures import image_in, image_of, key_of, put_image

__all__ = ["EEVEE_OUTPUT", "LIBRARY", "all_groups", "build_group", "edited", "forget", "group_id", "group_of",
           "input_names", "library_file", "mark", "merge_groups", "model_of_group", "node_group", "socket_named"]

LIBRARY = Path(__file__).parents[3] / "node_groups" / "groups"
"""The groups as tools/build_groups.py built them, a file for each: appending one takes milliseconds, building one
seconds; and of a file with several Blender reads them all."""

EEVEE_OUTPUT = "EEVEE"
VERSION_KEY = "facet_film_version"
FINGERPRINT_KEY = "facet_film_fingerprint_2"
FINGERPRINT_KEY_0_1_0 = "facet_film_fingerprint"


@functools.lru_cache(maxsize=1)
def _owners():
    """{group's id: (Model, Group)} of all models."""
    return {group.identifier: (model, group) for model in models.all_models() for group in model.groups}


def forget():
    """Ask the models anew, after one was put on their path or taken off it."""
    _owners.cache_clear()


def all_groups():
    """Every Group of every model."""
    return [group for _, group in _owners().values()]


def group_of(identifier):
    """The Group with this id, or None for an id that is none of ours."""
    return _owners()[identifier][1] if identifier in _owners() else None


def model_of_group(identifier):
    """The Model that a group's id belongs to, or None."""
    return _owners()[identifier][0] if identifier in _owners() else None


def node_group(identifier, image=None):
    """The group with this id in the current version, brought in where the file has none as we made it.

    image  that a pictured group shows; by default that of its model's default parameters

    A group that a user has edited is left alone and not reused.
    """
    model, group = _owners()[identifier]
    if group.pictured:
        image = image or image_of(model.picture(model.parameters(), {}))
    same = [tree for tree in bpy.data.node_groups
            if tree.get(ID_KEY) == identifier and tree.get(VERSION_KEY) == group.version
            and not tree.library and not edited(tree)
            and (not group.pictured or key_of(image_in(tree)) == key_of(image))]
    if same:
        return _merged(same, group, image)
    tree = _from_library(group) or build_group(identifier)
    if FINGERPRINT_KEY not in tree:
        if group.stand_in:
            _add_eevee_output(tree, node_group(group.stand_in, image))
        mark(tree, group)
    if group.pictured:
        put_image(tree, image)
    return tree


def mark(tree, group):
    """Note in a group, once it is whole, which one it is and what it computes."""
    tree[ID_KEY] = group.identifier
    tree[VERSION_KEY] = group.version
    tree[FINGERPRINT_KEY] = fingerprint(tree)


def _merged(trees, group, image):
    """The first of equal groups, in the place of the others: what was dragged or pasted in brings its own."""
    first, *others = trees
    for tree in others:
        tree.user_remap(first)
        bpy.data.node_groups.remove(tree)
    if others and group.stand_in:
        node_group(group.stand_in, image)  # the others brought one of that, too
    return first


def merge_groups(trees=None):
    """Make one of equal groups of ours, among these trees or all of the file: what comes in brings its own."""
    found = bpy.data.node_groups if trees is None else trees
    ours = {(tree[ID_KEY], image_in(tree)) for tree in found if _is_current(tree)}
    for identifier, image in ours:
        if sum(tree.get(ID_KEY) == identifier for tree in bpy.data.node_groups) > 1:
            node_group(identifier, image)


def _is_current(tree):
    group = group_of(tree.get(ID_KEY))
    return group is not None and is_editable(tree) and tree.get(VERSION_KEY) == group.version


def edited(tree):
    """Whether someone changed one of our groups since it was made."""
    if FINGERPRINT_KEY in tree:
        return tree[FINGERPRINT_KEY] != fingerprint(tree)
    return tree.get(FINGERPRINT_KEY_0_1_0) != fingerprint_0_1_0(tree)


def build_group(identifier):
    """The group with this id built from its formulas, without a second shader for EEVEE."""
    from ...nodes.builder import GroupBuilder
    model, group = _owners()[identifier]
    builder = GroupBuilder(group.name)
    model.build(identifier, builder)
    return builder.finish()


def library_file(identifier):
    """Where the library holds the group with this id."""
    return LIBRARY / f"{identifier}.blend"


def _from_library(group):
    """The group appended from the library, or None where the library does not hold it."""
    file = library_file(group.identifier)
    if not file.exists():
        return None
    before = set(bpy.data.libraries)
    with bpy.data.libraries.load(str(file), link=False) as (_, target):
        target.node_groups = [group.name]
    for library in set(bpy.data.libraries) - before:
        bpy.data.libraries.remove(library)  # appending leaves an entry from which nothing is linked
    return target.node_groups[0]


def _add_eevee_output(tree, fast):
    """Give the group a second shader, Fast with the same inputs, for an EEVEE material output."""
    output = next(node for node in tree.nodes if node.bl_idname == "NodeGroupOutput")
    inputs = tree.nodes.new("NodeGroupInput")
    stand_in = tree.nodes.new("ShaderNodeGroup")
    stand_in.node_tree = fast
    stand_in.location = (output.location.x - 260, output.location.y - 300)
    inputs.location = (stand_in.location.x - 260, stand_in.location.y)
    for name in input_names(fast):
        tree.links.new(_output_named(inputs, tree, name), socket_named(stand_in, name))
    item = tree.interface.new_socket(EEVEE_OUTPUT, description="The Fast realisation, for an EEVEE material output",
                                     in_out="OUTPUT", socket_type="NodeSocketShader")
    target = next(socket for socket in output.inputs if socket.identifier == item.identifier)
    tree.links.new(stand_in.outputs[0], target)


def group_id(tree):
    """The id of one of our groups, or None."""
    return tree.get(ID_KEY) if tree is not None else None


def input_names(tree):
    """Names of a group's input sockets, in their order."""
    return [item.name for item in tree.interface.items_tree
            if item.item_type == "SOCKET" and item.in_out == "INPUT"]


def socket_named(node, name):
    """The input of a group node that belongs to the interface socket of this name.

    The interface's names are data of ours, never translated; the node's socket
    is then taken by identifier.
    """
    return _by_interface(node.inputs, node.node_tree, name, "INPUT")


def output_named(node, name):
    """The output of a group node that belongs to the interface socket of this name."""
    return _by_interface(node.outputs, node.node_tree, name, "OUTPUT")


def _output_named(group_input, tree, name):
    return _by_interface(group_input.outputs, tree, name, "INPUT")


def _by_interface(sockets, tree, name, in_out):
    for item in tree.interface.items_tree:
        if item.item_type == "SOCKET" and item.in_out == in_out and item.name == name:
            return next(socket for socket in sockets if socket.identifier == item.identifier)
    raise KeyError(name)
