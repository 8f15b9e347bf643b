"""The Gaussian slope distribution as a sum of three Beckmann lobes, for renderers that only have these."""

from ...operands import maximum, minimum, part

__all__ = ["gaussian_lobes"]

ROUGHEST_FITTED = 0.65
"""Above this slope the lobes keep their shares and relative widths."""


@part("Gaussian as Three Lobes", "share 1", "m1", "share 2", "m2", "share 3", "m3")
def gaussian_lobes(m):
    """Three (share, slope) pairs whose Beckmann lobes add up to the Gaussian of rms slope m.

    sum_i share_i D_Beckmann(slope_i) comes close to c exp(-(alpha/m)^2), both
    in the scale where the integral of D cos(alpha) over the hemisphere is pi;
    the shares sum to 1.  Cubics in m by least squares on the hemisphere,
    weighted by cos(alpha): relative rms 0.04 % at m = 0.2, 0.2 % at 0.3 and
    0.4, 0.7 % at 0.5, 1.4 % at 0.6.  A slope is held to 1, the roughest that
    the Beckmann closure has, and rougher Gaussians suffer: 6 % at 0.7.

    m : rms slope, number of any shape, above 0 and at most 1.

    >>> [(round(float(share), 3), round(float(slope), 3)) for share, slope in gaussian_lobes(0.2)]
    [(0.39, 0.175), (0.542, 0.212), (0.068, 0.263)]
    """
    x = minimum(m, ROUGHEST_FITTED)
    narrow = 0.6909 + x * (-2.2014 + x * (3.922 - 2.138 * x))
    wide = maximum(0.0, -0.0215 + x * (0.4292 + x * (0.1877 - 0.522 * x)))
    return [
        (narrow, minimum(1.0, m * (1.0747 + x * (-1.2184 + x * (1.2874 - 0.641 * x))))),
        (1.0 - narrow - wide, minimum(1.0, m * (0.911 + x * (1.5094 + x * (-4.5471 + 3.8687 * x))))),
        (wide, minimum(1.0, m * (2.045 + x * (-7.7582 + x * (24.9655 - 21.8102 * x))))),
    ]
