"""Layered RGB materials: the model's group node, the thickness field before it, wired to the output."""

import json

from ..layered_parameters import LayeredRGB
from .compat import enable_nodes
from .groups import group_id, node_group, socket_named
from .osl_nodes import new_script_node, script_id, script_socket

__all__ = ["LAYERED_REALISATIONS", "apply_layered_rgb", "layered_node", "layered_parameters_of",
           "layered_realisation_of", "layered_socket"]

GROUP_OF = {"fast": "layered_rgb_fast", "exact": "layered_rgb_exact"}
"""Realisation -> id of the node group that renders it."""

SCRIPT = "layered_rgb"
EXACT_OF = {"osl": 1, "osl_fast": 0}
"""Realisation -> what the OSL shader's switch stands at."""

LAYERED_REALISATIONS = (*GROUP_OF, *EXACT_OF)
THICKNESS_GROUP = "layer_thickness"
RECORD_KEY = "facet_film"


def apply_layered_rgb(material, parameters, realisation, record):
    """Make the material a layered RGB one of these parameters, in place of what fed its surface.

    What is linked to a node of ours that is there already stays linked.  record
    is kept in the material as JSON.  Raises FacetFilmError, before anything is
    changed, where the realisation needs OSL and there is none.
    """
    enable_nodes(material)
    tree = material.node_tree
    old = layered_node(material)
    node = _new_node(tree, realisation)
    if old is None:
        for other in [other for other in tree.nodes if other != node]:
            tree.nodes.remove(other)
        output = tree.nodes.new("ShaderNodeOutputMaterial")
        output.location = (300, 0)
    else:
        output = next(link.to_node for link in tree.links if link.from_node == old)
        node.location = old.location
        _move_links(tree, old, node)
        tree.nodes.remove(old)
    node.width = 240
    tree.links.new(node.outputs[0], output.inputs[0])
    set_sockets(node, parameters)
    set_thickness(tree, node, parameters)
    material[RECORD_KEY] = json.dumps(record)
    material.diffuse_color = (*_viewport_colour(parameters), 1.0)
    material.metallic = 0.0
    material.roughness = (2.0 / (parameters.exponent_r + 2.0)) ** 0.25


def _new_node(tree, realisation):
    if realisation in GROUP_OF:
        node = tree.nodes.new("ShaderNodeGroup")
        node.node_tree = node_group(GROUP_OF[realisation])
        node.label = node.node_tree.name
        return node
    node = new_script_node(tree, SCRIPT)
    node.label = "Layered RGB (OSL)"
    node.inputs["Exact"].default_value = EXACT_OF[realisation]
    return node


def _move_links(tree, old, new):
    """Feed the new node by what feeds the old one."""
    names = [name for name in _socket_names() if _has(old, name) and _has(new, name)]
    for name in names:
        for link in list(layered_socket(old, name).links):
            tree.links.new(link.from_socket, layered_socket(new, name))


def _socket_names():
    return ("Specular", "Diffuse", "Thickness", "Refractive Index", "Exponent R", "Exponent T", "Deviation",
            "Azimuth", "Wavelengths", "Published Scale", "Normal", "Lower Normal", "Tangent", "Sampling Width")


def layered_socket(node, name):
    """The input with this name, "Refractive Index" for instance, of the group or Script node of the model."""
    return socket_named(node, name) if node.bl_idname == "ShaderNodeGroup" else script_socket(node, name)


def _has(node, name):
    try:
        layered_socket(node, name)
    except KeyError:
        return False
    return True


def set_sockets(node, parameters):
    """Write the parameters into the node's sockets."""
    values = {
        "Specular": parameters.specular, "Diffuse": parameters.diffuse,
        "Refractive Index": parameters.ior, "Wavelengths": parameters.wavelengths,
        "Exponent R": parameters.exponent_r, "Exponent T": parameters.exponent_t,
        "Deviation": parameters.deviation, "Azimuth": parameters.azimuth,
        "Published Scale": float(parameters.scale == "published"),
    }
    if parameters.thickness is not None:
        values["Thickness"] = parameters.thickness
    if _has(node, "Sampling Width"):  # all but the fast group
        values["Sampling Width"] = parameters.sampling_width
    for name, value in values.items():
        layered_socket(node, name).default_value = value


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
    tree.links.new(field.outputs["Thickness"], layered_socket(node, "Thickness"))
    lower = layered_socket(node, "Lower Normal")
    if parameters.correlated:
        tree.links.new(field.outputs["Lower Normal"], lower)
    else:
        for link in [link for link in lower.links if link.from_node == field]:
            tree.links.remove(link)


def layered_parameters_of(material):
    """The parameters that the material's nodes hold; textures on a socket are not seen."""
    node = layered_node(material)

    def value(name):
        return _plain(layered_socket(node, name).default_value)
    field = next((link.from_node for link in layered_socket(node, "Thickness").links
                  if group_id(getattr(link.from_node, "node_tree", None)) == THICKNESS_GROUP), None)
    if field is None:
        held = {"thickness": value("Thickness")}
    else:
        least, greatest, scale, detail = (
            _plain(socket_named(field, name).default_value)
            for name in ("Least Thickness", "Greatest Thickness", "Noise Scale", "Noise Detail"))
        held = {"thickness_range": (least, greatest), "noise_scale": scale, "noise_detail": detail,
                "correlated": bool(layered_socket(node, "Lower Normal").links)}
    if _has(node, "Sampling Width"):
        held["sampling_width"] = value("Sampling Width")
    return LayeredRGB(
        specular=value("Specular"), diffuse=value("Diffuse"), ior=value("Refractive Index"),
        wavelengths=value("Wavelengths"), exponent_r=value("Exponent R"), exponent_t=value("Exponent T"),
        deviation=value("Deviation"), azimuth=value("Azimuth"),
        scale="published" if value("Published Scale") > 0.5 else "energy", **held)


def _plain(value):
    return tuple(value)[:3] if hasattr(value, "__len__") else value


def layered_node(material):
    """The node of the layered model, group or Script, that the material renders with, or None."""
    if material is None or material.node_tree is None:
        return None
    for node in material.node_tree.nodes:
        if node.bl_idname == "ShaderNodeGroup" and group_id(node.node_tree) in GROUP_OF.values():
            return node
        if script_id(node) == SCRIPT:
            return node
    return None


def layered_realisation_of(material):
    """"fast", "exact", "osl" or "osl_fast", or None for a material of another kind."""
    node = layered_node(material)
    if node is None:
        return None
    if node.bl_idname == "ShaderNodeGroup":
        return next(name for name, group in GROUP_OF.items() if group == group_id(node.node_tree))
    return "osl" if node.inputs["Exact"].default_value else "osl_fast"


def _viewport_colour(parameters):
    """Colour for the Solid viewport: the diffuse albedo at the middle thickness."""
    import numpy as np

    from ..reflectance.layered_rgb import rho_d_eq16
    thickness = parameters.thickness if parameters.thickness_range is None else sum(parameters.thickness_range) / 2
    return np.clip(rho_d_eq16(np.array(parameters.ior), thickness, np.array(parameters.wavelengths)), 0.0, 1.0).tolist()
