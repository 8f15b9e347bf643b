"""CIE colour matching functions."""

import numpy as np

from ..errors import choice
from . import tables

__all__ = ["colour_matching_functions", "names", "WAVELENGTH_NM"]

WAVELENGTH_NM = np.arange(360.0, 781.0)
"""Where spectra are integrated: 360 to 780 nm in 1 nm steps, ``(421,)``."""


def names():
    """The observers: "1931" of 2°, "1964" of 10°.

    >>> names()
    ('1931', '1964')
    """
    return tuple(tables.read("cie")[1]["observers"])


def colour_matching_functions(observer="1931"):
    """x̄, ȳ and z̄ at WAVELENGTH_NM, ``(421, 3)``.

    Raises FacetFilmError for an unknown observer.

    >>> colour_matching_functions("1931")[555 - 360].round(4).tolist()
    [0.5121, 1.0, 0.0057]
    """
    _, index, values = tables.read("cie")
    place = index["observers"].index(choice("observer", str(observer), names())) * 3
    return values.reshape(-1, WAVELENGTH_NM.size)[place:place + 3].T.astype(float)
