"""Measured points with the lines they stand in: what has to hold for them, and the record they become."""

import dataclasses

import numpy as np

from ..optical_constants import (
    CORE_NM,
    VISIBLE_NM,
    OpticalConstants,
    ascending,
    from_normal_reflectance,
    on_common_wavelengths,
)

__all__ = ["Points", "checked", "constants", "LICENCE", "why_k_is_missing"]

LICENCE = "the user's own data"
LEAST_COVER_NM = 50.0
"""How much of 400 to 700 nm has to be measured: as much as for the datasets of the database."""
LARGEST_INDEX = 1e4
"""Of n and k; no material comes near it, not in the far infrared either."""
LARGEST_STEP = 50.0
"""Ratio of neighbouring wavelengths; beyond it units are mixed: they lie 1,000 apart."""
LARGEST_GAP_NM = 75.0
"""Between points beside one that is missing in the visible; so far apart are those of a coarse table."""
SAME = 0.05
"""Share by which two values at one wavelength may differ, and the floor that it is a share of."""
SAME_FLOOR = 0.05
SPIKE = 0.2
"""Share of its neighbours by which a point lies outside of what is between them, so that it is worth a question."""
DENSE_NM = 10.0
"""Between neighbours of a curve so dense that two values at one wavelength are its noise, or its slope."""
K_NOISE, R_NOISE, R_ABOVE = -0.005, -0.005, 1.05
"""What is still the noise of an instrument: k and R below 0, R above 1."""
K_NOISE_OF_THE_DATABASE = -0.1
LEAST_N_ALONE, LARGEST_RISE = 0.98, 0.1
"""Without k, n below the one, or a rise of n towards the red by more than the other, is a half of what absorbs."""


@dataclasses.dataclass(frozen=True, eq=False)
class Points:
    """One quantity over wavelength.

    role           "n", "k" or "R" (normal reflectance, 0 to 1)
    wavelength_nm  ``(W,)``
    values         ``(W,)``; NaN where nothing was measured
    lines          in which line each stands, ``(W,)``
    """

    role: str
    wavelength_nm: np.ndarray
    values: np.ndarray
    lines: np.ndarray

    def at(self, which):
        """Those of an index array, or of a mask."""
        return Points(self.role, self.wavelength_nm[which], self.values[which], self.lines[which])


def inside(wavelength_nm):
    """Where wavelengths are in the visible, 360 to 780 nm."""
    return (wavelength_nm >= VISIBLE_NM[0]) & (wavelength_nm <= VISIBLE_NM[1])


def checked(text, points, noise=False):
    """The points in ascending order, once everything that has to hold for them in the visible does.

    noise  whether k is of the database, which keeps more of its noise

    Points outside of 360 to 780 nm that cannot be are left out.  Raises
    FacetFilmError for too few points, wavelengths that are not above 0 or in
    disorder, units mixed, n ≤ 0, k < 0 and R outside 0 to 1.
    """
    w, lines = points.wavelength_nm, points.lines
    if w.size == 1:
        text.refuse(lines[0], "is the only point", "at least two wavelengths")
    if w.size == 0:
        text.refuse(None, f"no value of {points.role} is there", "at least two wavelengths")
    _require(text, lines, w, w > 0.0, "the wavelength is {:g} nm", "one above 0")
    step = w[1:] / w[:-1]
    ratio = np.maximum(step, 1.0 / np.maximum(step, 1e-300))
    _require(
        text,
        lines[1:],
        ratio,
        ratio <= LARGEST_STEP,
        "the wavelength is {:.0f} times apart from the one before: units are mixed",
        "nm throughout or µm throughout",
    )
    points = _possible(text, _measured(text, points), noise)
    points = _each_once(text, _in_order(text, points))
    _say_spikes(text, points)
    if points.wavelength_nm.size < 2:
        text.refuse(points.lines[0] if points.lines.size else None, "is the only point", "at least two wavelengths")
    return points


def _measured(text, points):
    """Those where something was measured; what is missing in the visible may be short of its neighbours only."""
    missing = np.isnan(points.values)
    if not missing.any():
        return points
    seen = np.flatnonzero(missing & inside(points.wavelength_nm))
    there = np.sort(points.wavelength_nm[~missing])
    for at in seen:
        w = points.wavelength_nm[at]
        below, above = there[there <= w], there[there >= w]
        if not below.size or not above.size or above[0] - below[-1] > LARGEST_GAP_NM:
            text.refuse(points.lines[at], f"{points.role} is missing at {w:g} nm", "a number")
    if seen.size:
        text.assume(f"{points.role} is missing at {_count(seen.size)} in the visible and taken from the neighbours")
    return points.at(~missing)


def _count(size):
    return "1 point" if size == 1 else f"{size} points"


