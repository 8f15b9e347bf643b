"""The layered RGB model by native closures: light-sampled on every device, and in EEVEE.

A Beckmann lobe for R, a pair of them a channel for T, where the channel's light
leaves the layer, and the interference dealt to them: see
addon.models.layered_rgb.pairs.
"""

from ...operands import part, widen
from ..parameters import add_inputs
from .formulas import rho_d_eq16
from .normals import normal_and_aside
from .pairs import aim, light_of_the_layer, mirrored_lobe, transmitted_lobes
from .parameters import TABLE

__all__ = ["build"]

NUDGE = (0.0003, 0.0005, 0.0007)
"""Turns a lobe's tangent, for where it is the lobe's normal, or 0, the two would span no plane."""


def build(builder):
    """Build the group."""
    sockets = add_inputs(builder, TABLE, "fast")
    view = builder.incoming()
    n0, aside = normal_and_aside(builder, sockets, view)
    light = light_of_the_layer(view, n0, aside, sockets.r1, sockets.d, sockets.wavelengths, sockets.e0, sockets.e1,
                               sockets.published)
    mirrored = mirrored_lobe(view, n0, aside, light)
    closures = [_closure(builder, mirrored, sockets.specular)]
    for half in light.halves:
        aimed = aim(light.exits, light.outer, half, light.t, sockets.r1)
        closures.append(_transmitted(builder, n0, aside, light.exits, half, aimed, sockets.specular))
    with builder.frame("specular ρ + diffuse ρ_d/π"):
        albedo = rho_d_eq16(sockets.r1, sockets.d, sockets.wavelengths, sockets.published)
        native = builder.node("ShaderNodeBsdfDiffuse", {
            "Color": albedo * widen(sockets.diffuse), "Normal": n0})
        builder.output("BSDF", builder.add_shaders(*closures, native))


@part("Lobes of T")
def _transmitted(builder, n0, aside, exits, half, aimed, specular):
    """The Glossy BSDFs of one lobe a channel."""
    lobes = transmitted_lobes(n0, aside, exits, half, aimed)
    return builder.add_shaders(*(_closure(builder, lobe, specular) for lobe in lobes))


@part("Native Lobe of the Layer")
def _closure(builder, lobe, specular):
    """The Glossy BSDF of one lobe."""
    return builder.node("ShaderNodeBsdfAnisotropic", {
        "Color": lobe.colour * widen(specular), "Roughness": lobe.roughness, "Anisotropy": lobe.anisotropy,
        "Normal": lobe.normal, "Tangent": lobe.tangent + NUDGE}, distribution="BECKMANN")
