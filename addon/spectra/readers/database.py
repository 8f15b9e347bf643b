"""YAML of refractiveindex.info: tabulated n, k or both, and its nine dispersion formulas.

Only as much of YAML as the database uses: keys at the line's start, and below
DATA a list of entries with their keys one to a line.
"""

import re

import numpy as np

from ..optical_constants import VISIBLE_NM, sampled_formula
from .points import LICENCE, Points, checked, constants
from .text import number_of
from .units import in_nm

__all__ = ["is_database", "read_database"]

TOP = re.compile(r"([A-Za-z_]\w*):(?:\s+(.*))?$")
ITEM = re.compile(r"\s*-\s+(\w+):(?:\s+(.*))?$")
KEY = re.compile(r"\s+(\w+):(?:\s+(.*))?$")
TABULATED = {"tabulated n": ("n",), "tabulated k": ("k",), "tabulated nk": ("n", "k")}
NONLINEAR = {"tabulated n2", "formula n2"}
TYPES = "'tabulated n', 'tabulated k', 'tabulated nk' or 'formula 1' to 'formula 9'"
EXAMPLE = "an entry such as '- type: tabulated nk'"
LEAST_COEFFICIENTS = {8: 4, 9: 6}
MOST_COEFFICIENTS = 40
LONGEST_REFERENCE = 2000
AGREE = 0.01
"""Within which two entries of n, or of k, are one."""


def is_database(text):
    """Whether the name ends with .yml or .yaml, or a line reads DATA: but not what we wrote as CSV from such a file."""
    ours = text.lines[0].startswith("wavelength_nm,")
    return text.suffix in {".yml", ".yaml"} and not ours or any(line.rstrip() == "DATA:" for line in text.lines)


def read_database(text):
    """The OpticalConstants of a Text in the database's YAML.

    Raises FacetFilmError with the line and what was expected there.

    >>> from .text import Text
    >>> yaml = "DATA:\\n  - type: formula 5\\n    wavelength_range: 0.4 0.7\\n    coefficients: 1.5"
    >>> read_database(Text("x.yml", yaml)).at(550.0)[0].tolist()
    1.5
    """
    found = []
    for item in _items(text):
        kind = _one_value(text, item, "type").strip("'\"").strip().lower()
        line = item["type"][0]
        formula = re.fullmatch(r"formula ([1-9])", kind)
        if kind in TABULATED:
            found += _tabulated(text, item, TABULATED[kind])
        elif formula:
            found.append(_formula(text, item, int(formula[1])))
        elif kind in NONLINEAR:
            text.refuse(line, "n2 tells how the index grows with very strong light: no reflectance follows",
                        "a dataset of n and k")
        else:
            text.refuse(line, f"the type is {kind[:40]!r}", TYPES)
    return constants(text, _each_quantity_once(text, found), _references(text), database=True)


def _each_quantity_once(text, found):
    """The first of two Points of one quantity that agree: a formula and the table that it was fitted to."""
    first = {}
    for points in found:
        before = first.setdefault(points.role, points)
        if before is not points:
            w = before.wavelength_nm
            w = w[(w >= points.wavelength_nm[0]) & (w <= points.wavelength_nm[-1])]
            differ = np.abs(np.interp(w, before.wavelength_nm, before.values)
                            - np.interp(w, points.wavelength_nm, points.values))
            if not w.size or differ.max() > AGREE:
                text.refuse(points.lines[0], f"{points.role} comes a second time", "each quantity once")
            text.assume(f"{points.role} is there twice and agrees: the first is read")
    return list(first.values())


def _items(text):
    """The entries below DATA: dicts of key to (line, [(line, content) …])."""
    items, inside, data_line = [], False, None
    for number, line in enumerate(text.lines, 1):
        line = re.sub(r"(^|\s)#.*", "", line).rstrip()
        if not line.strip():
            continue
        top, item, key = TOP.match(line), ITEM.match(line), KEY.match(line)
        if top:
            if top[1] == "DATA" and data_line is not None:
                text.refuse(number, "DATA comes a second time", "it once")
            inside = top[1] == "DATA"
            data_line = number if inside else data_line
            if inside and top[2]:
                text.refuse(number, f"after DATA: stands {top[2][:40]!r}", "a list of entries below it")
        elif inside and item:
            items.append({})
            _add_key(text, number, items[-1], *item.groups())
        elif inside and key and items:
            _add_key(text, number, items[-1], *key.groups())
        elif inside and items and line[0] in " \t":
            list(items[-1].values())[-1][1].append((number, line.strip()))
        elif inside:
            text.refuse(number, f"{line.strip()[:40]!r} is out of place", EXAMPLE)
    if data_line is None:
        text.refuse(None, "has no DATA", "the YAML of refractiveindex.info, with DATA: in a line of its own")
    if not items:
        text.refuse(data_line, "DATA is empty", EXAMPLE)
    return items


