"""A plain Principled BSDF material of a bake, for glTF and USD, which know no node groups."""

import json

import bpy

from ..export.principled import principled_settings
from .compat import enable_nodes
from .materials import RECORD_KEY

__all__ = ["principled_material"]


def principled_material(baked, name=None):
    """A new material whose Principled BSDF is set to F0 and F82 tint, or to an index of refraction.

    baked  an addon.bake.Bake
    name   of the material; by default the bake's title

    Returns a bpy.types.Material that carries the bake's record as our other
    materials do.  See :func:`addon.export.principled.principled_settings`.
    """
    material = bpy.data.materials.new(name or baked.title)
    enable_nodes(material)
    tree = material.node_tree
    tree.nodes.clear()
    shader = tree.nodes.new("ShaderNodeBsdfPrincipled")
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    output.location = (300, 0)
    tree.links.new(shader.outputs[0], output.inputs[0])
    sockets = {socket.identifier: socket for socket in shader.inputs}
    for identifier, value in principled_settings(baked).items():
        sockets[identifier].default_value = value
    material[RECORD_KEY] = json.dumps(baked.to_dict())
    material.diffuse_color = sockets["Base Color"].default_value[:]
    material.metallic = sockets["Metallic"].default_value
    material.roughness = sockets["Roughness"].default_value
    return material
