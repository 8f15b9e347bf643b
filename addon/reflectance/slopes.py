"""Slope distributions D of the facets, in the paper's scale, in which ∫ D cos α dω = π over the hemisphere.

cos α = N·H.  Cook and Torrance 1982, section "The Facet Slope Distribution
Function".
"""

from ..operands import arccos, exp, less, maximum, term, where

__all__ = ["beckmann", "gaussian", "gaussian_c", "mixture"]

SMALLEST_COS2 = 1e-8
"""cos² α below which D is taken as 0: the facet stands upright."""


@term("D")
def beckmann(cos_alpha, m):
    """Beckmann's distribution D = exp(−(tan α/m)²)/(m² cos⁴ α).

    cos_alpha  N·H, any shape; 0 for facets that face away
    m          rms slope, above 0

    >>> round(float(beckmann(1.0, 0.5)), 6)
    4.0
    >>> float(beckmann(-0.5, 0.5))
    0.0
    """
    c2 = maximum(cos_alpha * cos_alpha, SMALLEST_COS2)
    m2 = m * m
    d = exp((1.0 - 1.0 / c2) / m2) / (m2 * (c2 * c2))
    return where(less(0.0, cos_alpha), d, 0.0)


@term("D")
def gaussian(cos_alpha, m, c):
    """The Gaussian distribution D = c exp(−(α/m)²), α in radians.

    cos_alpha  N·H, any shape; 0 for facets that face away
    m          rms slope, above 0
    c          the paper's arbitrary constant; :func:`gaussian_c` normalises

    >>> round(float(gaussian(1.0, 0.5, 2.0)), 6)
    2.0
    """
    alpha = arccos(cos_alpha)
    return where(less(0.0, cos_alpha), c * exp(-(alpha * alpha) / (m * m)), 0.0)


@term("c")
def gaussian_c(m):
    """The c with which ∫ D cos α dω = π for the Gaussian distribution of rms slope m in (0, 1].

    1/c = ∫ exp(−(α/m)²) sin 2α dα from 0 to π/2, which over m² is 1 at m = 0 and
    a smooth function of m²: a polynomial fit, off by at most 1e-5.

    >>> round(float(gaussian_c(0.2)), 3)
    25.674
    """
    x = m * m
    share = 1.0 + x * (-0.66751 + x * (0.280318 + x * (
        -0.153716 + x * (0.193954 + x * (-0.145296 + x * 0.039929)))))
    return 1.0 / (x * share)


def mixture(distribution, cos_alpha, slopes):
    """D = Σ wj D(mj): several scales of roughness at once.

    distribution  function of cos α and m
    slopes        (mj, wj) pairs, Σ wj = 1

    >>> float(mixture(beckmann, 1.0, [(0.5, 0.5), (1.0, 0.5)]))
    2.5
    """
    total = 0.0
    for m, w in slopes:
        total = total + w * distribution(cos_alpha, m)
    return total
