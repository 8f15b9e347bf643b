"""The nine dispersion formulas of refractiveindex.info: index of refraction over wavelength.

λ is in µm here, as in the formulas' coefficients.  Each takes λ of any shape
and the coefficients in the database's order, and gives n of λ's shape.
Polyanskiy, "Refractiveindex.info database of optical constants", Scientific
Data 11, 94 (2024), and the database's "Dispersion formulas" document.
"""

import numpy as np

from ..errors import FacetFilmError

__all__ = ["index", "FORMULAS"]


def index(formula, coefficients, wavelength_um):
    """n by dispersion formula number 1 to 9.

    formula        1 to 9
    coefficients   sequence of floats, in the database's order, c1 first
    wavelength_um  array of any shape, µm

    Raises FacetFilmError for another formula number.

    >>> fused_silica = [0, 0.6961663, 0.0684043, 0.4079426, 0.1162414, 0.8974794, 9.896161]
    >>> round(float(index(1, fused_silica, 0.5876)), 5)
    1.45846
    """
    if formula not in FORMULAS:
        raise FacetFilmError(f"Dispersion formula {formula!r} is unknown; there are 1 to 9.")
    return FORMULAS[formula](np.asarray(wavelength_um, float), [float(c) for c in coefficients])


def _pairs(c):
    """The coefficients after the first, two by two; a missing last one is 0."""
    return zip(c[1::2], (c[2::2] + [0.0])[:len(c[1::2])])


def sellmeier(w, c):
    """1: n² − 1 = c1 + Σ B λ²/(λ² − C²)."""
    return np.sqrt(1.0 + c[0] + sum(b * w**2 / (w**2 - d**2) for b, d in _pairs(c)))


def sellmeier_2(w, c):
    """2: n² − 1 = c1 + Σ B λ²/(λ² − C)."""
    return np.sqrt(1.0 + c[0] + sum(b * w**2 / (w**2 - d) for b, d in _pairs(c)))


def polynomial(w, c):
    """3: n² = c1 + Σ c λ^e."""
    return np.sqrt(c[0] + sum(b * w**e for b, e in _pairs(c)))


def mixed(w, c):
    """4: n² = c1 + c2 λ^c3/(λ² − c4^c5) + c6 λ^c7/(λ² − c8^c9) + Σ c λ^e."""
    c = c + [0.0] * max(0, 9 - len(c))
    n2 = c[0]
    for b, e, d, f in (c[1:5], c[5:9]):
        if b:
            n2 = n2 + b * w**e / (w**2 - d**f)
    return np.sqrt(n2 + sum(b * w**e for b, e in _pairs(c[8:])))


def cauchy(w, c):
    """5: n = c1 + Σ c λ^e."""
    return c[0] + sum(b * w**e for b, e in _pairs(c))


def gases(w, c):
    """6: n − 1 = c1 + Σ B/(C − λ⁻²)."""
    return 1.0 + c[0] + sum(b / (d - w**-2.0) for b, d in _pairs(c))


def herzberger(w, c):
    """7: n = c1 + c2/(λ²−0.028) + c3/(λ²−0.028)² + c4 λ² + c5 λ⁴ + c6 λ⁶."""
    c = c + [0.0] * (6 - len(c))
    pole = 1.0 / (w**2 - 0.028)
    return c[0] + c[1] * pole + c[2] * pole**2 + c[3] * w**2 + c[4] * w**4 + c[5] * w**6


def retro(w, c):
    """8: (n²−1)/(n²+2) = c1 + c2 λ²/(λ²−c3) + c4 λ²."""
    ratio = c[0] + c[1] * w**2 / (w**2 - c[2]) + c[3] * w**2
    return np.sqrt((1.0 + 2.0 * ratio) / (1.0 - ratio))


def exotic(w, c):
    """9: n² = c1 + c2/(λ²−c3) + c4 (λ−c5)/((λ−c5)² + c6)."""
    return np.sqrt(c[0] + c[1] / (w**2 - c[2]) + c[3] * (w - c[4]) / ((w - c[4]) ** 2 + c[5]))


FORMULAS = dict(enumerate(
    (sellmeier, sellmeier_2, polynomial, mixed, cauchy, gases, herzberger, retro, exotic), start=1))
