"""Geometrical attenuation G: the share of facets that are neither masked from the viewer nor shadowed."""

from ..operands import clip, less, maximum, minimum, sqrt, term, where

__all__ = ["v_cavity", "v_cavity_one_side", "smith_beckmann", "smith_lambda"]

SMALLEST = 1e-6
"""Keeps a denominator away from 0 at grazing incidence."""

A_OF_NO_SHADOW = 1.6
"""Above this a = 1/(m tan θ), Smith's Λ is taken as 0."""


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

    n_v, n_l  cosines, ``(...)``; 0 where one is below the surface
    m         rms slope, above 0

    Heitz 2014, equation 99.

    >>> float(smith_beckmann(1.0, 1.0, 0.4))
    1.0
    """
    above = less(0.0, minimum(n_v, n_l))
    return where(above, 1.0 / (1.0 + smith_lambda(n_v, m) + smith_lambda(n_l, m)), 0.0)


def smith_lambda(cos_theta, m):
    """Smith's Λ for Beckmann's distribution: (1 − 1.259 a + 0.396 a²)/(3.535 a + 2.181 a²), a = 1/(m tan θ).

    0 where a is 1.6 or more.  The rational
    approximation of B. Walter et al., "Microfacet Models for Refraction through
    Rough Surfaces", EGSR 2007, as Heitz 2014 gives it below equation 69.

    >>> float(smith_lambda(0.9, 0.4))
    0.0
    >>> round(float(smith_lambda(0.1, 0.4)), 4)
    0.6908
    """
    cosine = clip(cos_theta, SMALLEST, 1.0)
    a = minimum(cosine / maximum(m * sqrt(1.0 - cosine * cosine), SMALLEST), A_OF_NO_SHADOW)
    return maximum((1.0 + a * (0.396 * a - 1.259)) / (a * (3.535 + 2.181 * a)), 0.0)
