"""Native lobes that stand in for the layered RGB BRDF: Standard, by nodes.

One Beckmann lobe for R, and a pair of them a channel for T, side by side in the plane of n0 and the direction in which
the channel's light leaves the layer.  A native lobe is even on both sides; the formula's is not, for refraction draws
it out towards the horizon, and interference that takes light out of its middle leaves a flat top.  Two lobes are as
lopsided and as flat as that, and keep the formula's tails.

Nothing is searched for: all is in closed form, of moments.

**T.**  Within the layer the lobe about w is a Gaussian of variance 1/(e1 + 2), cut off at the edge of total reflection.
What passes, its mean and its deviation are those of a Gaussian that is cut off; outside, the deviation grows by
d(angle)/d(angle within).

**Interference.**  X = 2 cos(2Φ) √(RT) is T times 2 cos(2Φ) √(R/T), and log √(R/T) is quadratic: so X is T's Gaussian,
moved, made narrower and scaled.  It is dealt to T and to R, by how near it stands to each; where that takes more light
from T than there is, R gives the rest.  No colour becomes negative.  Where the boundaries are not parallel, it stands
off the plane, towards the mirror direction: there it moves T's mean.

**The pair.**  Mean and variance are those of T and what it was dealt; how far apart the two stand, and which of them is
the wider, follows from third and fourth moments: X that takes light leaves flat tops, refraction lopsided ones.

**Tangents.**  A lobe of T is longest or shortest in the plane of n0 and D, so its tangent lies there.  V would not do:
where deviated light goes back to where it came from, V is the lobe's normal.

**Parallel boundaries.**  All that a tilted lower boundary changes is told by `aside`, the part of n1 across n0.  Where
Deviation is 0 and Lower Normal is not plugged in, it is a constant 0, and the renderer folds away what it multiplies.

**The constants** are a least-squares fit to quadrature of the formula: of the closures' albedo up to 75°, of the
colours' up to 80°, of the peaks in the plane of V and n0 up to 70°, and of the means over circles of normals about V,
4° to 70° from it, under suns of 0° to 82°; for the layers of the paper's figures 3 and 5, 15 to 400 nm thick, on the
circles 15 to 170, parallel and deviated by 5°, 10° and 14°.

The energy scale's (e + 2)/(2π) is in the albedos; the published scale takes it off again.

X. Granier, W. Heidrich, "A Simple Layered RGB BRDF Model", Graphical Models 65(4), 2003.
"""

import math
from types import SimpleNamespace

import numpy as np

from ...operands import (
    clip,
    cos,
    dot,
    exp,
    lookup,
    maximum,
    minimum,
    mix,
    multiply_add,
    part,
    power,
    sqrt,
    where,
    widen,
)
from ...reflectance.directions import PI
from .formulas import f_eq8, fifth_power, squared
from .lobes import CHANNELS

__all__ = ["exits_of", "within_the_layer", "outside", "interference", "dealt_out", "moments", "pair", "reflected",
           "light_of_the_layer", "native_lobes", "mirrored_lobe", "aim", "transmitted_lobes"]

MEAN = (1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0)

SMALLEST = 1e-9
LEAST_SINE2 = 1e-6
"""Of the square of D's sine, in a division."""
HIGHEST_SINE = 0.9718
"""Of the mean direction of what leaves."""
LEAST_HEIGHT = 0.02
"""Of the direction in which R/T is taken: at the horizon T is 0."""


def _normal_distribution(z):
    """Density at z, and share below it, of the normal distribution."""
    return np.exp(-0.5 * z * z) / math.sqrt(2.0 * PI), np.array([0.5 * math.erfc(-x / math.sqrt(2.0)) for x in z])


