"""CIE colour matching functions."""

import json
import re

import numpy as np

from ..errors import choice
from . import tables

__all__ = ["canonical", "colour_matching_functions", "names", "WAVELENGTH_NM"]

WAVELENGTH_NM = np.arange(360.0, 781.0)
"""Where spectra are integrated: 360 to 780 nm in 1 nm steps, ``(421,)``."""


ALIASES = {"1931": "1931", "2": "1931", "1964": "1964", "10": "1964"}
"""Years and angles of view."""


def names():
    """The observers: "1931" of 2°, "1964" of 10°.

    >>> names()
    ('1931', '1964')
    """
    return tuple(json.loads(name) for name in tables.lines("cie", "observers"))


def canonical(observer):
    """The name that names() has for an observer: "2", "10°", "CIE 1964" are known.

    Raises FacetFilmError for any other.

    >>> canonical(2), canonical("10 deg"), canonical("CIE 1931 2°")
    ('1931', '1964', '1931')
    """
    plain = re.sub(r"[^0-9 ]", " ", str(observer)).split()
    found = {ALIASES.get(word, "") for word in plain}
    return choice("observer", found.pop() if len(found) == 1 and "" not in found else str(observer), names())


def colour_matching_functions(observer="1931"):
    """x̄, ȳ and z̄ at WAVELENGTH_NM, ``(421, 3)``.

    Raises FacetFilmError for an unknown observer.

    >>> colour_matching_functions("1931")[555 - 360].round(4).tolist()
    [0.5121, 1.0, 0.0057]
    """
    size = WAVELENGTH_NM.size
    place = names().index(choice("observer", str(observer), names())) * 3
    return tables.numbers("cie", place * size, 3 * size).reshape(3, size).T.astype(float)
