"""Cook-Torrance itself: the published formula with the V-cavity G, sampled by drawing facets.

For every sample of a pixel the nodes draw one facet H, and a Glossy BSDF about
H carries the weight f (N.L)/p(L): see addon.models.cook_torrance.sampler.
At Sampling Width 0 the Glossy BSDF is a mirror, and Cycles integrates exactly
the formula.  Above 0 it is a narrow lobe, which light sampling reaches, and
native Metallic lobes carry the share of the light that lies under the formula.
Products start with what is constant as a rule, so that Cycles folds away what
a material does not use.
"""

from ...operands import dot, less, rotate, sqrt, where, widen
from ...reflectance.directions import PI, facing
from ...reflectance.fresnel import f82_factor, tinted
from ...reflectance.sampling import chosen, narrow_slope, wide_slope
from ...reflectance.slopes import along_across
from ..parameters import add_inputs
from .parameters import TABLE, slope_operands
from .sampler import (
    FLANKS,
    HEADROOM,
    facet,
    facet_weight,
    kept,
    native_fresnel,
    native_lobe,
    native_over_d,
    native_slope,
    scales,
    stretched,
)

__all__ = ["build"]

FACET, SLOPE, DISTRIBUTION, ROULETTE = range(1, 5)
"""The random numbers of a sample, each a dimension of its own."""


def build(builder):
    """Build the group."""
    sockets = add_inputs(builder, TABLE, "exact")
    surface = _Surface(builder, sockets)
    with builder.frame("R = s Rs + d Rd"):
        specular = builder.add_shaders(surface.drawn_lobe(), surface.native_lobes())
        diffuse = builder.node("ShaderNodeBsdfDiffuse", {"Color": sockets.tint * sockets.diffuse,
                                                         "Normal": surface.normal})
        total = builder.add_shaders(specular, builder.scale_shader(1.0 - sockets.specular, diffuse))
    builder.output("BSDF", total)


class _Surface:
    """What the lobes of one material share."""

    def __init__(self, builder, sockets):
        self.builder, self.sockets = builder, sockets
        self.slopes = slope_operands(sockets)
        self.view = builder.incoming()
        self.normal = facing(builder.normal(sockets.normal), self.view)
        self.n_v = dot(self.normal, self.view)
        self.n, self.k = tinted(sockets.n, sockets.k, sockets.tint)
        self.fresnel_82 = native_fresnel(self.n, self.k)
        with builder.frame("Frame"):
            self.tangent = rotate(builder.tangent(sockets.tangent), self.normal, (2.0 * PI) * sockets.rotation)
        with builder.frame("Width > 0"):
            self.has_width = less(0.0, sockets.width)
            self.has_native = self.has_width * (1.0 - less(0.0, sockets.anisotropy))

    def drawn_lobe(self):
        """The Glossy BSDF about a drawn facet, with what the native lobes leave of f."""
        builder, sockets = self.builder, self.sockets
        slopes, weights = zip(*self.slopes)
        shares, leans = zip(*[native_lobe(self.n_v, m) for m in slopes])
        with builder.frame("Width > 0"):
            narrow, wide = zip(*[self._lobe_slopes(m) for m in slopes])
        with builder.frame("Draw"):
            m, share, lean, a, wide = chosen(builder.random(SLOPE), weights, slopes, shares, leans, narrow, wide)
            gaussian = less(0.0, sockets.gaussian) * less(builder.random(DISTRIBUTION), sockets.gaussian)
            tilt, azimuth, side = builder.three_randoms(FACET)
        with builder.frame("Roulette"):
            probability = where(self.has_native, kept(share), 1.0)
            shown = less(builder.random(ROULETTE), probability)
        ellipse = stretched(self.normal, self.tangent, m, sockets.anisotropy)
        x = facet(self.normal, self.view, m, a, wide, FLANKS * self.has_native, gaussian, tilt, azimuth, side, ellipse)
        with builder.frame("Draw"):
            weight = sockets.specular * sum(weights[1:], weights[0])
        scale, native_scale = scales(m, gaussian, sockets.published, sockets.gaussian_c, ellipse)
        native = (self.has_native * (native_scale * HEADROOM) * share) * native_over_d(x, m, lean)
        f0, tint = self.fresnel_82
        colour = facet_weight(x, scale, native, self.n, self.k, f0, f82_factor(f0, tint), weight, probability)
        with builder.frame("Draw"):
            squeezed = sqrt(x.narrow / x.broad)
            glossy = builder.node("ShaderNodeBsdfAnisotropic", {
                "Color": colour, "Normal": x.h, "Tangent": x.lobe_tangent,
                "Roughness": sqrt(x.narrow / squeezed), "Anisotropy": 1.0 - squeezed,
            }, distribution="BECKMANN")
            return builder.scale_shader(shown, glossy)

    def _lobe_slopes(self, m):
        """Slopes of the lobes about drawn facets, before they are stretched: never wider than on a round surface."""
        longest, _ = along_across(m, self.sockets.anisotropy)
        shorter, width = m / longest, self.sockets.width
        return narrow_slope(longest, width) * shorter, wide_slope(longest, width) * shorter

    def native_lobes(self):
        """The Metallic BSDFs under f, one for each slope; nothing at Sampling Width 0, nor under an anisotropic f.

        A closure's weight is held to 1, so the published scale adds up four equal ones.
        """
        builder, published = self.builder, self.sockets.published
        once = builder.add_shaders(*[self._native_lobe(m, w) for m, w in self.slopes])
        twice = builder.add_shaders(once, once)
        return builder.node("ShaderNodeMixShader", {
            "Fac": published, "Shader": once, "Shader_001": builder.add_shaders(twice, twice)})

    def _native_lobe(self, m, w):
        sockets = self.sockets
        share, lean = native_lobe(self.n_v, m)
        f0, tint = self.fresnel_82
        metallic = self.builder.node("ShaderNodeBsdfMetallic", {
            "Base Color": f0, "Edge Tint": tint, "Roughness": sqrt(native_slope(m)),
            "Normal": self.normal + widen(lean) * self.view,
        }, distribution="BECKMANN", fresnel_type="F82")
        _, native_scale = scales(m, sockets.gaussian, sockets.published, sockets.gaussian_c)
        part = HEADROOM * native_scale / (1.0 + 3.0 * sockets.published)
        return self.builder.scale_shader((w * sockets.specular * self.has_native * part) * share, metallic)
