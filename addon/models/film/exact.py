"""A film by the formula itself, sampled by drawing facets: F is the table at V·H of the facet that is drawn.

See addon.models.cook_torrance.sampler, whose facets these are.  Above Sampling
Width 0 a native lobe carries what lies under the formula whatever V·H: the
least of seven looks around its mean, by channel.
"""

from types import SimpleNamespace

from ...operands import clip, less, maximum, minimum, part, rotate, sqrt, term, where, widen, x_of, y_of, z_of
from ...reflectance.directions import PI
from ...reflectance.film_facets import mean_v_h, spread_v_h
from ...reflectance.sampling import narrow_slope, wide_slope
from ...reflectance.slopes import along_across
from ..cook_torrance.sampler import (
    FLANKS,
    HEADROOM,
    facet,
    native_lobe,
    native_over_d,
    native_slope,
    sharpened_v_cavity,
    stretched,
)
from .lookup import look
from .surface import Surface, glossy

__all__ = ["build", "facet_weight", "kept", "looks", "looks_at"]

FACET, ROULETTE = 1, 2
"""The random numbers of a sample, each a dimension of its own."""
APART = 0.7, -0.7, 1.4, -1.4, 2.2, -2.2
"""Spreads of V·H from its mean that the native lobe's looks are: with one pair at 1.3 it sticks out of f where a film
is dark between them, by 7 CIEDE2000 at the 99th percentile of soap at a slope of 0.2; with these by 1.
"""
LEAST_KEPT, KEPT_OVER = 0.25, 1.5
"""Probability of a facet is this over the share that the native lobe leaves, and at least that."""
LEAST_COLOUR = 1e-3


def build(builder):
    """Build the group."""
    surface = Surface(builder, "exact")
    s = surface.sockets
    with builder.frame("Width > 0"):
        has_native = less(0.0, s.width) * (1.0 - less(0.0, s.anisotropy))
    facets = SimpleNamespace(n=surface.n, v=surface.v, n_v=surface.n_v, tangent=surface.tangent, width=s.width,
                             anisotropy=s.anisotropy, rotation=s.rotation, tint=s.tint, has_native=has_native)
    first, second = (_lobes(builder, facets, m, surface.table) for m in (surface.m, surface.second))
    builder.output("BSDF", surface.closures(surface.mixed(first, second), surface.look(surface.n_v)))


@part("Lobes of the Facets")
def _lobes(builder, facets, m, table):
    """The lobe about a drawn facet, and the native one under it."""
    share, lean = native_lobe(facets.n_v, m)
    middle, floor = looks_at(builder, facets.n_v, m, table)
    with builder.frame("Native lobe"):
        native = floor * widen(facets.has_native * HEADROOM * share)
        under = glossy(builder, facets.tint * native, facets.n + widen(lean) * facets.v, sqrt(native_slope(m)))
    with builder.frame("Roulette"):
        probability = where(facets.has_native, kept(middle, share, floor), 1.0)
        shown = less(builder.random(ROULETTE), probability)
    drawn = _drawn(builder, facets, m, native, lean, probability, table)
    return builder.add_shaders(builder.scale_shader(shown, drawn), under)


@part("Looks at the Film", "Middle", "Least")
def looks_at(builder, n_v, m, table):
    """The :func:`looks` in a table of addon.models.film.lookup."""
    return looks(n_v, m, lambda c: look(builder, c, table))


def looks(n_v, m, look):
    """(look at the mean of V·H, what is least of it and six looks around it, by channel).

    look  function of cos θ, held to [0, 1], -> colour of the film

    >>> middle, floor = looks(0.5, 0.1, lambda c: widen(c) * (1.0, 0.5, 0.0))
    >>> middle.round(3).tolist(), floor.round(3).tolist()
    ([0.504, 0.252, 0.0], [0.374, 0.187, 0.0])
    """
    mean, spread = mean_v_h(n_v, m), spread_v_h(n_v, m)
    middle = look(mean)
    return middle, minimum(middle, *(look(clip(mean + apart * spread, 0.0, 1.0)) for apart in APART))


@part("Kept")
def kept(middle, share, floor):
    """Probability of drawing a facet at all: more than the brightest channel's share that the native lobe leaves.

    >>> round(float(kept([0.5, 0.4, 0.1], 0.9, [0.4, 0.4, 0.1])), 6)
    0.42
    """
    left = _brightest(middle - floor * widen(share))
    return clip(KEPT_OVER * left / maximum(_brightest(middle), LEAST_COLOUR), LEAST_KEPT, 1.0)


def _brightest(colour):
    return maximum(x_of(colour), y_of(colour), z_of(colour))


@part("Lobe about the Film's Facet")
def _drawn(builder, facets, m, native, lean, probability, table):
    """The Glossy BSDF about a drawn facet, with what the native lobe leaves of f."""
    tilt, azimuth, side = builder.three_randoms(FACET)
    narrow, wide, turned = _drawn_about(facets, m)
    ellipse = stretched(facets.n, turned, m, facets.anisotropy)
    x = facet(facets.n, facets.v, m, narrow, wide, FLANKS * facets.has_native, 0.0, tilt, azimuth, side, ellipse)
    colour = facet_weight(x, look(builder, x.v_h, table), native, m, lean, probability)
    with builder.frame("Lobe"):
        squeezed = sqrt(x.narrow / x.broad)
        return glossy(builder, facets.tint * colour, x.h, sqrt(x.narrow / squeezed), Anisotropy=1.0 - squeezed,
                      Tangent=x.lobe_tangent)


@term("f cos/p")
def facet_weight(x, film, native, m, lean, probability=1.0):
    """Colour of the lobe about a drawn facet: F G less the native lobe, over the density, ``(..., 3)``.

    x            from :func:`addon.models.cook_torrance.sampler.facet`
    film         colour of the film at its V·H
    native       colour of the native lobe times its weight; 0 where there is none
    m, lean      rms slope, and the native lobe's lean
    probability  with which the facet is drawn at all

    >>> from addon.reflectance.directions import direction
    >>> up = direction(0.0, 0.0)
    >>> x = facet(up, up, 0.5, 0.0, 0.0, 0.0, 0.0, 0.36787944, 0.0, 0.0)
    >>> facet_weight(x, (0.5, 0.2, 0.0), (0.0, 0.0, 0.0), 0.5, 0.0).round(4).tolist()
    [0.5, 0.2, 0.0]
    """
    left = maximum(film * widen(sharpened_v_cavity(x)) - native * widen(native_over_d(x, m, lean)), 0.0)
    return left * widen(x.density / probability)


@part("Slopes of the Facet's Lobe", "narrow", "wide", "turned")
def _drawn_about(facets, m):
    """Slopes of the lobes about drawn facets, and the tangent that they are stretched along."""
    longest, _ = along_across(m, facets.anisotropy)
    shorter = m / longest  # lobes are never wider than on a round surface
    return (narrow_slope(longest, facets.width) * shorter, wide_slope(longest, facets.width) * shorter,
            rotate(facets.tangent, facets.n, (2.0 * PI) * facets.rotation))
