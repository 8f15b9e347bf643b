"""Geometrical attenuation G: the share of facets that are neither masked from the viewer nor shadowed."""

from ..operands import maximum, minimum, part, sqrt, term

__all__ = ["v_cavity", "v_cavity_one_side", "smith_beckmann", "smith_lambda", "smith_lambda_of_slope"]

SMALLEST = 1e-6
"""Keeps a denominator away from 0 at grazing incidence."""

T_OF_NO_SHADOW = (1.259 + (1.259 ** 2 - 4.0 * 0.396) ** 0.5) / 2.0
"""At this m tan θ, 0.646, the approximation of Smith's Λ is 0; it is taken as 0 below."""


@term("G")
def v_cavity(n_h, n_v, n_l, v_h):
    """G = min{1, 2(N·H)(N·V)/(V·H), 2(N·H)(N·L)/(V·H)}, symmetric V-shaped grooves.

    All cosines, ``(...)``; 0 where viewer or light is below the surface.
    Cook and Torrance 1982, after Torrance and Sparrow 1967.

    >>> float(v_cavity(1.0, 1.0, 1.0, 1.0))
    1.0
    >>> round(float(v_cavity(0.9, 0.2, 0.8, 0.6)), 6)
    0.6
    """
    groove = 2.0 * n_h / maximum(v_h, SMALLEST)
    return maximum(minimum(1.0, groove * n_v, groove * n_l), 0.0)


@term("G1")
def v_cavity_one_side(n_h, n_v, v_h):
    """Masking alone, min{1, 2(N·H)(N·V)/(V·H)}: the visible share of the facets with normal H.

    E. Heitz, "Understanding the Masking-Shadowing Function in Microfacet-Based
    BRDFs", JCGT 3(2), 2014, section 5.2.

    >>> round(float(v_cavity_one_side(0.9, 0.2, 0.6)), 6)
    0.6
    """
    return maximum(minimum(1.0, 2.0 * n_h * n_v / maximum(v_h, SMALLEST)), 0.0)


@term("G Smith")
def smith_beckmann(n_v, n_l, m):
    """Smith's G = 1/(1 + Λ(V) + Λ(L)), height-correlated, as the Beckmann closure of Cycles evaluates it.

    n_v, n_l  cosines, ``(...)``; below 1e-5/m where one is below the surface
    m         rms slope, above 0

    Heitz 2014, equation 99.

    >>> float(smith_beckmann(1.0, 1.0, 0.4))
    1.0
    """
    return 1.0 / (1.0 + smith_lambda(n_v, m) + smith_lambda(n_l, m))


def smith_lambda(cos_theta, m):
    """Smith's Λ for Beckmann's distribution: (t² − 1.259 t + 0.396)/(3.535 t + 2.181), t = m tan θ.

    0 where t is 0.646 or less.  The rational approximation in a = 1/t of
    B. Walter et al., "Microfacet Models for Refraction through Rough Surfaces",
    EGSR 2007, as Heitz 2014 gives it below equation 69.

    >>> float(smith_lambda(0.9, 0.4))
    0.0
    >>> round(float(smith_lambda(0.1, 0.4)), 4)
    0.6908
    """
    cosine, m2 = maximum(cos_theta, SMALLEST), m * m
    return smith_lambda_of_slope(sqrt(m2 / (cosine * cosine) - m2))


@part("Smith's Λ")
def smith_lambda_of_slope(t):
    """:func:`smith_lambda` where t = m tan θ is known.

    >>> round(float(smith_lambda_of_slope(2.0)), 4)
    0.203
    """
    t = maximum(t, T_OF_NO_SHADOW)
    return ((t - 1.259) * t + 0.396) / (3.535 * t + 2.181)
