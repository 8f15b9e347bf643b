"""Native lobes that stand in for the layered RGB BRDF: Layered RGB OSL Standard, whose text does the same.

One Beckmann lobe for R and one a channel for T, about the normals that mirror V
to where the light of each is brightest.  A native lobe takes any colour that
depends on V, none that depends on L, and no negative one.  So the albedos of R,
of T and of the interference 2 cos(2Φ) √(RT) are worked out, and the last one is
dealt: to T where it adds light; where it takes light, from R first and from T
what R cannot give.  As |2 √(RT)| ≤ R + T, neither becomes negative.

**Albedos.**  R and T in closed form: a lobe cos^e is a Gaussian of variance
1/(e + 2) in angle, cut off at the horizon, or in the layer at the edge of total
reflection.  The interference turns with the angle of L, so it is summed over
three directions in the plane of n0 and T's exit; across it, it is a Gaussian.

**Peaks.**  T (N.L) has its peak above the direction in which the light leaves, the
interference moves it to either side, and near grazing both make it narrower.
Five directions in the same plane tell the place and the width of the peak:
mean and deviation under the fourth power of T with what it was dealt.  Interference
that takes light leaves lopsided lobes: three more directions lead to their tops.

The energy scale's (e + 2)/(2π) is in the albedos; the published scale takes it off again.

X. Granier, W. Heidrich, "A Simple Layered RGB BRDF Model", Graphical Models 65(4), 2003.
"""

from types import SimpleNamespace

from ...operands import (
    arccos,
    cos,
    dot,
    exp,
    maximum,
    minimum,
    normalize,
    power,
    sin,
    sqrt,
    where,
    widen,
    x_of,
    y_of,
    z_of,
)
from ...reflectance.directions import PI, half_vector
from .formulas import cos_refracted, f_eq8, fifth_power, squared, transmission_eq9

__all__ = ["exit_directions", "exit_plane", "in_plane", "reflected_albedo", "transmitted_albedo",
           "interference_albedo", "peaks", "lobe_colours", "native_lobes"]

SMALLEST = 1e-9
LEAST_PEAK = 1e-30
"""Fourth power of what no lobe falls below: keeps a mean over nothing from being 0/0."""
LEAST_SINE = 1e-3
"""Of D, in a division: single precision has no direction for shorter ones."""
HALF_PI = 0.5 * PI

HIGHEST_EXIT_SINE = 0.985
"""Lobes whose light leaves lower, or not at all, are aimed 10° above the horizon."""

EDGE_STEPS = ((0.89, 0.0118), (0.11, 0.1237))
EDGE_CURVE, EDGE_LEAN = 0.581, 1.086
"""Where total reflection cuts T off, fitted to quadrature: inside the edge (1 - F)
rises to 1 in two steps, (height, offset times √(r1²-1)); the edge bends away from
a lobe of variance σ² by EDGE_CURVE σ² √(r1²-1)."""

CHANNELS = ((x_of, (1.0, 0.0, 0.0)), (y_of, (0.0, 1.0, 0.0)), (z_of, (0.0, 0.0, 1.0)))
MEAN = (1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0)

MOST_STRETCH = 2.5
LEAST_V_H = 0.2
MOST_LEAN, LEAST_LEAN = 0.12, -0.3
MOST_EXPONENT = 30.0

ALBEDO_STEP = 1.4
"""Standard deviations of √(RT) between the three directions of its albedo."""
FADING = -1.0 / 64.0
PEAK_STEP = 0.8
"""Standard deviations of T between the five directions that find its peak."""
SLANT, CURVE = 1.4, 1.2
"""How N.L and (1 - F) together turn and narrow T, over what N.L does alone: they differ little with V."""
PEAK_POWER = 4.0
TOP_STEP = 0.62
"""Standard deviations of the peak between the three directions that lead from its mean to its top."""
HORIZON, HIDDEN = 0.95, 0.25
"""How near a native lobe comes to the horizon, in its deviations, and how much of what it loses there V does not see:
between what Blender 4.5 wants, which also samples below a turned normal, and 5.x, which does not."""


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
    outside = _refracted_outwards(n0_v, n0_n1, n1_v, n1_o, cos_w, r1)
    return SimpleNamespace(n0_v=n0_v, cos_o=cos_o, cos_w=cos_w, **vars(outside))