LOWEST, HIGHEST = -3.5, 4.0
"""Ends of the curves of a Gaussian cut off at z deviations; they run over (z - LOWEST)/(HIGHEST - LOWEST)."""
SPAN = 1.0 / (HIGHEST - LOWEST)
KNOTS = np.linspace(0.0, 1.0, 26)
CUTS = LOWEST + KNOTS / SPAN
DENSITY, SHARE = _normal_distribution(CUTS)
SHIFT = DENSITY / SHARE
"""From the mean of the whole to that of what is left, in deviations."""
KEPT = 1.0 - SHIFT * (CUTS + SHIFT)
"""Variance of what is left over that of the whole."""
CUT_OFF = 1.0 - KEPT

R_SPAN = 0.25
R_KNOTS = np.linspace(0.0, 1.0, 17)
R_CUTS = R_KNOTS / R_SPAN
R_DENSITY, R_SHARE = _normal_distribution(R_CUTS)
R_MORE = R_CUTS * R_SHARE + R_DENSITY - R_CUTS
"""Mean cosine of a lobe that the horizon cuts off at z deviations less its axis's, in deviations."""
R_LOST = 1.0 / R_SHARE

EDGE_STEPS, LATE = (0.0116, 0.1251), 0.1113
EDGE_CURVE, EDGE_LEAN, EDGE_BEND = 0.4798, 1.1088, 0.2783
"""Where total reflection cuts T off: inside the edge (1 - F) rises to 1 in two steps, at these offsets over √(r1²-1),
LATE of it by the second; the edge bends away from a lobe of deviation σ by EDGE_CURVE σ² √(r1²-1)."""
SHIFTED = SHIFT * (1.0 + -0.2588 * CUT_OFF + 0.2007 * CUT_OFF ** 2)
KEPT_BY_FIT = KEPT * (1.0 + 0.831 * CUT_OFF + -0.9944 * CUT_OFF ** 2)
BEND = 0.2882 + 0.5303 * CUT_OFF + -1.3088 * CUT_OFF ** 2
SKEW_BY_EDGE = 1.8524 * CUT_OFF + 0.8822 * CUT_OFF ** 2
"""The curves of what the edge cuts off, for refraction bends the Gaussian."""
WHOLE = 0.9957
"""Of T's albedo in closed form."""
WIDER = 2.7535
"""How much wider than 1/(e + 2) the variance of cos^e is, times e + 2, widened by refraction."""
X_AWAY, X_RISE, PLACE, NARROW, FADING = 1.1351, 1.2263, 0.9871, 0.9098, 0.5648
MOST_EXPONENT = 2.0
"""Of the interference's lobe: how far from the mean R/T is taken, how much refraction raises it, its place and variance
over those of Gaussians, and how much it fades where 2Φ turns within it."""
NEAR, MOST_TO_R, MOST_TAKEN, PULL = 0.3341, 0.9, 2.0, 0.4446
"""How near to R's lobe the interference is R's; the most that R gets, and that T loses; how far it draws R's lobe."""
OFF_PLANE, SPREAD = 0.5374, 3.292
"""Weights of how far the interference moves T off the plane of n0 and D, and of how much it widens T across it."""
SKEW, SKEW_X, MOST_SKEW, MEAN_X = 5.8451, 1.7976, 2.0853, 3.2983
FLAT, FLAT_CUT = 2.1147, 0.3117
LEAST_VARIANCE, MOST_APART = 0.15, 2.076
"""Weights of refraction, interference and edge in the moments; the variance is some of T's at least, and the square of
how far apart a pair stands some of its variance at most."""
UNEVEN, A1, A2, B1, B2 = -0.0257, -0.0166, 0.0457, 0.0439, 0.1041
MOST_FARTHER = 1.5
"""How a lopsided pair differs in weight, in anisotropy and roughness (A1, B1), and in V.H (A2, B2): at most by
MOST_FARTHER."""
HIDDEN, HIDES = 0.321 * np.exp(-6.8542 * KNOTS), 1.5571
"""What a pair loses at the horizon, over the cosine of the mean of T, and r1² of those that lose nothing."""
LEAST_1_V_L, LEAST_V_H = 0.08, 0.2
LEAST_LEAN, MOST_LEAN = -0.3, 0.12
"""Of twice the tilt of R's normal."""


