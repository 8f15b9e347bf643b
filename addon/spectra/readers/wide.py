"""Tables that lie on their side: one spectrum a row, the wavelengths above them."""

import re

import numpy as np

from . import units
from .headings import Column, column_of
from .rows import Row, Table, number_in

__all__ = ["table_of_rows"]

LEAST_WAVELENGTHS = 5
"""Cells of a row that are numbers over a good part of the visible: fewer are a row of a table that stands."""
WITH_LETTERS = re.compile(
    r"(?P<before>[A-Za-z%_ ]*?)[\s_(]*(?P<number>\d+(?:[.,]\d+)?)\s*\)?\s*(?P<unit>nm|um|µm|μm)?", re.IGNORECASE
)


def table_of_rows(text):
    """The Table of a Text whose rows are spectra, or None."""
    lines = [(number, line.strip("\r\n \ufeff")) for number, line in enumerate(text.lines[:400], 1) if line.strip()]
    lines = [
        (number, line)
        for number, line in lines
        if not line.startswith(("%", "!", "//")) and not line.lower().startswith("sep=")
    ]
    for place, (number, line) in enumerate(lines[:60]):
        for separator in ("\t", ";", ",", None):
            if separator is not None and separator not in line:
                continue
            head = [cell.strip().strip("\"'#") for cell in (line.split(separator) if separator else line.split())]
            if len(head) < LEAST_WAVELENGTHS:
                continue
            axis = _axis_of(head)
            if axis is not None:
                table = _table(text, number, lines[place + 1 :], separator, *axis)
                if table is not None:
                    return table
            break
    return None


def _axis_of(head):
    """(first place, numbers, unit, whether letters stand with them) of the wavelengths in a row's cells, or None."""
    found = []
    start = 0
    unit, lettered = "", False
    for at, cell in enumerate(head):
        match = WITH_LETTERS.fullmatch(cell) if 0 < len(cell) < 40 else None
        if match is None:
            if found:
                if any(letter.isdigit() for rest in head[at:] for letter in rest):
                    return None  # one of the wavelengths is no number
                break
            start = at + 1
            continue
        if not found:
            start = at
        lettered = lettered or bool(match["before"].strip() or match["unit"])
        unit = unit or (units.UNIT_OF.get((match["unit"] or "").lower().replace("µ", "μ"), "") if match["unit"] else "")
        found.append(float(match["number"].replace(",", ".")))
    values = np.array(found)
    if values.size < LEAST_WAVELENGTHS or not (np.all(np.diff(values) > 0.0) or np.all(np.diff(values) < 0.0)):
        return None
    named = column_of(head[start - 1]) if start else Column("")
    unit = unit or (named.unit if named.is_axis else "")
    fits = (unit,) if unit else units.fitting(values, named.role if named.is_axis and named.role != "axis" else "")
    if not fits or values.max() < 1.2 * values.min():
        return None
    return start, values, fits[0] if len(fits) == 1 or "nm" not in fits else "nm", lettered or named.is_axis


def _table(text, number, below, separator, start, values, unit, lettered):
    series = []
    for line_number, line in below:
        cells = [cell.strip().strip("\"'") for cell in (line.split(separator) if separator else line.split())]
        data = cells[start : start + values.size]
        label = " ".join(cell for cell in cells[:start] if cell)
        if separator is None and len(cells) != start + values.size and len(cells) > values.size:
            data, label = cells[-values.size :], " ".join(cells[: -values.size])
        if len(data) != values.size:
            if series:
                break
            continue
        comma = separator != "," and any("," in cell for cell in data)
        try:
            row = [number_in(cell, comma) for cell in data]
        except ValueError:
            if series:
                break
            return None
        series.append((line_number, label, row))
    if (
        not series
        or not lettered
        and not (len(series) <= 2 and start == 0 or all(label and not _is_number(label) for _, label, _ in series))
    ):
        return None
    columns = [Column(units.AXIS_UNITS[unit].kind, unit, "wavelength")]
    for at, (_, label, _) in enumerate(series):
        told = column_of(label) if label else Column("")
        known = told.role in {"n", "k", "R", "ε1", "ε2", "T", "A"}
        columns.append(told if known else Column("", "", label or f"row {at + 1}"))
    if not lettered and start == 0 and len(series) == 2:
        columns[1:] = [Column("n", "", "n"), Column("k", "", "k")]
        text.assume("rows taken as wavelength, n, k: there are no headings")
    if all(not column.role for column in columns[1:]):
        columns[1:] = [Column("", column.unit, column.name) for column in columns[1:]]
        text.assume("one spectrum a row")
    rows = [Row(number, [values[at], *(row[at] for _, _, row in series)], {}) for at in range(values.size)]
    return Table([], rows, columns)


def _is_number(label):
    try:
        number_in(label)
    except ValueError:
        return False
    return True