def _refracted_outwards(n0_v, n0_n1, n1_v, n1_o, cos_w, r1):
    """What :func:`exit_directions` gives of D, by name."""
    # w = 2 n1_o n1 - (V - n0_v n0)/r1 - cos_o n0; refracted outwards its part across n0 grows r1 times.
    sin_1 = r1 * sqrt(1.0 - cos_w * cos_w)
    shrink = minimum(HIGHEST_EXIT_SINE / maximum(sin_1, SMALLEST), 1.0)
    cos_1 = sqrt(1.0 - squared(shrink * sin_1))
    on_n1 = shrink * (2.0 * r1 * n1_o)
    on_n0 = cos_1 + shrink * widen(n0_v) - on_n1 * widen(n0_n1)
    mirror_v, mirror_n1 = 2.0 * n0_v * n0_v - 1.0, 2.0 * n0_v * n0_n1 - n1_v
    between = on_n1 * widen(mirror_n1) + on_n0 * widen(n0_v) - shrink * widen(mirror_v)
    return SimpleNamespace(cos_1=cos_1, between=between, on_v=-shrink, on_n0=on_n0, on_n1=on_n1)


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
        total = total + height * _step_of_the_edge(offset, margin, edge_slope, sigma, cos_w, lean)
    return maximum(total, 0.0)


def _step_of_the_edge(offset, margin, edge_slope, sigma, cos_w, lean):
    """Mean cosine of a lobe that is cut off this far from the edge."""
    z = minimum(maximum((margin - offset / edge_slope) / sigma, -4.0), 4.0)
    return cos_w * above(z) + lean * bell(z)


def exit_plane(exits, r1, d, wavelengths, f, e0, e1):
    """What the lobes are within the plane of n0 and D, per channel ``(..., 3)``; angles count from n0 to D.

    exits from :func:`exit_directions`; r1, wavelengths, f ``(..., 3)``, d, e0, e1 ``(...)``.

    theta, sin_1     angle of D, and its sine
    sin_w            sine in the layer of w
    mirror_side      the mirror direction has the components n0_v along n0, mirror_side across it
    path             2π r1 d/λ
    out              𝒯(io) times (e1 + 2)/(e0 + 2), so that T is in units of R's scale
    sigma_t          standard deviation of T's lobe outside, the cut-offs left out
    middle, sigma    angle and standard deviation of the lobe √(RT)
    across           its integral across the plane over its height in the plane

    >>> import numpy as np
    >>> up, r1 = np.array([0.0, 0.0, 1.0]), np.full(3, 1.5)
    >>> exits = exit_directions(up, up, up, r1)
    >>> exit_plane(exits, r1, 90.0, np.full(3, 500.0), f_eq8(r1), 90.0, 170.0).sigma.round(4)
    array([0.109, 0.109, 0.109])
    """
    n0_v = widen(exits.n0_v)
    sin_1 = sqrt(1.0 - squared(exits.cos_1))
    mirror_side = (exits.between - exits.cos_1 * n0_v) / maximum(sin_1, LEAST_SINE)
    curve_r, curve_t, within = _curvatures(exits.cos_w, exits.cos_1, r1, e0, e1)
    theta, from_mirror = _angles(n0_v, exits.cos_1, sin_1, mirror_side)
    return SimpleNamespace(
        theta=theta, sin_1=sin_1, sin_w=sqrt(1.0 - squared(exits.cos_w)), mirror_side=mirror_side,
        path=r1 * widen(2.0 * PI * d) / wavelengths,
        out=transmission_eq9(exits.cos_o, f) * widen((e1 + 2.0) / (e0 + 2.0)),
        sigma_t=1.0 / sqrt(within), middle=theta - from_mirror * (curve_r / (curve_r + within)),
        sigma=sqrt(2.0 / (curve_r + within)), across=_across(n0_v, mirror_side, curve_r, curve_r + curve_t))


def _angles(n0_v, cos_1, sin_1, mirror_side):
    """The angle of D from n0, and from the mirror direction's place in the plane."""
    sine = sin_1 * n0_v - cos_1 * mirror_side
    return arccos(cos_1), sine * (1.0 + squared(sine) / 6.0)