@part("Exits")
def exits_of(view, n0, aside, r1):
    """Where the light of each channel leaves, for the viewer at V.

    view, n0 ``(..., 3)`` of length 1, aside ``(..., 3)`` the part of n1 across n0, r1 ``(..., 3)``.  w is the direction
    in the layer that reaches V by reflection at n1; D, which it leaves in, is across n0 `along` times aside less V.

    n0_v, across_v   <n0,V>, and the squared sine of V, ``(...)``
    v_across         V's part across n0, ``(..., 3)``
    and per channel ``(..., 3)``:
    r1_cos_o, r1_cos_w   r1 times the cosines in the layer of V refracted and of w
    along            see above
    sine, sine2, inverse_sine   of D, its square, and 1/sine; above 1 where D does not leave
    back             how far V leans away from D in their plane: part of -V along D's part across n0
    beyond           how much farther out D is in their plane than the mirror direction
    off_plane        squared distance of the mirror direction from the plane of n0 and D
    across_d         D's part across n0 the other way, for a mean channel, ``(..., 3)``: where T's lobes are long

    >>> import numpy as np
    >>> exits_of(np.array([0.6, 0.0, 0.8]), np.array([0.0, 0.0, 1.0]), np.zeros(3), np.full(3, 1.5)).sine.round(6)
    array([0.6, 0.6, 0.6])
    """
    n0_v, aside_v, aside2 = dot(n0, view), dot(aside, view), dot(aside, aside)
    across_v = 1.0 - n0_v * n0_v
    r1_cos_o2 = squared(r1) - widen(across_v)
    r1_cos_o = sqrt(r1_cos_o2)
    along = r1_cos_o * widen(2.0 * sqrt(1.0 - aside2)) + widen(2.0 * aside_v)
    farther = along * widen(aside2) - widen(aside_v)
    # Apart, so that parallel boundaries share the roots.
    by_tilt = along * (farther - widen(aside_v))
    sine2 = widen(across_v) + by_tilt
    inverse_sine = power(maximum(sine2, LEAST_SINE2), -0.5)
    v_across = view - widen(n0_v) * n0
    return SimpleNamespace(
        n0_v=n0_v, across_v=across_v, v_across=v_across, across_d=v_across - widen(dot(along, MEAN)) * aside,
        r1_cos_o=r1_cos_o, r1_cos_w=sqrt(r1_cos_o2 - by_tilt), along=along,
        sine=sine2 * inverse_sine, sine2=sine2, inverse_sine=inverse_sine,
        **vars(_from_v(along, inverse_sine, farther, across_v, aside_v, aside2)))


@part("From V")
def _from_v(along, inverse_sine, farther, across_v, aside_v, aside2):
    """Where V and the mirror direction are, seen from D: back, beyond and off_plane of :func:`exits_of`."""
    return SimpleNamespace(
        back=(widen(across_v) - along * widen(aside_v)) * inverse_sine, beyond=along * farther * inverse_sine,
        off_plane=squared(along * inverse_sine) * widen(across_v * aside2 - aside_v * aside_v))


@part("Within the Layer")
def within_the_layer(exits, r1, f, e1):
    """T's lobe in the layer, cut off at the edge of total reflection, per channel ``(..., 3)``.

    grazing  (1 - cos)^5 of V refracted
    albedo   half of ∫ T (N.L) dω
    shift    from w to the mean of what passes, in deviations; back the same as an angle
    kept     variance of what passes over that of the whole lobe
    bend     weight of refraction in the mean outside
    skew     what the cut adds to the third moment

    >>> import numpy as np
    >>> up, r1 = np.array([0.0, 0.0, 1.0]), np.full(3, 1.5)
    >>> within_the_layer(exits_of(up, up, 0.0 * up, r1), r1, f_eq8(r1), 170.0).albedo.round(2)
    array([1.03, 1.03, 1.03])
    """
    cut, late = _cuts(exits, r1, e1)
    share = lookup(cut, KNOTS, (1.0 - LATE) * SHARE) + lookup(late, KNOTS, LATE * SHARE)
    shift = lookup(cut, KNOTS, SHIFTED)
    back = shift * _deviation(e1)
    cosine = multiply_add(exits.sine * back, EDGE_LEAN, exits.r1_cos_w)
    grazing = fifth_power(multiply_add(exits.r1_cos_o, -1.0 / r1, 1.0))
    height = 0.5 * WHOLE * r1 * squared(1.0 - f)
    return SimpleNamespace(grazing=grazing, albedo=multiply_add(grazing, -1.0 * height, height) * cosine * share,
                           shift=shift, back=back, kept=lookup(cut, KNOTS, KEPT_BY_FIT),
                           bend=lookup(cut, KNOTS, BEND), skew=lookup(cut, KNOTS, SKEW_BY_EDGE))


