"""The Gaussian slope distribution as a sum of three Beckmann lobes, for renderers that only have these."""

from ...operands import maximum, minimum, multiply_add, part, sqrt, widen, x_of, y_of, z_of

__all__ = ["gaussian_lobes", "gaussian_share"]

ROUGHEST_FITTED = 0.65
"""Above this slope the lobes keep their shares and relative widths."""

SHARES = ((0.6909, 0.0, -0.0215), (-2.2014, 0.0, 0.4292), (3.922, 0.0, 0.1877), (-2.138, 0.0, -0.522))
"""Of the narrow and the wide lobe, for each power of m; the middle one has the rest."""
SLOPES = ((1.0747, 0.911, 2.045), (-1.2184, 1.5094, -7.7582), (1.2874, -4.5471, 24.9655), (-0.641, 3.8687, -21.8102))
"""Over m, for each power of m."""

C_BY_SUM, C_BY_PRODUCT = 0.33734, 0.15566
"""Of :func:`gaussian_share`."""


@part("Gaussian as Three Lobes", "share 1", "widening 1", "share 2", "widening 2", "share 3", "widening 3")
def gaussian_lobes(m):
    """Three (share, widening) pairs: Beckmann lobes of the slopes m widening² add up to the Gaussian of rms slope m.

    sum_i share_i D_Beckmann(slope_i) comes close to c exp(-(alpha/m)^2), both
    in the scale where the integral of D cos(alpha) over the hemisphere is pi;
    the shares sum to 1.  Cubics in m by least squares on the hemisphere,
    weighted by cos(alpha): relative rms 0.04 % at m = 0.2, 0.2 % at 0.3 and
    0.4, 0.7 % at 0.5, 1.4 % at 0.6.  A slope is held to 1, the roughest that
    the Beckmann closure has, and rougher Gaussians suffer: 6 % at 0.7.

    m : rms slope, number of any shape, above 0 and at most 1.

    >>> [(round(float(share), 3), round(float(0.2 * widening ** 2), 3)) for share, widening in gaussian_lobes(0.2)]
    [(0.39, 0.175), (0.542, 0.212), (0.068, 0.263)]
    """
    x = widen(minimum(m, ROUGHEST_FITTED))
    shares = maximum(_polynomial(x, SHARES), 0.0)
    widenings = sqrt(minimum(_polynomial(x, SLOPES), widen(1.0 / m)))
    narrow, wide = x_of(shares), z_of(shares)
    return [(narrow, x_of(widenings)), (1.0 - narrow - wide, y_of(widenings)), (wide, z_of(widenings))]


def _polynomial(x, factors):
    """Σ factorsᵢ xⁱ, ``(..., 3)``."""
    total = factors[-1]
    for factor in reversed(factors[:-1]):
        total = multiply_add(x, total, factor)
    return total


@part("Share of the Gaussian")
def gaussian_share(m, gaussian, published, printed_c, anisotropy):
    """How much of a slope the Gaussian is: `gaussian`, in the published scale times the printed c over the true one.

    m           rms slope, (0, 1]
    anisotropy  [0, 1)

    The c that normalises an elliptic Gaussian, :func:`addon.reflectance.slopes.elliptic_gaussian_c`, is
    (1 + a (mt² + mb²) + b mt² mb²)/(mt mb), fitted: within 0.25 %.

    >>> from addon.reflectance.slopes import along_across, elliptic_gaussian_c
    >>> shares = [gaussian_share(0.4, 1.0, 1.0, elliptic_gaussian_c(*along_across(0.4, a)), a) for a in (0.0, 0.8)]
    >>> [round(float(share), 2) for share in shares], float(gaussian_share(0.4, 0.5, 0.0, 3.0, 0.0))
    ([1.0, 1.0], 0.5)
    """
    squeezed, m2 = 1.0 - 0.9 * anisotropy, m * m
    along2, across2 = minimum(m2 / squeezed, 1.0), m2 * squeezed
    product2 = along2 * across2
    printed = printed_c * sqrt(product2) / (1.0 + C_BY_SUM * (along2 + across2) + C_BY_PRODUCT * product2)
    return gaussian * (1.0 + published * (printed - 1.0))