def _curvatures(cos_w, cos_1, r1, e0, e1):
    """One over the variances of the lobes R and T outside, and of T within the plane."""
    cos_axis = maximum(cos_w, sqrt(1.0 - 1.0 / squared(r1)))
    stretch = minimum(cos_axis / cos_1, MOST_STRETCH)
    curve_t = widen(e1 + 2.0) / squared(r1)
    return widen(e0 + 2.0), curve_t, curve_t / squared(stretch)


def _across(n0_v, mirror_side, curve_r, both):
    """The integral of √(RT) across the plane over its height in it."""
    # Where the mirror direction lies off the plane, √(RT) is highest on the way there.
    aside2 = maximum(1.0 - squared(n0_v) - squared(mirror_side), 0.0)
    height = exp(minimum(squared(curve_r) * aside2 / (4.0 * both), MOST_EXPONENT))
    return height * sqrt(4.0 * PI / (both + 2.0))


def in_plane(exits, plane, theta, r1, f, e0, e1):
    """R, T and 2 cos(2Φ) √(RT) towards an angle in the plane, each times N.L, in units of R's scale.

    theta and what comes back ``(..., 3)``; below the horizon all are 0.

    >>> import numpy as np
    >>> up, r1 = np.array([0.0, 0.0, 1.0]), np.full(3, 1.5)
    >>> f, exits = f_eq8(r1), exit_directions(up, up, up, r1)
    >>> plane = exit_plane(exits, r1, 0.0, np.full(3, 500.0), f, 90.0, 90.0)
    >>> [part.round(4)[0].item() for part in in_plane(exits, plane, plane.theta, r1, f, 90.0, 90.0)]
    [0.04, 0.9216, 0.384]
    """
    height, side = cos(theta), sin(theta)
    inside_side = side / r1
    inside_height = sqrt(1.0 - squared(inside_side))
    passed = (1.0 - f) * (1.0 - fifth_power(1.0 - height))
    mirror = height * widen(exits.n0_v) + side * plane.mirror_side
    lobe = inside_height * exits.cos_w + inside_side * plane.sin_w
    seen = maximum(height, 0.0)
    r = (1.0 - passed) * power(maximum(mirror, 0.0), widen(e0)) * seen
    t = passed * power(maximum(lobe, 0.0), widen(e1)) * (plane.out * seen)
    between = 2.0 * cos(plane.path * (inside_height + exits.cos_o)) * sqrt(r * t)
    return r, t, between


def interference_albedo(exits, plane, r1, f, e0, e1):
    """∫ 2 cos(2Φ) √(RT) (N.L) dω, ``(..., 3)``: three directions in the plane, a Gaussian across it.

    Layers so thick that 2Φ turns from one of these directions to the next have none.

    >>> import numpy as np
    >>> up, r1 = np.array([0.0, 0.0, 1.0]), np.full(3, 1.5)
    >>> f, exits = f_eq8(r1), exit_directions(up, up, up, r1)
    >>> plane = exit_plane(exits, r1, 0.0, np.full(3, 500.0), f, 90.0, 170.0)
    >>> interference_albedo(exits, plane, r1, f, 90.0, 170.0).round(2)
    array([0.56, 0.56, 0.56])
    """
    step = ALBEDO_STEP * plane.sigma
    _, _, total = in_plane(exits, plane, plane.middle, r1, f, e0, e1)
    for angle in (plane.middle - step, plane.middle + step):
        total = total + in_plane(exits, plane, angle, r1, f, e0, e1)[2]
    turn = plane.path * step * sin(plane.middle) / squared(r1)
    fading = exp(squared(squared(turn)) * FADING)
    return total * fading * step * plane.across * widen((e0 + 2.0) / (2.0 * PI))


