"""Our node groups in the open file: found again by id and version, so that they never multiply."""

import hashlib
from importlib import import_module
from pathlib import Path

import bpy

from . import compat

__all__ = ["GROUPS", "FAST_OF", "EEVEE_OUTPUT", "LIBRARY", "library_file", "build_group", "node_group", "group_id",
           "group_version", "edited", "socket_named", "input_names"]

GROUPS = {
    "cook_torrance_fast": "cook_torrance_fast",
    "cook_torrance_fast_f82": "cook_torrance_fast_f82",
    "cook_torrance_exact": "cook_torrance_exact",
    "cook_torrance_osl": "osl_groups.COOK_TORRANCE",
    "cook_torrance_osl_fast": "osl_groups.COOK_TORRANCE_FAST",
    "layered_rgb_exact": "layered_rgb_exact",
    "layered_rgb_fast": "layered_rgb_fast",
    "layered_rgb_osl": "osl_groups.LAYERED_RGB",
    "layered_rgb_osl_fast": "osl_groups.LAYERED_RGB_FAST",
    "layer_thickness": "layer_thickness",
}
"""Group id -> module of addon.nodes, or object in one, with NAME, VERSION and build()."""

FAST_OF = {
    "cook_torrance_exact": "cook_torrance_fast",
    "cook_torrance_osl": "cook_torrance_fast",
    "cook_torrance_osl_fast": "cook_torrance_fast",
    "layered_rgb_exact": "layered_rgb_fast",
    "layered_rgb_osl": "layered_rgb_fast",
    "layered_rgb_osl_fast": "layered_rgb_fast",
}
"""Groups that only Cycles can render -> the group that stands in for them in EEVEE."""

LIBRARY = Path(__file__).parents[2] / "node_groups" / "groups"
"""The groups as tools/build_groups.py built them, a file for each: appending one takes milliseconds, building one
seconds; and of a file with several Blender reads them all."""

EEVEE_OUTPUT = "EEVEE"
ID_KEY = "facet_film_id"
VERSION_KEY = "facet_film_version"
FINGERPRINT_KEY = "facet_film_fingerprint"


def node_group(identifier):
    """The group with this id in the current version, brought in where the file has none as we made it.

    A group that a user has edited is left alone and not reused.
    """
    definition = _definition(identifier)
    same = [tree for tree in bpy.data.node_groups
            if tree.get(ID_KEY) == identifier and tree.get(VERSION_KEY) == definition.VERSION
            and not tree.library and not edited(tree)]
    if same:
        return _merged(same, identifier)
    tree = _from_library(identifier) or definition.build()
    if identifier in FAST_OF:
        _add_eevee_output(tree, node_group(FAST_OF[identifier]))
    tree[ID_KEY] = identifier
    tree[VERSION_KEY] = definition.VERSION
    if FINGERPRINT_KEY not in tree:
        tree[FINGERPRINT_KEY] = fingerprint(tree)
    return tree


def _merged(trees, identifier):
    """The first of equal groups, in the place of the others: what was dragged or pasted in brings its own."""
    first, *others = trees
    for tree in others:
        tree.user_remap(first)
        bpy.data.node_groups.remove(tree)
    if others and identifier in FAST_OF:
        node_group(FAST_OF[identifier])  # the others brought one of that, too
    return first


def edited(tree):
    """Whether someone changed what one of our groups computes."""
    return tree.get(FINGERPRINT_KEY) != fingerprint(tree)


def group_version(identifier):
    """The version of the group with this id that this extension makes."""
    return _definition(identifier).VERSION


def build_group(identifier):
    """The group with this id built from its formulas, without a second shader for EEVEE."""
    return _definition(identifier).build()


def library_file(identifier):
    """Where the library holds the group with this id."""
    return LIBRARY / f"{identifier}.blend"


def _from_library(identifier):
    """The group appended from the library, or None where the library does not hold it."""
    if not library_file(identifier).exists():
        return None
    before = set(bpy.data.libraries)
    with bpy.data.libraries.load(str(library_file(identifier)), link=False) as (_, target):
        target.node_groups = [_definition(identifier).NAME]
    for library in set(bpy.data.libraries) - before:
        bpy.data.libraries.remove(library)  # appending leaves an entry from which nothing is linked
    return target.node_groups[0]


def _definition(identifier):
    module, _, name = GROUPS[identifier].partition(".")
    found = import_module(f"..nodes.{module}", __package__)
    return getattr(found, name) if name else found


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


def fingerprint(tree):
    """A short text that changes when someone edits what the group computes, and not with the Blender that reads it."""
    digest = hashlib.sha256()
    for node in tree.nodes:
        if node.bl_idname == "NodeFrame":
            continue
        digest.update(f"{node.name} {node.bl_idname} {getattr(node, 'operation', '')}".encode())
        for socket in node.inputs:
            if not socket.is_linked and hasattr(socket, "default_value") and not compat.is_unused_newcomer(socket):
                value = socket.default_value
                shown = tuple(value) if hasattr(value, "__len__") and not isinstance(value, str) else value
                digest.update(f"{socket.identifier}{shown}".encode())
    for link in tree.links:
        digest.update(f"{link.from_node.name}.{link.from_socket.identifier}>"
                      f"{link.to_node.name}.{link.to_socket.identifier}".encode())
    return digest.hexdigest()[:16]


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


def _output_named(group_input, tree, name):
    return _by_interface(group_input.outputs, tree, name, "INPUT")


def _by_interface(sockets, tree, name, in_out):
    for item in tree.interface.items_tree:
        if item.item_type == "SOCKET" and item.in_out == in_out and item.name == name:
            return next(socket for socket in sockets if socket.identifier == item.identifier)
    raise KeyError(name)
