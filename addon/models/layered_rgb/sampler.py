"""Draws directions of light for the layered RGB model, and weighs them: the exact realisation.

A glossy lobe of no width about H = (V + L)/|V + L| sends the path from V to L;
with the colour f(L,V) (N.L)/p(L), where p is the density that L was drawn from,
the average over samples is the integral of f.

**Proposal.**  One of four lobes is picked: the reflected one about the mirror
direction, or one a channel in the layer about the direction w from which the
light reaches n1, refracted outwards.  p is the density of the whole mixture, so
f (N.L)/p stays below a few times the albedo.  Where w lies beyond total
reflection, the lobe's axis is turned to the edge of the cone that leaves the
layer; it would be drawn in vain otherwise.  The shares follow what each lobe
reflects.

**Width.**  A mirror cannot be hit by light sampling.  With a width w in [0, 1)
each drawn H carries a narrow Beckmann lobe, and L is drawn from, and weighed by,
a formula whose three parts R, T and √(RT) are each so much narrower that the
lobe blurs them back: a lobe cos^e is a Gaussian of variance 1/(e + 2), variances
add, and (e' + 2) = (e + 2)/(1 - taken) where the share "taken" of the variance
is the Beckmann lobe's.  That lobe has the share w² of the mean variance of the
transmitted lobes: the same for all channels, as each draw carries all three.
√(RT) is a Gaussian between the lobes; raised to the power ν it is narrower about
the same place, and a factor restores its height.

X. Granier, W. Heidrich, "A Simple Layered RGB BRDF Model", Graphical Models 65(4), 2003.
"""

from types import SimpleNamespace

from ...operands import (
    absolute,
    clip,
    cos,
    cross,
    dot,
    exp,
    less,
    maximum,
    minimum,
    normalize,
    part,
    power,
    sin,
    sqrt,
    vector,
    where,
    widen,
    x_of,
    y_of,
)
from ...reflectance.directions import PI, frame_about, half_vector, in_frame
from .formulas import (
    cos_refracted,
    f_eq8,
    fresnel_eq7,
    inner_products,
    layer_is_reached,
    lobe_scale,
    phase_eq3,
    rho_of_parts,
    squared,
    transmission_eq9,
)

__all__ = ["narrowed_exponent", "proposal", "tapered_width", "narrowed", "draw", "weight", "kernel",
           "roughness_and_anisotropy"]

MEAN = (1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0)
LEAST_SHARE = 1e-4
SMALLEST = 1e-12

MOST_STRETCH = 2.5
LEAST_V_H = 0.2
TAPER = 3.0
LEAST_WIDTH = 0.25
MOST_TAKEN = 0.81
"""Share of a lobe's variance that the Beckmann lobe may be."""
TAKEN_FROM_R = 0.3
MOST_RISE = 30.0
"""Of the exponent that restores the height of √(RT)."""


def narrowed_exponent(exponent, taken):
    """The exponent of a lobe that a share of its variance is taken from, taken in [0, 1).

    >>> narrowed_exponent(98.0, 0.0), round(narrowed_exponent(98.0, 0.36), 2)
    (98.0, 154.25)
    """
    return (exponent + 2.0) / (1.0 - taken) - 2.0


