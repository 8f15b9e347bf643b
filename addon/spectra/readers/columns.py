"""From tables of cells to quantities over wavelength, and from those to n and k.

What headings, remarks, the file's name and the numbers themselves say decides,
in this order; where two readings stay possible the caller is asked.
"""

import dataclasses
import re

import numpy as np

from . import units
from .headings import Column, column_of, quantity_of_name
from .pairs import partner_of
from .points import checked, constants
from .quantities import n_and_k_of
from .rows import ROW, Table, numbers, tables_of
from .wide import table_of_rows

__all__ = ["read_columns", "Series", "series_of", "finished"]

LARGEST_PLAIN_INDEX, LEAST_PLAIN_PERCENT = 3.0, 10.0
"""In a table of two columns without headings: n up to the one, a reflectance in percent from the other on.

Between them lie the percents of glasses and the n of semiconductors alike.
"""
MOST_SERIES = 2000
LEAST_N_WITHOUT_K, LEAST_K_OF_A_METAL, LARGEST_N = 1.0, 0.5, 12.0
"""No material has n below the first and k below the second throughout, nor n above the last: R may be meant."""
MOST_LINES_OF_A_HEAD = 100
IN_HEADS = {
    role: re.compile(words, re.IGNORECASE)
    for role, words in {
        "R": r"\breflect(ance|ivity|ion)\b|%\s?R\b|\bR\s?%|\breflexion",
        "T": r"\btransmi(ttance|ssion|ssivity)\b|%\s?T\b|\bT\s?%",
        "A": r"\babsor(bance|ptance|ption)\b|\boptical density\b|\bemissivity\b|\b(ir)?radiance\b|\bcounts\b"
        r"|\bintensity\b",
    }.items()
}
"""Words of an instrument's head that tell what it measured."""
SHORT_REMARK = 4
"""Words of a remark that is no sentence: "Au n" names the quantity."""


@dataclasses.dataclass(eq=False)
class Series:
    """A column of values over its axis.

    role, name     the quantity, "" where nothing names it, and its heading
    unit           "%", "" or a unit of α
    wavelength_nm  ``(W,)``
    values         ``(W,)``, complex where its cells are
    lines          ``(W,)``
    angle          degrees from the normal that the heading names
    group          which table, or which of several side by side, it is from
    """

    role: str
    name: str
    unit: str
    wavelength_nm: np.ndarray
    values: np.ndarray
    lines: np.ndarray
    angle: float = 0.0
    group: str = ""


def read_columns(text):
    """The OpticalConstants of a Text that holds a table.

    Raises FacetFilmError with the line and what was expected there.

    >>> from .text import Text
    >>> read_columns(Text("glass.txt", "400 1.52\\n700 1.51")).n.tolist()
    [1.52, 1.51]
    """
    return finished(text, series_of(text))


def series_of(text):
    """The Series of all tables of a Text."""
    wide = table_of_rows(text)
    tables = [wide] if wide else tables_of(text)
    laid_out = [_laid_out(text, table) for table in tables]
    _name_units(text, laid_out)
    found = [series for at, layout in enumerate(laid_out) for series in _series(text, layout, at)]
    if len(found) > MOST_SERIES:
        text.refuse(None, f"has {len(found)} columns", f"at most {MOST_SERIES}")
    return found


# --- which column is what ---


@dataclasses.dataclass(eq=False)
class Layout:
    """A Table with its Columns, and in pairs which column is an axis and which are given over it.

    parts  [(place of the axis, places of its values)]
    units  the unit of each axis, as named or decided
    """

    table: Table
    columns: list
    parts: list
    matrix: np.ndarray
    units: list


def _laid_out(text, table):
    is_complex = any(type(value) is complex for row in table.rows if row.faults is not None for value in row.values)
    matrix = np.array([row.values for row in table.rows], complex if is_complex else float)
    real = matrix.real
    columns = table.columns or _columns_by_values(text, table, matrix)
    if len(columns) == 1:
        text.refuse(table.rows[0].line, f"has {numbers(1)}", "two or three: wavelength, n and k, or wavelength and R")
    axes = [at for at, column in enumerate(columns) if column.is_axis]
    if not axes:
        # None is called an axis: the first that is no count of the rows.
        first = 1 if len(columns) > 2 and columns[0].role == "number" else 0
        columns = list(columns)
        columns[first] = Column("axis", "", columns[first].name)
        axes = [first]
    parts = _parts(text, columns, axes, real)
    return Layout(table, columns, parts, matrix, [columns[axis].unit for axis, _ in parts])


