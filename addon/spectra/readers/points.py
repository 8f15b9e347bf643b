"""Measured points with the lines they stand in: what has to hold for them, and the record they become."""

import dataclasses

import numpy as np

from ..optical_constants import (
    CORE_NM,
    OpticalConstants,
    from_normal_reflectance,
    on_common_wavelengths,
)

__all__ = ["Points", "checked", "constants", "LICENCE"]

LICENCE = "the user's own data"
LEAST_COVER_NM = 50.0
"""How much of 400 to 700 nm has to be measured: as much as for the datasets of the database."""
LARGEST_INDEX = 1e4
"""Of n and k; no material comes near it, not in the far infrared either."""
LARGEST_STEP = 50.0
"""Ratio of neighbouring wavelengths; beyond it units are mixed: they lie 1,000 apart."""


@dataclasses.dataclass(frozen=True, eq=False)
class Points:
    """One quantity over wavelength.

    role           "n", "k" or "R" (normal reflectance, 0 to 1)
    wavelength_nm  ``(W,)``
    values         ``(W,)``
    lines          in which line each stands, ``(W,)``
    """

    role: str
    wavelength_nm: np.ndarray
    values: np.ndarray
    lines: np.ndarray


def checked(text, points):
    """The points, once everything that has to hold for them does.

    Raises FacetFilmError for too few points, wavelengths that are not above 0
    and ascending, units mixed, n ≤ 0, k < 0 and R outside 0 to 1.
    """
    w, lines = points.wavelength_nm, points.lines
    if w.size < 2:
        text.refuse(lines[0], "is the only point", "at least two wavelengths")
    _require(text, lines, w, w > 0.0, "the wavelength is {:g} nm", "one above 0")
    step = w[1:] / w[:-1]
    ratio = np.maximum(step, 1.0 / np.maximum(step, 1e-300))
    _require(text, lines[1:], ratio, ratio <= LARGEST_STEP,
             "the wavelength is {:.0f} times apart from the one before: units are mixed",
             "nm throughout or µm throughout")
    _require(text, lines[1:], w[1:], w[1:] != w[:-1], "the wavelength {:.10g} nm comes again", "each once")
    _require(text, lines[1:], w[1:], w[1:] > w[:-1],
             "the wavelength {:.10g} nm is below the one before", "wavelengths that ascend")
    _check_values(text, points)
    return points


def _check_values(text, points):
    values, lines = points.values, points.lines
    if points.role == "R":
        _require(text, lines, values, values >= 0.0, "R is {:g}", "0 to 1, or 0 to 100 %")
        _require(text, lines, values, values <= 1.0, "R is {:g}, more than all of the light",
                 "0 to 1, or a heading with % where it is in percent, up to 100")
        return
    low = values > 0.0 if points.role == "n" else values >= 0.0
    _require(text, lines, values, low, points.role + " is {:g}",
             "a number above 0" if points.role == "n" else "0 or more")
    _require(text, lines, values, values <= LARGEST_INDEX, points.role + " is {:g}",
             f"at most {LARGEST_INDEX:g}")


def _require(text, lines, values, holds, found, expected):
    """Refuse the first line whose value does not hold."""
    if not holds.all():
        at = int(np.argmin(holds))
        text.refuse(lines[at], found.format(values[at]), expected)


def constants(text, found, citation=LICENCE):
    """The OpticalConstants of checked Points: of n, of n and k, or of R.

    found  Points, each role once at most

    Raises FacetFilmError for another choice of quantities, and where less than
    50 nm of the visible are covered.
    """
    by_role = {points.role: points for points in found}
    if len(by_role) < len(found):
        twice = [points for points in found if by_role[points.role] is not points][0]
        text.refuse(by_role[twice.role].lines[0], f"{twice.role} comes a second time", "each quantity once")
    if set(by_role) not in ({"n"}, {"n", "k"}, {"R"}):
        text.refuse(None, "has " + " and ".join(sorted(by_role)), "n, n and k, or R")
    low = max(points.wavelength_nm[0] for points in found)
    high = min(points.wavelength_nm[-1] for points in found)
    if min(high, CORE_NM[1]) - max(low, CORE_NM[0]) < LEAST_COVER_NM - 1e-3:
        text.refuse(None, f"the wavelengths, {low:g} to {high:g} nm, cover less than {LEAST_COVER_NM:g} nm "
                          "of the visible", "400 to 700 nm or a good part of it")
    about = {"dataset": f"file:{text.name}", "title": text.title, "citation": citation, "licence": LICENCE}
    if "R" in by_role:
        return from_normal_reflectance(by_role["R"].wavelength_nm, by_role["R"].values, **about)
    n = by_role["n"]
    k = by_role.get("k")
    if k is None:
        return OpticalConstants(n.wavelength_nm, n.values, np.zeros_like(n.values), has_k=False, **about)
    wavelength, n, k = on_common_wavelengths((n.wavelength_nm, n.values), (k.wavelength_nm, k.values))
    return OpticalConstants(wavelength, n, k, range_nm=(float(low), float(high)), **about)
