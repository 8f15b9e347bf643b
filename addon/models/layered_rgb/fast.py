"""The layered RGB model by native closures: light-sampled on every device, and in EEVEE.

A Beckmann lobe for R, one a channel for T, aimed where the channel's light
leaves the layer, and the interference dealt to them: see
addon.models.layered_rgb.lobes.
"""

from ...operands import part, widen
from ..parameters import add_inputs
from .formulas import rho_d_eq16
from .lobes import native_lobes
from .normals import normals
from .parameters import TABLE
from .sampler import roughness_and_anisotropy

__all__ = ["build"]

NUDGE = (0.0003, 0.0005, 0.0007)
"""Turns a lobe's tangent off V, for where V is the lobe's normal the two would span no plane."""


def build(builder):
    """Build the group."""
    sockets = add_inputs(builder, TABLE, "fast")
    view = builder.incoming()
    n0, n1 = normals(builder, sockets, view)
    lobes = native_lobes(view, n0, n1, sockets.r1, sockets.d, sockets.wavelengths, sockets.e0, sockets.e1,
                         sockets.published)
    closures = [_closure(builder, lobe, view, sockets.specular) for lobe in lobes]
    with builder.frame("specular ρ + diffuse ρ_d/π"):
        albedo = rho_d_eq16(sockets.r1, sockets.d, sockets.wavelengths, sockets.published)
        native = builder.node("ShaderNodeBsdfDiffuse", {
            "Color": albedo * widen(sockets.diffuse), "Normal": n0})
        builder.output("BSDF", builder.add_shaders(*closures, native))


@part("Native Lobe of the Layer")
def _closure(builder, lobe, view, specular):
    """The Glossy BSDF of one lobe."""
    roughness, anisotropy = roughness_and_anisotropy(lobe.slope_in, lobe.slope_across)
    return builder.node("ShaderNodeBsdfAnisotropic", {
        "Color": lobe.colour * widen(specular), "Roughness": roughness, "Anisotropy": anisotropy,
        "Normal": lobe.normal, "Tangent": view + NUDGE}, distribution="BECKMANN")