@part("Proposal")
def proposal(view, n0, n1, r1, e0, e1):
    """The mixture that L is drawn from: lobe axes in the layer and the share of each lobe.

    view, n0, n1 ``(..., 3)`` of length 1, r1 ``(..., 3)``, exponents ``(...)``.

    cos_o ``(..., 3)``   cosine of V refracted into the layer
    turn, lift           the axis of a transmitted lobe is turn * w + lift * n0,
                         per channel ``(..., 3)``; w itself where it can leave
    share_r ``(...)``    share of the reflected lobe
    shares ``(..., 3)``  shares of the transmitted lobes; all four sum to 1
    clearance ``(...)``  height of the lobes over the horizon in their own
                         widths, the mean by the shares
    apart ``(..., 3)``   1 - <w, mirror direction refracted into the layer>

    >>> import numpy as np
    >>> up, r1 = np.array([0.0, 0.0, 1.0]), np.full(3, 1.5)
    >>> lobes = proposal(up, up, up, r1, 90.0, 170.0)
    >>> round(float(lobes.share_r + lobes.shares.sum()), 6), lobes.turn
    (1.0, array([1., 1., 1.]))
    """
    n0_v = dot(n0, view)
    cos_o = cos_refracted(n0_v, r1)
    n0_n1 = dot(n0, n1)
    n1_o = widen(dot(n1, view) - n0_v * n0_n1) / r1 + widen(n0_n1) * cos_o
    cos_w = 2.0 * n1_o * widen(n0_n1) - cos_o
    turn, lift, cos_axis = _axis(cos_w, r1)
    share_r, shares = _shares(n0_v, cos_o, turn + lift * cos_w, r1, e1)
    clearance = _clearance(n0_v, cos_axis, share_r, shares, r1, e0, e1)
    n1_mirror = 2.0 * widen(n0_n1) * cos_o - n1_o
    apart = 2.0 * (squared(cos_o) - n1_o * n1_mirror)
    return SimpleNamespace(cos_o=cos_o, turn=turn, lift=lift, share_r=share_r, shares=shares,
                           clearance=clearance, apart=apart)


@part("Axis in the Layer", "turn", "lift", "cosine")
def _axis(cos_w, r1):
    """turn and lift of :func:`proposal`, and the axis's cosine."""
    sin_w = sqrt(1.0 - cos_w * cos_w)
    sin_edge = 1.0 / r1
    cos_edge = sqrt(1.0 - sin_edge * sin_edge)
    turn = minimum(sin_edge / maximum(sin_w, SMALLEST), 1.0)
    cos_axis = maximum(cos_w, cos_edge)
    return turn, cos_axis - turn * cos_w, cos_axis


@part("Shares of the Lobes", "of R", "of T")
def _shares(n0_v, cos_o, cos_to_axis, r1, e1):
    """Shares of the reflected lobe and of the transmitted ones.

    cos_to_axis  <axis, w>: 1 inside the cone; beyond it the lobe has fallen to its e1-th power at the edge
    """
    f = f_eq8(r1)
    fresnel = fresnel_eq7(n0_v, f)
    leaves = (1.0 - fresnel) * transmission_eq9(cos_o, f) * r1 * r1 * cos_o
    leaves = leaves * power(clip(cos_to_axis, 0.0, 1.0), widen(e1)) / 3.0 + LEAST_SHARE
    reflected = dot(fresnel, MEAN) * n0_v + LEAST_SHARE
    total = reflected + 3.0 * dot(leaves, MEAN)
    return reflected / total, leaves / widen(total)


@part("Clearance")
def _clearance(n0_v, cos_axis, share_r, shares, r1, e0, e1):
    """Height of the lobes over the horizon in their own widths."""
    exit_cos = sqrt(1.0 - r1 * r1 * (1.0 - cos_axis * cos_axis))
    stretch = minimum(cos_axis / maximum(exit_cos, SMALLEST), MOST_STRETCH)
    return share_r * n0_v * sqrt(e0 + 2.0) + dot(shares, exit_cos / (r1 * stretch)) * sqrt(e1 + 2.0)


@part("Tapered Width")
def tapered_width(lobes, width):
    """The width where the lobes stand clear of the horizon, down to a quarter of it where they touch it.

    Near the horizon refraction stretches the lobes out of the shape that a
    native lobe can have, and part of that would end up below the horizon.

    >>> tapered_width(SimpleNamespace(clearance=7.0), 0.3), tapered_width(SimpleNamespace(clearance=0.0), 0.4)
    (0.3, 0.1)
    """
    return width * clip(lobes.clearance / TAPER, LEAST_WIDTH, 1.0)


