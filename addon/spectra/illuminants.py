"""CIE illuminants: relative spectral power."""

import functools
import re

from ..errors import choice
from . import observers, tables
from .observers import WAVELENGTH_NM

__all__ = ["power", "names", "title", "canonical"]

TITLES = {
    "A": "incandescent lamp, 2856 K", "B": "direct sunlight at noon (superseded), 4874 K",
    "C": "average daylight (superseded), 6774 K", "D50": "daylight, 5000 K", "D55": "daylight, 5500 K",
    "D60": "daylight, 6000 K", "D65": "daylight, 6500 K", "D75": "north sky daylight, 7500 K",
    "E": "equal energy",
    "F1": "daylight fluorescent, 6430 K", "F2": "cool white fluorescent, 4230 K",
    "F3": "white fluorescent, 3450 K", "F4": "warm white fluorescent, 2940 K",
    "F5": "daylight fluorescent, 6350 K", "F6": "light white fluorescent, 4150 K",
    "F7": "broadband fluorescent, D65 simulator, 6500 K",
    "F8": "broadband fluorescent, D50 simulator, 5000 K",
    "F9": "broadband fluorescent, cool white deluxe, 4150 K", "F10": "three-band fluorescent, 5000 K",
    "F11": "three-band fluorescent, 4000 K", "F12": "three-band fluorescent, 3000 K",
    "F3.1": "halophosphate fluorescent, 2930 K", "F3.2": "halophosphate fluorescent, 3970 K",
    "F3.3": "halophosphate fluorescent, 6280 K", "F3.4": "deluxe fluorescent, 2900 K",
    "F3.5": "deluxe fluorescent, 4090 K", "F3.6": "deluxe fluorescent, 4890 K",
    "F3.7": "three-band fluorescent, 2980 K", "F3.8": "three-band fluorescent, 4010 K",
    "F3.9": "three-band fluorescent, 4850 K", "F3.10": "three-band fluorescent, 5000 K",
    "F3.11": "three-band fluorescent, 5850 K", "F3.12": "multi-band fluorescent, 2980 K",
    "F3.13": "multi-band fluorescent, 3900 K", "F3.14": "multi-band fluorescent, 5040 K",
    "F3.15": "fluorescent, D65 simulator, 6510 K",
    "HP1": "high pressure sodium lamp, 1960 K", "HP2": "colour enhanced high pressure sodium lamp, 2510 K",
    "HP3": "high pressure metal halide lamp, 3140 K", "HP4": "high pressure metal halide lamp, 4000 K",
    "HP5": "high pressure metal halide lamp, 4040 K",
    "LED-B1": "white LED, blue with phosphor, 2730 K", "LED-B2": "white LED, blue with phosphor, 3000 K",
    "LED-B3": "white LED, blue with phosphor, 4100 K", "LED-B4": "white LED, blue with phosphor, 5110 K",
    "LED-B5": "white LED, blue with phosphor, 6600 K",
    "LED-BH1": "white LED, blue with phosphor, and red, 2850 K",
    "LED-RGB1": "white LED, red, green and blue, 2840 K",
    "LED-V1": "white LED, violet with phosphor, 2720 K", "LED-V2": "white LED, violet with phosphor, 4070 K",
    "ID65": "indoor daylight, 6600 K", "ID50": "indoor daylight, 5100 K",
}
"""What each illuminant is, with its correlated colour temperature, in the order of the table.  CIE 015:2018."""

ALIASES = {
    "TL84": "F11", "TL83": "F12", "TL85": "F10", "U30": "F12", "UL30": "F12", "CWF": "F2", "COOL WHITE": "F2",
    "WW": "F4", "WWF": "F4", "WARM WHITE": "F4", "WHITE FLUORESCENT": "F3", "DLF": "F1", "TUNGSTEN": "A",
    "INCANDESCENT": "A", "INCA": "A", "DAYLIGHT": "D65", "EQUAL ENERGY": "E", "EE": "E", "2856K": "A",
    "5000K": "D50", "5500K": "D55", "6000K": "D60", "6500K": "D65", "7500K": "D75",
}
"""What lamps of light booths and daylight are called, in capitals."""


@functools.lru_cache(maxsize=1)
def names():
    """The illuminants: A to E, D50 to D75, fluorescent F…, high pressure HP…, LED-….

    >>> {"A", "D65", "F2", "F3.12", "HP1", "LED-B3", "E"} <= set(names())
    True
    """
    return tuple(TITLES)


def title(illuminant):
    """What an illuminant is, in words.

    >>> title("A")
    'incandescent lamp, 2856 K'
    """
    return TITLES[canonical(illuminant)]


def canonical(illuminant):
    """The illuminant's name as names() has it; "FL2" is "F2", "TL84" is "F11", small letters will do.

    Raises FacetFilmError for an unknown illuminant, with the nearest names.

    >>> canonical("fl2"), canonical("CWF"), canonical("CIE illuminant A")
    ('F2', 'F2', 'A')
    """
    name = re.sub(r"^((CIE|STANDARD|STD|ILLUMINANT|ILL)\.?[\s_-]+)+", "", str(illuminant).strip().upper())
    name = ALIASES.get(name.replace("_", " ").replace("-", " ").replace(" K", "K"), name)
    name = re.sub(r"^LED[\s_-]?(?=B|R|V)", "LED-", re.sub(r"^FL?\s?0?(?=\d)", "F", name))
    return choice("illuminant", name if name in names() else illuminant, names())


def power(illuminant="D65"):
    """Relative spectral power at 360 to 780 nm in 1 nm steps, ``(421,)``.

    Raises FacetFilmError for an unknown illuminant.

    >>> float(power("D65")[560 - 360])
    100.0
    """
    row = 3 * len(observers.names()) + names().index(canonical(illuminant))
    return tables.numbers("cie", row * WAVELENGTH_NM.size, WAVELENGTH_NM.size).astype(float)
