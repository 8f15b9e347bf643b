"""The native Beckmann lobe that comes next to Cook and Torrance's: with Smith's G, but as rough and bright as theirs.

The V-cavity G leaves facets unshadowed up to its kinks and ends rough lobes sooner than Smith's, the more so the
further V leans, and it narrows them in the plane of N and V.  A Beckmann lobe whose slope, weight and anisotropy follow
N·V makes up for most of that.  They were fitted to spheres under suns from 20° to 90° and to the albedo, m from 0.2 to
0.65, that of 60° counting most: first at each N·V by itself, then as polynomials.  On a sphere under a sun at 60°,
where N·V is above 0.2, the rms difference is 0.1 % of the rms at m = 0.2, 0.4 % at 0.3, 1.2 % at 0.4, 2.4 % at 0.5 and
3.5 % at 0.6 (with slope and weight constant 0.0 %, 0.2 %, 1.7 %, 5.2 % and 9.7 %); the albedo is within 1.3 % up to 80°
and m = 0.6.  Smooth surfaces need less: up to m = 0.25 the weight alone, for the albedo at grazing angles, and up to
0.1 nothing.  Where a surface is anisotropic itself, its lobes keep its own anisotropy.
"""

from types import SimpleNamespace

from ...operands import (
    clip,
    cross,
    dot,
    length,
    less,
    maximum,
    minimum,
    mix,
    multiply_add,
    part,
    rotate,
    sqrt,
    vector,
    where,
    widen,
    x_of,
    y_of,
    z_of,
)
from ...reflectance.directions import PI, frame_along

__all__ = ["of_slope", "seen_from", "v_cavity_lobe"]

ROUGHEST_FITTED = 0.65
"""Above this slope the fit's factors are those of this slope."""

SMALLEST_SINE = 1e-4

HEIGHT2 = 2.5
"""Times 1 − sine it is about the square of V's height above the horizon; of this the fewest powers are needed."""

OF_NOTHING = (1.0, 1.0, 0.0)
"""Roughness, weight and anisotropy of a lobe that is left as it is."""

CHANGES = (
    ((0.1225, -0.0112, 0.0048), (-0.3206, 0.4558, 0.0673), (-0.8444, -2.5164, 0.5186)),
    ((-1.2619, 0.171, -0.5801), (8.1648, -0.6153, -0.0355), (-3.1696, 8.9401, -0.3075)),
    ((-1.7711, 3.9865, 6.9277), (-9.8887, -12.552, -17.2193), (6.3641, -1.1282, 13.1955)),
    ((3.7681, -3.4592, -7.316), (0.7906, 11.3703, 20.2949), (-1.9636, -4.5626, -16.0594)),
)
"""What each power of q adds to them: a, b and c of m² (a + b m + c m²)."""

LEANING = (0.0, 0.0, 0.3718)
"""What the third power of q adds whatever the slope."""

SHAPED, WEIGHED = (0.25, 0.35), (0.1, 0.16)
"""Between which slopes roughness and anisotropy begin to change, and the weight: below, they need not, and the nodes of
what is left as it is fold away."""


@part("Seen From")
def seen_from(n, v, tangent, rotation, anisotropy):
    """How a surface is seen, by name: what lobes of any slope have in common.

    n, v       unit normal and direction to the viewer
    tangent    what the slopes are stretched along, turned by `rotation` about n
    anisotropy [0, 1); where it is 0 all that the tangent adds to the nodes folds away

    sine       of the angle from N to V
    free       the same where there is no anisotropy, and lobes may have their own; else 0
    tangent    what lobes are stretched along: N×V where they have their own
    stretch    rms slope in the plane of N and V over m
    steepest   rms slope along the tangent over m

    >>> from addon.reflectance.directions import direction
    >>> seen = seen_from(direction(0.0, 0.0), direction(0.5, 0.0), direction(0.3, 0.0), 0.25, 0.6)
    >>> [round(float(x), 4) + 0.0 for x in (seen.sine, seen.free, seen.stretch, seen.steepest)]
    [0.4794, 0.0, 0.6782, 1.4744]
    """
    is_elliptic = less(0.0, anisotropy)
    t, b = frame_along(n, rotate(tangent, n, (2.0 * PI) * rotation))
    beside = cross(n, v)
    sine = length(beside)
    aspect = sqrt(1.0 - 0.9 * anisotropy)
    along, across = dot(v, t) / aspect, dot(v, b) * aspect
    stretched = sqrt(along * along + across * across) / maximum(sine, SMALLEST_SINE)
    return SimpleNamespace(sine=sine, free=sine * (1.0 - is_elliptic), stretch=where(is_elliptic, stretched, 1.0),
                           steepest=1.0 / aspect, tangent=where(widen(is_elliptic), tangent, beside))


@part("V-cavity Lobe", "roughness", "weight", "anisotropy")
def v_cavity_lobe(sine, m, roughness=1.0, free=None, steepest=None):
    """What the lobe's roughness √m becomes, its weight, and its anisotropy across the plane of N and V.

    sine       of the angle from N to V, ``(...)``
    m          rms slope in the direction of V, ``(...)``
    roughness  √m; of 1, what it is multiplied by
    free       the sine where the lobe may have an anisotropy; by default everywhere
    steepest   rms slope in the direction where it is largest, which tells what need not change; by default m

    All are polynomials in q = m²/(m² + 2.5 (1 − sine)), where 2.5 (1 − sine) is about the square of V's height h above
    the horizon: q runs from 0.4 m² or so, where V is straight above, to 1 at the horizon, and is about ½ where facets
    of the slope m mirror V into it.  Straight above there is no anisotropy, as there is no plane.

    >>> [round(float(x), 4) for x in v_cavity_lobe(0.0, 0.1)], [round(float(x), 4) for x in v_cavity_lobe(0.94, 0.5)]
    ([1.0, 1.0, 0.0], [0.9784, 1.0399, 0.1063])
    """
    shaped, weighed = (_begun(m if steepest is None else steepest, *ends) for ends in (SHAPED, WEIGHED))
    held, m2 = widen(minimum(m, ROUGHEST_FITTED)), m * m
    # What a material keeps constant stands together, √m multiplied into it: there it costs the renderer nothing.
    q = m2 / ((HEIGHT2 + m2) - HEIGHT2 * sine)
    own = vector(roughness, 1.0, 1.0)
    constant, first, second, third = (own * of_slope(held, *factors) for factors in CHANGES)
    factors = third + LEANING, second, first, constant + own * OF_NOTHING
    # Numbers by themselves: three take less time than one vector, and what folds away takes none.
    rough, weight, leaning = (_in_powers(q, *map(of, factors)) for of in (x_of, y_of, z_of))
    return (mix(shaped, rough, roughness), mix(weighed, weight, 1.0),
            (sine if free is None else free) * (shaped * leaning))


@part("In Powers of q")
def _in_powers(q, third, second, first, constant):
    """The polynomial in q of these factors."""
    return multiply_add(q, multiply_add(q, multiply_add(q, third, second), first), constant)


def _begun(m, start, end):
    """Share, [0, 1], of what begins at one slope and is whole at another."""
    return clip(multiply_add(m, 1.0 / (end - start), -start / (end - start)), 0.0, 1.0)


@part("m² (a + b m + c m²)")
def of_slope(m, a, b, c):
    """m² (a + b m + c m²).

    >>> round(float(of_slope(0.5, 1.0, 2.0, 4.0)), 4)
    0.75
    """
    return (m * m) * multiply_add(m, multiply_add(m, c, b), a)