@part("Cut by the Edge", "cut", "late")
def _cuts(exits, r1, e1):
    """Where each of the two steps of (1 - F) cuts the lobe off, on the curves' scale."""
    edge, sigma = sqrt(squared(r1) - 1.0), _deviation(e1)
    steep = SPAN / (edge * sigma)
    at_n0 = (1.0 - EDGE_BEND - EDGE_STEPS[0]) * steep - SPAN * (LOWEST + EDGE_CURVE * edge * sigma)
    cut = multiply_add(exits.sine2, -EDGE_BEND * steep,
                       multiply_add(exits.sine, (2.0 * EDGE_BEND - 1.0) * steep, at_n0))
    return cut, cut - (EDGE_STEPS[1] - EDGE_STEPS[0]) * steep


def _deviation(e1):
    """Of T's lobe in the layer."""
    return 1.0 / widen(sqrt(e1 + 2.0))


@part("Outside the Layer")
def outside(exits, within, r1, e1):
    """T's lobe outside about the mean of what leaves, in the plane of n0 and D, per channel ``(..., 3)``.

    sine, cosine, tangent, over_cosine   of the mean's angle from n0, and 1 over its cosine
    r1_cosine_within        r1 times the cosine of the mean in the layer
    steep, flat             the deviation in the layer over that outside, and 1 over that
    variance                of what passes
    bent                    tangent times that: how fast refraction widens the lobe within its width
    """
    sine = clip(exits.sine - within.back * exits.r1_cos_w, 0.0, HIGHEST_SINE)
    sine2 = squared(sine)
    cosine2, r1_cosine2 = 1.0 - sine2, squared(r1) - sine2
    over_cosine, over_r1_cosine = power(cosine2, -0.5), power(r1_cosine2, -0.5)
    cosine, r1_cosine_within = cosine2 * over_cosine, r1_cosine2 * over_r1_cosine
    steep, tangent = cosine * over_r1_cosine, sine * over_cosine
    variance = squared(r1_cosine_within * over_cosine) * (squared(_deviation(e1)) * _wider(e1)) * within.kept
    return SimpleNamespace(sine=sine, cosine=cosine, tangent=tangent, over_cosine=over_cosine,
                           r1_cosine_within=r1_cosine_within, steep=steep, flat=r1_cosine_within * over_cosine,
                           variance=variance, bent=tangent * variance)


def _wider(e1):
    """Variance of cos^e over that of a Gaussian."""
    return 1.0 + WIDER * squared(_deviation(e1))


@part("Interference")
def interference(exits, within, outer, r1, d, wavelengths, f, e0, e1):
    """2 cos(2Φ) √(RT) as a lobe in the plane, per channel ``(..., 3)``.

    albedo       half of ∫ 2 cos(2Φ) √(RT) (N.L) dω
    place        of its mean, from T's
    from_mirror  of T's mean, from the mirror direction
    ratio        its variance over T's
    towards_r    share that R is to get
    """
    from_mirror = outer.sine * widen(exits.n0_v) - outer.cosine * exits.back
    lobe = _lobe_between(exits, within, outer, from_mirror, r1, e0, e1)
    path, turn = widen(2.0 * PI * d) / wavelengths, outer.sine * outer.steep
    inner = outer.r1_cosine_within + exits.r1_cos_o - lobe.place * turn
    exponent = multiply_add(squared(path * turn) * lobe.variance, -FADING, lobe.exponent)
    albedo = (within.albedo * cos(path * inner) * multiply_add(outer.tangent * outer.bent, X_RISE, 1.0)
              * exp(minimum(exponent, MOST_EXPONENT))
              * sqrt(_r_over_t(outer, within, lobe.place, f) * lobe.ratio * lobe.tall))
    return SimpleNamespace(albedo=albedo, place=lobe.place, from_mirror=from_mirror, ratio=lobe.ratio,
                           towards_r=_towards_r(outer, lobe.place, from_mirror))


