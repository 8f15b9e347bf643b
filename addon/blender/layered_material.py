"""The layered RGB model: which groups render it, its parameters in a group node's sockets, its thickness field."""

from ..layered_parameters import LayeredRGB
from .groups import group_id, input_names, node_group, socket_named

__all__ = ["GROUP_OF", "F82_GROUP_OF", "write", "read", "show_in_viewport"]

GROUP_OF = {
    "fast": "layered_rgb_fast",
    "exact": "layered_rgb_exact",
    "osl": "layered_rgb_osl",
    "osl_fast": "layered_rgb_osl_fast",
}
"""Realisation -> id of the node group that renders it."""

F82_GROUP_OF = GROUP_OF
"""The model has a Fresnel term of its own."""

THICKNESS_GROUP = "layer_thickness"
FIELD_WIDTH = 200
WIDTH = "Sampling Width"


def write(node, parameters):
    """Write the parameters into the group node's sockets, with a thickness field before it where they ask for one."""
    values = {
        "Specular": parameters.specular, "Diffuse": parameters.diffuse,
        "Refractive Index": parameters.ior, "Wavelengths": parameters.wavelengths,
        "Exponent R": parameters.exponent_r, "Exponent T": parameters.exponent_t,
        "Deviation": parameters.deviation, "Azimuth": parameters.azimuth,
        "Published Scale": float(parameters.scale == "published"),
    }
    if parameters.thickness is not None:
        values["Thickness"] = parameters.thickness
    if WIDTH in input_names(node.node_tree):
        values[WIDTH] = parameters.sampling_width
    for name, value in values.items():
        socket_named(node, name).default_value = value
    _write_thickness(node.id_data, node, parameters)


def _write_thickness(tree, node, parameters):
    field = _field(node)
    if parameters.thickness_range is None:
        if field is not None:
            tree.nodes.remove(field)
        return
    if field is None:
        field = tree.nodes.new("ShaderNodeGroup")
        field.node_tree = node_group(THICKNESS_GROUP)
        field.location = (node.location.x - FIELD_WIDTH - 80, node.location.y)
        field.width = FIELD_WIDTH
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


def _field(node):
    """The thickness field that feeds the node, or None."""
    return next((link.from_node for link in socket_named(node, "Thickness").links
                 if group_id(getattr(link.from_node, "node_tree", None)) == THICKNESS_GROUP), None)


def read(node):
    """The parameters that the nodes hold; textures on a socket are not seen."""
    def value(name, of=node):
        found = socket_named(of, name).default_value
        return tuple(found)[:3] if hasattr(found, "__len__") else found
    field = _field(node)
    if field is None:
        held = {"thickness": value("Thickness")}
    else:
        held = {"thickness_range": (value("Least Thickness", field), value("Greatest Thickness", field)),
                "noise_scale": value("Noise Scale", field), "noise_detail": value("Noise Detail", field),
                "correlated": socket_named(node, "Lower Normal").is_linked}
    if WIDTH in input_names(node.node_tree):
        held["sampling_width"] = value(WIDTH)
    return LayeredRGB(
        specular=value("Specular"), diffuse=value("Diffuse"), ior=value("Refractive Index"),
        wavelengths=value("Wavelengths"), exponent_r=value("Exponent R"), exponent_t=value("Exponent T"),
        deviation=value("Deviation"), azimuth=value("Azimuth"),
        scale="published" if value("Published Scale") > 0.5 else "energy", **held)


def show_in_viewport(material, parameters):
    """Colour and gloss for the Solid viewport: the diffuse albedo at the middle thickness."""
    import numpy as np

    from ..reflectance.layered_rgb import rho_d_eq16
    middle = parameters.thickness if parameters.thickness_range is None else sum(parameters.thickness_range) / 2.0
    colour = np.clip(rho_d_eq16(np.array(parameters.ior), middle, np.array(parameters.wavelengths)), 0.0, 1.0)
    material.diffuse_color = (*colour.tolist(), 1.0)
    material.metallic = 0.0
    material.roughness = (2.0 / (parameters.exponent_r + 2.0)) ** 0.25
