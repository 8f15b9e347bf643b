"""CIE illuminants: relative spectral power."""

import re

from ..errors import choice
from . import tables
from .observers import WAVELENGTH_NM

__all__ = ["power", "names", "canonical"]


def names():
    """The illuminants: A to E, D50 to D75, fluorescent F…, high pressure HP…, LED-….

    >>> {"A", "D65", "F2", "F3.12", "HP1", "LED-B3", "E"} <= set(names())
    True
    """
    return tuple(tables.read("cie")[1]["illuminants"])


def canonical(illuminant):
    """The illuminant's name as names() has it; CIE's newer "FL2" is "F2", small letters will do.

    Raises FacetFilmError for an unknown illuminant, with the nearest names.

    >>> canonical("fl2")
    'F2'
    """
    name = re.sub(r"^FL(?=\d)", "F", str(illuminant).strip().upper())
    return choice("illuminant", name if name in names() else illuminant, names())


def power(illuminant="D65"):
    """Relative spectral power at 360 to 780 nm in 1 nm steps, ``(421,)``.

    Raises FacetFilmError for an unknown illuminant.

    >>> float(power("D65")[560 - 360])
    100.0
    """
    _, index, values = tables.read("cie")
    row = 3 * len(index["observers"]) + index["illuminants"].index(canonical(illuminant))
    return values.reshape(-1, WAVELENGTH_NM.size)[row].astype(float)
