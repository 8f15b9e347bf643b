"""Cook-Torrance: which groups render it, and its parameters in a group node's sockets."""

from ..parameters import CookTorrance
from .groups import input_names, socket_named

__all__ = ["GROUP_OF", "F82_GROUP_OF", "write", "read", "show_in_viewport"]

GROUP_OF = {
    "fast": "cook_torrance_fast",
    "exact": "cook_torrance_exact",
    "osl": "cook_torrance_osl",
    "osl_fast": "cook_torrance_osl_fast",
}
"""Realisation -> id of the node group that renders it."""

F82_GROUP_OF = {**GROUP_OF, "fast": "cook_torrance_fast_f82"}
"""The same for a dielectric that this Blender's conductor closure misses."""

UNUSED_SLOPES = (0.2, 0.4, 0.1, 0.6)
WIDTH = "Sampling Width"


def write(node, parameters):
    """Write the parameters into the group node's sockets."""
    unused = tuple((m, 0.0) for m in UNUSED_SLOPES[len(parameters.slopes):])
    values = {
        "Specular": parameters.specular,
        "Diffuse Color": (*parameters.diffuse, 1.0),
        "Refractive Index n": parameters.n,
        "Extinction k": parameters.k,
        "Gaussian": float(parameters.distribution == "gaussian"),
        "Published Scale": float(parameters.scale == "published"),
        "Gaussian c": parameters.gaussian_c,
    }
    for j, (m, w) in enumerate(parameters.slopes + unused, 1):
        values[f"Slope {j}"] = m
        values[f"Weight {j}"] = w
    if WIDTH in input_names(node.node_tree):
        values[WIDTH] = parameters.sampling_width
    for name, value in values.items():
        socket_named(node, name).default_value = value


def read(node):
    """The parameters that a group node's sockets hold; textures on a socket are not seen."""
    def value(name):
        found = socket_named(node, name).default_value
        return tuple(found)[:3] if hasattr(found, "__len__") else found
    slopes = tuple((value(f"Slope {j}"), value(f"Weight {j}")) for j in range(1, 5))
    width = {"sampling_width": value(WIDTH)} if WIDTH in input_names(node.node_tree) else {}
    return CookTorrance(
        slopes=tuple(pair for pair in slopes if pair[1] > 0.0) or slopes[:1],
        distribution="gaussian" if value("Gaussian") > 0.5 else "beckmann",
        specular=value("Specular"), n=value("Refractive Index n"), k=value("Extinction k"),
        diffuse=value("Diffuse Color"), scale="published" if value("Published Scale") > 0.5 else "energy",
        gaussian_c=value("Gaussian c"), **width)


def show_in_viewport(material, parameters):
    """Colour and gloss for the Solid viewport: normal reflectance and diffuse, by their shares.

    Not metallic: there is nothing for a metal to mirror there, and it would be dark.
    """
    from ..reflectance.fresnel import conductor
    s = parameters.specular
    colour = [s * float(conductor(1.0, n, k)) + (1.0 - s) * diffuse
              for n, k, diffuse in zip(parameters.n, parameters.k, parameters.diffuse)]
    material.diffuse_color = (*colour, 1.0)
    material.metallic = 0.0
    material.roughness = parameters.slopes[0][0] ** 0.5
