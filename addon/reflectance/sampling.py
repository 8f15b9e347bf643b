"""What the samplers of the exact realisations share.

A perfect mirror whose normal is H sends the path from V to L; drawing H with
density p and colouring the mirror f (N·L)/p(L) makes the renderer integrate f.
Light sampling cannot reach a mirror, so it is widened to a narrow Beckmann lobe
of slope a about H, and H is drawn from a distribution narrowed by as much:
slopes add like variances, (m² − a²) + a² = m².
"""

from ..operands import less, log, maximum, minimum, sqrt, where

__all__ = ["narrow_slope", "wide_slope", "narrowed", "towards_flanks", "squared_tilt", "chosen"]

MOST_ALONG = 0.8
"""Largest slope along the rings, as a share of m."""


def narrow_slope(m, width):
    """Slope a, across the rings about N, of the lobes about facets of rms slope m: 1.5 width·m/√(1 + 20 m²).

    width  Sampling Width, [0, 1].  The kinks of the V-cavity G, which the lobes
           blur, lie at fixed angles, so a stays below 0.34 width on rough surfaces.

    >>> round(float(narrow_slope(0.2, 0.2)), 4), round(float(narrow_slope(0.6, 0.2)), 4)
    (0.0447, 0.0629)
    """
    return 1.5 * width * m / sqrt(1.0 + 20.0 * (m * m))


def wide_slope(m, width):
    """Largest slope of the same lobes along the rings about N, where D is constant: 1.5 width·m/√(1 + 4 m²).

    >>> round(float(wide_slope(0.2, 0.2)), 4), round(float(wide_slope(0.6, 0.2)), 4)
    (0.0557, 0.1152)
    """
    return minimum(1.5 * width, MOST_ALONG) * m / sqrt(1.0 + 4.0 * (m * m))


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
    """A number drawn from [0, 1) with the density 1 + bias·(1 − 2x), and that density.

    u     even in [0, 1)
    bias  [0, 1]: 0 leaves u as it is, 1 keeps away from x = 1, the middle of a lobe

    >>> x, density = towards_flanks(0.5, 0.8)
    >>> round(float(x), 4), round(float(density), 4)
    (0.3246, 1.2806)
    """
    b, twice = 1.0 + bias, 2.0 * u
    root = sqrt(b * b - (2.0 * bias) * twice)
    return twice / (b + root), root


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
