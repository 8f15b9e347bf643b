"""SOPRA's files: .nk with unit, low, high and number of intervals, then n and k by turns; .MAT with a point a line.

The units of .nk are 1 eV, 2 µm, 3 1/cm and 4 nm; the points are evenly spaced in
them.  In .MAT stars part "DATA1", a running number, the wavelength in nm, n and k.
"""

import re

import numpy as np

from .points import Points, checked, constants
from .text import NUMBER, number_of
from .units import in_nm

__all__ = ["is_sopra", "read_sopra", "is_sopra_mat", "read_sopra_mat"]

UNITS = {1: "eV", 2: "µm", 3: "1/cm", 4: "nm"}
"""By the number in the head."""
MAT_ROW = re.compile(r"\s*DATA\d*\s*\*", re.IGNORECASE)


def is_sopra(text):
    """Whether the first line has four numbers, the unit's first and a count last, and the second has not."""
    lines = [_words(line) for line in text.lines if line.strip()][:2]
    first = lines[0]
    if len(first) != 4 or not all(NUMBER.fullmatch(word) for word in first):
        return False
    follows = len(lines) < 2 or len(lines[1]) != 4 or text.suffix == ".nk"
    return follows and float(first[0]) in UNITS and float(first[3]).is_integer()


def _words(line):
    return line.replace(";", " ").split()


def read_sopra(text):
    """The OpticalConstants of a Text in SOPRA's format.

    Raises FacetFilmError with the line and what was expected there.

    >>> from .text import Text
    >>> read_sopra(Text("x.nk", "4 400 700 1\\n1.5 0\\n1.4 0.1")).wavelength_nm.tolist()
    [400.0, 700.0]
    """
    words = [(number, word) for number, line in enumerate(text.lines, 1) for word in _words(line)]
    head, rest = words[:4], words[4:]
    unit, low, high, intervals = (number_of(text, number, word, "the head") for number, word in head)
    line = head[0][0]
    if not 0.0 < low < high:
        text.refuse(line, f"the range is {low:g} to {high:g}", "two numbers above 0, the lower first")
    if intervals < 1:
        text.refuse(line, f"there are {intervals:g} intervals", "one or more")
    values = np.array([number_of(text, number, word, "n or k") for number, word in rest])
    if len(rest) != 2 * (intervals + 1):
        text.refuse(rest[-1][0] if rest else line, f"{len(rest)} numbers follow the head",
                    f"{2 * (intervals + 1):g}: n and k at both ends of {intervals:g} intervals")
    wavelength = np.round(in_nm(np.linspace(low, high, int(intervals) + 1), UNITS[int(unit)]), 9)
    lines = np.array([number for number, _ in rest[::2]])
    return constants(text, [checked(text, Points(role, wavelength, column, lines))
                            for role, column in (("n", values[::2]), ("k", values[1::2]))])


def is_sopra_mat(text):
    """Whether a line begins as those of SOPRA's .MAT do."""
    return any(MAT_ROW.match(line) for line in text.lines[:50])


def read_sopra_mat(text):
    """The OpticalConstants of a Text in SOPRA's .MAT.

    Raises FacetFilmError with the line and what was expected there.

    >>> from .text import Text
    >>> read_sopra_mat(Text("X.MAT", "VERSION*1*\\nDATA1*1*4e2*1.5*0*\\nDATA1*2*7e2*1.4*0.1*\\nEOF*")).n.tolist()
    [1.5, 1.4]
    """
    rows, lines = [], []
    for number, line in enumerate(text.lines, 1):
        if MAT_ROW.match(line):
            cells = [cell.strip() for cell in line.strip().rstrip("*").split("*")]
            if len(cells) != 5:
                text.refuse(number, f"has {len(cells) - 1} numbers", "4: number, wavelength, n, k")
            rows.append([number_of(text, number, cell, "a number") for cell in cells[2:]])
            lines.append(number)
    table = np.array(rows)
    unit = "nm"
    return constants(text, [checked(text, Points(role, in_nm(table[:, 0], unit), column, np.array(lines)))
                            for role, column in (("n", table[:, 1]), ("k", table[:, 2]))])
