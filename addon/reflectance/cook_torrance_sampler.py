"""Drawing facets of the Cook-Torrance model, for renderers that cannot evaluate it.

Proposal: the normals that the viewer sees between V-shaped grooves.  A groove
has two sides, H and its mirror image H' about N; draw one from D cos α and keep
the side that V sees, with probability (V·H)⁺/((V·H)⁺ + (V·H')⁺).  The density
is p(L) = G1 D/(4π N·V), so the weight f (N·L)/p(L) is F G/G1: no D in it, never
above F, and 1 on most of the lobe.  E. Heitz and E. d'Eon, "Importance Sampling
Microfacet-Based BSDFs using the Distribution of Visible Normals", EGSR 2014.

With Sampling Width 0 that is all, and exact.  With a width above 0 a native
Beckmann lobe that lies under f carries most of the light (:func:`native_share`),
and narrow lobes about drawn facets only what is left of f above it.
"""

from types import SimpleNamespace

from ..operands import absolute, clip, cos, dot, exp, less, maximum, minimum, sin, sqrt, term, where, widen
from .directions import PI, frame_about
from .fresnel import COS_THETA_82, conductor, f82, f82_tint_of
from .masking import smith_beckmann, v_cavity, v_cavity_one_side
from .sampling import narrowed, tilt, towards_flanks
from .slopes import gaussian_c

__all__ = ["native_share", "kept", "native_fresnel", "scales", "facet", "facet_weight", "sharpened_v_cavity",
           "HEADROOM", "FLANKS"]

SMALLEST = 1e-6
STEEPEST = 1.55
"""Largest tilt of a drawn facet in radians; steeper ones carry no light."""

HEADROOM = 0.97
"""Keeps the native lobe under f where its F82 Fresnel term lies above the exact one."""


FLANKS = 0.8
"""How far facets for the light above the native lobe are drawn from its flanks, where most of it is."""


@term("Native share")
def native_share(n_v, m):
    """Share w of the light that a native Beckmann lobe of slope m√w can carry without passing f.

    n_v  N·V, ``(...)``
    m    rms slope, ``(...)``

    With x = tan(half the angle from V to the horizon)/m, how far in slopes the
    facets are that mirror V into the horizon: w is the largest of 0.57,
    0.36 + 0.18 x and the hump min(0.5 + x, 1.1 − 0.6 x), which is lower above
    m = 0.5; at most 1.  Found by comparing the lobes over all L.  Up to 85° from
    the normal what sticks out of f, and is lost, is less than 0.1 % of the light.

    >>> round(float(native_share(1.0, 0.2)), 6)                # smooth, from above: all of it
    1.0
    >>> round(float(native_share(0.5, 0.3)), 6)
    0.57
    """
    cosine = clip(n_v, 0.0, 1.0)
    x = cosine / ((1.0 + sqrt(1.0 - cosine * cosine)) * m)
    hump = minimum(0.5 + x, 1.1 - 0.6 * x - 0.4 * maximum(m - 0.5, 0.0))
    return minimum(1.0, maximum(0.57, 0.36 + 0.18 * x, hump))


@term("Roulette")
def kept(share):
    """Probability of drawing a facet at all: little where the native lobe leaves little.

    share  of :func:`native_share`

    A drawn facet's weight is divided by it; the nodes of a facet that is not
    drawn are not evaluated.

    >>> float(kept(0.57)), round(float(kept(1.0)), 6)
    (1.0, 0.15)
    """
    return minimum(1.0, 2.35 - 2.2 * share)


@term("F0, F82")
def native_fresnel(n, k):
    """F0 and tint of the F82 model for the native lobe, each within [0, 1], ``(..., 3)``.

    F82 and not the conductor formula, which differs between Blender's versions.

    >>> f0, tint = native_fresnel(0.2, 3.91)
    >>> round(float(f0), 4), round(float(tint), 4)
    (0.9522, 0.9783)
    """
    f0 = conductor(1.0, n, k)
    return f0, clip(f82_tint_of(maximum(f0, SMALLEST), conductor(COS_THETA_82, n, k)), 0.0, 1.0)