def _parts(text, columns, axes, real):
    """[(axis, values)]: side by side where one kind of axis comes again, else over the axis that tells most."""
    values = [at for at, column in enumerate(columns) if not column.is_axis and column.role not in {"number", "other"}]
    kinds = {(columns[axis].role, columns[axis].unit) for axis in axes}
    if len(axes) > 1 and len(kinds) == 1:
        parts = []
        for place, axis in enumerate(axes):
            end = axes[place + 1] if place + 1 < len(axes) else len(columns)
            parts.append((axis, [at for at in values if axis < at < end]))
        if all(found for _, found in parts):
            return parts
    order = ["nm", "µm", "Å", "eV"]
    best = min(
        axes,
        key=lambda axis: (
            columns[axis].unit == "",
            order.index(columns[axis].unit) if columns[axis].unit in order else len(order),
            axis,
        ),
    )
    if len(axes) > 1:
        text.assume(f"read over {columns[best].name!r}, as the axis is there several times")
    if not values:
        text.refuse(
            None,
            "the headings name only " + ", ".join(repr(column.name) for column in columns)[:80],
            "wavelength and n, n and k, or R",
        )
    return [(best, values)]


def _columns_by_values(text, table, matrix):
    """The Columns of a table without headings.

    A running number first is left aside; an axis that comes again begins a
    second table beside the first; then three are wavelength, n, k, and two may
    be n or R.
    """
    real = matrix.real
    width = real.shape[1]
    first = table.rows[0].line
    with np.errstate(invalid="ignore"):
        running = width >= 3 and len(real) > 2 and np.all(np.diff(real[:, 0]) == 1.0) and real[0, 0] in (0.0, 1.0)
    if running and _is_axis(real[:, 1]):
        text.assume("the first column counts the rows")
        rest = _columns_by_values(text, Table(table.above, table.rows, None), matrix[:, 1:])
        return [Column("number"), *rest]
    axes = [at for at in range(0, width, width // 2)] if width in (4,) else []
    if axes and all(_is_axis(real[:, at]) and not _is_axis(real[:, at + 1]) for at in axes):
        text.assume("two tables side by side taken as wavelength, n, wavelength, k: there are no headings")
        return [Column("axis"), Column("n"), Column("axis"), Column("k")]
    if width == 4 and _is_reflectance_of(real):
        text.assume("columns taken as wavelength, n, k, R: there are no headings, and R fits n and k")
        return [Column("axis"), Column("n"), Column("k"), Column("other")]
    if width == 5 and _is_permittivity_of(real):
        text.assume("columns taken as wavelength, n, k, ε1, ε2: there are no headings, and ε fits n and k")
        return [Column("axis"), Column("n"), Column("k"), Column("other"), Column("other")]
    if width == 2:
        return [Column("axis"), Column("")]
    if width == 3:
        return _three(text, real)
    return text.refuse(
        first,
        f"has {numbers(width)}",
        "two or three: wavelength, n and k, or wavelength and R; or headings that say what they are",
    )


def _is_axis(values):
    """Whether numbers rise or fall throughout, over a range that can be a good part of the visible."""
    values = values[np.isfinite(values)]
    step = np.diff(values)
    return (
        values.size > 1
        and values.min() > 0.0
        and (np.all(step > 0.0) or np.all(step < 0.0))
        and bool(units.fitting(values))
        and values.max() > 1.1 * values.min()
    )


def _three(text, real):
    negative = np.mean(real[:, 1] < 0.0)
    if negative >= 0.5 and np.all(np.nan_to_num(real[:, 2]) >= 0.0):
        text.assume("columns taken as ε1 and ε2: there are no headings, and no n is below 0")
        return [Column("axis"), Column("ε1"), Column("ε2")]
    if _only_the_last_is_axis(real):
        text.assume("columns taken as n, k, wavelength: there are no headings, and only the last can be wavelengths")
        return [Column("n"), Column("k"), Column("axis")]
    second, third = real[np.isfinite(real[:, 1]), 1], np.abs(real[np.isfinite(real[:, 2]), 2])
    if (
        second.size
        and third.size
        and (second.max() < LEAST_N_WITHOUT_K and third.max() < LEAST_K_OF_A_METAL or np.median(second) > LARGEST_N)
    ):
        percent = np.median(second) > LARGEST_N
        readings = ("R in % and another", "n and k") if percent else ("R and another", "n and k")
        span = f"{second.min():g} to {second.max():g}"
        if (
            text.ask(
                None,
                f"the second numbers, {span}, beside third ones to {third.max():g}, may be",
                readings,
                "headings that say what they are",
            )
            != "n and k"
        ):
            return [Column("axis"), Column("R", "%" if percent else ""), Column("other")]
    text.assume("columns taken as wavelength, n, k: there are no headings")
    return [Column("axis"), Column("n"), Column("k")]


def _only_the_last_is_axis(real):
    first, last = real[:, 0], real[:, 2]
    step = np.diff(last[np.isfinite(last)])
    orderly = step.size > 1 and max(np.mean(step > 0.0), np.mean(step < 0.0)) >= (0.85 if step.size > 6 else 1.0)
    lengths = (
        [unit for unit in units.fitting(last) if unit in {"nm", "µm"}] if orderly and np.nanmin(last) > 0.0 else []
    )
    return bool(lengths) and np.isfinite(first).all() and not _is_axis(first) and first.max() < 20.0


def _is_reflectance_of(real):
    n, k, r = real[:, 1], real[:, 2], real[:, 3]
    with np.errstate(all="ignore"):
        expected = ((n - 1.0) ** 2 + k**2) / ((n + 1.0) ** 2 + k**2)
        return len(r) > 2 and bool(np.all(np.abs(expected - r) < 0.01) or np.all(np.abs(100.0 * expected - r) < 1.0))


def _is_permittivity_of(real):
    n, k, e1, e2 = real[:, 1:].T
    with np.errstate(all="ignore"):
        return len(n) > 2 and bool(
            np.allclose(n * n - k * k, e1, rtol=0.02, atol=0.02) and np.allclose(2.0 * n * k, e2, rtol=0.02, atol=0.02)
        )


# --- in which unit the axis is ---


def _name_units(text, laid_out):
    """Set the units of axes that name none: what remarks say and the numbers of all tables can be."""
    for layout in laid_out:
        for (axis, _), unit in zip(layout.parts, layout.units):
            _refuse_invisible(text, layout, _usable(layout.matrix[:, axis].real), unit)
    open_ones = [
        (layout, at) for layout in laid_out for at, unit in enumerate(layout.units) if not unit or unit[0] == "?"
    ]
    if not open_ones:
        return
    for layout, at in open_ones:
        if layout.units[at][:1] == "?":
            column = layout.columns[layout.parts[at][0]]
            text.refuse(
                _line_of(layout),
                f"the unit {layout.units[at][1:]!r} of {column.role} is unknown",
                "nm, µm, Å, eV, 1/cm or THz",
            )
    kinds = {layout.columns[layout.parts[at][0]].role for layout, at in open_ones}
    kind = kinds.pop() if len(kinds) == 1 else ""
    kind = "" if kind == "axis" else kind
    axis = np.concatenate([_usable(layout.matrix[:, layout.parts[at][0]].real) for layout, at in open_ones])
    line = _line_of(open_ones[0][0])
    if not axis.size:
        text.refuse(line, "there are no wavelengths", "lines of wavelength, n, k")
    unit = _unit_of(text, open_ones, axis, kind, line)
    for layout, at in open_ones:
        layout.units[at] = unit
        column = layout.columns[layout.parts[at][0]]
        layout.columns[layout.parts[at][0]] = dataclasses.replace(column, role=units.AXIS_UNITS[unit].kind, unit=unit)


def _refuse_invisible(text, layout, values, unit):
    if unit not in units.AXIS_UNITS or not values.size:
        return
    nm = units.in_nm(values, unit)
    if nm.min() > 780.0 or nm.max() < 360.0:
        text.refuse(
            _line_of(layout),
            f"the headings say {unit}, in which {values.min():g} to {values.max():g} are not visible",
            "400 to 700 nm or a good part of it",
        )


def _line_of(layout):
    return layout.table.rows[0].line


def _usable(values):
    return values[np.isfinite(values) & (values > 0.0)]


def _unit_of(text, open_ones, axis, kind, line):
    low, high = axis.min(), axis.max()
    fits = units.fitting(axis, kind)
    named = [unit for unit in _units_in_remarks(text) if unit in fits]
    what = {"energy": "energies", "wavenumber": "wavenumbers", "frequency": "frequencies"}.get(kind, "wavelengths")
    if not fits:
        common = " or ".join(units.KINDS[kind][:2])
        text.refuse(
            line,
            f"the {what}, {low:g} to {high:g}, are not visible in {common}",
            "400 to 700 nm or a good part of it, the unit in a heading",
        )
    chosen = text.chosen(fits)
    if chosen:
        return chosen
    if len(set(named)) == 1:
        text.assume(f"{what} read in {named[0]}, as a remark says")
        return named[0]
    if len(fits) == 1:
        only = "" if fits[0] in {"nm", "µm"} else f", as {low:g} to {high:g} are visible in no other unit"
        text.assume(f"{units.AXIS_UNITS[fits[0]].kind} taken in {fits[0]}{only}: no unit is named")
        return fits[0]
    layout = open_ones[0][0]
    places = dict((layout.columns[at].role, at) for _, values in layout.parts for at in values)
    column = {role: layout.matrix[:, places[role]].real for role in ("n", "k") if role in places}
    own = layout.matrix[:, layout.parts[0][0]].real
    good = np.isfinite(own) & (own > 0.0)
    for values in column.values():
        good &= np.isfinite(values)
    best, why = (
        (None, "")
        if len(open_ones) > 1 or not good.any()
        else units.decided(own[good], fits, *(column[role][good] if role in column else None for role in ("n", "k")))
    )
    if best is None:
        return text.ask(
            line,
            f"the {what}, {low:g} to {high:g}, may be in",
            fits,
            "one unit throughout, named in a heading such as wavelength_nm",
        )
    text.assume(
        f"{units.AXIS_UNITS[best].kind} read in {best}, not {' or '.join(unit for unit in fits if unit != best)}: {why}"
    )
    return best


def _units_in_remarks(text):
    """Units of the axis that remarks name: "wavelengths in nm", "units: eV"."""
    found = []
    for line in text.lines[:60]:
        if len(line) > 300:
            continue
        for match in re.finditer(
            r"(?:wavelengths?|lambda|energy|energies|units?|wl|x[ _-]?axis|spectral unit)\b[\s:=(\[]*"
            r"(?:is|are|in|of|:|=)*\s*[(\[]?\s*([^\s,;()\[\]]+)",
            line,
            re.IGNORECASE,
        ):
            word = match[1].lower().strip(".\"'").replace("µ", "μ")
            if word in units.UNIT_OF and word not in {"a", "m", "j"}:
                found.append(units.UNIT_OF[word])
    return found


# --- the columns as series ---


def _series(text, layout, place):
    table, matrix = layout.table, layout.matrix
    lines = np.array([row.line for row in table.rows])
    titles = _titles(table)
    for (axis, values), unit in zip(layout.parts, layout.units):
        axis_values = matrix[:, axis].real
        nm = (
            units.in_nm(np.where(axis_values == 0.0, np.nan, axis_values), unit)
            if units.AXIS_UNITS[unit].falls
            else units.in_nm(axis_values, unit)
        )
        for at in values:
            column = layout.columns[at]
            if column.unit[:1] == "?":
                text.refuse(
                    table.above[-1][0] if table.above else lines[0],
                    f"the unit {column.unit[1:]!r} of {column.role} is unknown",
                    "% or none" if column.role in {"R", "T"} else "none, as it is a mere number",
                )
            keep = _without_faults(text, table.rows, nm, axis, at, matrix)
            name = column.name or titles.get(at) or titles.get(axis) or ""
            group = titles.get(axis) or titles.get(at) or ""
            yield Series(column.role, name, column.unit, nm[keep], matrix[keep, at], lines[keep], column.angle, group)


def _titles(table):
    """What stands in the line above the headings, by column: samples that an instrument writes side by side."""
    for at in range(len(table.above) - 1, 0, -1):
        if table.columns is not None and column_of(table.above[at][1].split(",")[0].split("\t")[0].split(";")[0]).role:
            line = table.above[at - 1][1]
            for separator in ("\t", ";", ","):
                if separator in line:
                    return {
                        place: cell.strip().strip('"')
                        for place, cell in enumerate(line.split(separator))
                        if cell.strip().strip('"')
                    }
    return {}


def _without_faults(text, rows, nm, axis, at, matrix):
    """Which rows count: those without a fault.  One in the visible is refused, one outside of it left out."""
    missing = np.isnan(nm)
    empty = missing & np.isnan(matrix[:, at]) | (matrix == 0.0).all(axis=1)
    keep = ~empty
    faulty = [
        place
        for place, row in enumerate(rows)
        if row.faults and (ROW in row.faults or axis in row.faults or at in row.faults)
    ]
    faulty += np.flatnonzero(missing & ~empty).tolist()
    left_out = 0
    for place in sorted(set(faulty)):
        faults = rows[place].faults or {}
        if not missing[place] and not 360.0 <= nm[place] <= 780.0 and axis not in faults and nm[place] > 0.0:
            keep[place] = False
            left_out += 1
            continue
        text.refuse(
            rows[place].line,
            *(faults.get(ROW) or faults.get(axis) or faults.get(at) or ("the wavelength is missing", "a number")),
        )
    if left_out:
        text.assume(f"{left_out} lines outside of 360 to 780 nm left out: they are faulty")
    return keep


# --- which quantities, and what follows from them ---


def finished(text, found):
    """The OpticalConstants of some Series: those that the caller chose, or the only ones that there are."""
    found = _chosen(text, [_told(text, series, found) for series in found])
    roles = {series.role: series for series in found}
    points = n_and_k_of(text, roles)
    if points is None:
        points = _with_partner(text, roles)
    if set(roles) & {"R", "T", "A", "α", "ε1", "ε2"} and {"n", "k"} <= set(roles):
        text.assume("read from n and k: " + ", ".join(sorted(set(roles) - {"n", "k"})) + " left aside")
    noise_free = [checked(text, one) for one in points]
    return constants(text, noise_free)


def _told(text, series, every):
    """The Series with its role, told by remarks, the file's name or its values where no heading tells it."""
    if np.iscomplexobj(series.values) and series.role in {"", "n", "ε1+iε2"} and np.any(series.values.imag):
        return dataclasses.replace(series, role="ε1+iε2" if series.role == "ε1+iε2" else "n+ik")
    if np.iscomplexobj(series.values):
        series = dataclasses.replace(series, values=series.values.real)
    if series.role or sum(one.role == "" for one in every) > 1 and any(one.role in {"n", "k", "R"} for one in every):
        return series
    return dataclasses.replace(series, **_told_by_values(text, series))


def _told_by_values(text, series):
    """role and unit of a Series that has no heading."""
    chosen = text.chosen(("n", "R", "k", "R in %"))
    if chosen:
        return {"role": chosen[0], "unit": "%" if "%" in chosen else ""}
    if series.unit == "%":
        return {"role": "R", "unit": "%"}
    told = {role for role in (_by_remarks(text), quantity_of_name(text.name[: -len(text.suffix) or None])) if role}
    values = series.values[np.isfinite(series.values)]
    line = series.lines[0] if series.lines.size else None
    if not values.size:
        text.refuse(line, "there are no values", "numbers")
    if not told:
        told = _by_words_above(text, line)
    if len(told) > 1:
        role = text.ask(line, "the second numbers may be", tuple(sorted(told)), "a heading that says what they are")
        return {"role": role}
    if len(told) == 1:
        role = told.pop()
        text.assume(f"taken as {role}, as the file's name or a remark says")
        return {"role": role}
    span = f"{values.min():g} to {values.max():g}"
    if text.suffix == ".spd":
        role = text.ask(
            line,
            f"the second numbers, {span}, are one half of an eta and k pair, or a reflectance: they may be",
            ("n", "k", "R"),
            "a name such as Au.eta.spd with Au.k.spd beside it",
        )
        return {"role": role}
    if values.min() <= 0.0 or (values >= 1.0).all() and values.max() <= LARGEST_PLAIN_INDEX:
        if values.min() > 0.0:
            text.assume("taken as n: there are no headings, and all is from 1 to 3")
        return {"role": "n"}
    if (values < 1.0).all():
        text.assume("taken as the reflectance R: there are no headings, and all is below 1")
        return {"role": "R"}
    if (values >= LEAST_PLAIN_PERCENT).all():
        text.assume("taken as the reflectance R in %: there are no headings, and all is from 10 on")
        return {"role": "R", "unit": "%"}
    role = text.ask(
        line,
        f"the second numbers, {span}, may be n or R:",
        ("n", "R", "R in %"),
        "a heading such as 'wavelength_nm, n' or 'wavelength_nm, R (%)'",
    )
    return {"role": role[0], "unit": "%" if "%" in role else ""}


def _by_words_above(text, line):
    """The quantities that heads of instruments name in their lines: "YUNITS  TRANSMITTANCE"."""
    found = set()
    for above in text.lines[: min(line - 1 if line else 0, MOST_LINES_OF_A_HEAD)]:
        if len(above) < 300:
            found |= {role for role, words in IN_HEADS.items() if words.search(above)}
    return found


def _by_remarks(text):
    """The quantity that a short remark names: "# Au n"."""
    found = set()
    for line in text.lines[:12]:
        bare = line.lstrip()
        if bare[:1] in ("#", "%", ";", "!", "*") or bare[:2] == "//":
            words = bare.lstrip("#%;!*/ ").split()
            if 0 < len(words) <= SHORT_REMARK:
                role = quantity_of_name(words[-1]) or quantity_of_name(words[0]) or column_of(words[-1]).role
                if role in {"n", "k", "R", "T", "A", "α"}:
                    found.add(role)
    return found.pop() if len(found) == 1 else ""


def _chosen(text, found):
    """One Series a role: what the caller chose where several materials or spectra stand beside each other."""
    roles = [series.role for series in found]
    if len(set(roles)) == len(roles):
        return found
    names = _sample_names(found)
    line = found[0].lines[0] if found[0].lines.size else None
    samples = list(dict.fromkeys(name for name in names if name))
    if len(samples) < 2:
        role = next(role for role in roles if roles.count(role) > 1)
        twice = [series for series in found if series.role == role][1]
        text.refuse(twice.lines[0] if twice.lines.size else None, f"{role} comes a second time", "each quantity once")
    chosen = text.ask(None if len(samples) > 1 else line, "holds several spectra:", samples)
    text.assume(f"of {len(samples)} spectra: {chosen}")
    picked = [series for series, name in zip(found, names) if name == chosen]
    shared = [
        series for series, name in zip(found, names) if not name and series.role not in {one.role for one in picked}
    ]
    return (
        _chosen(text, picked + shared)
        if len({one.role for one in picked}) == len(picked)
        else text.refuse(line, f"{chosen} comes a second time", "each quantity once")
    )


def _sample_names(found):
    """What tells the Series apart: the heading without the words of its quantity, or the title above it."""
    names = []
    for series in found:
        words = [word for word in re.split(r"[\s_()\[\],;:/]+", series.name) if word]
        rest = [word for word in words if not column_of(word).role and word not in {"%"}]
        names.append(" ".join(rest))
    if len(set(names)) < 2:
        names = [series.group for series in found]
    return names


def _with_partner(text, roles):
    """Points of n and k where one of both is here and the other in a file beside it."""
    half = "n" if "n" in roles else "k" if "k" in roles else "α" if "α" in roles else None
    other = "k" if half == "n" else "n"
    partner = partner_of(text, half)
    if partner is None:
        if half == "n":
            _ask_for_k(text, roles["n"])
            return n_and_k_of(text, roles, alone=True)
        text.refuse(
            None,
            f"has {half} alone, half of a pair",
            "n, n and k, or R; or n in a file beside it, named alike" if half == "k" else "n beside it",
        )
    theirs = {series.role: series for series in series_of(partner)}
    told = {
        role: series
        for role, series in ((_told_half(partner, series, half, other), series) for series in theirs.values())
    }
    if not set(told) & {other, "α"}:
        text.refuse(None, f"has {half} alone, half of a pair, and {partner.name} beside it has no {other}", "n and k")
    found = {
        half: roles[half],
        **{role: dataclasses.replace(series, role=role) for role, series in told.items() if role != half},
    }
    text.assume(f"{half} from here, {other} from {partner.name} beside it")
    return n_and_k_of(text, found)


def _told_half(partner, series, half, other):
    """The role of a Series in the partner's file: the other half where nothing names it."""
    if series.role:
        return series.role
    return quantity_of_name(partner.name[: -len(partner.suffix) or None]) or other


def _ask_for_k(text, series):
    """Refuse n that only a file's name or a remark calls so: that is half of a pair."""
    named = "n" in {quantity_of_name(text.name[: -len(text.suffix) or None]), _by_remarks(text)}
    if named and not series.name:
        text.ask(
            None,
            "has n alone, half of a pair, and no file with k lies beside it;",
            ("k = 0",),
            "the other half in a file beside it, named alike",
        )
