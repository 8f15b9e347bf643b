"""The sockets that every realisation of the layered RGB model shares, in one order that never changes."""

import math
from types import SimpleNamespace

from ..operands import cross, dot, less, normalize, where
from ..reflectance.directions import facing
from ..reflectance.layered_rgb import WAVELENGTHS, tilted_normal

__all__ = ["layered_inputs", "normals"]

NOTHING = 1e-8


def layered_inputs(builder):
    """Add the sockets to the group under construction; return their operands by the paper's names."""
    specular = builder.input(
        "Specular", 1.0, minimum=0.0, maximum=1.0, subtype="FACTOR",
        description="Weight of the specular part with its interference and colour separation")
    diffuse = builder.input(
        "Diffuse", 0.5, minimum=0.0, maximum=1.0, subtype="FACTOR",
        description="Weight of the diffuse part, whose colour the thickness makes")
    d = builder.input(
        "Thickness", 70.0, minimum=0.0, maximum=100000.0,
        description="Thickness d of the layer in nanometres: low ones are reddish, more adds blue and green")
    r1 = builder.input(
        "Refractive Index", (1.4, 1.45, 1.6), "VECTOR", minimum=1.001, maximum=10.0,
        description="Refractive index r1 of the layer for red, green and blue; different ones make rainbows "
                    "where the boundaries deviate")
    e0 = builder.input(
        "Exponent R", 90.0, minimum=0.0, maximum=100000.0,
        description="Phong exponent e0 of the reflected lobe: 10 is dull, 100 satin, 1000 polished")
    e1 = builder.input(
        "Exponent T", 170.0, minimum=0.0, maximum=100000.0,
        description="Phong exponent e1 of the lobe that has passed the layer")
    deviation = builder.input(
        "Deviation", 0.0, minimum=0.0, maximum=math.radians(89.9), subtype="ANGLE",
        description="Angle between the boundaries: splits each highlight in two, one with a rainbow edge")
    azimuth = builder.input(
        "Azimuth", 0.0, minimum=-2.0 * math.pi, maximum=2.0 * math.pi, subtype="ANGLE",
        description="Direction of the deviation about the normal, counted from the tangent")
    wavelengths = builder.input(
        "Wavelengths", WAVELENGTHS, "VECTOR", minimum=1.0, maximum=10000.0, panel="Model",
        description="Wavelengths of red, green and blue in nanometres")
    published = builder.input(
        "Published Scale", 0.0, minimum=0.0, maximum=1.0, subtype="FACTOR", panel="Model",
        description="0: lobes scaled by (e + 2)/(2 pi), diffuse part with its factor of a half; "
                    "1: as printed. Both can reflect more light than arrives")
    normal = builder.input(
        "Normal", kind="VECTOR", hide_value=True,
        description="Normal n0 of the upper boundary; the surface's own where nothing is plugged in")
    lower = builder.input("Lower Normal", kind="VECTOR", hide_value=True,
                          description="Normal n1 of the lower boundary, a Bump node's for instance; "
                                      "takes the place of Deviation and Azimuth")
    tangent = builder.input("Tangent", kind="VECTOR", hide_value=True,
                            description="Direction that the azimuth is counted from; "
                                        "around the object's Z axis where nothing is plugged in")
    return SimpleNamespace(specular=specular, diffuse=diffuse, d=d, r1=r1, e0=e0, e1=e1, deviation=deviation,
                           azimuth=azimuth, wavelengths=wavelengths, published=published, normal=normal,
                           lower=lower, tangent=tangent)


def normals(builder, sockets, view):
    """n0 and n1 of the surface under the sockets' settings, n0 turned to face V."""
    with builder.frame("n0"):
        n0 = facing(builder.normal(sockets.normal), view)
        around = builder.node("ShaderNodeTangent", direction_type="RADIAL", axis="Z")
        along = where(less(dot(sockets.tangent, sockets.tangent), NOTHING), around, sockets.tangent)
        bitangent = normalize(cross(n0, along))
        tangent = cross(bitangent, n0)
    tilted = tilted_normal(n0, tangent, bitangent, sockets.deviation, sockets.azimuth)
    with builder.frame("n1"):
        n1 = where(less(dot(sockets.lower, sockets.lower), NOTHING), tilted, sockets.lower)
        return n0, normalize(n1)
