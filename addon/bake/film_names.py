"""What a bare word means as a layer of a stack: the datasets that films were held against, and constant indices.

A preset's name means its dataset for a mirror of its own; a film wants the
data of a film: anodic oxides, not crystals.
"""

import difflib
import re

import numpy as np

from ..errors import FacetFilmError
from ..spectra.observers import WAVELENGTH_NM
from ..spectra.optical_constants import OpticalConstants

__all__ = ["DATASETS", "film_lookup", "constant_index"]

DATASETS = {
    "TiO2": "main/TiO2/Jolivet-anatase", "Ti": "main/Ti/Palm",
    "Nb2O5": "main/Nb2O5/Lemarchand", "Nb": "main/Nb/Golovashkin-293K",
    "Ta2O5": "main/Ta2O5/Gao", "Ta": "main/Ta/Werner",
    "Fe3O4": "main/Fe3O4/Querry", "Fe2O3": "main/Fe2O3/Querry-o", "Fe": "main/Fe/Johnson",
    "steel": "main/Fe/Johnson", "stainless": "other/stainless_steel/Karlsson-austenitic",
    "SiO2": "main/SiO2/Malitson", "Si3N4": "main/Si3N4/Philipp", "Si": "main/Si/Schinke",
    "MgF2": "main/MgF2/Dodge-o", "Al2O3": "main/Al2O3/Boidin", "Al": "main/Al/McPeak", "ZrO2": "main/ZrO2/Wood",
    "HfO2": "main/HfO2/Al-Kuhaili", "ZnS": "main/ZnS/Amotchkina", "ITO": "other/In2O3-SnO2/Konig",
    "TiN": "main/TiN/Pfluger", "CaCO3": "main/CaCO3/Ghosh-o", "Cr": "main/Cr/Johnson",
    "Au": "main/Au/McPeak", "Ag": "main/Ag/McPeak", "Cu": "main/Cu/McPeak",
    "water": "main/H2O/Hale", "H2O": "main/H2O/Hale", "soap": "main/H2O/Hale",
    "glass": "popular_glass/BK7/SCHOTT", "BK7": "popular_glass/BK7/SCHOTT",
}
"""Word -> dataset: films.md's choice, by what published charts and colours it comes closest to."""

SMALL_LETTERS = {word.lower(): dataset for word, dataset in DATASETS.items()}
AIR = ("air", "vacuum")
TERM = re.compile(r"\s*([+-]?)\s*(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+)\s*(i|/\s*(?:λ|lambda|L)\s*\^?\s*([24²⁴]))?")


def film_lookup(lookup):
    """A look-up of layers: air, constant indices and DATASETS first, then what `lookup` knows.

    lookup  function of a word -> OpticalConstants, which raises FacetFilmError for what it does not know

    >>> from ..spectra.optical_constants import load
    >>> find = film_lookup(load)
    >>> find("SiO2").dataset, find("air").at(550.0)[0].item(), find("1.38+0.1i").at(550.0)[1].item()
    ('main/SiO2/Malitson', 1.0, 0.1)
    """
    def find(word):
        if word in AIR:
            return _constants("1", {0: 1.0}, 0.0)
        found = constant_index(word)
        return found if found is not None else _looked_up(word, lookup)
    return find


def _looked_up(word, lookup):
    try:
        return lookup(DATASETS.get(word) or SMALL_LETTERS.get(word.lower(), word))
    except FacetFilmError:
        near = difflib.get_close_matches(word.lower(), SMALL_LETTERS, 3, 0.7)
        if "/" in word or not near:
            raise
        names = {name.lower(): name for name in DATASETS}
        raise FacetFilmError("{word!r} is unknown; did you mean {near}? A layer is of a dataset, a preset's material "
                             "or an index such as 1.38.", word=word, near=tuple(names[name] for name in near)) from None


def constant_index(word):
    """OpticalConstants of an index that is written out, or None where the word is none.

    word  n, n+ki, or Cauchy's n = a + b/λ² + c/λ⁴ with λ in nm, k added in the
          same way: "1.5", "1.38+0.1i", "1.517+8800/λ²", "1.5+4200/L^2+0.01i"

    Raises FacetFilmError for an index that is not above 0, or k below 0.

    >>> constant_index("1.517+8800/λ²").at(500.0)[0].round(4).item()
    1.5522
    >>> constant_index("1.517+8800/L^2").dataset, constant_index("MgF2")
    ('1.517+8800/λ²', None)
    """
    powers, k, place = {}, 0.0, 0
    while place < len(word):
        term = TERM.match(word, place)
        if not term or (place and not term[1]):
            return None
        value = float(term[2]) * (-1.0 if term[1] == "-" else 1.0)
        if term[3] == "i":
            k += value
        else:
            power = {"2": 2, "²": 2, "4": 4, "⁴": 4}.get(term[4], 0)
            powers[power] = powers.get(power, 0.0) + value
        place = term.end() if word[term.end():].strip() else len(word)
    return _constants(_text_of(powers, k), powers, k) if powers else None


def _constants(text, powers, k):
    wavelength = WAVELENGTH_NM if set(powers) - {0} else WAVELENGTH_NM[[0, -1]]
    n = sum(value / wavelength**power for power, value in powers.items())
    if np.min(n) <= 0.0 or k < 0.0:
        raise FacetFilmError("The index {text} needs n above 0 and k of at least 0 from 360 to 780 nm.", text=text)
    return OpticalConstants(wavelength, n + 0.0 * wavelength, np.full(wavelength.size, k), text,
                            title=f"Index {text}", citation="given", has_k=k > 0.0)


def _text_of(powers, k):
    parts = [f"{powers.get(0, 0.0):g}", *(f"{powers[power]:+g}/λ{mark}" for power, mark in ((2, "²"), (4, "⁴"))
                                          if powers.get(power)), *([f"{k:+g}i"] if k else [])]
    return "".join(parts)
