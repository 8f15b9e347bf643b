"""What headings of columns say: the quantity, its unit."""

import dataclasses
import re
import unicodedata

import numpy as np

__all__ = ["Column", "columns_of", "in_nm"]

NM_OF = {"nm": 1.0, "µm": 1000.0, "Å": 0.1}
"""nm in a unit of wavelength."""

UNITS = {
    "nm": "nm", "nanometer": "nm", "nanometers": "nm", "nanometre": "nm", "nanometres": "nm",
    "μm": "µm", "um": "µm", "micron": "µm", "microns": "µm", "mum": "µm", "micrometer": "µm",
    "micrometers": "µm", "micrometre": "µm", "micrometres": "µm",
    "å": "Å", "a": "Å", "ang": "Å", "angstrom": "Å", "angstroms": "Å", "ångström": "Å", "ångstrom": "Å",
}
"""Units of wavelength as people write them, after compatibility normalisation and in small letters."""

NAMES = {
    "wavelength": ("wavelength", "wavelengths", "wave length", "wl", "wvl", "lambda", "lam", "λ", "w"),
    "n": ("n", "index", "refractive index", "index of refraction", "refractive index n", "re(n)", "n(λ)"),
    "k": ("k", "κ", "kappa", "extinction", "extinction coefficient", "extinction coefficient k", "im(n)",
          "k(λ)"),
    "R": ("r", "rn", "r0", "f0", "reflectance", "reflectivity", "normal reflectance", "normal reflectivity",
          "reflectance at normal incidence"),
}
ROLES = {name: role for role, names in NAMES.items() for name in names}
PERCENT = {"%", "percent", "pct", "per cent"}
HEADING = re.compile(r"(?P<name>.*?)[\s,/]*(?:\bin\s)?[\s(\[]*(?P<unit>[^\s()\[\]/,]*)[\s)\]]*")
PHRASES = re.compile(
    r"(refractive index(?: n)?|index of refraction|extinction coefficient(?: k)?|normal reflect\w+"
    r"|wave length|reflectance at normal incidence|\S+ in \S+)")


LONGEST = 300
"""Letters of a line of headings."""


def in_nm(wavelength, unit):
    """Wavelengths in nm, without the digits that binary fractions add where the unit is another.

    wavelength  ``(W,)``
    unit        "nm", "µm" or "Å"

    >>> in_nm(np.array([0.5876]), "µm").tolist()
    [587.6]
    """
    return wavelength if unit == "nm" else np.round(wavelength * NM_OF[unit], 9)


@dataclasses.dataclass(frozen=True)
class Column:
    """A column's role, "wavelength", "n", "k" or "R", and its unit: "nm", "µm", "Å", "%" or ""."""

    role: str
    unit: str = ""


def columns_of(text, line, heading):
    """The Columns that a line of headings names, in its order.

    line     its number in the Text
    heading  the line

    Raises FacetFilmError for headings that are not understood.

    >>> from .text import Text
    >>> [(column.role, column.unit) for column in columns_of(Text("a", "a"), 1, "Wavelength, µm, n, k")]
    [('wavelength', 'µm'), ('n', ''), ('k', '')]
    """
    if len(heading) > LONGEST:
        text.refuse(line, f"has {len(heading)} letters and begins with no number",
                    "numbers, or short headings")
    columns = [_column(text, line, cell) for cell in _cells(heading)]
    roles = [column.role for column in columns]
    if roles[:1] != ["wavelength"] or len(set(roles)) < len(roles) or len(roles) < 2:
        text.refuse(line, "the headings name " + ", ".join(roles),
                    "wavelength first, then n, n and k, or R, each once")
    if "R" in roles and len(roles) > 2:
        text.refuse(line, "the headings name both R and " + "".join({"n", "k"} & set(roles)),
                    "R alone, or n and k")
    return columns


def _cells(heading):
    """The headings one by one; a unit that stands alone belongs to the one before."""
    plain = unicodedata.normalize("NFKC", heading).lower().strip().rstrip(",;\t ")
    separator = next((s for s in "\t;," if s in plain), None)
    if separator is None:
        plain = re.sub(r"\s+(?=[(\[%])", "", plain)
        plain = PHRASES.sub(lambda phrase: phrase[0].replace(" ", "_"), plain)
    cells = [cell.strip().strip("\"'").strip() for cell in plain.split(separator)]
    joined = []
    for cell in cells:
        if joined and cell.strip("()[]") in UNITS.keys() | PERCENT and joined[-1] in ROLES:
            joined[-1] += f" ({cell.strip('()[]')})"
        else:
            joined.append(cell.replace("_", " "))
    return joined


def _column(text, line, cell):
    if cell in ROLES:
        return Column(ROLES[cell])
    if cell in UNITS:
        return Column("wavelength", UNITS[cell])
    if cell in {"%r", "% r", "%reflectance", "% reflectance"}:
        return Column("R", "%")
    if cell.endswith("%"):
        cell = cell[:-1] + " %"
    found = HEADING.fullmatch(cell)
    role = ROLES.get(found["name"].strip()) if found else None
    if role is None:
        text.refuse(line, f"{cell[:40]!r} is no heading",
                    "headings such as 'wavelength_nm, n, k', numbers, or a comment that begins with #")
    unit = found["unit"]
    if role == "wavelength" and unit in UNITS:
        return Column(role, UNITS[unit])
    if role == "R" and unit in PERCENT:
        return Column(role, "%")
    if role != "wavelength" and unit in {"-", "1", ""}:
        return Column(role)
    known = {"wavelength": "nm or µm", "R": "% or none"}.get(role, "none, as it is a mere number")
    return text.refuse(line, f"the unit {unit!r} of {role} is unknown", known)