def _possible(text, points, noise):
    """Those that can be: noise is held to what can be, what is impossible outside the visible left out."""
    values, role = points.values.copy(), points.role
    seen = inside(points.wavelength_nm)
    if role == "R":
        low, high = values < 0.0, values > 1.0
        _say_held(text, points, low & (values >= R_NOISE) & seen, "below 0", 0)
        _say_held(text, points, high & (values <= R_ABOVE) & seen, "above 1", 1)
        values = np.where(low & (values >= R_NOISE), 0.0, np.where(high & (values <= R_ABOVE), 1.0, values))
        wrong = (values < 0.0) | (values > 1.0)
    elif role == "k":
        low = (values < 0.0) & (values >= (K_NOISE_OF_THE_DATABASE if noise else K_NOISE))
        _say_held(text, points, low & seen, "below 0", 0)
        values = np.where(low, 0.0, values)
        wrong = (values < 0.0) | (values > LARGEST_INDEX)
    else:
        wrong = (values <= 0.0) | (values > LARGEST_INDEX)
    points = Points(role, points.wavelength_nm, values, points.lines)
    _check_values(text, points.at(seen))
    if wrong.any():
        text.assume(f"{_count(int(wrong.sum()))} of {role} outside of 360 to 780 nm left out: impossible values")
    return points.at(~wrong)


def _say_held(text, points, held, where, value):
    if held.any():
        text.assume(f"{points.role} {where} at {_count(int(held.sum()))} taken as {value}")


def _check_values(text, points):
    values, lines = points.values, points.lines
    if points.role == "R":
        _require(text, lines, values, values >= 0.0, "R is {:g}", "0 to 1, or 0 to 100 %")
        _require(
            text,
            lines,
            values,
            values <= 1.0,
            "R is {:g}, more than all of the light",
            "0 to 1, or a heading with % where it is in percent, up to 100",
        )
        return
    low = values > 0.0 if points.role == "n" else values >= 0.0
    _require(
        text, lines, values, low, points.role + " is {:g}", "a number above 0" if points.role == "n" else "0 or more"
    )
    _require(text, lines, values, values <= LARGEST_INDEX, points.role + " is {:g}", f"at most {LARGEST_INDEX:g}")


def _in_order(text, points):
    """In ascending order: turned where it falls, sorted where the pieces of the table agree with each other."""
    w = points.wavelength_nm
    step = np.diff(w)
    if (step >= 0.0).all():
        return points
    if (step <= 0.0).all():
        return points.at(slice(None, None, -1))
    if np.count_nonzero(step < 0.0) > np.count_nonzero(step > 0.0):
        points = points.at(slice(None, None, -1))
        w, step = points.wavelength_nm, -step[::-1]
    run = np.concatenate([[0], np.cumsum(step < 0.0)])
    if _is_out_of_place(points, run):
        at = int(np.argmax(step < 0.0)) + 1
        text.refuse(
            points.lines[at],
            f"the wavelength {w[at]:.10g} nm is below the one before",
            "wavelengths that ascend or fall",
        )
    if inside(w[1:][step < 0.0]).any():
        text.assume("the wavelengths are in no order: sorted")
    return points.at(np.argsort(w, kind="stable"))


def _say_spikes(text, points):
    """Say where one point of the visible stands far from both its neighbours: a cut number, or a typing error."""
    w, values = points.wavelength_nm, points.values
    if points.role == "k" and values.max(initial=0.0) < 0.1 or w.size < 5:
        return
    left, middle, right = values[:-2], values[1:-1], values[2:]
    high, low = np.maximum(left, right), np.minimum(left, right)
    away = np.maximum(middle - high, low - middle) / np.maximum(high, 1e-12) * inside(w[1:-1])
    spikes = np.flatnonzero(away > SPIKE) + 1
    if spikes.size and np.ptp(spikes) <= 2:
        at = spikes[away[spikes - 1].argmax()]
        text.assume(
            f"{points.role} at {w[at]:g} nm, {values[at]:g} in line {points.lines[at]}, stands far from both its "
            "neighbours: is that number right?"
        )


def _is_out_of_place(points, run):
    """Whether a point of the visible, once sorted, does not lie between its neighbours, or nearly."""
    order = np.argsort(points.wavelength_nm, kind="stable")
    w, values = points.wavelength_nm[order], points.values[order]
    moved = (run != np.bincount(run).argmax())[order] & inside(w)
    seen = values[inside(w)]
    room = SAME * (np.ptp(seen) + np.maximum(np.abs(values), SAME_FLOOR)) if seen.size else 0.0
    low = np.minimum(np.roll(values, 1), np.roll(values, -1)) - room
    high = np.maximum(np.roll(values, 1), np.roll(values, -1)) + room
    wrong = moved & ((values < low) | (values > high))
    wrong[[0, -1]] = False
    return bool(wrong.any())


def _each_once(text, points):
    """Each wavelength once where values agree, in the order of the file: the last counts, as in the database."""
    w, values = points.wavelength_nm, points.values
    again = np.flatnonzero(w[1:] == w[:-1]) + 1
    if not again.size:
        return points
    differ = np.abs(values[again] - values[again - 1]) > SAME * np.maximum(np.abs(values[again]), SAME_FLOOR)
    seen = [at for at in again[differ & inside(w[again])] if not _in_a_dense_table(w, values, at)]
    if seen:
        text.refuse(
            max(points.lines[seen[0] - 1], points.lines[seen[0]]),
            f"the wavelength {w[seen[0]]:.10g} nm comes again",
            "each once",
        )
    if inside(w[again]).any():
        text.assume(
            f"{_count(int(inside(w[again]).sum()))} of {points.role} at a wavelength that comes twice: the last counts"
        )
    return Points(points.role, ascending(w), values, points.lines)