@part("Lobe of the Interference")
def _lobe_between(exits, within, outer, from_mirror, r1, e0, e1):
    """Place and variance of √(RT) in the plane, the logarithm of its height, and its factor across the plane."""
    curve_r, curve_t = widen(e0 + 2.0), widen(e1 + 2.0) / squared(r1)
    both = 1.0 / (curve_r / curve_t + 1.0)
    ratio = 1.0 / multiply_add(outer.variance, 0.5 * curve_r,
                               multiply_add(within.kept, -0.5 * NARROW * _wider(e1), 1.0))
    variance = outer.variance * ratio
    slope = multiply_add(from_mirror, curve_r, within.shift * outer.steep / _deviation(e1))
    place = slope * variance * (-0.5 * PLACE)
    off_mirror = squared(from_mirror) + exits.off_plane * both
    return SimpleNamespace(place=place, variance=variance, ratio=ratio,
                           exponent=0.25 * (squared(within.shift) - slope * place - curve_r * off_mirror),
                           tall=8.0 * curve_r / widen(e1 + 2.0) * both)


@part("R over T")
def _r_over_t(outer, within, place, f):
    """F over (1 - F) 𝒯 at the middle of the interference's lobe."""
    away = minimum(outer.sine * place * X_AWAY + (1.0 - outer.cosine), 1.0 - LEAST_HEIGHT)
    passed = multiply_add(fifth_power(away), f - 1.0, 1.0 - f)
    return (1.0 - passed) / (passed * multiply_add(within.grazing, f - 1.0, 1.0 - f))


@part("Towards R")
def _towards_r(outer, place, from_mirror):
    """The share of the interference's lobe that R is to get."""
    reach = multiply_add(outer.variance, NEAR, squared(from_mirror))
    return clip(place * from_mirror / reach * -1.0, 0.0, MOST_TO_R)


@part("Dealt Out", "R", "T", "share", "pulled")
def dealt_out(r, t, between, towards_r, e0, e1, published):
    """Albedos that R's lobe and T's pair reflect, interference included, its share of the pair's, and of R's lobe.

    >>> import numpy as np
    >>> r, t, between = (np.full(3, x) for x in (0.04, 0.5, -0.2))
    >>> [float(x[0].round(3)) for x in dealt_out(r, t, between, 0.1, 90.0, 170.0, 0.0)]
    [0.02, 0.32, -0.562, 0.0]
    """
    scale_r, scale_t = (where(published, 2.0 * PI / (e + 2.0), 1.0) for e in (e0, e1))
    r, t, between = r * widen(scale_r), t * widen(scale_t), between * widen(sqrt(scale_r * scale_t))
    to_r, both = maximum(towards_r * between, -1.0 * r), t + between
    by_t = maximum(both - to_r, SMALLEST)
    share = maximum(1.0 - t / by_t, -MOST_TAKEN)
    pulled = maximum(to_r, 0.0) * (1.0 - towards_r) / maximum(r + to_r, SMALLEST)
    return maximum(r + both - by_t, 0.0), by_t, share, pulled


