"""Ansys Zemax: glass catalogues .agf with their thirteen dispersion formulas, and coating files with materials.

In a catalogue NM names a glass and the number of its formula, CD has the
coefficients for λ in µm, LD the range, IT internal transmittances.  One more
formula is one more line in FORMULAS.
"""

import dataclasses
import re

import numpy as np

from ..optical_constants import VISIBLE_NM, sampled_wavelengths
from .points import Points, checked, constants
from .text import NUMBER, number_of
from .units import in_nm

__all__ = ["is_glass_catalogue", "read_glass_catalogue", "is_coating", "read_coating", "FORMULAS"]


def _powers(w, c, exponents):
    return sum(a * w**e for a, e in zip(c, exponents))


def _sellmeier(w, c, pairs):
    return 1.0 + sum(c[2 * i] * w**2 / (w**2 - c[2 * i + 1]) for i in range(pairs))


def _herzberger(w, c):
    pole = 1.0 / (w**2 - 0.028)
    return (c[0] + c[1] * pole + c[2] * pole**2 + c[3] * w**2 + c[4] * w**4 + c[5] * w**6) ** 2


FORMULAS = {
    1: ("Schott", 6, lambda w, c: _powers(w, c, (0, 2, -2, -4, -6, -8))),
    2: ("Sellmeier 1", 6, lambda w, c: _sellmeier(w, c, 3)),
    3: ("Herzberger", 6, _herzberger),
    4: ("Sellmeier 2", 5, lambda w, c: 1.0 + c[0] + c[1] * w**2 / (w**2 - c[2] ** 2) + c[3] / (w**2 - c[4] ** 2)),
    5: ("Conrady", 3, lambda w, c: (c[0] + c[1] / w + c[2] / w**3.5) ** 2),
    6: ("Sellmeier 3", 8, lambda w, c: _sellmeier(w, c, 4)),
    7: ("Handbook of Optics 1", 4, lambda w, c: c[0] + c[1] / (w**2 - c[2]) - c[3] * w**2),
    8: ("Handbook of Optics 2", 4, lambda w, c: c[0] + c[1] * w**2 / (w**2 - c[2]) - c[3] * w**2),
    9: ("Sellmeier 4", 5, lambda w, c: c[0] + c[1] * w**2 / (w**2 - c[2]) + c[3] * w**2 / (w**2 - c[4])),
    10: ("Extended", 8, lambda w, c: _powers(w, c, (0, 2, -2, -4, -6, -8, -10, -12))),
    11: ("Sellmeier 5", 10, lambda w, c: _sellmeier(w, c, 5)),
    12: ("Extended 2", 8, lambda w, c: _powers(w, c, (0, 2, -2, -4, -6, -8, 4, 6))),
    13: ("Extended 3", 9, lambda w, c: _powers(w, c, (0, 2, 4, -2, -4, -6, -8, -10, -12))),
}
"""n² over λ in µm: (name, how many coefficients, formula), by the number in the catalogue.

Zemax OpticStudio's manual, "Using glass catalogs".
"""
LEAST_TRANSMITTANCE = 1e-12
CATALOGUE_LINE = re.compile(r"(CC|NM|GC|ED|CD|TD|OD|LD|IT|MD|BD)(\s|$)")
MATERIAL = re.compile(r"\s*MATE\s+(\S+)\s*(.*)", re.IGNORECASE)
SECTIONS = re.compile(r"\s*(MATE|COAT|IDEAL2?|TABLE|TAPR|ENCRYPTED|COATINGFILE|DATA)\b", re.IGNORECASE)


def is_glass_catalogue(text):
    """Whether a line names a glass as a catalogue does, and another has its coefficients."""
    starts = {line[:3] for line in text.lines if CATALOGUE_LINE.match(line)}
    return "NM " in starts and "CD " in starts


def read_glass_catalogue(text):
    """The OpticalConstants of the only glass in a catalogue, or of the chosen one.

    Raises Ambiguous, which names the glasses, where none is chosen.

    >>> from .text import Text
    >>> agf = "NM A 5 0 1.5 60 0\\nCD 1.5 0 0\\nLD 0.3 2\\nNM B 5 0 1.6 60 0\\nCD 1.6 0 0\\nLD 0.3 2"
    >>> read_glass_catalogue(Text("x.agf", agf, choose="B")).at(500.0)[0].tolist()
    1.6
    """
    glasses = _glasses(text)
    names = list(glasses)
    name = (
        names[0] if len(names) == 1 else text.ask(None, "is a catalogue of glasses:", names, "one of them by its name")
    )
    if len(names) > 1:
        text.assume(f"of {len(names)} glasses: {name}")
    return _glass(text, name, glasses[name])


def _glasses(text):
    """{name: {code: [(line, words) …]}}"""
    glasses, entry = {}, None
    for number, line in enumerate(text.lines, 1):
        if not CATALOGUE_LINE.match(line):
            continue
        words = line.split()
        if words[0] == "NM":
            name = words[1] if len(words) > 1 else f"line {number}"
            if name in glasses:
                name = f"{name} (line {number})"
            entry = glasses[name] = {}
        if entry is not None:
            entry.setdefault(words[0], []).append((number, words[1:]))
    return glasses


