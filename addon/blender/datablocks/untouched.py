"""Whether a material is as Blender made it, so that nothing is lost with it."""

import bpy

from ..compat import enable_nodes

__all__ = ["is_untouched"]

NEW = ("ShaderNodeBsdfPrincipled", "ShaderNodeOutputMaterial")


def is_untouched(material):
    """Whether a material is still what a new one is: a Principled BSDF as it comes, and an output."""
    if material.node_tree is None:
        return True
    nodes = material.node_tree.nodes
    if sorted(node.bl_idname for node in nodes) != sorted(NEW):
        return False
    fresh = bpy.data.materials.new(".facet_film fresh")
    try:
        enable_nodes(fresh)
        return _values(nodes) == _values(fresh.node_tree.nodes)
    finally:
        bpy.data.materials.remove(fresh)


def _values(nodes):
    """{identifier: value} of the Principled BSDF's sockets."""
    principled = next(node for node in nodes if node.bl_idname == NEW[0])
    values = {socket.identifier: socket.default_value for socket in principled.inputs
              if hasattr(socket, "default_value")}
    return {name: tuple(value) if hasattr(value, "__len__") else value for name, value in values.items()}
