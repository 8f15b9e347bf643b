"""Standard: one index of refraction, by the Glass BSDF, absorption at the back face; and what EEVEE shows."""

from ...operands import sqrt, widen
from ...reflectance.transmission import transmittance
from ..parameters import add_inputs
from .parameters import TABLE
from .surfaces import absorbed, given, mixed, sheet, with_straight_shadows

__all__ = ["build", "build_eevee"]


def build(builder):
    """Build the group."""
    sockets = add_inputs(builder, TABLE, "fast")
    at = given(builder, sockets)
    glass = _glass(builder, sockets, at, absorbed(at) * sqrt(sockets.tint))
    solid = with_straight_shadows(builder, sockets, at, glass)
    builder.output("BSDF", mixed(builder, sockets.thin, solid, sheet(builder, sockets, at)))


def build_eevee(builder):
    """Build what stands in for the others in EEVEE, which knows no length of a path: half of Thickness a face."""
    sockets = add_inputs(builder, TABLE, "fast")
    at = given(builder, sockets)
    half = transmittance(at.sigma, widen(0.5 * sockets.thickness / sockets.scene_scale))
    glass = _glass(builder, sockets, at, half * sqrt(sockets.tint))
    builder.output("BSDF", mixed(builder, sockets.thin, glass, sheet(builder, sockets, at)))


def _glass(builder, sockets, at, colour):
    with builder.frame("Glass"):
        return builder.node("ShaderNodeBsdfGlass", {
            "Color": colour, "IOR": at.n, "Roughness": sockets.roughness, "Normal": at.normal}, distribution="BECKMANN")
