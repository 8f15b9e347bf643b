"""Cook-Torrance materials: a group node with its sockets set, wired to the output."""

import json

from ..parameters import CookTorrance
from .compat import enable_nodes
from .groups import group_id, node_group, socket_named

__all__ = ["apply_cook_torrance", "group_node", "parameters_of", "record_of", "realisation_of"]

GROUP_OF = {"fast": "cook_torrance_fast"}
"""Realisation -> id of the node group that renders it."""

F82_GROUP_OF = {"fast": "cook_torrance_fast_f82"}
"""The same where F82 comes closer than this Blender's conductor."""

RECORD_KEY = "facet_film"


def apply_cook_torrance(material, parameters, realisation, record, *, by_f82=False):
    """Make the material a Cook-Torrance of these parameters, in place of what fed its surface.

    record is kept in the material as JSON: what was baked, from which dataset,
    with which error.
    """
    enable_nodes(material)
    tree = material.node_tree
    group = node_group((F82_GROUP_OF if by_f82 else GROUP_OF)[realisation])
    node = group_node(material)
    if node is None:
        tree.nodes.clear()
        node = tree.nodes.new("ShaderNodeGroup")
        output = tree.nodes.new("ShaderNodeOutputMaterial")
        output.location = (300, 0)
        node.width = 240
    else:
        output = next(link.to_node for link in tree.links if link.from_node == node)
    node.node_tree = group
    node.label = group.name
    tree.links.new(node.outputs[0], output.inputs[0])
    set_sockets(node, parameters)
    material[RECORD_KEY] = json.dumps(record)
    material.diffuse_color = (*_viewport_colour(parameters), 1.0)
    material.metallic = parameters.specular
    material.roughness = parameters.slopes[0][0] ** 0.5


def set_sockets(node, parameters):
    """Write the parameters into the group node's sockets."""
    slopes = parameters.slopes + tuple((m, 0.0) for m in (0.4, 0.1, 0.6)[len(parameters.slopes) - 1:])
    values = {
        "Specular": parameters.specular,
        "Diffuse Color": (*parameters.diffuse, 1.0),
        "Refractive Index n": parameters.n,
        "Extinction k": parameters.k,
        "Gaussian": float(parameters.distribution == "gaussian"),
        "Published Scale": float(parameters.scale == "published"),
        "Gaussian c": parameters.gaussian_c,
    }
    for j, (m, w) in enumerate(slopes, 1):
        values[f"Slope {j}"] = m
        values[f"Weight {j}"] = w
    for name, value in values.items():
        socket_named(node, name).default_value = value


def parameters_of(node):
    """The parameters that a group node's sockets hold; textures on a socket are not seen."""
    def value(name):
        found = socket_named(node, name).default_value
        return tuple(found)[:3] if hasattr(found, "__len__") else found
    slopes = tuple((value(f"Slope {j}"), value(f"Weight {j}")) for j in range(1, 5))
    return CookTorrance(
        slopes=tuple(pair for pair in slopes if pair[1] > 0.0) or slopes[:1],
        distribution="gaussian" if value("Gaussian") > 0.5 else "beckmann",
        specular=value("Specular"), n=value("Refractive Index n"), k=value("Extinction k"),
        diffuse=value("Diffuse Color"), scale="published" if value("Published Scale") > 0.5 else "energy",
        gaussian_c=value("Gaussian c"))


def group_node(material):
    """The node of one of our groups that the material renders with, or None."""
    if material is None or material.node_tree is None:
        return None
    for node in material.node_tree.nodes:
        if node.bl_idname == "ShaderNodeGroup" and realisation_of_group(node.node_tree):
            return node
    return None


def realisation_of(material):
    """"fast", "exact" …, or None for a material that is not ours."""
    node = group_node(material)
    return realisation_of_group(node.node_tree) if node else None


def realisation_of_group(tree):
    """The realisation that a node group is, or None for a group that is not ours."""
    identifier = group_id(tree)
    for groups in (GROUP_OF, F82_GROUP_OF):
        for realisation, group in groups.items():
            if group == identifier:
                return realisation
    return None


def record_of(material):
    """What was baked into the material, as create_material wrote it; empty for others."""
    try:
        return json.loads(material.get(RECORD_KEY, "{}"))
    except (TypeError, ValueError):
        return {}


def _viewport_colour(parameters):
    """Colour for the Solid viewport: normal reflectance and diffuse, by their shares."""
    from ..reflectance.fresnel import conductor
    s = parameters.specular
    return [s * float(conductor(1.0, n, k)) + (1.0 - s) * diffuse
            for n, k, diffuse in zip(parameters.n, parameters.k, parameters.diffuse)]
