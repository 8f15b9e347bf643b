"""Granier and Heidrich's layered RGB model itself, sampled: nodes alone, on every device.

For every sample of a pixel the nodes draw a direction L from the lobes of the
model, and a Glossy BSDF about H, half-way between V and L, carries the weight
f (N.L)/p(L): see addon.models.layered_rgb.sampler.  At Sampling Width 0 it
is a mirror, and Cycles integrates exactly the formula; above, a narrow lobe
that light sampling reaches.  The diffuse part is a native Diffuse BSDF.
"""

from ...operands import widen
from ..parameters import add_inputs
from .formulas import rho_d_eq16
from .normals import normals
from .parameters import TABLE
from .sampler import draw, kernel, narrowed, proposal, roughness_and_anisotropy, tapered_width, weight

__all__ = ["build"]

LOBE, COSINE, AZIMUTH = range(1, 4)
"""The random numbers that a sample draws."""


def build(builder):
    """Build the group."""
    sockets = add_inputs(builder, TABLE, "exact")
    view = builder.incoming()
    n0, n1 = normals(builder, sockets, view)
    specular = _drawn_lobe(builder, sockets, view, n0, n1)
    with builder.frame("specular ρ + diffuse ρ_d/π"):
        albedo = rho_d_eq16(sockets.r1, sockets.d, sockets.wavelengths, sockets.published)
        native = builder.node("ShaderNodeBsdfDiffuse", {
            "Color": albedo * widen(sockets.diffuse), "Normal": n0})
        builder.output("BSDF", builder.add_shaders(specular, native))


def _drawn_lobe(builder, sockets, view, n0, n1):
    """The Glossy BSDF, mirror or narrow lobe, about the H of a drawn L."""
    r1 = sockets.r1
    lobes = proposal(view, n0, n1, r1, sockets.e0, sockets.e1)
    narrow = narrowed(lobes, r1, sockets.e0, sockets.e1, _width(builder, lobes, sockets))
    with builder.frame("Draw L"):
        numbers = [builder.random(number) for number in (LOBE, COSINE, AZIMUTH)]
    drawn = draw(lobes, narrow, view, n0, n1, r1, *numbers)
    colour = weight(lobes, narrow, drawn, view, n0, n1, r1, sockets.d, sockets.wavelengths, sockets.e0, sockets.e1,
                    sockets.published)
    lobe = kernel(drawn, view, n0)
    roughness, anisotropy = roughness_and_anisotropy(lobe.slope_along, lobe.slope_across)
    return builder.node("ShaderNodeBsdfAnisotropic", {
        "Color": colour * widen(sockets.specular), "Roughness": roughness, "Anisotropy": anisotropy,
        "Normal": lobe.normal, "Tangent": lobe.tangent}, distribution="BECKMANN")


def _width(builder, lobes, sockets):
    with builder.frame("Narrowed"):
        return tapered_width(lobes, sockets.width)
