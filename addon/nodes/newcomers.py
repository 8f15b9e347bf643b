"""Links that only those Blenders take whose Metallic BSDF has a thin film of its own.

One library of groups serves every Blender and is written by the oldest, so a
node keeps what its sockets are to be fed by, and they are, or are not, where
the group is used.
"""

import json

__all__ = ["KEY", "NEW_OUTPUT", "defer", "deferred", "settle"]

KEY = "facet_film_native"

NEW_OUTPUT = "Portal Depth"
"""Of the Light Path, in the Blenders with a native film."""


def defer(node, identifier, source, output):
    """Note that an input of a node is to be fed by an output of another one where there is a native film."""
    node[KEY] = json.dumps({**deferred(node), identifier: [source.name, output]})


def deferred(node):
    """{identifier of an input: [name of the node, identifier of the output] that is to feed it}."""
    return json.loads(node[KEY]) if KEY in node else {}


def settle(tree, native):
    """Link what waits in a tree and in the groups within it, or take it apart.

    native  whether this Blender has a native film
    """
    for node in tree.nodes:
        for identifier, (name, output) in deferred(node).items():
            socket = _socket(node.inputs, identifier)
            if socket is not None and socket.is_linked and not native:
                tree.links.remove(socket.links[0])
            elif socket is not None and native and not socket.is_linked:
                tree.links.new(_socket(tree.nodes[name].outputs, output), socket)
    for inner in {node.node_tree for node in tree.nodes if node.bl_idname == "ShaderNodeGroup" and node.node_tree}:
        settle(inner, native)


def _socket(sockets, identifier):
    return next((socket for socket in sockets if socket.identifier == identifier), None)