def peaks(exits, plane, r1, f, e0, e1):
    """Angle of T's peak in the plane, interference included, and its standard deviation, ``(..., 3)``.

    >>> import numpy as np
    >>> view, r1 = np.array([0.6, 0.0, 0.8]), np.full(3, 1.5)
    >>> f, exits = f_eq8(r1), exit_directions(view, np.array([0.0, 0.0, 1.0]), np.array([0.0, 0.0, 1.0]), r1)
    >>> plane = exit_plane(exits, r1, 0.0, np.full(3, 500.0), f, 90.0, 170.0)
    >>> peak, sigma = peaks(exits, plane, r1, f, 90.0, 170.0)
    >>> np.degrees(plane.theta - peak).round(2)[0].item(), np.degrees(sigma).round(1)[0].item()
    (0.6, 7.1)
    """
    curve = 1.0 / squared(plane.sigma_t) + CURVE / squared(exits.cos_1)
    centre = plane.theta - SLANT * plane.sin_1 / (exits.cos_1 * curve)
    step = PEAK_STEP / sqrt(curve)
    weights = [_peak_weight(exits, plane, centre + place * step, r1, f, e0, e1)
               for place in (-2.0, -1.0, 0.0, 1.0, 2.0)]
    mean, spread = _mean_and_spread(weights)
    middle, sigma = centre + mean * step, step * sqrt(PEAK_POWER * spread)
    return middle + _towards_the_top(exits, plane, middle, TOP_STEP * sigma, r1, f, e0, e1), sigma


def _mean_and_spread(weights):
    """Mean and variance of five weighed steps from -2 to 2."""
    inner, outer = weights[1] + weights[3], weights[0] + weights[4]
    total = inner + outer + weights[2] + LEAST_PEAK
    mean = (weights[3] - weights[1] + 2.0 * (weights[4] - weights[0])) / total
    return mean, maximum((inner + 4.0 * outer) / total - squared(mean), 0.01)


def _towards_the_top(exits, plane, middle, step, r1, f, e0, e1):
    """From the mean of a lopsided lobe to its top: the mean of three directions about it, under the sixth power."""
    fourth_powers = [_peak_weight(exits, plane, middle + place * step, r1, f, e0, e1) for place in (-1.0, 0.0, 1.0)]
    before, at, after = (weight * sqrt(weight) for weight in fourth_powers)
    return step * (after - before) / (before + at + after + LEAST_PEAK)


def _peak_weight(exits, plane, theta, r1, f, e0, e1):
    """Fourth power of T (N.L) and what interference T is dealt, towards an angle."""
    r, t, between = in_plane(exits, plane, theta, r1, f, e0, e1)
    return squared(squared(maximum(t + _dealt_to_t(r, between), 0.0)))


def _dealt_to_t(r, between):
    """The interference but for what R gives of it where it takes light."""
    return maximum(between, minimum(r + between, 0.0))


def lobe_colours(exits, plane, r1, f, e0, e1, published=0.0):
    """Albedo that the lobes of R and of T reflect, interference included, ``(..., 3)``; never below 0.

    >>> import numpy as np
    >>> up, r1 = np.array([0.0, 0.0, 1.0]), np.full(3, 1.5)
    >>> f, exits = f_eq8(r1), exit_directions(up, up, up, r1)
    >>> plane = exit_plane(exits, r1, 0.0, np.full(3, 500.0), f, 90.0, 170.0)
    >>> r, t = lobe_colours(exits, plane, r1, f, 90.0, 170.0)
    >>> (r + t).round(2)
    array([1.34, 1.34, 1.34])
    """
    r = reflected_albedo(exits.n0_v, f, e0)
    t = transmitted_albedo(exits, r1, f, e1)
    between = interference_albedo(exits, plane, r1, f, e0, e1)
    scale_r, scale_t = (where(published, 2.0 * PI / (e + 2.0), 1.0) for e in (e0, e1))
    r, t, between = r * widen(scale_r), t * widen(scale_t), between * widen(sqrt(scale_r * scale_t))
    most = 2.0 * sqrt(r * t)
    between = minimum(maximum(between, -most), most)
    to_t = _dealt_to_t(r, between)
    return 0.5 * maximum(r + between - to_t, 0.0), 0.5 * maximum(t + to_t, 0.0)


