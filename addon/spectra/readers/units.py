"""Units of the axis of a spectrum: wavelength, photon energy, wavenumber, frequency; and which of them numbers can be.

One more unit is one more line in AXIS_UNITS.
"""

import dataclasses
from collections.abc import Callable

import numpy as np

from ..optical_constants import CORE_NM, VISIBLE_NM

__all__ = ["AXIS_UNITS", "UNIT_OF", "EV_NM", "in_nm", "fitting", "decided"]

EV_NM = 1239.841984
"""Planck's constant times the speed of light, eV nm (CODATA 2018)."""
LIGHT_NM_THZ = 299792.458
"""The speed of light, nm THz."""


@dataclasses.dataclass(frozen=True)
class AxisUnit:
    """A unit of the axis.

    kind       "wavelength", "energy", "wavenumber" or "frequency"
    to_nm      nm of numbers in it
    spellings  as people write it, after compatibility normalisation, in small letters
    unnamed    whether numbers without any unit may be in it
    """

    kind: str
    to_nm: Callable
    spellings: tuple
    unnamed: bool = False

    @property
    def falls(self):
        """Whether the wavelength falls where its numbers rise."""
        return self.kind != "wavelength"


AXIS_UNITS = {
    "nm": AxisUnit("wavelength", lambda w: w, (
        "nm", "nanometer", "nanometers", "nanometre", "nanometres", "nanomètre", "nanomètres", "nanómetros", "нм",
        "纳米", "ナノメートル"), True),
    "µm": AxisUnit("wavelength", lambda w: np.round(w * 1e3, 9), (
        "μm", "um", "mkm", "âμm", "âµm", "micron", "microns", "mum", "micrometer", "micrometers", "micrometre",
        "micrometres", "mikrometer", "мкм", "微米", "\\mum", "$\\mu$m"), True),
    "Å": AxisUnit("wavelength", lambda w: np.round(w * 0.1, 9), (
        "å", "a", "ang", "angs", "angstrom", "angstroms", "ångström", "ångstrom", "angström", "埃"), True),
    "m": AxisUnit("wavelength", lambda w: np.round(w * 1e9, 9), ("m", "meter", "metre", "meters", "metres"), True),
    "mm": AxisUnit("wavelength", lambda w: np.round(w * 1e6, 9), ("mm", "millimeter", "millimetre")),
    "eV": AxisUnit("energy", lambda e: EV_NM / e, (
        "ev", "electronvolt", "electronvolts", "electron volt", "эв", "电子伏特"), True),
    "meV": AxisUnit("energy", lambda e: 1e3 * EV_NM / e, ("mev",)),
    "J": AxisUnit("energy", lambda e: EV_NM * 1.602176634e-19 / e, ("j", "joule", "joules")),
    "1/cm": AxisUnit("wavenumber", lambda v: 1e7 / v, (
        "1/cm", "cm-1", "cm^-1", "cm^{-1}", "/cm", "cm⁻¹", "cm−1", "cm^(-1)", "см-1", "см^-1", "kayser"), True),
    "1/µm": AxisUnit("wavenumber", lambda v: 1e3 / v, ("1/μm", "μm-1", "um-1", "1/um", "μm^-1")),
    "1/m": AxisUnit("wavenumber", lambda v: 1e9 / v, ("1/m", "m-1", "m^-1")),
    "THz": AxisUnit("frequency", lambda f: LIGHT_NM_THZ / f, ("thz", "terahertz", "тгц")),
    "PHz": AxisUnit("frequency", lambda f: LIGHT_NM_THZ / (1e3 * f), ("phz",)),
    "GHz": AxisUnit("frequency", lambda f: 1e3 * LIGHT_NM_THZ / f, ("ghz",)),
    "Hz": AxisUnit("frequency", lambda f: 1e12 * LIGHT_NM_THZ / f, ("hz", "hertz", "1/s", "s-1", "гц"), True),
    "rad/s": AxisUnit("frequency", lambda w: 2e12 * np.pi * LIGHT_NM_THZ / w, ("rad/s", "rad s-1")),
}
"""The units of the axis by the name that messages use."""

UNIT_OF = {spelling: name for name, unit in AXIS_UNITS.items() for spelling in unit.spellings}
KINDS = {"wavelength": ("nm", "µm", "Å", "m"), "energy": ("eV", "meV", "J"), "wavenumber": ("1/cm", "1/m", "1/µm"),
         "frequency": ("THz", "Hz", "PHz", "GHz"), "": tuple(name for name, unit in AXIS_UNITS.items() if unit.unnamed)}
