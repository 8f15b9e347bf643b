"""The index of a clear material in four numbers: n_d, V_d, and a Cauchy curve through four lines of the spectrum."""

from typing import NamedTuple

import numpy as np

from ..reflectance.transmission import LAMBDA_D, cauchy

__all__ = ["Index", "index_of"]

LINES = {"d": 1e3 * LAMBDA_D, "F": 486.1327, "C": 656.2725, "g": 435.8343}
"""Fraunhofer's lines of helium, hydrogen and mercury, in nm."""

VISIBLE = np.arange(400.0, 701.0)


class Index(NamedTuple):
    """What was found.

    d          n at 587.56 nm
    abbe       V_d = (n_d − 1)/(n_F − n_C), or None where the data have no dispersion of glass's sign
    b, c       of :func:`addon.reflectance.transmission.cauchy`, in µm² and µm⁴
    error_max  largest difference of the curve from the data over 400 to 700 nm, as far as they reach
    """

    d: float
    abbe: float | None
    b: float
    c: float
    error_max: float

    @property
    def terms(self):
        """(a0, a1, a2) of n = a0 + a1/λ² + a2/λ⁴, λ in µm."""
        x = 1.0 / LAMBDA_D**2
        return (self.d - self.b * x - self.c * x * x, self.b, self.c)


def index_of(constants, abbe=None):
    """The Index of OpticalConstants.

    abbe  V_d that is known better than from the data, as a maker's; the curve then has two terms

    n_d, V_d and the partial dispersion P_gF fix the curve.

    >>> from addon.spectra.optical_constants import load
    >>> found = index_of(load("popular_glass/BK7/SCHOTT"))
    >>> round(found.d, 5), round(found.abbe, 2)
    (1.5168, 64.17)
    """
    n = {line: float(constants.at(wavelength)[0]) for line, wavelength in LINES.items()}
    spread = (n["d"] - 1.0) / abbe if abbe else n["F"] - n["C"]
    low, high = constants.range_nm
    if spread <= 0.0 or not abbe and (low > LINES["F"] or high < LINES["C"]):
        return _with_error(constants, Index(n["d"], None, 0.0, 0.0, 0.0))
    b, c = _through(spread, None if abbe or low > LINES["g"] else n["g"] - n["F"])
    return _with_error(constants, Index(n["d"], (n["d"] - 1.0) / spread, b, c, 0.0))


def _through(n_f_c, n_g_f):
    """(b, c) of the curve with these differences between lines F and C, g and F; without the last c is 0."""
    x = {line: 1e6 / wavelength**2 for line, wavelength in LINES.items()}
    if n_g_f is None:
        return n_f_c / (x["F"] - x["C"]), 0.0
    rows = [[x[p] - x[q], x[p] ** 2 - x[q] ** 2] for p, q in (("F", "C"), ("g", "F"))]
    return tuple(np.linalg.solve(rows, [n_f_c, n_g_f]).tolist())


def _with_error(constants, found):
    low, high = constants.range_nm
    at = VISIBLE[(VISIBLE >= low) & (VISIBLE <= high)]
    if not at.size:
        return found
    curve = cauchy(at / 1e3, found.d, found.b, found.c)
    return found._replace(error_max=float(np.abs(curve - constants.at(at)[0]).max()))