@part("Left to T")
def left_to_t(exits, outer, between, r1, e0, e1):
    """What T gets of the interference as a lobe, so that the mean of the whole stays, per channel ``(..., 3)``.

    place      of its mean in the plane, from T's
    ratio      its variance over T's
    aside      how far it is moved from T's along aside, for it lies off the plane as well, over how far the mirror
               direction is from D
    undone     what of that is in the plane, as an angle, for `place` has all that is
    off_plane  squared distance of its mean from the plane
    """
    kept = 1.0 - between.towards_r
    aside = OFF_PLANE * (1.0 - _off_plane_of_x(r1, e0, e1) / kept)
    return SimpleNamespace(place=(between.place + between.towards_r * between.from_mirror) / kept, ratio=between.ratio,
                           aside=aside, undone=aside * exits.beyond * outer.over_cosine,
                           off_plane=squared(aside) * exits.off_plane)


def _off_plane_of_x(r1, e0, e1):
    """How far off the plane, over the mirror direction, T would have to stand for √(RT) to stand on it."""
    return 1.0 / (squared(r1) * widen((e0 + 2.0) / (e1 + 2.0)) + 1.0)


@part("Moments")
def moments(outer, within, between, share, e1):
    """Of T with this share of interference in the plane, per channel ``(..., 3)``.

    mean      from T's
    aside     how far the mean is from there along aside, as of :func:`left_to_t`
    variance
    off_plane what the interference adds to the variance across the plane
    skewed    how far apart two lobes stand that are as lopsided
    flat      the square of how far apart two lobes stand whose top is as flat
    """
    narrower, mixed = outer.variance * between.ratio - outer.variance, share * (1.0 - share)
    apart, apart2, moved = between.place, squared(between.place), share * MEAN_X
    variance = maximum(mix(share, outer.variance * between.ratio, outer.variance) + mixed * apart2,
                       LEAST_VARIANCE * outer.variance)
    mean = multiply_add(moved, apart + between.undone, within.bend * outer.bent)
    third = mixed * apart * multiply_add(1.0 - 2.0 * share, apart2, 3.0 * narrower)
    return SimpleNamespace(mean=mean, aside=moved * between.aside, variance=variance,
                           off_plane=mixed * between.off_plane * SPREAD,
                           skewed=_skewed(outer, within, third, variance, e1),
                           flat=_flat(outer, within, mixed, narrower))


@part("Skewed")
def _skewed(outer, within, third, variance, e1):
    """Refraction's part, what the edge cuts off, and the interference's third moment; at most some deviations."""
    skewed = (multiply_add(outer.bent, SKEW, within.skew * outer.flat * (-1.0 * _deviation(e1)))
              + third / variance * SKEW_X)
    return skewed * sqrt(variance / multiply_add(squared(skewed), 1.0 / MOST_SKEW ** 2, variance))


@part("Flat")
def _flat(outer, within, mixed, narrower):
    """From the fourth cumulant, which is below 0 for flat tops."""
    fourth = multiply_add(FLAT_CUT * (1.0 - within.kept), squared(outer.variance), mixed * squared(narrower) * -3.0)
    return sqrt(fourth) * FLAT


@part("Pair")
def pair(exits, outer, moments, share, r1, e0, e1):
    """The two lobes, per channel ``(..., 3)``: place in the plane and along aside, weight, roughness and anisotropy."""
    mean, variance, skewed = moments.mean, moments.variance, moments.skewed
    both = maximum(multiply_add(skewed, skewed, moments.flat), SMALLEST)
    apart2 = minimum(both, MOST_APART * variance)
    half_within = multiply_add(apart2, -0.125, 0.5 * variance)
    over_apart = power(apart2, -0.5)
    apart, lean = apart2 * over_apart, skewed * over_apart
    weight = multiply_add(lean, UNEVEN, 0.5)
    farther_place = mean + weight * apart
    rough, round_ = _shape(exits, outer, half_within, moments.off_plane, share, r1, e0, e1)
    farther, anisotropy = minimum(outer.tangent * apart, MOST_FARTHER), 1.0 - round_
    rougher = multiply_add(farther, B2, multiply_add(lean, B1, 1.0))
    rounder = multiply_add(farther, A2, multiply_add(lean, A1, 1.0))
    return [SimpleNamespace(place=farther_place - apart, aside=moments.aside, weight=weight,
                            roughness=rough * (2.0 - rougher), anisotropy=mix(rounder, anisotropy, 1.0)),
            SimpleNamespace(place=farther_place, aside=moments.aside, weight=1.0 - weight,
                            roughness=rough * rougher, anisotropy=mix(2.0 - rounder, anisotropy, 1.0))]


