"""Native lobes that stand in for the layered RGB BRDF: the fast realisation.

One Beckmann lobe about n0 for R, and one a channel for T, about the normal that
mirrors V to where this channel's light leaves the layer.  A native lobe takes
any colour that depends on V, none that depends on L, and no negative one.  So
the albedos of R, of T and of the interference 2 cos(2Φ) √(RT) are worked out in
closed form, and the last one, which may be negative, is dealt to the other two
in proportion to theirs: as |2 √(RT)| ≤ R + T, neither becomes negative.

In the closed forms a lobe cos^e is a Gaussian of variance 1/(e + 2) in angle,
cut off at the horizon, or in the layer at the edge of total reflection; √(RT)
is a Gaussian between R and T.
The energy scale's (e + 2)/(2π) is in them; the published scale takes it off again.

X. Granier, W. Heidrich, "A Simple Layered RGB BRDF Model", Graphical Models 65(4), 2003.
"""

from types import SimpleNamespace

from ..operands import (
    arccos, cos, dot, exp, maximum, minimum, normalize, sqrt, term, where, widen, x_of, y_of, z_of,
)
from .directions import PI, half_vector
from .layered_rgb import (
    cos_refracted, f_eq8, fifth_power, fresnel_eq7, phase_eq3, squared, transmission_eq9,
)

__all__ = ["exit_directions", "reflected_albedo", "transmitted_albedo", "interference_albedo", "lobe_colours",
           "native_lobes"]

SMALLEST = 1e-9
HALF_PI = 0.5 * PI

HIGHEST_EXIT_SINE = 0.985
"""Lobes whose light leaves lower, or not at all, are aimed 10° above the horizon."""

EDGE_STEPS = ((0.89, 0.0118), (0.11, 0.1237))
EDGE_CURVE, EDGE_LEAN = 0.581, 1.086
"""Where total reflection cuts T off, fitted to quadrature: inside the edge (1 - F)
rises to 1 in two steps, (height, offset times √(r1²-1)); the edge bends away from
a lobe of variance σ² by EDGE_CURVE σ² √(r1²-1)."""

CHANNELS = (("T lobe, red", x_of, (1.0, 0.0, 0.0)), ("T lobe, green", y_of, (0.0, 1.0, 0.0)),
            ("T lobe, blue", z_of, (0.0, 0.0, 1.0)))

MOST_STRETCH = 2.5
LEAST_V_H = 0.2
MOST_LEAN = 0.12
MOST_SHARE = 2.5
MOST_SHIFT = 0.3
PEAK_OF_MEAN = 0.7
LEAST_LEFT = 0.2


@term("Exit directions")
def exit_directions(view, n0, n1, r1):
    """Where the light of each channel leaves, for the viewer at V.

    view, n0, n1 ``(..., 3)`` of length 1, r1 ``(..., 3)``.

    n0_v ``(...)``   <n0,V>, also the cosine of the mirror direction
    and per channel ``(..., 3)``:
    cos_o            cosine of V refracted into the layer
    cos_w            cosine in the layer of w, which reaches V by reflection at n1
    cos_1            cosine outside of the direction D that w leaves in
    on_v, on_n0, on_n1   D is the sum of these times V, n0 and n1
    between          <mirror direction, D>

    >>> import numpy as np
    >>> up = np.array([0.0, 0.0, 1.0])
    >>> exit_directions(up, up, up, np.full(3, 1.5)).between
    array([1., 1., 1.])
    """
    n0_v, n0_n1, n1_v = dot(n0, view), dot(n0, n1), dot(n1, view)
    cos_o = cos_refracted(n0_v, r1)
    n1_o = widen(n1_v - n0_v * n0_n1) / r1 + widen(n0_n1) * cos_o
    cos_w = minimum(2.0 * n1_o * widen(n0_n1) - cos_o, 1.0)
    # w = 2 n1_o n1 - (V - n0_v n0)/r1 - cos_o n0; refracted outwards its part across n0 grows r1 times.
    sin_1 = r1 * sqrt(1.0 - cos_w * cos_w)
    shrink = minimum(HIGHEST_EXIT_SINE / maximum(sin_1, SMALLEST), 1.0)
    cos_1 = sqrt(1.0 - squared(shrink * sin_1))
    on_n1 = shrink * (2.0 * r1 * n1_o)
    on_n0 = cos_1 + shrink * widen(n0_v) - on_n1 * widen(n0_n1)
    mirror_v, mirror_n1 = 2.0 * n0_v * n0_v - 1.0, 2.0 * n0_v * n0_n1 - n1_v
    between = on_n1 * widen(mirror_n1) + on_n0 * widen(n0_v) - shrink * widen(mirror_v)
    return SimpleNamespace(n0_v=n0_v, cos_o=cos_o, cos_w=cos_w, cos_1=cos_1, between=between,
                           on_v=-shrink, on_n0=on_n0, on_n1=on_n1)