@part("Narrowed")
def narrowed(lobes, r1, e0, e1, width):
    """The parts of the formula, so much narrower that Beckmann lobes of this width blur them back.

    lobes from :func:`proposal`; r1 ``(..., 3)``, exponents and width ``(...)``.

    taken_r ``(...)``, taken_t ``(..., 3)``   share of the variance taken from R and from T
    e0 ``(...)``, e1 ``(..., 3)``             their exponents
    slope_r, slope_t ``(...)``                rms slope of the Beckmann lobe, straight above
    power ``(..., 3)``                        what √(RT) is raised to
    rise ``(..., 3)``                         what it is multiplied with

    >>> import numpy as np
    >>> up, r1 = np.array([0.0, 0.0, 1.0]), np.full(3, 1.5)
    >>> of_t = narrowed(proposal(up, up, up, r1, 90.0, 170.0), r1, 90.0, 170.0, 0.3)
    >>> of_t.taken_t.round(4), of_t.power.round(3)
    (array([0.09, 0.09, 0.09]), array([1.11, 1.11, 1.11]))
    """
    inverse_r, inverse_t = e0 + 2.0, widen(e1 + 2.0) / squared(r1)
    share = width * width
    variance = share * dot(squared(r1), MEAN) / (e1 + 2.0)
    taken_r = clip(variance * inverse_r, 0.5 * share, maximum(share, TAKEN_FROM_R))
    taken_t = minimum(widen(variance) * inverse_t, MOST_TAKEN)
    both = widen(inverse_r) + inverse_t
    exponent = 1.0 / (1.0 - minimum(0.5 * widen(variance) * both, MOST_TAKEN))
    depth = 0.5 * widen((e0 + 2.0) * (e1 + 2.0)) * lobes.apart / both
    rise = exponent * exp(minimum((exponent - 1.0) * depth, MOST_RISE))
    return SimpleNamespace(
        taken_r=taken_r, taken_t=taken_t, e0=part("Narrowed Exponent")(narrowed_exponent)(e0, taken_r),
        e1=part("Narrowed Exponents")(narrowed_exponent)(widen(e1), taken_t), slope_r=sqrt(0.5 * taken_r / inverse_r),
        slope_t=sqrt(0.5 * variance), power=exponent, rise=rise)


@part("Drawn L")
def draw(lobes, narrow, view, n0, n1, r1, u_lobe, u_cos, u_phi):
    """A direction L drawn from the mixture, and which lobe it came from.

    lobes from :func:`proposal`, narrow from :func:`narrowed`; u_lobe, u_cos, u_phi
    independent numbers from [0, 1), ``(...)``.  With index 1 and n0 for n1 the reflected lobe is drawn by
    the same steps as a transmitted one.

    light ``(..., 3)``; valid is 0 where the draw does not leave the layer, and
    light then means nothing; light_cos, inside_cos: cosines to n0 outside and in
    the layer; index and slope: those of the lobe and of Beckmann's in it; all ``(...)``.

    >>> import numpy as np
    >>> up, r1 = np.array([0.0, 0.0, 1.0]), np.full(3, 1.5)
    >>> lobes = proposal(up, up, up, r1, 90.0, 170.0)
    >>> draw(lobes, narrowed(lobes, r1, 90.0, 170.0, 0.0), up, up, up, r1, 0.5, 1.0, 0.0).light
    array([0., 0., 1.])
    """
    is_r, channel = _picked(lobes, u_lobe)
    index = is_r + dot(channel, r1)
    exponent = is_r * narrow.e0 + dot(channel, narrow.e1)
    n0_v = dot(n0, view)
    cos_o = is_r * n0_v + dot(channel, lobes.cos_o)
    upwards = view / widen(index) + widen(cos_o - n0_v / index) * n0
    normal = where(widen(is_r), n0, n1)
    w = widen(2.0 * dot(upwards, normal)) * normal - upwards
    axis = widen(is_r + dot(channel, lobes.turn)) * w + widen(dot(channel, lobes.lift)) * n0
    inside = _around(axis, power(u_cos, 1.0 / (exponent + 1.0)), 2.0 * PI * u_phi)
    return SimpleNamespace(**vars(_out_of_the_layer(inside, index, n0)), index=index,
                           slope=where(is_r, narrow.slope_r, narrow.slope_t))


@part("Out of the Layer")
def _out_of_the_layer(inside, index, n0):
    """The direction outside, whether there is one, and its cosine, by name."""
    inside_cos = dot(inside, n0)
    across = widen(index) * (inside - widen(inside_cos) * n0)
    sine2 = dot(across, across)
    light_cos = sqrt(1.0 - sine2)
    return SimpleNamespace(light=across + widen(light_cos) * n0, valid=less(sine2, 1.0) * less(0.0, inside_cos),
                           light_cos=light_cos)