def _glass(text, name, entry):
    line, words = entry["NM"][0]
    number = number_of(text, line, words[1] if len(words) > 1 else "", "the number of the formula")
    if number not in FORMULAS:
        text.refuse(line, f"the dispersion formula is number {number:g}", "1 to 13")
    title, count, formula = FORMULAS[int(number)]
    if "CD" not in entry:
        text.refuse(line, f"the glass {name} has no coefficients", "a line CD")
    at, found = entry["CD"][0]
    coefficients = [number_of(text, at, word, "a coefficient") for word in found[:count]]
    coefficients += [0.0] * (count - len(coefficients))
    low, high = _range(text, entry, line)
    wavelength = sampled_wavelengths(low, high)
    with np.errstate(all="ignore"):
        n = np.sqrt(formula(wavelength / 1000.0, coefficients) + np.zeros(wavelength.shape))
    if not np.isfinite(n).all():
        text.refuse(at, f"the formula {title} has no real value somewhere in its range", "coefficients for λ in µm")
    points = [checked(text, Points("n", wavelength, n, np.full(n.shape, at)))]
    points += _absorption(text, entry)
    found = constants(text, points, database=True)
    return dataclasses.replace(found, title=name)


def _range(text, entry, line):
    """The range in nm; the visible where none is given."""
    if "LD" not in entry:
        text.assume("no range is given: the formula taken as good for all of the visible")
        return VISIBLE_NM
    at, words = entry["LD"][0]
    ends = [1000.0 * number_of(text, at, word, "the range") for word in words[:2]]
    if len(ends) < 2 or not 0.0 < ends[0] < ends[1]:
        text.refuse(at, "the range is not two wavelengths", "the lower and the higher in µm")
    if ends[0] >= VISIBLE_NM[1] or ends[1] <= VISIBLE_NM[0]:
        text.refuse(at, f"the formula holds from {ends[0]:g} to {ends[1]:g} nm", "some of the visible, 400 to 700 nm")
    return ends


def _absorption(text, entry):
    """Points of k from internal transmittances: τ = exp(−4πkd/λ); [] where fewer than two are given."""
    rows, lines = [], []
    for at, words in entry.get("IT", ()):
        if len(words) >= 3 and all(NUMBER.fullmatch(word) for word in words[:3]):
            w, t, mm = map(float, words[:3])
            if w > 0.0 and 0.0 < t <= 1.0 and mm > 0.0:
                rows.append((1000.0 * w, -np.log(max(t, LEAST_TRANSMITTANCE)) * w / (4.0 * np.pi * 1000.0 * mm)))
                lines.append(at)
    table = np.array(rows).reshape(-1, 2)
    inside = (table[:, 0] > VISIBLE_NM[0]) & (table[:, 0] < VISIBLE_NM[1])
    if (
        np.count_nonzero(inside) < 2
        or table[:, 0].min() > 400.0
        or table[:, 0].max() < 700.0
        or len(set(table[:, 0])) < len(table)
    ):
        return []
    text.assume("k from the internal transmittances")
    return [checked(text, Points("k", table[:, 0], table[:, 1], np.array(lines)))]


def is_coating(text):
    """Whether a line names a material as a coating file of Zemax does, and the lines below it are numbers."""
    return any(
        MATERIAL.match(line)
        and any(NUMBER.fullmatch(word) for word in " ".join(text.lines[at + 1 : at + 4]).split()[:3])
        for at, line in enumerate(text.lines)
        if line[:1] in "Mm \t"
    )


def read_coating(text):
    """The OpticalConstants of the only material in a coating file, or of the chosen one: λ in µm, n and k.

    Raises Ambiguous, which names the materials, where none is chosen.

    >>> from .text import Text
    >>> read_coating(Text("c.dat", "MATE AG\\n0.4 0.1 -2\\n0.7 0.1 -4\\n")).k.tolist()
    [2.0, 4.0]
    """
    materials, rows = {}, None
    for number, line in enumerate(text.lines, 1):
        line = line.split("!", 1)[0]
        named = MATERIAL.match(line)
        if named:
            rows = materials.setdefault(named[1], [])
        elif SECTIONS.match(line):
            rows = None
        elif rows is not None and line.strip():
            rows.append((number, line.replace(",", " ").split()))
    names = [name for name, rows in materials.items() if rows]
    name = names[0] if len(names) == 1 else text.ask(None, "holds the materials", names, "one of them by its name")
    if len(names) > 1:
        text.assume(f"of {len(names)} materials: {name}")
    lines = np.array([number for number, _ in materials[name]])
    values = []
    for number, words in materials[name]:
        if len(words) < 2:
            text.refuse(number, "has 1 number", "wavelength in µm, n and k")
        values.append([number_of(text, number, word, "a number") for word in (words + ["0"])[:3]])
    table = np.array(values)
    k = table[:, 2]
    if k.max() <= 0.0 and k.min() < 0.0:
        text.assume("k is below 0 throughout: read as n − ik, as Zemax has it")
        k = -k
    wavelength = in_nm(table[:, 0], "µm")
    found = constants(
        text,
        [checked(text, Points(role, wavelength, column, lines)) for role, column in (("n", table[:, 1]), ("k", k))],
    )
    return dataclasses.replace(found, title=name)