def above(z):
    """Share of a normal distribution below z standard deviations, within 2e-4.

    >>> round(float(above(1.0)), 3)
    0.841
    """
    return 1.0 / (1.0 + exp(-1.5976 * z - 0.07056 * z * z * z))


def bell(z):
    """Density of the normal distribution at z.

    >>> round(bell(0.0), 4)
    0.3989
    """
    return 0.3989423 * exp(-0.5 * z * z)


@term("Albedo of R")
def reflected_albedo(n0_v, f, e0):
    """∫ R (N.L) dω, ``(..., 3)``: F's constant part over the cut-off lobe, its (1 - c)^5 at three points.

    >>> reflected_albedo(1.0, 0.04, 90.0).round(4)
    array([0.04])
    """
    sigma = 1.0 / sqrt(e0 + 2.0)
    slant = sqrt(1.0 - n0_v * n0_v) * sigma
    z = (HALF_PI - arccos(n0_v)) / sigma
    mean_cosine = n0_v * above(minimum(z, 4.0)) + slant * bell(z)
    grazing = (4.0 * _schlick(n0_v) + _schlick(n0_v + 1.732 * slant) + _schlick(n0_v - 1.732 * slant)) / 6.0
    return f * widen(mean_cosine) + (1.0 - f) * widen(grazing)


def _schlick(c):
    c = minimum(maximum(c, 0.0), 1.0)
    return fifth_power(1.0 - c) * c


@term("Albedo of T")
def transmitted_albedo(exits, r1, f, e1):
    """∫ T (N.L) dω, ``(..., 3)``: 𝒯 r1² times the mean of (1 - F) cos over the lobe in the layer.

    >>> import numpy as np
    >>> up, r1 = np.array([0.0, 0.0, 1.0]), np.full(3, 1.5)
    >>> transmitted_albedo(exit_directions(up, up, up, r1), r1, f_eq8(r1), 170.0).round(2)
    array([2.07, 2.07, 2.07])
    """
    return (1.0 - f) * transmission_eq9(exits.cos_o, f) * r1 * r1 * _mean_cosine(exits.cos_w, r1, e1)


def _mean_cosine(cos_w, r1, e1):
    """Mean over the lobe about w in the layer of its cosine times (1 - F)/(1 - f), 0 beyond the edge."""
    edge_slope = sqrt(r1 * r1 - 1.0)
    edge = arccos(edge_slope / r1)
    sigma2 = 1.0 / (e1 + 2.0)
    sigma = widen(sqrt(sigma2))
    margin = edge - arccos(cos_w) - edge_slope * widen(EDGE_CURVE * sigma2)
    lean = EDGE_LEAN * sigma * sqrt(1.0 - cos_w * cos_w)
    total = 0.0
    for height, offset in EDGE_STEPS:
        z = minimum(maximum((margin - offset / edge_slope) / sigma, -4.0), 4.0)
        total = total + height * (cos_w * above(z) + lean * bell(z))
    return maximum(total, 0.0)