@part("Drawn Lobe of the Layer", "is R", "channel")
def _picked(lobes, u_lobe):
    """1.0 for the lobe that u_lobe picks: the reflected one, and the channels as a colour."""
    first = lobes.share_r + x_of(lobes.shares)
    below_r, below_red = less(u_lobe, lobes.share_r), less(u_lobe, first)
    below_green = less(u_lobe, first + y_of(lobes.shares))
    return below_r, vector(below_red - below_r, below_green - below_red, 1.0 - below_green)


@part("Direction about an Axis")
def _around(axis, cos_alpha, phi):
    """The unit direction at the angle α from the axis, turned by φ about it."""
    sine = sqrt(1.0 - cos_alpha * cos_alpha)
    return in_frame(sine * cos(phi), sine * sin(phi), cos_alpha, *frame_about(axis), axis)


@part("f (N·L)/p")
def weight(lobes, narrow, drawn, view, n0, n1, r1, d, wavelengths, e0, e1, published=0.0):
    """ρ (N.L)/p of a drawn direction, its parts narrowed, ``(..., 3)``; 0 where the draw was in vain.

    >>> import numpy as np
    >>> up, r1 = np.array([0.0, 0.0, 1.0]), np.full(3, 1.5)
    >>> lobes = proposal(up, up, up, r1, 90.0, 170.0)
    >>> narrow = narrowed(lobes, r1, 90.0, 170.0, 0.0)
    >>> drawn = draw(lobes, narrow, up, up, up, r1, 0.5, 1.0, 0.0)
    >>> weight(lobes, narrow, drawn, up, up, up, r1, 0.0, np.full(3, 500.0), 90.0, 170.0).round(2)
    array([1.38, 1.38, 1.38])
    """
    cosines = inner_products(drawn.light, view, n0, n1, r1)
    phase = phase_eq3(cosines.cos_i, cosines.cos_o, r1, d, wavelengths)
    rho = rho_of_parts(*narrowed_parts(cosines, narrow, r1, e0, e1, published), phase)
    p = _density(lobes, narrow, cosines, r1)
    return rho * widen(drawn.valid * cosines.n0_l / maximum(p, SMALLEST))


@part("R and T narrowed", "R", "T", "√RT")
def narrowed_parts(cosines, narrow, r1, e0, e1, published=0.0):
    """R, T and √(RT) with the variance taken from each that Beckmann lobes put back, ``(..., 3)``.

    At width 0 they are those of eq. 5.

    >>> import numpy as np
    >>> up, r1 = np.array([0.0, 0.0, 1.0]), np.full(3, 1.5)
    >>> narrow = narrowed(proposal(up, up, up, r1, 90.0, 170.0), r1, 90.0, 170.0, 0.0)
    >>> r, t, root = narrowed_parts(inner_products(up, up, up, up, r1), narrow, r1, 90.0, 170.0)
    >>> np.allclose(r * t, root * root)
    True
    """
    f = f_eq8(r1)
    reflects = fresnel_eq7(cosines.n0_l, f)
    reached = layer_is_reached(cosines.n1_i, cosines.n1_o, cosines.lobe)
    passes = (1.0 - reflects) * transmission_eq9(cosines.cos_o, f) * reached
    mirror, lobe = maximum(cosines.mirror, 0.0), maximum(cosines.lobe, 0.0)
    scale_r, scale_t = lobe_scale(e0, published), lobe_scale(e1, published)
    r = reflects * widen(power(mirror, narrow.e0) * scale_r / (1.0 - narrow.taken_r))
    t = passes * power(lobe, narrow.e1) * (widen(scale_t) / (1.0 - narrow.taken_t))
    root = sqrt(reflects * passes * widen(scale_r * scale_t)) * narrow.rise
    root = root * power(widen(power(mirror, 0.5 * e0)) * power(lobe, widen(0.5 * e1)), narrow.power)
    return r, t, root


