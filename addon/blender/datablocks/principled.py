"""A plain Principled BSDF material of a bake, for glTF and USD, which know no node groups."""

import bpy

from ...errors import FacetFilmError
from ...models import named
from ...models.record import Record
from ..compat import enable_nodes
from .materials import RECORD_KEY

__all__ = ["principled_material"]


def principled_material(record: Record, name: str | None = None) -> bpy.types.Material:
    """A new material whose Principled BSDF is set to F0 and F82 tint, or to an index of refraction.

    record  what :func:`addon.api.record_of` gives, or :func:`addon.models.making.made`
    name    of the material; by default the record's title

    Returns a bpy.types.Material that carries the record as our other materials
    do.  Raises FacetFilmError for a model that a Principled BSDF cannot stand
    for.  See :func:`addon.export.principled.principled_settings`.
    """
    model = named(record.model)
    if model.principled is None or not record.measured:
        raise FacetFilmError("{material} has no Principled BSDF that comes close: name a measured preset.",
                             material=record.title)
    material = bpy.data.materials.new(name or record.title)
    enable_nodes(material)
    tree = material.node_tree
    tree.nodes.clear()
    shader = tree.nodes.new("ShaderNodeBsdfPrincipled")
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    output.location = (300, 0)
    tree.links.new(shader.outputs[0], output.inputs[0])
    sockets = {socket.identifier: socket for socket in shader.inputs}
    for identifier, value in model.principled(record).items():
        sockets[identifier].default_value = value
    material[RECORD_KEY] = record.to_json()
    material.diffuse_color = sockets["Base Color"].default_value[:]
    material.metallic = sockets["Metallic"].default_value
    material.roughness = sockets["Roughness"].default_value
    return material
