"""Slope distributions D of the facets, in the paper's scale, in which ∫ D cos α dω = π over the hemisphere.

cos α = N·H.  Cook and Torrance 1982, section "The Facet Slope Distribution
Function".  The paper's are round; the elliptic ones here have the slope mt
along a tangent T and mb along B = N×T.  In the direction φ from T it is
m(φ), 1/m(φ)² = (cos φ/mt)² + (sin φ/mb)², and D is what the paper has with
m(φ) in its exponent and mt·mb in place of m² before it.  For Beckmann's that is
the Gaussian of slopes stretched along T: E. Heitz, "Understanding the
Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2), 2014, on
anisotropy, which Cycles has as well; for the paper's Gaussian of angles it is
this project's choice.
"""

from ..operands import arccos, exp, less, maximum, minimum, part, sqrt, term, where

__all__ = ["along_across", "beckmann", "elliptic", "elliptic_beckmann", "elliptic_gaussian", "elliptic_gaussian_c",
           "gaussian", "gaussian_c", "mixture"]

LEAST_SINE2 = 1e-12

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


@part("Slopes along and across", "along", "across")
def along_across(m, anisotropy):
    """Slopes along and across the tangent: m/√(1 − 0.9 a), at most 1, and m √(1 − 0.9 a).

    m           rms slope, above 0
    anisotropy  a, [0, 1)

    As Cycles makes them for its Metallic and Principled closures, after B. Burley, "Physically Based Shading at
    Disney", SIGGRAPH 2012 course notes.

    >>> [round(float(slope), 4) for slope in along_across(0.2, 0.6)]
    [0.2949, 0.1356]
    """
    aspect = sqrt(1.0 - 0.9 * anisotropy)
    return minimum(m / aspect, 1.0), m * aspect


@term("D")
def elliptic(h_t, h_b, slope_t, slope_b):
    """(H·T/mt)² + (H·B/mb)², which is sin² α/m(φ)².

    >>> round(elliptic(0.3, 0.0, 0.5, 0.1), 6)
    0.36
    """
    x, y = h_t / slope_t, h_b / slope_b
    return x * x + y * y


@term("D")
def elliptic_beckmann(h_t, h_b, n_h, slope_t, slope_b):
    """D = exp(−(tan α/m(φ))²)/(mt mb cos⁴ α).

    h_t, h_b, n_h     H·T, H·B and N·H, any shape; 0 for facets that face away
    slope_t, slope_b  mt and mb

    >>> round(float(elliptic_beckmann(0.0, 0.0, 1.0, 0.5, 0.25)), 6)
    8.0
    >>> bool(abs(elliptic_beckmann(0.6, 0.0, 0.8, 0.3, 0.3) - beckmann(0.8, 0.3)) < 1e-12)
    True
    """
    c2 = maximum(n_h * n_h, SMALLEST_COS2)
    d = exp(-elliptic(h_t, h_b, slope_t, slope_b) / c2) / (slope_t * slope_b * (c2 * c2))
    return where(less(0.0, n_h), d, 0.0)


@term("D")
def elliptic_gaussian(h_t, h_b, n_h, slope_t, slope_b, c):
    """D = c exp(−(α/m(φ))²); c as :func:`elliptic_gaussian_c` normalises, or the paper's own.

    >>> round(float(elliptic_gaussian(0.0, 0.0, 1.0, 0.5, 0.25, 2.0)), 6)
    2.0
    >>> bool(abs(elliptic_gaussian(0.6, 0.0, 0.8, 0.3, 0.3, 2.0) - gaussian(0.8, 0.3, 2.0)) < 1e-12)
    True
    """
    alpha = arccos(n_h)
    sine2 = maximum(h_t * h_t + h_b * h_b, LEAST_SINE2)
    d = c * exp(-(alpha * alpha) * elliptic(h_t, h_b, slope_t, slope_b) / sine2)
    return where(less(0.0, n_h), d, 0.0)


SHARES = (1.0, -0.66751, 0.280318, -0.153716, 0.193954, -0.145296, 0.039929)
"""Of the powers of m² in 1/(c m²), fitted: off by at most 1e-5."""


@part("Round Gaussian c")
def gaussian_c(m):
    """The c with which ∫ D cos α dω = π for the Gaussian distribution of rms slope m in (0, 1].

    1/c = ∫ exp(−(α/m)²) sin 2α dα from 0 to π/2, which over m² is 1 at m = 0 and
    a smooth function of m²: a polynomial, with SHARES.

    >>> round(float(gaussian_c(0.2)), 3)
    25.674
    """
    x = m * m
    share = SHARES[-1]
    for coefficient in SHARES[-2::-1]:
        share = coefficient + x * share
    return 1.0 / (x * share)


@part("Gaussian c")
def elliptic_gaussian_c(slope_t, slope_b):
    """The same of an elliptic Gaussian: 1/c is the mean over φ of what a round one of slope m(φ) has.

    slope_t, slope_b  mt and mb, (0, 1]

    The mean of m(φ)^2k is (mt mb)^k P(z), P Legendre's polynomial of order k − 1 and z = (mt/mb + mb/mt)/2: Laplace's
    integral.

    >>> round(float(elliptic_gaussian_c(0.2, 0.2)), 3), round(float(elliptic_gaussian_c(0.4, 0.1)), 3)
    (25.674, 26.43)
    """
    x, z = slope_t * slope_b, 0.5 * (slope_t / slope_b + slope_b / slope_t)
    before, legendre, power = 1.0, z, x
    total = SHARES[0] + SHARES[1] * (x * z)
    for k, share in enumerate(SHARES[2:], 2):
        before, legendre = legendre, ((2.0 * k - 1.0) / k) * (z * legendre) + ((1.0 - k) / k) * before
        power = power * x
        total = total + share * (power * legendre)
    return 1.0 / (x * total)


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