"""In which units an axis can be whose heading names its kind and no unit; "" where there is no heading."""

NEEDS_NO_POINTS_INSIDE = {"nm", "µm", "Å"}
LEAST_INSIDE = 3
"""Points in the visible that a unit rarer than those needs where nothing names it."""
MORE_POINTS = 4.0
"""So many times the points in the visible speak for one length in place of another."""
WINS_BY = 2.0
METAL_K, DIELECTRIC_K = 2.0, 0.05


def in_nm(values, unit):
    """Wavelengths in nm, without the digits that binary fractions add where the unit is another length.

    values  ``(W,)``
    unit    a name of AXIS_UNITS

    >>> in_nm([0.5876], "µm").tolist(), in_nm([2.0], "eV").round(3).tolist()
    ([587.6], [619.921])
    """
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        return AXIS_UNITS[unit].to_nm(np.asarray(values, float))


def fitting(values, kind=""):
    """The units of a kind in which some of these numbers are visible, in the table's order.

    >>> fitting(np.linspace(0.64, 6.6, 50))
    ('µm', 'eV')
    """
    found = []
    for unit in KINDS[kind]:
        nm = in_nm(values, unit)
        nm = nm[np.isfinite(nm)]
        if nm.size and nm.min() <= VISIBLE_NM[1] and nm.max() >= VISIBLE_NM[0]:
            inside = np.count_nonzero((nm >= VISIBLE_NM[0]) & (nm <= VISIBLE_NM[1]))
            if unit in NEEDS_NO_POINTS_INSIDE or kind or inside >= LEAST_INSIDE:
                found.append(unit)
    return tuple(found)


def decided(values, units, n=None, k=None):
    """(the unit that all of the file speaks for, why) of some that fit, or (None, "") where none does clearly.

    values  of the axis, ``(W,)``, in the file's order
    units   names of AXIS_UNITS
    n, k    ``(W,)``, where the table has them: physics tells energies from lengths

    What speaks: the whole visible is covered; numbers fall, as energies of a table by wavelength do; in
    metals k grows towards the red, in what is clear n falls towards it; among lengths, far more points
    in the visible.
    """
    votes = {unit: [] for unit in units}
    nm = {unit: in_nm(values, unit) for unit in units}
    for unit in units:
        if nm[unit].min() <= CORE_NM[0] and nm[unit].max() >= CORE_NM[1]:
            votes[unit].append((1.0, "the whole visible is covered"))
        if AXIS_UNITS[unit].falls and values[0] > values[-1]:
            votes[unit].append((1.0, "the numbers fall"))
        speaks = _physics(nm[unit], n, k)
        if speaks:
            votes[unit].append((3.0, speaks))
    lengths = [unit for unit in units if AXIS_UNITS[unit].kind == "wavelength"]
    inside = {unit: np.count_nonzero((nm[unit] >= VISIBLE_NM[0]) & (nm[unit] <= VISIBLE_NM[1])) for unit in lengths}
    for unit in lengths:
        others = [inside[other] for other in lengths if other != unit]
        if others and inside[unit] >= MORE_POINTS * max(1, *others):
            votes[unit].append((3.0, "most points lie in the visible"))
    total = {unit: sum(weight for weight, _ in found) for unit, found in votes.items()}
    best, *rest = sorted(units, key=lambda unit: -total[unit])
    if rest and total[best] - total[rest[0]] < WINS_BY:
        return None, ""
    return best, ", ".join(reason for _, reason in votes[best])


def _physics(nm, n, k):
    """Why values are as they have to be over these wavelengths, or ""."""
    if n is None or n.size < 4:
        return ""
    order = np.argsort(nm)
    n = n[order]
    k = np.zeros_like(n) if k is None else np.abs(k[order])
    if not (np.isfinite(n).all() and np.isfinite(k).all()):
        return ""
    if k[-1] > METAL_K and k[-1] > 2.0 * k[0]:
        return "k grows towards the red"
    step = np.diff(n)
    if k.max() < DIELECTRIC_K and np.count_nonzero(step) and np.mean(step[step != 0.0] < 0.0) >= 0.9:
        return "n falls towards the red"
    return ""