@part("Density p")
def _density(lobes, narrow, cosines, r1):
    """Density p(L) of the whole mixture per steradian outside, ``(...)``.

    In the layer the lobes are (e+1)/(2π) cos^e; a solid angle there is
    (N.L)/(r1² cos_i) times as large outside.
    """
    reflected = (narrow.e0 + 1.0) * power(maximum(cosines.mirror, 0.0), narrow.e0)
    to_axis = maximum(lobes.turn * cosines.lobe + lobes.lift * cosines.cos_i, 0.0)
    transmitted = (narrow.e1 + 1.0) * power(to_axis, narrow.e1) / (squared(r1) * cosines.cos_i)
    transmitted = cosines.n0_l * dot(lobes.shares, transmitted)
    return (lobes.share_r * reflected + transmitted) / (2.0 * PI)


@part("Lobe about H")
def kernel(drawn, view, n0):
    """The Beckmann lobe about H in place of a mirror.

    It is round in the layer for a transmitted lobe, round outside for the
    reflected one.  Refraction stretches it outside in the plane of n0 and L, by
    cos_i/(N.L); a mirror stretches it across the plane of V and H, by 1/(V.H).
    The slopes and the tangent are the axes of the ellipse that both make.

    normal = H and tangent ``(..., 3)``; slope_along the tangent, slope_across it
    ``(...)``: Beckmann's rms slopes; 0 for width 0.

    >>> import numpy as np
    >>> up, view = np.array([0.0, 0.0, 1.0]), np.array([0.6, 0.0, 0.8])
    >>> drawn = SimpleNamespace(light=view * [-1.0, 1.0, 1.0], index=1.5, slope=0.1, light_cos=0.8)
    >>> lobe = kernel(drawn, view, up)
    >>> lobe.normal.round(3) + 0.0, round(float(lobe.slope_along), 4), round(float(lobe.slope_across), 4)
    (array([0., 0., 1.]), 0.1146, 0.125)
    """
    half = half_vector(view, drawn.light)
    across = normalize(cross(half, view))
    along = cross(half, across)
    bend = 1.0 - 1.0 / squared(drawn.index)
    steep = bend / maximum(squared(drawn.light_cos), bend / (MOST_STRETCH * MOST_STRETCH - 1.0) + SMALLEST)
    x, y = dot(n0, cross(drawn.light, across)), dot(n0, across)
    v_h = maximum(dot(view, half), LEAST_V_H)
    to_along, to_across, slope_along, slope_across = _ellipse(x, y, v_h, steep)
    return SimpleNamespace(normal=half, tangent=normalize(widen(to_along) * along + widen(to_across) * across),
                           slope_along=drawn.slope * slope_along, slope_across=drawn.slope * slope_across)


@part("Ellipse of the Lobe", "along", "across", "slope along", "slope across")
def _ellipse(x, y, v_h, steep):
    """The first axis of the ellipse (xx, xy; xy, yy) along and across the plane of V and H, that nearer to "along",
    and how far both reach.
    """
    xx, xy, yy = 1.0 + steep * x * x, steep * x * y / v_h, (1.0 + steep * y * y) / (v_h * v_h)
    gap = absolute(xx - yy)
    spread = sqrt(gap * gap + 4.0 * (xy * xy))
    side = where(less(xx, yy), -1.0, 1.0)
    turned = side * spread
    return (gap + spread + SMALLEST, 2.0 * side * xy, sqrt(0.5 * (xx + yy + turned)), sqrt(0.5 * (xx + yy - turned)))


@part("Roughness and Anisotropy", "roughness", "anisotropy")
def roughness_and_anisotropy(slope_in, slope_across):
    """What the Glossy BSDF makes these two slopes from, its Tangent in the plane of the first.

    Cycles squares the roughness to α; with anisotropy a ≥ 0 its slopes are
    α (1 - a) and α/(1 - a), with a < 0 they are α/(1 + a) and α (1 + a).

    >>> [round(float(x), 4) for x in roughness_and_anisotropy(0.04, 0.16)]
    [0.2828, 0.5]
    """
    ratio = sqrt(slope_in / maximum(slope_across, SMALLEST))
    anisotropy = where(less(ratio, 1.0), 1.0 - ratio, 1.0 / maximum(ratio, 1.0) - 1.0)
    return sqrt(sqrt(slope_in * slope_across)), anisotropy
