"""Fields of the layer's thickness, Perlin noise or a texture, and the lower normal tilted along them."""

from ..operands import clip, dot, less, tan, where
from .builder import GroupBuilder

__all__ = ["NAME", "VERSION", "build"]

NAME = "Layer Thickness"
VERSION = 1

NOTHING = 1e-12
SPREAD = 1.6
"""Noise keeps to the middle of [0, 1]: spread by this much it reaches both thicknesses."""


def build():
    """The node group, newly built."""
    builder = GroupBuilder(NAME)
    least = builder.input("Least Thickness", 66.0, minimum=0.0, maximum=100000.0,
                          description="Thickness in nanometres where the field is 0")
    greatest = builder.input("Greatest Thickness", 76.0, minimum=0.0, maximum=100000.0,
                             description="Thickness in nanometres where the field is 1")
    scale = builder.input("Noise Scale", 3.0, minimum=0.001, maximum=100000.0,
                          description="Features of the field per unit of its coordinates")
    detail = builder.input("Noise Detail", 2.0, minimum=0.0, maximum=15.0,
                           description="Octaves of the Perlin noise")
    texture = builder.input("Texture", 0.5, minimum=0.0, maximum=1.0, subtype="FACTOR",
                            description="A field of your own between 0 and 1, a texture's for instance")
    share = builder.input("Texture Share", 0.0, minimum=0.0, maximum=1.0, subtype="FACTOR",
                          description="0: Perlin noise alone; 1: the texture alone")
    deviation = builder.input(
        "Deviation", 0.0, minimum=0.0, maximum=1.5, subtype="ANGLE",
        description="Tilt of Lower Normal where the field climbs from 0 to 1 within one feature")
    coordinates = builder.input(
        "Vector", kind="VECTOR", hide_value=True,
        description="Coordinates of the noise; the object's where nothing is plugged in")
    normal = builder.input(
        "Normal", kind="VECTOR", hide_value=True,
        description="Normal of the upper boundary; the surface's own where nothing is plugged in")
    with builder.frame("Field"):
        own = builder.node("ShaderNodeTexCoord", output="Object")
        at = where(less(dot(coordinates, coordinates), NOTHING), own, coordinates)
        noise = builder.node("ShaderNodeTexNoise", {"Vector": at, "Scale": scale, "Detail": detail}, "Fac")
        noise = clip(0.5 + SPREAD * (noise - 0.5), 0.0, 1.0)
        field = noise + share * (texture - noise)
    with builder.frame("Lower normal"):
        tilted = builder.node("ShaderNodeBump", {
            "Height": field, "Distance": tan(deviation) / scale, "Strength": 1.0,
            "Normal": builder.normal(normal)})
    builder.output("Thickness", least + (greatest - least) * field, description="Thickness in nanometres")
    builder.output("Field", field, description="The field between 0 and 1")
    builder.output("Lower Normal", tilted,
                   description="Normal n1 of the lower boundary, tilted along the gradient")
    return builder.finish()