@term("Albedo of 2 cos 2Φ √RT")
def interference_albedo(exits, r1, d, wavelengths, f, e0, e1, r):
    """∫ 2 cos(2Φ) √(RT) (N.L) dω, ``(..., 3)``; r is R's own albedo.

    √(RT) has its peak between the mirror direction and D, and falls with their
    distance: across the plane of incidence by the curvatures e0 + 2 and
    (e1 + 2)/r1², within it by the angles that lie between them outside and in
    the layer.  Its phase is taken there, and faded by what it turns within the lobe.

    >>> import numpy as np
    >>> up, r1 = np.array([0.0, 0.0, 1.0]), np.full(3, 1.5)
    >>> exits = exit_directions(up, up, up, r1)
    >>> interference_albedo(exits, r1, 0.0, np.full(3, 500.0), f_eq8(r1), 90.0, 170.0, 0.04).round(2)
    array([0.57, 0.57, 0.57])
    """
    cos_axis = maximum(exits.cos_w, sqrt(1.0 - 1.0 / (r1 * r1)))
    stretch = exits.cos_1 / cos_axis
    curve_r = widen(e0 + 2.0)
    across = widen(e1 + 2.0) / (r1 * r1)
    within = across * stretch * stretch
    distance2 = maximum(2.0 - 2.0 * exits.between, 0.0)
    outside2 = minimum(squared(arccos(exits.cos_1) - widen(arccos(exits.n0_v))), distance2)
    inside2 = squared(arccos(exits.cos_w) - arccos(exits.cos_o))
    pull_r, pull_t = curve_r * outside2, widen(e1 + 2.0) * inside2
    apart = (pull_r * pull_t / maximum(pull_r + pull_t, SMALLEST)
             + (distance2 - outside2) * curve_r * across / (curve_r + across))
    # The peak: the mirror direction and D, weighted by their curvatures.
    weight_t = across * stretch
    size2 = curve_r * curve_r + weight_t * weight_t + 2.0 * curve_r * weight_t * exits.between
    cos_peak = minimum((curve_r * widen(exits.n0_v) + weight_t * exits.cos_1) / sqrt(size2), 1.0)
    cos_i = sqrt(1.0 - (1.0 - cos_peak * cos_peak) / (r1 * r1))
    phase = phase_eq3(cos_i, exits.cos_o, r1, d, wavelengths)
    turn = widen(2.0 * PI * d) / wavelengths * sqrt(1.0 - cos_peak * cos_peak) * cos_peak / (r1 * cos_i)
    curve = 0.5 * (curve_r + within)
    fading = exp(-0.5 * (turn * turn / curve + 0.5 * apart))
    middle = 0.75 * exits.cos_w + 0.25 * cos_i  # of T and √(RT), for what total reflection leaves of them
    left = minimum(_mean_cosine(middle, r1, e1) / middle, 1.0) * above(
        minimum((HALF_PI - arccos(cos_peak)) * sqrt(curve), 4.0))
    fresnel = f + (1.0 - f) * fifth_power(1.0 - cos_peak)
    # The mean of F over the lobe exceeds F in its middle, as R's albedo tells.
    curved = r / (fresnel_eq7(exits.n0_v, f) * maximum(widen(exits.n0_v), SMALLEST))
    amplitude = curved * fresnel * transmission_eq9(exits.cos_o, f) * sqrt((1.0 - fresnel) * (1.0 - f) * left)
    spread = sqrt(curve * 0.5 * (curve_r + across))
    return 2.0 * cos(2.0 * phase) * fading * sqrt(amplitude * curve_r * widen(e1 + 2.0)) * cos_peak / spread


@term("Colours")
def lobe_colours(exits, r1, d, wavelengths, e0, e1, published=0.0):
    """Albedo that the lobes of R and of T reflect, interference included, and its share in T's.

    Each ``(..., 3)``; the albedos are never below 0.

    >>> import numpy as np
    >>> up, r1 = np.array([0.0, 0.0, 1.0]), np.full(3, 1.5)
    >>> exits = exit_directions(up, up, up, r1)
    >>> r, t, share = lobe_colours(exits, r1, 0.0, np.full(3, 500.0), 90.0, 170.0)
    >>> (r + t).round(2)
    array([1.34, 1.34, 1.34])
    """
    f = f_eq8(r1)
    r = reflected_albedo(exits.n0_v, f, e0)
    t = transmitted_albedo(exits, r1, f, e1)
    between = interference_albedo(exits, r1, d, wavelengths, f, e0, e1, r)
    scale_r, scale_t = (where(published, 2.0 * PI / (e + 2.0), 1.0) for e in (e0, e1))
    r, t, between = r * widen(scale_r), t * widen(scale_t), between * widen(sqrt(scale_r * scale_t))
    most = 2.0 * sqrt(r * t)
    between = minimum(maximum(between, -most), most) / maximum(r + t, SMALLEST)
    dealt = 0.5 * maximum(1.0 + between, 0.0)
    return r * dealt, t * dealt, between / maximum(1.0 + between, LEAST_LEFT)


