"""Cook-Torrance Fast for dielectrics in Blender 4.5, whose conductor Fresnel is far off where k is 0.

The same sockets; F0 and F82 tint are worked out from n and k, and the Metallic
BSDF interpolates between them.
"""

from ..operands import clip
from ..reflectance.fresnel import COS_THETA_82, conductor, f82_tint_of
from .cook_torrance_fast import build_with

__all__ = ["NAME", "VERSION", "build"]

NAME = "Cook-Torrance Fast F82"
VERSION = 1


def build():
    """The node group, newly built."""
    return build_with(NAME, _f82_closure)


def _f82_closure(builder, sockets):
    with builder.frame("F0 and F82 tint of n and k"):
        f0 = conductor(1.0, sockets.n, sockets.k)
        tint = f82_tint_of(f0, conductor(COS_THETA_82, sockets.n, sockets.k))
        return {"Base Color": clip(f0, 0.0, 1.0), "Edge Tint": clip(tint, 0.0, 1.0)}, "F82"
