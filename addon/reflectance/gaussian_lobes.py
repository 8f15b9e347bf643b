"""The Gaussian slope distribution as a sum of three Beckmann lobes, for renderers that only have these."""

from ..operands import maximum, minimum

__all__ = ["gaussian_lobes"]


def gaussian_lobes(m):
    """Three (share, slope) pairs whose Beckmann lobes add up to the Gaussian of rms slope m.

    sum_i share_i D_Beckmann(slope_i) comes close to c exp(-(alpha/m)^2), both
    in the scale where the integral of D cos(alpha) over the hemisphere is pi;
    the shares sum to 1.  Least squares on the hemisphere, weighted by
    cos(alpha), over m from 0.05 to 1: relative rms 0.2 % at m = 0.2, 0.3 % at
    0.3, 0.5 % at 0.4, 0.9 % at 0.5, 2 % at 0.6 and 5 % at 0.7.  A slope is
    held to 1, the roughest that the Beckmann closure has.

    m : rms slope, number of any shape, above 0 and at most 1.

    >>> [(round(float(a), 3), round(float(b), 3)) for a, b in gaussian_lobes(0.2)]
    [(0.525, 0.182), (0.422, 0.217), (0.053, 0.274)]
    """
    narrow = 0.5149 + m * (0.1071 - 0.2869 * m)
    wide = maximum(0.0, -0.013 + m * (0.3671 - 0.1735 * m))
    return [
        (narrow, minimum(1.0, m * (1.0 - m * (0.4543 + 0.0309 * m)))),
        (1.0 - narrow - wide, minimum(1.0, m * (1.0 + m * (0.487 - 0.3121 * m)))),
        (wide, minimum(1.0, m * (1.0 + m * (2.2002 - 1.6896 * m)))),
    ]