def native_lobes(view, n0, n1, r1, d, wavelengths, e0, e1, published=0.0):
    """The four native lobes: R's, and T's for red, green and blue.

    view, n0, n1, r1, wavelengths ``(..., 3)``; d in nm, exponents ``(...)``.

    Each lobe has a normal and a colour ``(..., 3)`` and the Beckmann slopes
    slope_in, in the plane of V and the normal, and slope_across ``(...)``.

    >>> import numpy as np
    >>> up = np.array([0.0, 0.0, 1.0])
    >>> lobes = native_lobes(up, up, up, np.full(3, 1.5), 0.0, np.full(3, 500.0), 98.0, 170.0)
    >>> lobes[0].normal, round(float(lobes[0].slope_in), 4), lobes[2].colour.round(2)
    (array([0., 0., 1.]), 0.0707, array([0.  , 1.32, 0.  ]))
    """
    exits = exit_directions(view, n0, n1, r1)
    r, t, share = lobe_colours(exits, r1, d, wavelengths, e0, e1, published)
    mirror = widen(2.0 * exits.n0_v) * n0 - view
    # From D towards the mean of T and of the interference that T carries, as far as the peak moves;
    # and as the two lobes differ in width, so does what N.L moves them by.
    curve_r, curve_t = widen(e0 + 2.0), widen(e1 + 2.0) / (r1 * r1)
    shift = PEAK_OF_MEAN * share * (curve_r / (curve_r + curve_t))
    shift = minimum(maximum(shift, -MOST_SHIFT), MOST_SHIFT)
    cos_axis = maximum(exits.cos_w, sqrt(1.0 - 1.0 / (r1 * r1)))
    curve_t = curve_t * squared(exits.cos_1 / cos_axis)
    lean = 1.0 + maximum(share, -MOST_SHARE) * ((curve_t - curve_r) / (curve_t + curve_r))
    lobes = [_lobe("R lobe", view, n0, mirror, 1.0, e0, exits.n0_v, exits.n0_v, 1.0, r)]
    for name, of, channel in CHANNELS:
        direction = (widen(of(exits.on_v)) * view + widen(of(exits.on_n0)) * n0 + widen(of(exits.on_n1)) * n1)
        direction = direction + widen(of(shift)) * (mirror - direction)
        lobes.append(_lobe(name, view, n0, direction, of(r1), e1, of(cos_axis), of(exits.cos_1), of(lean),
                           t * channel))
    return lobes


def _lobe(name, view, n0, direction, index, exponent, inside_cos, outside_cos, lean, colour):
    """The Beckmann lobe as wide as cos^e, in a layer of this index, about a direction outside.

    It is aimed a little above the direction, for N.L falls towards the horizon and
    the printed lobe times N.L has its peak there: higher by the variance / tan of the height.
    """
    return term(name)(_leaned_lobe)(
        view, n0, direction, index, exponent, inside_cos, outside_cos, lean, colour)


def _leaned_lobe(view, n0, direction, index, exponent, inside_cos, outside_cos, lean, colour):
    slope = index / sqrt(2.0 * (exponent + 2.0))
    height = maximum(outside_cos, SMALLEST)
    slope_in = slope * minimum(inside_cos / height, MOST_STRETCH)
    lean = minimum(lean * (2.0 * slope_in * slope_in / height), MOST_LEAN)
    normal = half_vector(view, normalize(direction + widen(lean) * n0))
    # A native lobe loses what of it lies below the horizon; the colours are what is to be reflected.
    clearance = (HALF_PI - arccos(outside_cos) + lean) / maximum(1.4142 * slope_in, SMALLEST)
    kept = above(minimum(clearance, 4.0))
    return SimpleNamespace(normal=normal, colour=colour / widen(kept), slope_in=slope_in,
                           slope_across=slope / maximum(dot(view, normal), LEAST_V_H))
