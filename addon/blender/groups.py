"""Our node groups in the open file: found again by id and version, so that they never multiply."""

import hashlib
from importlib import import_module

import bpy

__all__ = ["GROUPS", "node_group", "group_id", "socket_named"]

GROUPS = {
    "cook_torrance_fast": "cook_torrance_fast",
    "cook_torrance_fast_f82": "cook_torrance_fast_f82",
    "layered_rgb_fast": "layered_rgb_fast",
    "layered_rgb_exact": "layered_rgb_exact",
    "layer_thickness": "layer_thickness",
}
"""Group id -> module of addon.nodes with NAME, VERSION and build()."""

ID_KEY = "facet_film_id"
VERSION_KEY = "facet_film_version"
FINGERPRINT_KEY = "facet_film_fingerprint"


def node_group(identifier):
    """The group with this id in the current version, built where the file has none as we made it.

    A group that a user has edited is left alone and not reused.
    """
    definition = import_module(f"..nodes.{GROUPS[identifier]}", __package__)
    for tree in bpy.data.node_groups:
        if (tree.get(ID_KEY) == identifier and tree.get(VERSION_KEY) == definition.VERSION
                and not tree.library and tree.get(FINGERPRINT_KEY) == fingerprint(tree)):
            return tree
    tree = definition.build()
    tree[ID_KEY] = identifier
    tree[VERSION_KEY] = definition.VERSION
    tree[FINGERPRINT_KEY] = fingerprint(tree)
    return tree


def group_id(tree):
    """The id of one of our groups, or None."""
    return tree.get(ID_KEY) if tree is not None else None


def fingerprint(tree):
    """A short text that changes when someone edits what the group computes."""
    digest = hashlib.sha256()
    for node in tree.nodes:
        if node.bl_idname == "NodeFrame":
            continue
        digest.update(f"{node.name} {node.bl_idname} {getattr(node, 'operation', '')}".encode())
        for socket in node.inputs:
            if not socket.is_linked and hasattr(socket, "default_value"):
                value = socket.default_value
                shown = tuple(value) if hasattr(value, "__len__") and not isinstance(value, str) else value
                digest.update(f"{socket.identifier}{shown}".encode())
    for link in tree.links:
        digest.update(f"{link.from_node.name}.{link.from_socket.identifier}>"
                      f"{link.to_node.name}.{link.to_socket.identifier}".encode())
    return digest.hexdigest()[:16]


def socket_named(node, name):
    """The input of a group node that belongs to the interface socket of this name.

    The interface's names are data of ours, never translated; the node's socket
    is then taken by identifier.
    """
    for item in node.node_tree.interface.items_tree:
        if item.item_type == "SOCKET" and item.in_out == "INPUT" and item.name == name:
            return next(socket for socket in node.inputs if socket.identifier == item.identifier)
    raise KeyError(name)
