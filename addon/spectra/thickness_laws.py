"""How thick a film is, as people have it: volts, temperature and time, height in a soap film.

Every law is a function over :mod:`addon.operands`: numbers and arrays give
nm, node operands build the nodes that do.  Each names the stack that it was
held against, as nm per volt belong to the dataset chosen, and whether it is
estimated: fitted here to published colours, not measured.
"""

import dataclasses

from ..errors import number
from ..operands import clip, exp, maximum, sqrt

__all__ = ["Anodising", "HeatTint", "ANODISING", "HEAT_TINTS", "drained", "KELVIN"]

KELVIN = 273.15


@dataclasses.dataclass(frozen=True)
class Anodising:
    """The oxide that a voltage grows on a metal: d = d₀ + r U.

    stack       in the notation, with the thickness to put in as {}
    nm_per_volt r
    native_nm   d₀, of the oxide that air grows
    volts       (low, high) that the law is for
    source      where r is from
    estimated   whether it was fitted to colours or is a textbook's round number
    """

    stack: str
    nm_per_volt: float
    native_nm: float
    volts: tuple
    source: str
    estimated: bool

    def thickness(self, volts):
        """nm at U volts, any shape; held to the law's range.

        >>> round(float(ANODISING["titanium"].thickness(60.0)), 1)
        121.5
        """
        return self.native_nm + self.nm_per_volt * clip(volts, *self.volts)

    def checked(self, volts):
        """nm at one number of volts, which has to be in the law's range; else FacetFilmError.

        >>> ANODISING["titanium"].checked(500)
        Traceback (most recent call last):
        ...
        addon.errors.FacetFilmError: voltage must be a number from 0 to 120 V, not 500.
        """
        return float(self.thickness(number("voltage", volts, *self.volts, unit="V")))


ANODISING = {
    "titanium": Anodising(
        "TiO2 {} nm / Ti", 2.0, 1.5, (0.0, 120.0),
        "hobby charts of colour over volts, which 2.0 nm/V of Jolivet's anatase on Palm's titanium follow best; "
        "Ohtsuka, Masuda and Sato 1985 have 2.4 to 2.8 nm/V by ellipsometry below 7.5 V", True),
    "niobium": Anodising(
        "Nb2O5 {} nm / Nb", 3.6, 1.5, (0.0, 110.0), "3.6 ± 0.2 nm/V; older tables have 2.2 to 2.8", False),
    "tantalum": Anodising(
        "Ta2O5 {} nm / Ta", 1.7, 2.0, (0.0, 200.0),
        "the capacitor makers' 1.7 nm/V; Young, Anodic Oxide Films (1961), 1.6 to 1.8", True),
    "aluminium": Anodising(
        "Al2O3 {} nm / Al", 1.32, 2.5, (0.0, 500.0),
        "1.32 nm/V of barrier films in borate; porous anodising, which takes dyes, grows with time", False),
}
"""Metal -> its law."""


@dataclasses.dataclass(frozen=True)
class HeatTint:
    """The oxide that heat grows in air, parabolic in time: d = exp(a − b/T) √(t/t₀), T in kelvin.

    stack      in the notation, with the thickness to put in as {}
    a, b       b in kelvin: half the activation energy over the gas constant
    minutes    t₀
    celsius    (low, high) that the law is for
    colours    ((°C, what charts call the colour after t₀, nm), …)
    source     where those are from
    """

    stack: str
    a: float
    b: float
    minutes: float
    celsius: tuple
    colours: tuple
    source: str
    estimated: bool = True

    def thickness(self, celsius, minutes=None):
        """nm after some minutes at a temperature in °C, any shapes; t₀ where none are given.

        >>> steel = HEAT_TINTS["carbon steel"]
        >>> round(float(steel.thickness(282.0)), 1), round(float(steel.thickness(282.0, 4 * steel.minutes)), 1)
        (43.3, 86.6)
        """
        grown = exp(self.a - self.b / (clip(celsius, *self.celsius) + KELVIN))
        return grown if minutes is None else grown * sqrt(maximum(minutes, 0.0) * (1.0 / self.minutes))

    def checked(self, celsius, minutes=None):
        """The same of one temperature, which has to be in the law's range; else FacetFilmError.

        >>> HEAT_TINTS["carbon steel"].checked(900)
        Traceback (most recent call last):
        ...
        addon.errors.FacetFilmError: temperature must be a number from 20 to 380 °C, not 900.
        """
        celsius = number("temperature", celsius, *self.celsius, unit="°C")
        return float(self.thickness(celsius, None if minutes is None else number("time", minutes, 0.0, unit="minutes")))


HEAT_TINTS = {
    "carbon steel": HeatTint(
        "Fe3O4 {} nm / Fe", 8.455, 2602.0, 60.0, (20.0, 380.0),
        ((205.0, "straw", 21.0), (226.0, "dark straw", 28.0), (260.0, "brown", 34.0), (282.0, "purple", 39.5),
         (310.0, "dark blue", 48.0), (337.0, "light blue", 66.0)),
        "tempering colours as toolmakers' tables have them; magnetite of the hue that each names"),
    "stainless steel": HeatTint(
        "2.5+0.3i {} nm / stainless", 7.73, 2934.0, 60.0, (20.0, 560.0),
        ((290.0, "pale yellow", 12.0), (340.0, "straw yellow", 18.0), (370.0, "dark yellow", 23.0),
         (390.0, "brown", 29.0), (420.0, "purple brown", 34.0), (450.0, "dark purple", 39.0), (540.0, "blue", 55.0)),
        "British Stainless Steel Association, heat tint colours of 1.4301 (304) after an hour in air; no chromium "
        "oxide is measured in the visible, so the film is 2.5 + 0.3i, and its thickness what has the hue that each "
        "names; their dark blue at 600 °C comes back from where this law grows lighter and is beyond it"),
    "titanium": HeatTint(
        "TiO2 {} nm / Ti", 7.157, 2806.0, 30.0, (20.0, 550.0),
        ((300.0, "light yellow", 10.0), (400.0, "golden yellow", 18.0), (500.0, "blue", 36.0)),
        "makers' charts of titanium after half an hour in air; violet of the second order, theirs at 600 °C, grows "
        "faster than this law and is beyond it"),
}
"""Metal -> its law."""


def drained(height, top, bottom):
    """nm at a height in a vertical soap film that drains: d² falls evenly from bottom to top.

    height       0 at the bottom, 1 at the top; held to that
    top, bottom  nm at the ends, top ≤ bottom

    Between surfaces that do not move ρ g d³/12η flows down, and ∂d/∂t + ∂q/∂z
    = 0 has d = √(4 η z/ρ g t), z from the top: K. J. Mysels, K. Shinoda and
    S. Frankel, Soap Films, 1959.  A real one drains faster, in much the same
    shape; the time is in the two ends here.

    >>> [round(float(drained(height, 0.0, 800.0))) for height in (0.0, 0.75, 1.0)]
    [800, 400, 0]
    """
    from_top = 1.0 - clip(height, 0.0, 1.0)
    return sqrt(top * top + (bottom * bottom - top * top) * from_top)
