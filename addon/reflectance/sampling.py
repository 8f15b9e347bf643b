"""What the samplers of the exact realisations share.

A perfect mirror whose normal is H sends the path from V to L; drawing H with
density p and colouring the mirror f (N·L)/p(L) makes the renderer integrate f.
Light sampling cannot reach a mirror, so it is widened to a narrow Beckmann lobe
of slope a about H, and H is drawn from a distribution narrowed by as much:
slopes add like variances, (m² − a²) + a² = m².
"""

from ..operands import less, log, maximum, minimum, part, sqrt, where

__all__ = ["narrow_slope", "wide_slope", "narrowed", "towards_flanks", "squared_tilt", "chosen"]

WIDEST = 0.8
"""Largest slope of a lobe about a facet, as a share of m: what is left is drawn."""
LEAST_RANDOM = 1e-7
"""Keeps logarithms from 0."""


@part("Narrow Slope")
def narrow_slope(m, width):
    """Slope a, across the rings about N, of the lobes about facets of rms slope m: 2.25 width·m/√(1 + 55 m²).

    width  Sampling Width, [0, 1].  The kinks of the V-cavity G, which the lobes
           blur, lie at fixed angles, so a stays below 0.31 width on rough surfaces, and below 0.8 m.

    >>> round(float(narrow_slope(0.2, 0.2)), 4), round(float(narrow_slope(0.6, 0.2)), 4)
    (0.0503, 0.0592)
    """
    return minimum(2.25 * width, WIDEST) * m / sqrt(1.0 + 55.0 * (m * m))


@part("Wide Slope")
def wide_slope(m, width):
    """Largest slope of the same lobes along the rings about N, where D is constant: 2 width·m/√(1 + 8 m²).

    >>> round(float(wide_slope(0.2, 0.2)), 4), round(float(wide_slope(0.6, 0.2)), 4)
    (0.0696, 0.1218)
    """
    return minimum(2.0 * width, WIDEST) * m / sqrt(1.0 + 8.0 * (m * m))


def narrowed(m, a):
    """The square m² − a² of the slope to draw facets from, and what to stretch the drawn slope by to undo that.

    Given a slope in the blurred lobe, the drawn slopes that it comes from are
    shorter by (m² − a²)/m² on average; at a drawn slope stretched by the
    inverse, weights are evaluated without bias of first order.

    >>> m2_drawn, stretch = narrowed(0.5, 0.3)
    >>> round(float(m2_drawn), 6), round(float(stretch), 6)
    (0.16, 1.5625)
    """
    m2 = m * m
    rest = maximum(m2 - a * a, 0.04 * m2)
    return rest, m2 / rest


def towards_flanks(u, bias):
    """A number x = u (1 − bias + bias u²) in (0, 1), and one over its density: 1 − bias + 3 bias u².

    u     even in [0, 1)
    bias  [0, 1]: 0 leaves u as it is, 1 keeps away from x = 1, the middle of a lobe

    x is D over its peak.  Drawn evenly, the far flank of a lobe is hit once in
    thousands of samples, and each hit is a speck; at bias 1 it is hit as often as
    the cube root of x, and weighs 3 x^⅔.

    >>> x, weight = towards_flanks(0.2, 1.0)
    >>> round(float(x), 4), round(float(weight), 4)
    (0.008, 0.12)
    """
    u = maximum(u, LEAST_RANDOM)
    u2 = u * u
    return u * (bias * u2 + (1.0 - bias)), (3.0 * bias) * u2 + (1.0 - bias)


def squared_tilt(x, m2):
    """−m² ln x: tan² α of Beckmann's distribution, or α² of the Gaussian in its plane, for x even in [0, 1).

    m2  square of the rms slope; x = 0, at which there is no tilt, gives 0

    >>> round(float(squared_tilt(0.36787944, 0.09)), 6)
    0.09
    """
    return -m2 * log(x)


def chosen(u, weights, *values):
    """For each of the value lists, the entry that is drawn with probability proportional to its weight.

    u  even in [0, 1); entries of weight 0 are never drawn

    >>> [float(x) for x in chosen(0.7, [0.4, 0.6], [1.0, 2.0], [3.0, 4.0])]
    [2.0, 4.0]
    """
    total = sum(weights[1:], weights[0])
    found = [value[0] for value in values]
    passed = weights[0]
    for j in range(1, len(weights)):
        here = less(passed, u * total) * less(0.0, weights[j])
        found = [where(here, value[j], old) for value, old in zip(values, found)]
        passed = passed + weights[j]
    return found
