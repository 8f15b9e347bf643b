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
each drawn H carries a narrow Beckmann lobe that makes up the share w² of the
variance of the lobe it was drawn from, and f is evaluated, and L drawn, with
lobes narrowed to 1 - w² of theirs: (e' + 2) = (e + 2)/(1 - w²).  The two
together have the exponent e again, and the albedo stays as it was.

X. Granier, W. Heidrich, "A Simple Layered RGB BRDF Model", Graphical Models 65(4), 2003.
"""

from types import SimpleNamespace

from ..operands import (
    clip, cos, dot, less, maximum, minimum, power, sin, sqrt, term, vector, where, widen, x_of, y_of,
)
from .directions import PI, frame_about, half_vector, in_frame
from .layered_rgb import (
    cos_refracted, f_eq8, fresnel_eq7, inner_products, layered_specular, transmission_eq9,
)

__all__ = ["narrowed_exponent", "proposal", "tapered_width", "draw", "weight", "kernel",
           "roughness_and_anisotropy", "DEFAULT_WIDTH"]

DEFAULT_WIDTH = 0.3
"""Sampling Width that is open to light sampling; its bias is in docs and tests."""

MEAN = (1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0)
LEAST_SHARE = 1e-4
SMALLEST = 1e-12

MOST_STRETCH = 2.5
LEAST_V_H = 0.2
TAPER = 3.5
LEAST_WIDTH = 0.25


def narrowed_exponent(exponent, width):
    """The exponent of a lobe narrowed to 1 - width² of its variance, width in [0, 1).

    >>> narrowed_exponent(98.0, 0.0), round(narrowed_exponent(98.0, 0.6), 2)
    (98.0, 154.25)
    """
    return (exponent + 2.0) / (1.0 - width * width) - 2.0


@term("Proposal")
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
    sin_w = sqrt(1.0 - cos_w * cos_w)
    sin_edge = 1.0 / r1
    cos_edge = sqrt(1.0 - sin_edge * sin_edge)
    turn = minimum(sin_edge / maximum(sin_w, SMALLEST), 1.0)
    cos_axis = maximum(cos_w, cos_edge)
    lift = cos_axis - turn * cos_w
    # <axis, w>: 1 inside the cone; beyond it the lobe has fallen to its e1-th power at the edge.
    cos_to_axis = turn + lift * cos_w
    f = f_eq8(r1)
    fresnel = fresnel_eq7(n0_v, f)
    leaves = (1.0 - fresnel) * transmission_eq9(cos_o, f) * r1 * r1 * cos_o
    leaves = leaves * power(clip(cos_to_axis, 0.0, 1.0), widen(e1)) / 3.0 + LEAST_SHARE
    reflected = dot(fresnel, MEAN) * n0_v + LEAST_SHARE
    total = reflected + 3.0 * dot(leaves, MEAN)
    share_r, shares = reflected / total, leaves / widen(total)
    exit_cos = sqrt(1.0 - r1 * r1 * (1.0 - cos_axis * cos_axis))
    clearance = share_r * n0_v * sqrt(e0 + 2.0) + dot(shares, exit_cos / r1) * sqrt(e1 + 2.0)
    return SimpleNamespace(cos_o=cos_o, turn=turn, lift=lift, share_r=share_r, shares=shares,
                           clearance=clearance)


def tapered_width(lobes, width):
    """The width where the lobes stand clear of the horizon, down to a quarter of it where they touch it.

    Near the horizon refraction stretches the lobes out of the shape that a
    native lobe can have, and part of that would end up below the horizon.

    >>> tapered_width(SimpleNamespace(clearance=7.0), 0.3), tapered_width(SimpleNamespace(clearance=0.0), 0.4)
    (0.3, 0.1)
    """
    return width * clip(lobes.clearance / TAPER, LEAST_WIDTH, 1.0)


@term("Draw L")
def draw(lobes, view, n0, n1, r1, e0, e1, u_lobe, u_cos, u_phi):
    """A direction L drawn from the mixture, and which lobe it came from.

    lobes from :func:`proposal`; u_lobe, u_cos, u_phi independent numbers from
    [0, 1), ``(...)``.  With index 1 and n0 for n1 the reflected lobe is drawn by
    the same steps as a transmitted one.

    light ``(..., 3)``; valid is 0 where the draw does not leave the layer, and
    light then means nothing; light_cos, inside_cos: cosines to n0 outside and in
    the layer; index, exponent: those of the lobe; all ``(...)``.

    >>> import numpy as np
    >>> up, r1 = np.array([0.0, 0.0, 1.0]), np.full(3, 1.5)
    >>> lobes = proposal(up, up, up, r1, 90.0, 170.0)
    >>> draw(lobes, up, up, up, r1, 90.0, 170.0, 0.5, 1.0, 0.0).light
    array([0., 0., 1.])
    """
    is_r, channel = _picked(lobes, u_lobe)
    index = is_r + dot(channel, r1)
    exponent = where(is_r, e0, e1)
    n0_v = dot(n0, view)
    cos_o = is_r * n0_v + dot(channel, lobes.cos_o)
    upwards = view / widen(index) + widen(cos_o - n0_v / index) * n0
    normal = where(widen(is_r), n0, n1)
    w = widen(2.0 * dot(upwards, normal)) * normal - upwards
    axis = widen(is_r + dot(channel, lobes.turn)) * w + widen(dot(channel, lobes.lift)) * n0
    inside = _around(axis, power(u_cos, 1.0 / (exponent + 1.0)), 2.0 * PI * u_phi)
    inside_cos = dot(inside, n0)
    across = widen(index) * (inside - widen(inside_cos) * n0)
    sine2 = dot(across, across)
    light_cos = sqrt(1.0 - sine2)
    return SimpleNamespace(light=across + widen(light_cos) * n0,
                           valid=less(sine2, 1.0) * less(0.0, inside_cos), light_cos=light_cos,
                           inside_cos=inside_cos, index=index, exponent=exponent)


def _picked(lobes, u_lobe):
    """1.0 for the lobe that u_lobe picks: the reflected one, and the channels as a colour."""
    first = lobes.share_r + x_of(lobes.shares)
    below_r, below_red = less(u_lobe, lobes.share_r), less(u_lobe, first)
    below_green = less(u_lobe, first + y_of(lobes.shares))
    return below_r, vector(below_red - below_r, below_green - below_red, 1.0 - below_green)


def _around(axis, cos_alpha, phi):
    """The unit direction at the angle α from the axis, turned by φ about it."""
    sine = sqrt(1.0 - cos_alpha * cos_alpha)
    return in_frame(sine * cos(phi), sine * sin(phi), cos_alpha, *frame_about(axis), axis)


@term("f (N.L) / p")
def weight(lobes, drawn, view, n0, n1, r1, d, wavelengths, e0, e1, published=0.0, width=0.0):
    """ρ (N.L)/p of a drawn direction, ``(..., 3)``; 0 where the draw was in vain.

    e0, e1 are the exponents that L was drawn with: narrowed ones where there is
    a width.  In the published scale the narrowed lobes are 1/(1 - width²) as
    high; the energy scale has that in its (e + 2)/(2π).

    >>> import numpy as np
    >>> up, r1 = np.array([0.0, 0.0, 1.0]), np.full(3, 1.5)
    >>> lobes = proposal(up, up, up, r1, 90.0, 170.0)
    >>> drawn = draw(lobes, up, up, up, r1, 90.0, 170.0, 0.5, 1.0, 0.0)
    >>> weight(lobes, drawn, up, up, up, r1, 0.0, np.full(3, 500.0), 90.0, 170.0).round(2)
    array([1.38, 1.38, 1.38])
    """
    cosines = inner_products(drawn.light, view, n0, n1, r1)
    rho = layered_specular(cosines, r1, d, wavelengths, e0, e1, published)
    heightened = where(published, 1.0 / (1.0 - width * width), 1.0)
    p = _density(lobes, cosines, r1, e0, e1)
    return rho * widen(drawn.valid * heightened * cosines.n0_l / maximum(p, SMALLEST))


@term("p")
def _density(lobes, cosines, r1, e0, e1):
    """Density p(L) of the whole mixture per steradian outside, ``(...)``.

    In the layer the lobes are (e+1)/(2π) cos^e; a solid angle there is
    (N.L)/(r1² cos_i) times as large outside.
    """
    reflected = (e0 + 1.0) * power(maximum(cosines.mirror, 0.0), e0)
    to_axis = maximum(lobes.turn * cosines.lobe + lobes.lift * cosines.cos_i, 0.0)
    transmitted = power(to_axis, widen(e1)) / (r1 * r1 * cosines.cos_i)
    transmitted = (e1 + 1.0) * cosines.n0_l * dot(lobes.shares, transmitted)
    return (lobes.share_r * reflected + transmitted) / (2.0 * PI)


@term("Lobe about H")
def kernel(drawn, view, width):
    """The Beckmann lobe about H in place of a mirror: width² of the variance of the lobe L was drawn from.

    It is round in the layer for a transmitted lobe, round outside for the
    reflected one, hence two slopes: in the plane of V and H, and across it.

    normal = H ``(..., 3)``; slope_in, slope_across ``(...)``: Beckmann's rms
    slopes; 0 for width 0.

    >>> import numpy as np
    >>> up = np.array([0.0, 0.0, 1.0])
    >>> drawn = SimpleNamespace(light=up, index=1.0, exponent=98.0,
    ...                         inside_cos=1.0, light_cos=1.0)
    >>> lobe = kernel(drawn, up, 0.0)
    >>> lobe.normal, float(lobe.slope_in)
    (array([0., 0., 1.]), 0.0)
    """
    half = half_vector(view, drawn.light)
    slope = width * drawn.index / sqrt(2.0 * (drawn.exponent + 2.0) * (1.0 - width * width))
    stretch = minimum(drawn.inside_cos / maximum(drawn.light_cos, SMALLEST), MOST_STRETCH)
    return SimpleNamespace(normal=half, slope_in=slope * stretch,
                           slope_across=slope / maximum(dot(view, half), LEAST_V_H))


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