@part("Shape of a Lobe", "roughness", "roundness")
def _shape(exits, outer, half_within, off_plane, share, r1, e0, e1):
    """Roughness of a lobe of twice this variance in the plane, and 1 - its anisotropy.

    The Beckmann slopes are √(variance/2) in the plane and across it √(variance across/(1 + V.L)), for normals stand
    V.H times as far apart there as L does.
    """
    across_t = squared(r1) / widen(e1 + 2.0)
    across_x = 2.0 / (widen(e0 + 2.0) + 1.0 / across_t)
    across = maximum(mix(share, across_x, across_t) + off_plane, LEAST_VARIANCE * across_t)
    v_l = outer.cosine * widen(exits.n0_v) - outer.sine * exits.back
    slope2 = across / maximum(1.0 + v_l, LEAST_1_V_L)
    return power(half_within * slope2, 0.125), power(half_within / slope2, 0.25)


@part("R's Lobe")
def reflected(exits, f, e0):
    """R's lobe but for the interference, in numbers where no channel differs.

    albedo      half of ∫ R (N.L) dω, ``(..., 3)``: F's constant part over the cut-off lobe, and (1 - c)^5 c to its
                second derivative
    lost        what a closure of this albedo is multiplied with, for what it loses at the horizon
    lean        of the normal from n0 to V
    roughness, anisotropy

    >>> import numpy as np
    >>> up = np.array([0.0, 0.0, 1.0])
    >>> reflected(exits_of(up, up, 0.0 * up, np.full(3, 1.5)), np.full(3, 0.04), 90.0).albedo.round(4)
    array([0.02, 0.02, 0.02])
    """
    cosine, variance = exits.n0_v, 1.0 / (e0 + 2.0)
    cut = cosine * (R_SPAN / sqrt(variance))
    mean = cosine + sqrt(variance) * lookup(cut, R_KNOTS, R_MORE)
    away = 1.0 - cosine
    away2 = away * away
    grazing = away2 * away * (away2 * mean + variance * exits.across_v * (15.0 * cosine - 5.0))
    lean = _lean(cosine, dot(f, MEAN), variance)
    root = sqrt(maximum(cosine + lean, LEAST_V_H))
    return SimpleNamespace(
        albedo=0.5 * f * widen(mean) + (0.5 - 0.5 * f) * widen(grazing), lost=lookup(cut, R_KNOTS, R_LOST),
        lean=lean, roughness=power(0.5 * variance, 0.25) / sqrt(root), anisotropy=1.0 - root)


@part("Lean of R")
def _lean(cosine, f, variance):
    """N.L moves R's peak up, F towards the horizon, by the variance times their logarithms' slopes."""
    away = 1.0 - cosine
    away2 = away * away
    steep = (1.0 - f) * (away2 * away2)
    rise = 5.0 * steep / (f + steep * away)
    return 0.5 * maximum(minimum((1.0 / cosine - rise) * variance, MOST_LEAN), LEAST_LEAN)