def _add_key(text, number, item, key, value):
    if key in item:
        text.refuse(number, f"{key} comes a second time in its entry", "it once")
    item[key] = (number, [(number, value)] if value and value.strip() not in {"|", "|-", ">", ">-"} else [])


def _lines_of(text, item, *keys):
    """[(line, content) …] below the first of these keys that the entry has."""
    for key in keys:
        if key in item:
            if not item[key][1]:
                text.refuse(item[key][0], f"{key} is empty", "numbers")
            return item[key][1]
    first_line = next(iter(item.values()))[0]
    return text.refuse(first_line, f"the entry has no {keys[0]}", f"{keys[0]}: below its type")


def _one_value(text, item, key):
    lines = _lines_of(text, item, key)
    if len(lines) > 1:
        text.refuse(lines[1][0], f"{lines[1][1][:40]!r} is out of place", "one line for " + key)
    return lines[0][1]


def _numbers(text, item, *keys):
    return [number_of(text, number, word.strip("'\""), keys[0])
            for number, line in _lines_of(text, item, *keys) for word in line.split()]


def _tabulated(text, item, roles):
    rows, lines = [], []
    for number, line in _lines_of(text, item, "data"):
        rows.append([number_of(text, number, word, "a number of data") for word in line.split()])
        lines.append(number)
        if len(rows[-1]) != 1 + len(roles):
            text.refuse(number, f"has {len(rows[-1])} numbers",
                        f"{1 + len(roles)}: wavelength, " + ", ".join(roles))
    table = np.array(rows)
    wavelength = in_nm(table[:, 0], "µm")
    return [checked(text, Points(role, wavelength, values, np.array(lines)), noise=True)
            for role, values in zip(roles, table.T[1:])]


def _formula(text, item, formula):
    line = item["type"][0]
    coefficients = _numbers(text, item, "coefficients")
    coefficients_line = item["coefficients"][0]
    least = LEAST_COEFFICIENTS.get(formula, 1)
    if not least <= len(coefficients) <= MOST_COEFFICIENTS:
        text.refuse(coefficients_line, f"formula {formula} has {len(coefficients)} coefficients",
                    f"{least} to {MOST_COEFFICIENTS}")
    span = _numbers(text, item, "wavelength_range", "range")
    if len(span) != 2 or not 0.0 < span[0] < span[1]:
        text.refuse(line, "the wavelength_range is not two wavelengths",
                    "the lower and the higher in µm, above 0")
    low, high = (round(1000.0 * end, 9) for end in span)
    if low >= VISIBLE_NM[1] or high <= VISIBLE_NM[0]:
        text.refuse(line, f"the formula holds from {low:g} to {high:g} nm",
                    "some of the visible, 400 to 700 nm")
    try:
        with np.errstate(all="ignore"):
            wavelength, n = sampled_formula(formula, coefficients, low, high)
    except (ArithmeticError, TypeError):
        wavelength, n = np.ones(1), np.array([np.nan])
    n = n + np.zeros(wavelength.shape)
    if np.iscomplexobj(n) or not np.isfinite(n).all():
        text.refuse(coefficients_line, f"formula {formula} has no real value somewhere in its range",
                    "coefficients in the database's order, for λ in µm")
    return checked(text, Points("n", wavelength, n, np.full(n.shape, coefficients_line)))


def _references(text):
    """What stands after REFERENCES, as one line without tags; the user's own data where nothing does."""
    found, inside = [], False
    for line in text.lines:
        top = TOP.match(line)
        if top:
            inside = top[1] == "REFERENCES"
            line = top[2] or ""
        if inside:
            found.append(line.strip())
    plain = re.sub(r"<[^>]*>", "", " ".join(found)[:LONGEST_REFERENCE]).replace("|", " ")
    return " ".join(plain.split()).strip("'\"").strip() or LICENCE
