"""The normals of both boundaries, which every realisation of the layered RGB model by nodes shares."""

from ...operands import cross, dot, less, normalize, part, where
from ...reflectance.directions import facing
from .formulas import tilted_normal

__all__ = ["normals"]

NOTHING = 1e-8


@part("Normals of the Layer", "n0", "n1")
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
