"""The normals of both boundaries, which every realisation of the layered RGB model by nodes shares."""

from ...operands import cross, dot, less, normalize, part, sin, where, widen
from ...reflectance.directions import facing
from .formulas import tilt_direction, tilted_normal

__all__ = ["normals", "normal_and_aside"]

NOTHING = 1e-8


@part("Normals of the Layer", "n0", "n1")
def normals(builder, sockets, view):
    """n0 and n1 of the surface under the sockets' settings, n0 turned to face V."""
    n0, tangent, bitangent = _surface(builder, sockets, view)
    tilted = tilted_normal(n0, tangent, bitangent, sockets.deviation, sockets.azimuth)
    with builder.frame("n1"):
        n1 = where(less(dot(sockets.lower, sockets.lower), NOTHING), tilted, sockets.lower)
        return n0, normalize(n1)


@part("Normal and Lean of the Layer", "n0", "aside")
def normal_and_aside(builder, sockets, view):
    """n0, and the part of n1 across it: a constant 0 without Deviation and Lower Normal, and so are its products."""
    n0, tangent, bitangent = _surface(builder, sockets, view)
    with builder.frame("aside"):
        tilted = widen(sin(sockets.deviation)) * tilt_direction(tangent, bitangent, sockets.azimuth)
        lower = normalize(sockets.lower)
        across = lower - widen(dot(lower, n0)) * n0
        return n0, where(less(dot(sockets.lower, sockets.lower), NOTHING), tilted, across)


def _surface(builder, sockets, view):
    """n0, and the tangent and bitangent that the azimuth is counted from."""
    with builder.frame("n0"):
        n0 = facing(builder.normal(sockets.normal), view)
        around = builder.node("ShaderNodeTangent", direction_type="RADIAL", axis="Z")
        along = where(less(dot(sockets.tangent, sockets.tangent), NOTHING), around, sockets.tangent)
        bitangent = normalize(cross(n0, along))
        return n0, cross(bitangent, n0), bitangent
