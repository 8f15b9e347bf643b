"""The twin of a material: one Principled BSDF that comes closest, for engines that know no groups of ours."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy

from .. import compat
from .materials import record_of

if TYPE_CHECKING:
    from ...export.standin import Standin

__all__ = ["LOST_KEY", "DELTA_E_KEY", "standin_of_material", "twin_of"]

LOST_KEY, DELTA_E_KEY = "facet_film_lost", "facet_film_delta_e"
COLOURS = ("Base Color", "Specular Tint")


def standin_of_material(material: bpy.types.Material) -> Standin:
    """The addon.export.standin.Standin of one of our materials.  Raises FacetFilmError for one that is not ours."""
    record = record_of(material)
    from ...models.standins import standin_of
    return standin_of(record, compat.working_space())


def twin_of(material: bpy.types.Material, name: str | None = None) -> bpy.types.Material:
    """A new material of one Principled BSDF, in the file's working space; see addon.api.principled_twin."""
    found = standin_of_material(material)
    twin = bpy.data.materials.new(name or f"{material.name} Principled")
    compat.enable_nodes(twin)
    tree = twin.node_tree
    tree.nodes.clear()
    shader, output = (tree.nodes.new(kind) for kind in ("ShaderNodeBsdfPrincipled", "ShaderNodeOutputMaterial"))
    output.location = (300, 0)
    tree.links.new(shader.outputs[0], output.inputs[0])
    _set(shader, found)
    compat.set_refraction(twin, found.transmission > 0.0)
    twin[LOST_KEY], twin[DELTA_E_KEY] = list(found.lost), found.delta_e[0]
    _show(twin, shader)
    return twin


def _set(shader, found):
    from ...bake.colour import converted
    from ...export import principled
    sockets = {socket.identifier: socket for socket in shader.inputs}
    for identifier, value in principled(found).items():
        if identifier in COLOURS:
            value = (*converted(value[:3], "Rec.709", compat.working_space()), 1.0)
        if identifier in sockets:
            sockets[identifier].default_value = value


def _show(material, shader):
    """The same colour, metalness and gloss in the Solid viewport, where exporters without nodes look."""
    sockets = {socket.identifier: socket for socket in shader.inputs}
    material.diffuse_color = sockets["Base Color"].default_value[:]
    material.metallic = sockets["Metallic"].default_value
    material.roughness = sockets["Roughness"].default_value
