"""Cook-Torrance itself: the published formula with the V-cavity G, sampled by drawing facets.

For every sample of a pixel the nodes draw one groove, and a Glossy BSDF about
the facet H on each of its two sides carries the weight f (N.L)/p(L): see
addon.models.cook_torrance.sampler.
At Sampling Width 0 the Glossy BSDF is a mirror, and Cycles integrates exactly
the formula.  Above 0 it is a narrow lobe, which light sampling reaches, and
native Metallic lobes carry the share of the light that lies under the formula.
Products start with what is constant as a rule, so that Cycles folds away what
a material does not use.
"""

from types import SimpleNamespace

from ...operands import dot, less, part, rotate, sqrt, where, widen
from ...reflectance.directions import PI, facing
from ...reflectance.fresnel import f82_factor, tinted
from ...reflectance.sampling import narrow_slope, wide_slope
from ...reflectance.slopes import along_across
from ..parameters import add_inputs
from .parameters import TABLE, slope_operands
from .sampler import (
    FLANKS,
    HEADROOM,
    drawn_slope,
    facet,
    facet_weight,
    kept,
    native_fresnel,
    native_lobe,
    native_over_d,
    native_scale,
    native_slope,
    scales,
    stretched,
)
from .scale import in_scale

__all__ = ["build"]

FACET, DISTRIBUTION, ROULETTE = range(1, 4)
"""The random numbers of a sample, each a dimension of its own."""


def build(builder):
    """Build the group."""
    sockets = add_inputs(builder, TABLE, "exact")
    view = builder.incoming()
    normal = facing(builder.normal(sockets.normal), view)
    n, k = tinted(sockets.n, sockets.k, sockets.tint)
    with builder.frame("Frame"):
        tangent = rotate(builder.tangent(sockets.tangent), normal, (2.0 * PI) * sockets.rotation)
        surface = SimpleNamespace(normal=normal, tangent=tangent, view=view, n_v=dot(normal, view),
                                  anisotropy=sockets.anisotropy)
    with builder.frame("Width > 0"):
        has_native = less(0.0, sockets.width)
    f0, tint = native_fresnel(n, k)
    index = SimpleNamespace(n=n, k=k, f0=f0, tint=tint)
    scale = SimpleNamespace(gaussian=sockets.gaussian, published=sockets.published, gaussian_c=sockets.gaussian_c)
    slopes = [SimpleNamespace(m=m, w=w) for m, w in slope_operands(sockets)]
    with builder.frame("R = s Rs + d Rd"):
        specular = builder.add_shaders(
            _drawn_lobe(builder, slopes, sockets.specular, sockets.width, has_native, scale, surface, index),
            _native_lobes(builder, slopes, sockets.specular, has_native, scale, surface, index))
        diffuse = builder.node("ShaderNodeBsdfDiffuse", {"Color": sockets.tint * sockets.diffuse, "Normal": normal})
        total = builder.add_shaders(specular, builder.scale_shader(1.0 - sockets.specular, diffuse))
    builder.output("BSDF", total)


@part("Drawn Lobe")
def _drawn_lobe(builder, slopes, specular, width, has_native, scale, surface, index):
    """The Glossy BSDFs about both sides of a drawn groove, with what the native lobes leave of f."""
    with builder.frame("Draw"):
        gaussian = less(0.0, scale.gaussian) * less(builder.random(DISTRIBUTION), scale.gaussian)
        tilt, azimuth, which = builder.three_randoms(FACET)
    slope = _chosen_slope(which, has_native, slopes, surface.n_v, width, surface.anisotropy)
    with builder.frame("Roulette"):
        probability = where(has_native, kept(slope.share), 1.0)
        shown = less(builder.random(ROULETTE), probability)
    ellipse = stretched(surface.normal, surface.tangent, slope.m, surface.anisotropy)
    whole, scale_under = scales(slope.m, gaussian, scale.published, scale.gaussian_c, ellipse)
    with builder.frame("Native"):
        native = has_native * (scale_under * HEADROOM) * slope.share
    drawing = SimpleNamespace(flanks=FLANKS * has_native, gaussian=gaussian, tilt=tilt, azimuth=azimuth)
    weights = SimpleNamespace(whole=whole, native=native, all=specular * slope.weight, probability=probability)
    sides = [_side(builder, side, slope, drawing, ellipse, weights, surface, index) for side in (1.0, -1.0)]
    return builder.scale_shader(shown, builder.add_shaders(*sides))


