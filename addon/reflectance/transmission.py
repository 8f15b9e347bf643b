"""Light through clear bodies: a slab's inner reflections, absorption over a length, dispersion.

n is the index inside relative to that outside; lengths and absorption have inverse units.
"""

from ..operands import exp, minimum, sqrt, term

__all__ = ["LAMBDA_D", "cauchy", "cauchy_over_x", "cos_inside", "slab_reflectance", "slab_transmittance",
           "straight_path", "transmittance"]

LAMBDA_D = 0.5875618
"""The helium d line, in µm."""

LARGEST_EXPONENT = 30.0
"""Beyond it a straight path's entry would leave what a float can hold, and the shadow is too dark instead."""


@term("cos θ'")
def cos_inside(cos_theta, n):
    """Cosine of the refracted ray with the normal, by Snell's law: cos²θ' = 1 − (1 − cos²θ)/n².

    cos_theta  outside, [0, 1]; n above 0; both ``(...)``

    >>> float(cos_inside(1.0, 1.5))
    1.0
    """
    return sqrt(1.0 - (1.0 - cos_theta * cos_theta) / (n * n))


@term("T = exp(−σd)")
def transmittance(sigma, d):
    """Bouguer, Lambert and Beer: the share of light left after a path of length d.

    sigma ``(..., 3)`` in 1/length, at or above 0; d in that length, ``(..., 1)`` or widened

    >>> float(transmittance(2.0, 0.5).round(4))
    0.3679
    """
    return exp(-1.0 * (sigma * d))


@term("T of a straight path")
def straight_path(sigma, d, back):
    """What a face does to a ray that goes straight on: exp(−σd) at the back face, its inverse at the front one.

    sigma ``(..., 3)``; d along the ray, from a point of it that both faces count from, widened; back 1.0 at back faces,
    else 0.0, widened.  The product over a body's two faces is the transmittance of what lies between them; from the
    middle of the body each face has its half.

    >>> float((straight_path(2.0, -0.2, 0.0) * straight_path(2.0, 0.3, 1.0)).round(4))
    0.3679
    """
    return exp(minimum((1.0 - 2.0 * back) * (sigma * d), LARGEST_EXPONENT))


@term("T of a slab")
def slab_transmittance(r, t):
    """All light that comes through a plane-parallel slab, its inner reflections summed: (1−R)²t/(1−R²t²).

    r  reflectance of one face, [0, 1);  t  transmittance of one passage, [0, 1].  Born and Wolf, Principles of Optics,
    section 7.6, incoherent.

    >>> round(float(slab_transmittance(0.04, 1.0)), 6)
    0.923077
    """
    return (1.0 - r) * (1.0 - r) * t / (1.0 - r * r * t * t)


@term("R of a slab")
def slab_reflectance(r, t):
    """All light that a slab sends back: R(1 + T t), T its transmittance; 2R/(1 + R) where nothing is absorbed.

    >>> round(float(slab_reflectance(0.04, 1.0)), 6)
    0.076923
    """
    return r * (1.0 + slab_transmittance(r, t) * t)


@term("n(λ)")
def cauchy(wavelength, n_d, b, c):
    """Index at a wavelength: n_d + b(x − x_d) + c(x² − x_d²), x = 1/λ².  Cauchy 1836, n_d for its constant.

    wavelength in µm; b in µm², c in µm⁴

    >>> cauchy(LAMBDA_D, 1.5, 0.004, 0.0)
    1.5
    """
    return cauchy_over_x(1.0 / (wavelength * wavelength) - LAMBDA_D**-2, n_d, b, c)


@term("n(λ)")
def cauchy_over_x(x, n_d, b, c):
    """The same at x = 1/λ² − 1/λ_d², in 1/µm².

    >>> cauchy_over_x(0.0, 1.5, 0.004, 0.0)
    1.5
    """
    return n_d + x * (b + c * (x + 2.0 * LAMBDA_D**-2))