@term("Scale")
def scales(m, gaussian, published, printed_c):
    """Factors on the energy-conserving lobe of slope m: of f, and of the native lobe, at most four.

    gaussian   0 for Beckmann's D, 1 for the Gaussian
    published  0 for the energy scale, 1 for the printed one: four times as
               bright, with printed_c in place of the c that normalises

    >>> scales(0.2, 0.0, 0.0, 1.0), scales(0.2, 0.0, 1.0, 1.0)
    ((1.0, 1.0), (4.0, 4.0))
    """
    printed = 4.0 * (1.0 + gaussian * (printed_c / gaussian_c(m) - 1.0))
    scale = 1.0 + published * (printed - 1.0)
    return scale, minimum(scale, 1.0 + 3.0 * published)


@term("H")
def facet(n, v, m, a, share, flanks, gaussian, u_tilt, u_azimuth, u_side):
    """A facet of rms slope m drawn as the viewer sees it, for a lobe of slope a about it.

    n, v       unit directions, ``(..., 3)``
    m, a       rms slope and narrow slope, ``(...)``; a = 0 draws exactly
    share      of :func:`native_share`, for d_native
    flanks     [0, 1], how far the drawing keeps to the flanks of the lobe; 0 draws as D
    gaussian   0 for Beckmann's D, 1 for the Gaussian
    u_...      independent and even in [0, 1)

    Returns by name: h, the facet's normal ``(..., 3)``; a, and spread, the slope
    of the lobe about it in its own frame; and to weigh it, at the stretched facet (see
    :func:`addon.reflectance.sampling.narrowed`): the cosines n_h, v_h, n_v,
    n_l, d_native, which is D of the native lobe over D, and density, which is D
    over the drawn density's part that depends on the distribution and the side.

    >>> from .directions import direction
    >>> up = direction(0.0, 0.0)
    >>> x = facet(up, up, 0.5, 0.0, 1.0, 0.0, 0.0, 0.36787944, 0.0, 0.0)
    >>> round(float(x.n_h), 4), round(float(x.v_h), 4), float(x.density)     # tan α = m
    (0.8944, 0.8944, 1.0)
    """
    m_drawn, stretch = narrowed(m, a)
    kept, drawn_density = towards_flanks(u_tilt, flanks)
    drawn = tilt(kept, m_drawn)
    tilted = [where(gaussian, g, b) for g, b in zip(_gaussian(drawn, stretch, m, share),
                                                    _beckmann(drawn, stretch, m, share))]
    sine_drawn, cos_drawn, sine, n_h, density, d_native, narrowing = tilted

    t, b = frame_about(n)
    phi = 2.0 * PI * u_azimuth
    across = widen(cos(phi)) * t + widen(sin(phi)) * b
    n_v, across_v = dot(n, v), dot(across, v)
    this = maximum(cos_drawn * n_v + sine_drawn * across_v, 0.0)
    other = maximum(cos_drawn * n_v - sine_drawn * across_v, 0.0)
    is_other = less(this, u_side * (this + other))
    side = 1.0 - 2.0 * is_other

    v_h = n_h * n_v + side * sine * across_v
    seen = maximum(v_cavity_one_side(cos_drawn, n_v, where(is_other, other, this)), SMALLEST)
    return SimpleNamespace(
        h=widen(cos_drawn) * n + widen(side * sine_drawn) * across, a=a, spread=a * narrowing,
        n_h=n_h, n_v=n_v, n_l=2.0 * v_h * n_h - n_v, v_h=clip(v_h, 0.0, 1.0),
        density=density * cos_drawn / (seen * drawn_density), d_native=d_native)


def _beckmann(drawn, stretch, m, share):
    """What :func:`facet` needs of a facet with tan α = drawn, in its order.

    In the plane of slopes dω = cos³ α d²slope, which D cos α leaves a 1/cos α of,
    and a lobe that is even in angle is wider by cos^-1.5 α, hence the narrowing.
    """
    slope = drawn * stretch
    cos_drawn, n_h = 1.0 / sqrt(1.0 + drawn * drawn), 1.0 / sqrt(1.0 + slope * slope)
    below = _native_over_d(slope * slope * (1.0 - 1.0 / share), m, stretch, share)
    return (drawn * cos_drawn, cos_drawn, slope * n_h, n_h, 1.0 / n_h, below, cos_drawn * sqrt(cos_drawn))