def light_of_the_layer(view, n0, aside, r1, d, wavelengths, e0, e1, published=0.0):
    """Everything about the lobes but their closures, by name.

    view, n0 ``(..., 3)`` of length 1, aside ``(..., 3)`` the part of n1 across n0; r1, wavelengths ``(..., 3)``; d in
    nm, exponents ``(...)``.  r, t are what R's lobe and T's pairs reflect, ``(..., 3)``.

    >>> import numpy as np
    >>> up = np.array([0.0, 0.0, 1.0])
    >>> light = light_of_the_layer(up, up, 0.0 * up, np.full(3, 1.5), 0.0, np.full(3, 500.0), 98.0, 170.0)
    >>> (light.r + light.t).round(2)
    array([1.33, 1.33, 1.33])
    """
    f = f_eq8(r1)
    exits = exits_of(view, n0, aside, r1)
    within = within_the_layer(exits, r1, f, e1)
    outer = outside(exits, within, r1, e1)
    between = interference(exits, within, outer, r1, d, wavelengths, f, e0, e1)
    mirrored = reflected(exits, f, e0)
    r, t, share, pulled = dealt_out(mirrored.albedo, within.albedo, between.albedo, between.towards_r, e0, e1,
                                    published)
    shape = moments(outer, within, left_to_t(exits, outer, between, r1, e0, e1), share, e1)
    return SimpleNamespace(exits=exits, outer=outer, mirrored=mirrored, r=r, t=t, pulled=_pull(exits, pulled),
                           halves=pair(exits, outer, shape, share, r1, e0, e1))


@part("Pull")
def _pull(exits, pulled):
    """How far R's normal leans along aside, for the interference that R gets stands between its lobe and T's."""
    return dot(pulled * exits.along, MEAN) * (0.5 * PULL / exits.n0_v)


def native_lobes(view, n0, aside, *layer):
    """The seven native lobes: R's, and two of T for red, green and blue.

    Operands as of :func:`light_of_the_layer`.  Each lobe has a normal, not of length 1, and a colour ``(..., 3)``, and
    the roughness and the anisotropy of a Glossy BSDF, ``(...)``, and its tangent ``(..., 3)``.

    >>> import numpy as np
    >>> up = np.array([0.0, 0.0, 1.0])
    >>> lobes = native_lobes(up, up, 0.0 * up, np.full(3, 1.5), 0.0, np.full(3, 500.0), 98.0, 170.0)
    >>> len(lobes), lobes[0].normal.round(2).tolist(), round(float(lobes[0].roughness), 3)
    (7, [0.0, 0.0, 1.0], 0.266)
    """
    light = light_of_the_layer(view, n0, aside, *layer)
    lobes = [mirrored_lobe(view, n0, aside, light)]
    for half in light.halves:
        lobes += transmitted_lobes(n0, aside, light.exits, half, aim(light.exits, light.outer, half, light.t, layer[0]))
    return lobes


@part("Lobe of R")
def mirrored_lobe(view, n0, aside, light):
    """R's, as :func:`native_lobes` gives it."""
    mirrored = light.mirrored
    return SimpleNamespace(normal=n0 + widen(mirrored.lean) * view + widen(light.pulled) * aside,
                           colour=light.r * widen(mirrored.lost),
                           roughness=mirrored.roughness, anisotropy=mirrored.anisotropy,
                           tangent=light.exits.v_across)


@part("Aim")
def aim(exits, outer, half, albedo, r1):
    """How far the normals that mirror V to the lobes' places lean from n0 along V's part across it and along aside;
    and the lobes' colour, for what closures lose at the horizon; per channel ``(..., 3)``."""
    height = multiply_add(half.place, -1.0 * outer.sine, outer.cosine + widen(exits.n0_v))
    on_plane = multiply_add(half.place, outer.cosine, outer.sine) * exits.inverse_sine
    hidden = multiply_add(lookup(outer.cosine, KNOTS, HIDDEN), squared(r1) - HIDES, 1.0)
    return SimpleNamespace(on_v=(1.0 - on_plane) / height, on_aside=(on_plane - half.aside) * exits.along / height,
                           colour=albedo * hidden * half.weight)


def transmitted_lobes(n0, aside, exits, half, aim):
    """One half of T's pairs, as :func:`native_lobes` gives them."""
    return [SimpleNamespace(normal=_turned(n0, exits.v_across, aside, of(aim.on_v), of(aim.on_aside)),
                            colour=aim.colour * channel, roughness=of(half.roughness), anisotropy=of(half.anisotropy),
                            tangent=exits.across_d)
            for of, channel in CHANNELS]


@part("Turned Normal")
def _turned(n0, v_across, aside, on_v, on_aside):
    return mix(widen(on_v), n0 + v_across, n0) + widen(on_aside) * aside
