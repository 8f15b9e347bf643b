"""Layered RGB materials: the model's group node, the thickness field before it, wired to the output."""

import json

from ..layered_parameters import LayeredRGB
from .compat import enable_nodes
from .groups import group_id, node_group, socket_named

__all__ = ["LAYERED_GROUP_OF", "apply_layered_rgb", "layered_node", "layered_parameters_of"]

LAYERED_GROUP_OF = {"fast": "layered_rgb_fast", "exact": "layered_rgb_exact"}
"""Realisation -> id of the node group that renders it."""

THICKNESS_GROUP = "layer_thickness"
RECORD_KEY = "facet_film"


def apply_layered_rgb(material, parameters, realisation, record):
    """Make the material a layered RGB one of these parameters, in place of what fed its surface.

    A node of ours that is there keeps its links where the parameters leave the
    socket alone; record is kept in the material as JSON.
    """
    enable_nodes(material)
    tree = material.node_tree
    node = layered_node(material)
    if node is None:
        tree.nodes.clear()
        node = tree.nodes.new("ShaderNodeGroup")
        output = tree.nodes.new("ShaderNodeOutputMaterial")
        output.location = (300, 0)
        node.width = 240
    else:
        output = next(link.to_node for link in tree.links if link.from_node == node)
    node.node_tree = node_group(LAYERED_GROUP_OF[realisation])
    node.label = node.node_tree.name
    tree.links.new(node.outputs[0], output.inputs[0])
    set_sockets(node, parameters)
    set_thickness(tree, node, parameters)
    material[RECORD_KEY] = json.dumps(record)
    material.diffuse_color = (*_viewport_colour(parameters), 1.0)
    material.metallic = 0.0
    material.roughness = (2.0 / (parameters.exponent_r + 2.0)) ** 0.25


def set_sockets(node, parameters):
    """Write the parameters into the group node's sockets."""
    values = {
        "Specular": parameters.specular, "Diffuse": parameters.diffuse,
        "Refractive Index": parameters.ior, "Wavelengths": parameters.wavelengths,
        "Exponent R": parameters.exponent_r, "Exponent T": parameters.exponent_t,
        "Deviation": parameters.deviation, "Azimuth": parameters.azimuth,
        "Published Scale": float(parameters.scale == "published"),
        "Sampling Width": parameters.sampling_width,
    }
    if parameters.thickness is not None:
        values["Thickness"] = parameters.thickness
    for name, value in values.items():
        try:
            socket_named(node, name).default_value = value
        except KeyError:
            if name != "Sampling Width":  # which the exact group alone has
                raise


def set_thickness(tree, node, parameters):
    """Put the thickness field before the model's node, or take it away for a constant thickness."""
    field = next((n for n in tree.nodes if n.bl_idname == "ShaderNodeGroup"
                  and group_id(n.node_tree) == THICKNESS_GROUP), None)
    if parameters.thickness_range is None:
        if field is not None:
            tree.nodes.remove(field)
        return
    if field is None:
        field = tree.nodes.new("ShaderNodeGroup")
        field.node_tree = node_group(THICKNESS_GROUP)
        field.location = (node.location.x - 280, node.location.y)
        field.width = 200
    least, greatest = parameters.thickness_range
    for name, value in {"Least Thickness": least, "Greatest Thickness": greatest,
                        "Noise Scale": parameters.noise_scale, "Noise Detail": parameters.noise_detail,
                        "Deviation": parameters.deviation}.items():
        socket_named(field, name).default_value = value
    tree.links.new(field.outputs["Thickness"], socket_named(node, "Thickness"))
    lower = socket_named(node, "Lower Normal")
    if parameters.correlated:
        tree.links.new(field.outputs["Lower Normal"], lower)
    else:
        for link in [link for link in lower.links if link.from_node == field]:
            tree.links.remove(link)


def layered_parameters_of(material):
    """The parameters that the material's nodes hold; textures on a socket are not seen."""
    node = layered_node(material)

    def value(of, name):
        found = socket_named(of, name).default_value
        return tuple(found)[:3] if hasattr(found, "__len__") else found
    field = next((link.from_node for link in socket_named(node, "Thickness").links
                  if link.from_node.bl_idname == "ShaderNodeGroup"
                  and group_id(link.from_node.node_tree) == THICKNESS_GROUP), None)
    if field is None:
        thickness = {"thickness": value(node, "Thickness")}
    else:
        thickness = {"thickness_range": (value(field, "Least Thickness"), value(field, "Greatest Thickness")),
                     "noise_scale": value(field, "Noise Scale"), "noise_detail": value(field, "Noise Detail"),
                     "correlated": bool(socket_named(node, "Lower Normal").links)}
    if group_id(node.node_tree) == LAYERED_GROUP_OF["exact"]:
        thickness["sampling_width"] = value(node, "Sampling Width")
    return LayeredRGB(
        specular=value(node, "Specular"), diffuse=value(node, "Diffuse"), ior=value(node, "Refractive Index"),
        wavelengths=value(node, "Wavelengths"), exponent_r=value(node, "Exponent R"),
        exponent_t=value(node, "Exponent T"), deviation=value(node, "Deviation"), azimuth=value(node, "Azimuth"),
        scale="published" if value(node, "Published Scale") > 0.5 else "energy", **thickness)


def layered_node(material):
    """The node of one of the layered groups that the material renders with, or None."""
    if material is None or material.node_tree is None:
        return None
    for node in material.node_tree.nodes:
        if node.bl_idname == "ShaderNodeGroup" and group_id(node.node_tree) in LAYERED_GROUP_OF.values():
            return node
    return None


def _viewport_colour(parameters):
    """Colour for the Solid viewport: the diffuse albedo at the middle thickness."""
    import numpy as np

    from ..reflectance.layered_rgb import rho_d_eq16
    thickness = parameters.thickness if parameters.thickness_range is None else sum(parameters.thickness_range) / 2
    return np.clip(rho_d_eq16(np.array(parameters.ior), thickness, np.array(parameters.wavelengths)), 0.0, 1.0).tolist()
