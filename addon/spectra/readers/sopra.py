"""SOPRA's .nk files: a line with unit, low, high and number of intervals, then n and k by turns.

The units are 1 eV, 2 µm, 3 1/cm and 4 nm; the points are evenly spaced in them.
"""

import numpy as np

from .points import Points, checked, constants
from .text import NUMBER, number_of

__all__ = ["is_sopra", "read_sopra"]

EV_NM = 1239.841984
"""Planck's constant times the speed of light, eV nm (CODATA 2018)."""
TO_NM = {1: lambda e: EV_NM / e, 2: lambda w: 1000.0 * w, 3: lambda v: 1e7 / v, 4: lambda w: w}
"""By the unit's number: nm of energies in eV, wavelengths in µm, wave numbers in 1/cm, wavelengths in nm."""


def is_sopra(text):
    """Whether the first line has four numbers, the unit's first and a count last, and the second has not."""
    lines = [_words(line) for line in text.lines if line.strip()][:2]
    first = lines[0]
    if len(first) != 4 or not all(NUMBER.fullmatch(word) for word in first):
        return False
    follows = len(lines) < 2 or len(lines[1]) != 4 or text.suffix == ".nk"
    return follows and float(first[0]) in TO_NM and float(first[3]).is_integer()


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
    wavelength = np.round(TO_NM[int(unit)](np.linspace(low, high, int(intervals) + 1)), 9)
    lines = np.array([number for number, _ in rest[::2]])
    order = slice(None, None, -1 if wavelength[0] > wavelength[-1] else 1)
    return constants(text, [
        checked(text, Points(role, wavelength[order], column[order], lines[order]))
        for role, column in (("n", values[::2]), ("k", values[1::2]))])
