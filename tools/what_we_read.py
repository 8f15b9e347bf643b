"""Writes docs/what_we_read.md from the tables of the reader.

    python tools/what_we_read.py
"""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from addon.spectra.readers import FORMATS, SUFFIXES, glass, headings, pairs, points, rows, text, units  # noqa: E402  # noqa: E402

PAGE = ROOT / "docs" / "what_we_read.md"

QUANTITIES = {
    "n": "index of refraction", "k": "extinction coefficient", "ε1": "real part of the permittivity",
    "ε2": "imaginary part of the permittivity", "R": "reflectance at normal incidence, a share or in %",
    "T": "transmittance: k follows from it beside n and a thickness", "A": "absorbance: nothing follows from it",
    "α": "absorption coefficient: k = αλ/4π beside n", "n+ik": "complex index of refraction",
    "ε1+iε2": "complex permittivity", "number": "counts the rows: left aside", "other": "left aside",
    "axis": "any of the axes", "wavelength": "axis", "energy": "axis", "wavenumber": "axis", "frequency": "axis",
}

HEAD = """# What we read

Written by tools/what_we_read.py from the tables of addon/spectra/readers; how to give a file is in
[Your own measurements](own_data.md).

A file whose meaning is plain is read, and what was assumed is said in one line. A file that can mean two things
is refused with the readings named: `choose` takes the name of one. Nothing else is guessed.

## Formats
"""
TABLES = """
Names of files end as they like; file dialogues show {suffixes}.

## Tables

A point a line, or one spectrum a row. Columns are parted by {separators}; numbers have a decimal point, or a
comma where columns are parted otherwise; `1.5D0`, `(1.48+1.88j)` and `400nm` are numbers. Lines that begin with
{marks} or first of all `;` are remarks, which may name the columns. Titles, rows of units, `sep=`, instruments'
heads and feet, empty columns, running numbers and further columns are left aside. Nothing was measured in a cell
that is empty or {missing}.

Wavelengths ascend or fall, or are in any order in which points lie between their neighbours. In the visible no
point may be missing between others that lie more than {gap:g} nm apart. k and R below 0 down to {noise:g} are 0, R up
to {above:g} is 1, and it is said; so is a number that stands far from both its neighbours. k or ε2 below 0 throughout
is n − ik. What is faulty outside of 360 to 780 nm is left out.

n alone that falls below {least:g}, or rises by more than {rise:g} towards the red, is half of a pair: k is missing.
The other half is looked for beside a file, where it has the same name with another of these words:
"""
UNITS = """
## Units of the axis

Where none is named, the unit is what all numbers of the file can be: those with a star. Several are told apart by
what is covered, by the order, and by physics: in metals k grows towards the red, in what is clear n falls towards it.
"""
HEADINGS = """
## Headings

Capitals, spaces, brackets and units beside a word do not matter; `n_Au`, `Index n`, `R (%)` and `wavelength/nm` are
understood.
"""
END = """
Text that is not UTF-8 is read in the first of {encodings} in which it has one of these words, else in Latin-1.

## Dispersion formulas of glass catalogues
"""


def page():
    """The text of the page."""
    return "\n".join([
        HEAD, *table(("What", "How it is known"), [
            (f"{what[0].upper()}{what[1:]}", how) for _, _, what, how in FORMATS]),
        TABLES.format(
            suffixes=quoted(SUFFIXES), separators=", ".join(rows.SEPARATORS.values()), marks=quoted(rows.COMMENTS),
            missing=quoted(sorted(rows.MISSING - {""})), gap=points.LARGEST_GAP_NM, noise=points.K_NOISE,
            above=points.R_ABOVE, least=points.LEAST_N_ALONE, rise=points.LARGEST_RISE),
        *table(("Half", "Words"), [(half, quoted(words)) for half, words in pairs.HALVES.items()]),
        UNITS, *table(("Unit", "Kind", "As people write it"), [
            (name + (" *" if unit.unnamed else ""), unit.kind, words_of(unit.spellings))
            for name, unit in units.AXIS_UNITS.items()]),
        HEADINGS, *table(("Quantity", "What it is", "Words"), [
            (role, QUANTITIES[role], words_of(names)) for role, names in headings.QUANTITIES.items()]),
        END.format(encodings=", ".join(text.OLD_ENCODINGS)),
        *table(("Number", "Formula", "Coefficients"), [
            (number, name, count) for number, (name, count, _) in glass.FORMULAS.items()]), ""])


def quoted(words):
    """Words side by side, as code."""
    return ", ".join(f"`{word}`" for word in words)


def words_of(words):
    """Words side by side, as they stand in a table."""
    return ", ".join(word.replace("|", "\\|").replace("$", "").replace("\\mum", "µm") for word in words if word)


def table(heads, lines):
    """Lines of a table."""
    return ["| " + " | ".join(heads) + " |", "| " + " | ".join("---" for _ in heads) + " |",
            *("| " + " | ".join(map(str, line)) + " |" for line in lines)]


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