@part("Side of a Groove")
def _side(builder, side, slope, drawing, ellipse, weights, surface, index):
    """The Glossy BSDF about the facet on one side, 1 or −1, of a drawn groove."""
    x = facet(surface.normal, surface.view, slope.m, slope.narrow, slope.wide, drawing.flanks, drawing.gaussian,
              drawing.tilt, drawing.azimuth, None, ellipse, side)
    with builder.frame("Native"):
        native = weights.native * native_over_d(x, slope.m, slope.lean)
    colour = facet_weight(x, weights.whole, native, index.n, index.k, index.f0, f82_factor(index.f0, index.tint),
                          weights.all, weights.probability)
    return _glossy(builder, colour, x.h, x.lobe_tangent, x.narrow, x.broad)


@part("Native Lobes")
def _native_lobes(builder, slopes, specular, has_native, scale, surface, index):
    """The Metallic BSDFs under f, one for each slope; nothing at Sampling Width 0."""
    once = builder.add_shaders(*[
        _native_lobe(builder, slope.m, slope.w, specular, has_native, scale, surface, index) for slope in slopes])
    return in_scale(builder, once, scale.published)


@part("Drawn Slope")
def _chosen_slope(u, has_native, slopes, n_v, width, anisotropy):
    """One of the slopes, with what its lobes need and what it weighs for all, by name."""
    slopes, weights = zip(*[(slope.m, slope.w) for slope in slopes])
    shares, leans = zip(*[_native_share(n_v, m, anisotropy) for m in slopes])
    narrow, wide = zip(*[_lobe_slopes(m, width, anisotropy) for m in slopes])
    m, weight, share, lean, narrow, wide = drawn_slope(u, has_native, slopes, weights, shares, leans, narrow, wide)
    return SimpleNamespace(m=m, share=share, lean=lean, narrow=narrow, wide=wide, weight=weight)


@part("Share under the Lobe", "share", "lean")
def _native_share(n_v, m, anisotropy):
    """Of :func:`native_lobe`: for stretched slopes that of the longest, upright, for the lean is askew to them."""
    longest, _ = along_across(m, anisotropy)
    share, lean = native_lobe(n_v, longest)
    return share, lean * (1.0 - less(0.0, anisotropy))


@part("Slopes of the Drawn Lobe", "narrow", "wide")
def _lobe_slopes(m, width, anisotropy):
    """Slopes of the lobes about drawn facets, before they are stretched: never wider than on a round surface."""
    longest, _ = along_across(m, anisotropy)
    shorter = m / longest
    return narrow_slope(longest, width) * shorter, wide_slope(longest, width) * shorter


@part("Lobe about the Facet")
def _glossy(builder, colour, h, tangent, narrow, broad):
    """A Glossy BSDF about H with the slope `narrow` along the tangent, and `broad` across it."""
    squeezed = sqrt(narrow / broad)
    return builder.node("ShaderNodeBsdfAnisotropic", {
        "Color": colour, "Normal": h, "Tangent": tangent, "Roughness": sqrt(narrow / squeezed),
        "Anisotropy": 1.0 - squeezed}, distribution="BECKMANN")


@part("Native Beckmann Lobe")
def _native_lobe(builder, m, w, specular, has_native, scale, surface, index):
    """The Metallic BSDF under f for one slope."""
    share, lean = _native_share(surface.n_v, m, surface.anisotropy)
    longest, shortest = along_across(m, surface.anisotropy)
    aspect2 = shortest / longest
    metallic = builder.node("ShaderNodeBsdfMetallic", {
        "Base Color": index.f0, "Edge Tint": index.tint, "Roughness": sqrt(native_slope(longest) * sqrt(aspect2)),
        "Anisotropy": (1.0 - aspect2) / 0.9, "Tangent": surface.tangent,
        "Normal": surface.normal + widen(lean) * surface.view,
    }, distribution="BECKMANN", fresnel_type="F82")
    ellipse = stretched(surface.normal, surface.tangent, m, surface.anisotropy)
    under = native_scale(m, scale.gaussian, scale.published, scale.gaussian_c, ellipse)
    quarter = HEADROOM * under / (1.0 + 3.0 * scale.published)
    return builder.scale_shader((w * specular * has_native * quarter) * share, metallic)