def _in_a_dense_table(w, values, at):
    """Whether two values at one wavelength lie between close neighbours, as where a steep curve was digitised."""
    if at < 2 or at + 1 >= w.size or w[at + 1] - w[at - 2] > 2.0 * DENSE_NM:
        return False
    around, two = values[[at - 2, at + 1]], values[at - 1 : at + 1]
    return bool(0.9 * around.min() <= two.min() and two.max() <= 1.1 * around.max())


def _require(text, lines, values, holds, found, expected):
    """Refuse the first line whose value does not hold."""
    if not holds.all():
        at = int(np.argmin(holds))
        text.refuse(lines[at], found.format(values[at]), expected)


def constants(text, found, citation=LICENCE, database=False):
    """The OpticalConstants of checked Points: of n, of n and k, or of R.

    found     Points, each role once at most
    database  whether it is a file of the database: n alone is then what is known of it

    Raises FacetFilmError for another choice of quantities, and where less than
    50 nm of the visible are covered.
    """
    by_role = {points.role: points for points in found}
    if len(by_role) < len(found):
        twice = [points for points in found if by_role[points.role] is not points][0]
        text.refuse(by_role[twice.role].lines[0], f"{twice.role} comes a second time", "each quantity once")
    if set(by_role) not in ({"n"}, {"n", "k"}, {"R"}):
        half = ", half of a pair" if set(by_role) == {"k"} else ""
        text.refuse(None, "has " + " and ".join(sorted(by_role)) + half, "n, n and k, or R")
    low = max(points.wavelength_nm[0] for points in found)
    high = min(points.wavelength_nm[-1] for points in found)
    if min(high, CORE_NM[1]) - max(low, CORE_NM[0]) < LEAST_COVER_NM - 1e-3:
        text.refuse(
            None,
            f"the wavelengths, {low:g} to {high:g} nm, cover less than {LEAST_COVER_NM:g} nm of the visible",
            "400 to 700 nm or a good part of it",
        )
    if low > CORE_NM[0] or high < CORE_NM[1]:
        text.assume(
            f"only {max(low, CORE_NM[0]):g} to {min(high, CORE_NM[1]):g} nm of 400 to 700 nm are measured: "
            "the values at the ends are held beyond"
        )
    about = {"dataset": f"file:{text.name}", "title": text.title, "citation": citation, "licence": LICENCE}
    if "R" in by_role:
        made = from_normal_reflectance(by_role["R"].wavelength_nm, by_role["R"].values, **about)
        return dataclasses.replace(made, assumed=tuple(text.assumed))
    n, k = by_role["n"], by_role.get("k")
    if k is None:
        chosen = _alone(text, n, database)
        return OpticalConstants(
            n.wavelength_nm, n.values, np.zeros_like(n.values), has_k=chosen, assumed=tuple(text.assumed), **about
        )
    wavelength, n, k = on_common_wavelengths((n.wavelength_nm, n.values), (k.wavelength_nm, k.values))
    return OpticalConstants(wavelength, n, k, range_nm=(float(low), float(high)), assumed=tuple(text.assumed), **about)


def why_k_is_missing(wavelength_nm, n):
    """Why n alone cannot be all that there is, or "": metals have n below 1, or n that rises towards the red.

    >>> wavelength = np.array([400.0, 700.0])
    >>> why_k_is_missing(wavelength, np.array([1.5, 1.4])), why_k_is_missing(wavelength, np.array([1.6, 0.2]))
    ('', 'n falls to 0.2')
    """
    core = (wavelength_nm >= CORE_NM[0]) & (wavelength_nm <= CORE_NM[1])
    ends = np.interp([max(wavelength_nm[0], CORE_NM[0]), min(wavelength_nm[-1], CORE_NM[1])], wavelength_nm, n)
    least = min(ends.min(), n[core].min(initial=np.inf))
    if least < LEAST_N_ALONE:
        return f"n falls to {least:g}"
    return f"n rises from {ends[0]:g} to {ends[1]:g} towards the red" if ends[1] - ends[0] > LARGEST_RISE else ""


def _alone(text, n, database):
    """Whether k = 0 is the caller's choice, where n alone cannot be all; in the database it is all that is known."""
    why = why_k_is_missing(n.wavelength_nm, n.values)
    if database or not why:
        text.assume("no k is given: taken as 0")
        return False
    text.ask(
        None,
        f"has n alone, half of a pair: {why}, as only where light is absorbed, so that k is missing;",
        ("k = 0",),
        "n and k, or the other half in a file beside it",
    )
    text.assume("no k is given: taken as 0, as chosen")
    return True
