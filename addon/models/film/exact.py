"""A film by the formula itself, sampled by drawing facets: F is the table at V·H of the facet that is drawn.

See addon.models.cook_torrance.sampler, whose facets these are.  Above Sampling
Width 0 a native lobe carries what lies under the formula whatever V·H: the
least of three looks around its mean, by channel.
"""

from ...operands import clip, less, maximum, minimum, sqrt, where, widen, x_of, y_of, z_of
from ...reflectance.film_facets import mean_v_h, spread_v_h
from ...reflectance.sampling import narrow_slope, wide_slope
from ..cook_torrance.sampler import (
    FLANKS,
    HEADROOM,
    facet,
    native_lobe,
    native_over_d,
    native_slope,
    sharpened_v_cavity,
)
from .surface import Surface

__all__ = ["build"]

FACET, ROULETTE = 1, 2
"""The random numbers of a sample, each a dimension of its own."""
APART = 1.3
"""Spreads of V·H from its mean that the native lobe's looks are."""
LEAST_KEPT, KEPT_OVER = 0.25, 1.5
"""Probability of a facet is this over the share that the native lobe leaves, and at least that."""
LEAST_COLOUR = 1e-3


def build(builder):
    """Build the group."""
    surface = Surface(builder, "exact")
    with builder.frame("Width > 0"):
        has_width = less(0.0, surface.sockets.width)
    first = _lobes(surface, surface.m, has_width)
    with builder.frame("Slope 2"):
        second = _lobes(surface, surface.second, has_width)
    builder.output("BSDF", surface.closures(surface.mixed(first, second), reflected=surface.look(surface.n_v)))


def _lobes(surface, m, has_width):
    """The lobe about a drawn facet, and the native one under it."""
    builder = surface.builder
    share, lean = native_lobe(surface.n_v, m)
    middle, floor = _looks(surface, m)
    with builder.frame("Native lobe"):
        native = floor * widen(has_width * HEADROOM * share)
        under = surface.glossy(native, surface.n + widen(lean) * surface.v, sqrt(native_slope(m)))
    with builder.frame("Roulette"):
        probability = where(has_width, _kept(middle, share, floor), 1.0)
        shown = less(builder.random(ROULETTE), probability)
    return builder.scale_shader(shown, _drawn(surface, m, has_width, native, lean, probability)), under


def _looks(surface, m):
    """(look at the mean of V·H, what is least of three looks around it by channel)."""
    mean, spread = mean_v_h(surface.n_v, m), spread_v_h(surface.n_v, m)
    middle = surface.look(mean)
    return middle, minimum(middle, surface.look(mean + APART * spread), surface.look(mean + (-APART) * spread))


def _kept(middle, share, floor):
    """Probability of drawing a facet at all: more than the brightest channel's share that the native lobe leaves."""
    left = _brightest(middle - floor * widen(share))
    return clip(KEPT_OVER * left / maximum(_brightest(middle), LEAST_COLOUR), LEAST_KEPT, 1.0)


def _brightest(colour):
    return maximum(x_of(colour), y_of(colour), z_of(colour))


def _drawn(surface, m, has_width, native, lean, probability):
    """The Glossy BSDF about a drawn facet, with what the native lobe leaves of f."""
    builder, width = surface.builder, surface.sockets.width
    with builder.frame("Draw"):
        tilt, azimuth, side = builder.three_randoms(FACET)
        narrow, wide = narrow_slope(m, width), wide_slope(m, width)
    x = facet(surface.n, surface.v, m, narrow, wide, FLANKS * has_width, 0.0, tilt, azimuth, side)
    whole = surface.look(x.v_h) * widen(sharpened_v_cavity(x))
    with builder.frame("f cos/p"):
        left = maximum(whole - native * widen(native_over_d(x, m, lean)), 0.0)
        colour = left * widen(x.density / probability)
        squeezed = sqrt(x.a_across / x.a_along)
        return surface.glossy(colour, x.h, sqrt(x.a_across / squeezed), Anisotropy=1.0 - squeezed, Tangent=x.across)