def _gaussian(drawn, stretch, m, share):
    """What :func:`facet` needs of a facet with α = drawn, in its order.

    In the plane of (α cos φ, α sin φ) dω = sin α/α d²α.
    """
    alpha_drawn = minimum(drawn, STEEPEST)
    alpha = maximum(minimum(alpha_drawn * stretch, STEEPEST), 1e-4)
    sine, n_h = sin(alpha), cos(alpha)
    c_m2 = gaussian_c(m) * (m * m)
    tangent = sine / n_h
    below = _native_over_d(alpha * alpha - tangent * tangent / share, m, stretch, share)
    below = below / (c_m2 * (n_h * n_h) * (n_h * n_h))
    reached = less(alpha, STEEPEST)
    return (sin(alpha_drawn), cos(alpha_drawn), sine, n_h, reached * c_m2 * sine / alpha, below, 1.0)


def _native_over_d(exponent, m, stretch, share):
    """D of the native lobe over D, exp(exponent/m²)/share, evaluated so that blurring it gives this.

    The blur makes exp(−κx) to exp(−κx/(1 + κb))/(1 + κb), with b = stretch − 1
    the relative variance of stretched slopes, so a narrower and higher curve is
    blurred; κ = 1/share − 1.
    """
    sharper = 1.0 / (1.0 - minimum((1.0 / share - 1.0) * (stretch - 1.0), 0.5))
    return exp(exponent * sharper / (m * m)) * sharper / share


@term("G")
def sharpened_v_cavity(n_h, n_v, n_l, v_h, a):
    """The V-cavity G with its kinks raised, so that blurred by lobes of slope a it comes out as G.

    At its kinks, where masking or shadowing sets in, the blur lowers G by about
    0.4 times its change across the blur.  That change is small where masking
    sets in, and three times as large where shadowing does, for L turns twice as
    far as H.  The constants are the best of those tried, on spheres under suns.

    >>> float(sharpened_v_cavity(0.9, 0.2, 0.8, 0.6, 0.0)) == float(v_cavity(0.9, 0.2, 0.8, 0.6))
    True
    >>> float(sharpened_v_cavity(0.8, 0.5, 0.9, 0.8, 0.1)) > 1.0
    True
    """
    groove = 2.0 * n_h / maximum(v_h, SMALLEST)
    reach = a * (1.1 + 2.4 * less(n_l, n_v))
    near = maximum(reach - absolute(1.0 - groove * minimum(n_l, n_v)), 0.0)
    return v_cavity(n_h, n_v, n_l, v_h) + 0.25 * near * near / maximum(reach, SMALLEST)


@term("f cos/p")
def facet_weight(x, m, share, scale, native_weight, n, k, f0, tint):
    """Colour of the lobe about a drawn facet: F G less the native lobe, over the density, ``(..., 3)``.

    x                   from :func:`facet`
    m, share            rms slope, and share of :func:`native_share`
    scale               of f, see :func:`scales`
    native_weight       factor on the native lobe; 0 where there is none
    n, k                complex refractive index, ``(..., 3)``
    f0, tint            of :func:`native_fresnel`

    With native_weight 0 and a facet drawn with a = 0 it is f (N·L)/p(L).

    >>> from .directions import direction
    >>> up = direction(0.0, 0.0)
    >>> x = facet(up, up, 0.5, 0.0, 1.0, 0.0, 0.0, 0.36787944, 0.0, 0.0)
    >>> facet_weight(x, 0.5, 1.0, 1.0, 0.0, 1.5, 0.0, 0.04, 1.0).round(4)
    array([0.0409])
    """
    v_h = widen(x.v_h)
    whole = conductor(v_h, n, k) * widen(scale * sharpened_v_cavity(x.n_h, x.n_v, x.n_l, x.v_h, x.a))
    g_native = smith_beckmann(x.n_v, x.n_l, m * sqrt(share))
    native = f82(v_h, f0, tint) * widen(native_weight * x.d_native * g_native)
    return maximum(whole - native, 0.0) * widen(x.density)
