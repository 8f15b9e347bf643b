"""The layered RGB model by native closures: light-sampled on every device, and in EEVEE.

A Beckmann lobe for R, one a channel for T, aimed where the channel's light
leaves the layer, and the interference dealt to them: see
addon.reflectance.layered_rgb_fast.
"""

from ..operands import widen
from ..reflectance.layered_rgb import rho_d_eq16
from ..reflectance.layered_rgb_fast import native_lobes
from ..reflectance.layered_rgb_sampler import roughness_and_anisotropy
from .builder import GroupBuilder
from .layered_inputs import layered_inputs, normals

__all__ = ["NAME", "VERSION", "build"]

NAME = "Layered RGB Fast"
VERSION = 1

NUDGE = (0.0003, 0.0005, 0.0007)
"""Turns a lobe's tangent off V, for where V is the lobe's normal the two would span no plane."""


def build():
    """The node group, newly built."""
    builder = GroupBuilder(NAME)
    sockets = layered_inputs(builder)
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
    return builder.finish()


def _closure(builder, lobe, view, specular):
    """The Glossy BSDF of one lobe."""
    with builder.frame("Native lobes"):
        roughness, anisotropy = roughness_and_anisotropy(lobe.slope_in, lobe.slope_across)
        return builder.node("ShaderNodeBsdfAnisotropic", {
            "Color": lobe.colour * widen(specular), "Roughness": roughness, "Anisotropy": anisotropy,
            "Normal": lobe.normal, "Tangent": view + NUDGE}, distribution="BECKMANN")