def native_lobes(view, n0, n1, r1, d, wavelengths, e0, e1, published=0.0):
    """The four native lobes: R's, and T's for red, green and blue.

    view, n0, n1, r1, wavelengths ``(..., 3)``; d in nm, exponents ``(...)``.

    Each lobe has a normal and a colour ``(..., 3)`` and the Beckmann slopes
    slope_in, in the plane of V and the normal, and slope_across ``(...)``.

    >>> import numpy as np
    >>> up = np.array([0.0, 0.0, 1.0])
    >>> lobes = native_lobes(up, up, up, np.full(3, 1.5), 0.0, np.full(3, 500.0), 98.0, 170.0)
    >>> lobes[0].normal, round(float(lobes[0].slope_in), 4), lobes[2].colour.round(2)
    (array([0., 0., 1.]), 0.0707, array([0.  , 1.31, 0.  ]))
    """
    f = f_eq8(r1)
    exits = exit_directions(view, n0, n1, r1)
    plane = exit_plane(exits, r1, d, wavelengths, f, e0, e1)
    r, t = lobe_colours(exits, plane, r1, f, e0, e1, published)
    peak, sigma = peaks(exits, plane, r1, f, e0, e1)
    return [_r_lobe(view, n0, exits, f, e0, r), *_t_lobes(view, n0, n1, exits, plane, r1, e1, t, peak, sigma)]


def _r_lobe(view, n0, exits, f, e0, albedo):
    """R's lobe: N.L moves its peak up, F towards the horizon, by the variance times their logarithms' slopes."""
    height = maximum(exits.n0_v, SMALLEST)
    mean_f = dot(f, MEAN)
    away = 1.0 - exits.n0_v
    steep = (1.0 - mean_f) * squared(squared(away))
    rise = 5.0 * steep / (mean_f + steep * away)
    lean = minimum(maximum((1.0 / height - rise) / (e0 + 2.0), LEAST_LEAN), MOST_LEAN)
    mirror = widen(2.0 * exits.n0_v + lean) * n0 - view
    normal = half_vector(view, normalize(mirror))
    kept = above(minimum((HALF_PI - arccos(exits.n0_v)) * sqrt(e0 + 2.0), 4.0))
    slope = 1.0 / sqrt(2.0 * (e0 + 2.0))
    return _lobe(view, normal, albedo / widen(kept), slope, slope)


def _t_lobes(view, n0, n1, exits, plane, r1, e1, albedo, peak, sigma):
    """T's lobes, each about the normal that mirrors V to its channel's peak."""
    with_loss = _cut_off(albedo, exits.n0_v, peak, sigma)
    # The peak: D turned about its plane's normal, as a sum of V, n0 and n1 as D is.
    turned = sin(peak) / maximum(plane.sin_1, LEAST_SINE)
    on_n0 = turned * (exits.on_n0 - exits.cos_1) + cos(peak)
    on_v, on_n1 = turned * exits.on_v, turned * exits.on_n1
    slope_in, slope_across = sqrt(0.5) * sigma, r1 / widen(sqrt(2.0 * (e1 + 2.0)))
    return [_aimed(view, n0, n1, of(on_v), of(on_n0), of(on_n1), with_loss * channel, of(slope_in), of(slope_across))
            for of, channel in CHANNELS]


def _cut_off(albedo, n0_v, peak, sigma):
    """The colour of a lobe that loses what of it lies below the horizon, to reflect this albedo.

    The horizon is n0's, or that of the lobe's normal, half-way between V and the peak, where it comes first; the
    facets that would mirror V beyond it are seen at grazing angles, and count for less.
    """
    lower = maximum(peak, 0.5 * (peak + widen(arccos(n0_v))))
    z = minimum(maximum(HORIZON * (HALF_PI - lower) / sigma, 0.5), 4.0)
    return albedo / (above(z) + HIDDEN * bell(z) / z)


def _aimed(view, n0, n1, on_v, on_n0, on_n1, colour, slope_in, slope_across):
    direction = widen(on_v) * view + widen(on_n0) * n0 + widen(on_n1) * n1
    return _lobe(view, half_vector(view, direction), colour, slope_in, slope_across)


def _lobe(view, normal, colour, slope_in, slope_across):
    """A Beckmann lobe of these slopes; across the plane of V its normals stand as V.H times as far apart as L does."""
    return SimpleNamespace(normal=normal, colour=colour, slope_in=slope_in,
                           slope_across=slope_across / maximum(dot(view, normal), LEAST_V_H))
