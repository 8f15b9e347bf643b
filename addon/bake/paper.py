"""The ways to a colour over angle, and how far each is from the exact one.

Cook and Torrance had two short cuts in 1982: the normal reflectance spectrum
alone, and a colour shift interpolated in RGB.  Beside them stand three that
are common since: Schlick's curve, and n and k or the normal reflectance taken
at three wavelengths.
"""

import dataclasses

import numpy as np

from ..catalogue.resolving import require_measured
from ..reflectance import fresnel
from ..spectra import observers
from .colour import delta_e_2000, lab
from .reflected import Viewing, mirror_spectra

__all__ = ["Way", "Ways", "ways", "DEGREES", "SAMPLED_NM"]

DEGREES = np.arange(0.0, 90.0)
SAMPLED_NM = (650.0, 550.0, 450.0)
"""The wavelengths of those who take one for red, one for green and one for blue."""


@dataclasses.dataclass(frozen=True)
class Way:
    """A way to a colour, and how far it is from the exact colours.

    rgb                linear RGB at 0 to 89° in steps of 1°, ``(90, 3)``, before gamut mapping
    delta_e_2000_max   largest CIEDE2000 from exact
    at_degrees         the angle where it is that far off
    """

    name: str
    title: str
    rgb: tuple
    delta_e_2000_max: float
    at_degrees: float


@dataclasses.dataclass(frozen=True)
class Ways:
    """All ways to the colour of one material; the first is the exact one."""

    name: str
    title: str
    dataset: str
    illuminant: str
    observer: str
    space: str
    ways: tuple

    def to_dict(self):
        """The same as dicts and lists, ready for JSON."""
        return dataclasses.asdict(self)


def ways(preset, *, illuminant="D65", observer="1931", space="Rec.709", adapt=False):
    """The Ways to the colour of a material over angle.

    preset and the others as for :func:`addon.bake.bake`.

    exact                spectrum of n and k, exact Fresnel at every wavelength
    normal_reflectance   the paper's: k = 0 and an effective n from the normal
                         reflectance, at every wavelength
    colour_shift         the paper's cheap one: in RGB, between the colours at
                         0 and 90° as F of the average normal reflectance goes
    schlick              Schlick's curve from the colour at 0°
    three_wavelengths    n and k at 650, 550 and 450 nm taken for red, green, blue

    Cook and Torrance 1982, section "Spectral composition of the reflected light".

    >>> {way.name: round(way.delta_e_2000_max, 1) for way in ways("copper").ways}["exact"]
    0.0
    """
    viewing = Viewing(illuminant, observer, space, adapt)
    record, constants = require_measured(preset)
    n, k = constants.at(observers.WAVELENGTH_NM)
    cos_theta = np.cos(np.radians(DEGREES))
    c = cos_theta[:, None]
    exact = mirror_spectra(cos_theta, n, k) @ viewing.weights
    average = float(fresnel.conductor(1.0, n, k).mean())
    n_3, k_3 = constants.at(SAMPLED_NM)
    found = [
        ("exact", "exact, n and k at every wavelength", exact),
        ("normal_reflectance", "normal reflectance at every wavelength, k = 0 (1982)",
         mirror_spectra(cos_theta, n, k, True) @ viewing.weights),
        ("colour_shift", "cheap colour shift in RGB (1982)",
         fresnel.cheap_colour_shift(c, exact[0], viewing.weights.sum(axis=0), average)),
        ("schlick", "Schlick's curve in RGB (1994)", fresnel.schlick(c, exact[0])),
        ("three_wavelengths", "n and k at 650, 550 and 450 nm only", fresnel.conductor(c, n_3, k_3)),
    ]
    return Ways(record.name, record.title, constants.dataset, viewing.illuminant, viewing.observer, space,
                tuple(_way(name, title, rgb, exact, space) for name, title, rgb in found))


def _way(name, title, rgb, exact, space):
    difference = delta_e_2000(lab(exact, space), lab(rgb, space))
    worst = int(difference.argmax())
    return Way(name, title, tuple(map(tuple, rgb.tolist())), float(difference[worst]), float(DEGREES[worst]))
