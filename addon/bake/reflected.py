"""The colour of a measured material's mirror at every angle."""

import dataclasses
import numbers
from typing import NamedTuple

import numpy as np

from ..catalogue.presets import Preset
from ..catalogue.resolving import require_measured
from ..errors import FacetFilmError, choice
from ..reflectance import fresnel
from ..spectra import illuminants, observers, optical_constants
from .colour import canonical_space, spectral_weights
from .gamut import DEFAULT, METHODS, GamutReport, map_colours

__all__ = [
    "Viewing", "Reflected", "reflect", "mirror_spectra", "index_of_medium", "COS_THETA", "ANGLES", "AT_NORMAL", "AT_82",
    "COMPARED",
]

COS_THETA = np.concatenate([
    np.arange(0, 24), np.arange(24, 48, 2), np.arange(48, 96, 4), np.arange(96, 255, 8), [255]]) / 255.0
"""Where a curve may have its points, grazing to normal: dense near grazing, where Fresnel
curves bend most, and where the renderer's table of 256 entries has its own."""
ANGLES = np.concatenate([COS_THETA, [fresnel.COS_THETA_82, np.cos(np.radians(89.0))]])
"""cos θ of every angle at which colours are calculated, ``(A,)``: those of COS_THETA, 82° and 89°."""
AT_NORMAL, AT_82 = len(COS_THETA) - 1, len(COS_THETA)
LEAST_MEDIUM, LARGEST_MEDIUM = 1.0, 4.0
LARGEST_K_OF_A_MEDIUM = 1e-4
"""Extinction in the visible up to which light reaches a surface through a drop of what is outside."""
COMPARED = np.flatnonzero(ANGLES >= np.cos(np.radians(89.0)) - 1e-12)
"""Which of them count for colour differences: 0 to 89°."""


@dataclasses.dataclass(frozen=True)
class Viewing:
    """In which light a colour is seen, by whom, through what, and in which numbers it is written.

    illuminant  a CIE illuminant, or what people call it: "TL84", "CWF"
    observer    "1931" (2°) or "1964" (10°); "2" and "10" are these
    space       scene-linear space: "Rec.709", "Rec.2020" or "ACEScg", however spelt; neutral is
                a perfect reflector in D65 in each, as in Blender
    adapt       whether the eye is adapted to the illuminant, so that a perfect
                reflector is neutral in any light
    gamut       what to do with colours outside [0, 1]: "nearest", "desaturate", "scale", "clip", "leave"
    medium      what the surface is in: its index, or a clear material; 1 is air

    Raises FacetFilmError for anything unknown, with the nearest names.

    >>> Viewing("fl2").illuminant, Viewing(observer=10, space="sRGB").space
    ('F2', 'Rec.709')
    """

    illuminant: str = "D65"
    observer: str = "1931"
    space: str = "Rec.709"
    adapt: bool = False
    gamut: str = DEFAULT
    medium: object = 1.0

    def __post_init__(self):
        object.__setattr__(self, "illuminant", illuminants.canonical(self.illuminant))
        object.__setattr__(self, "observer", observers.canonical(self.observer))
        object.__setattr__(self, "space", canonical_space(self.space))
        choice("gamut", self.gamut, METHODS)
        object.__setattr__(self, "adapt", bool(self.adapt))
        object.__setattr__(self, "medium", _medium(self.medium))

    @property
    def weights(self):
        """What each nm of a reflectance adds to linear RGB, ``(421, 3)``."""
        return spectral_weights(self.illuminant, self.observer, self.space, self.adapt)

    def map(self, rgb):
        """(colours brought into the gamut, GamutReport)."""
        return map_colours(rgb, self.gamut, self.space)


class Reflected(NamedTuple):
    """A material's mirror: its spectrum of n and k, and its colours at ANGLES.

    preset     the addon.catalogue.presets.Preset
    constants  the OpticalConstants
    viewing    the Viewing
    n, k       at 360 to 780 nm, ``(421,)`` each, relative to the medium outside
    from_normal_reflectance  whether by the normal reflectance alone
    colours    linear RGB before gamut mapping, ``(A, 3)``
    mapped     linear RGB after it, ``(A, 3)``
    gamut      the GamutReport
    """

    preset: Preset
    constants: optical_constants.OpticalConstants
    viewing: Viewing
    n: np.ndarray
    k: np.ndarray
    from_normal_reflectance: bool
    colours: np.ndarray
    mapped: np.ndarray
    gamut: GamutReport

    def mapped_at(self, cos_theta):
        """Linear RGB after gamut mapping at other cos θ, ``(A,)`` to ``(A, 3)``."""
        spectra = mirror_spectra(cos_theta, self.n, self.k, self.from_normal_reflectance)
        return self.viewing.map(spectra @ self.viewing.weights)[0]


def reflect(what, viewing=None, from_normal_reflectance=False):
    """The Reflected of whatever :func:`addon.catalogue.resolving.resolve` understands and was measured.

    viewing                  a Viewing; by default Viewing()
    from_normal_reflectance  the paper's way where only the normal reflectance
                             is known: k = 0 and an effective n a wavelength

    F(λ,θ) by the exact equations, integrated from 360 to 780 nm in 1 nm steps.
    Cook and Torrance 1982, sections "Spectral composition of the reflected
    light" and "Determining the RGB values".

    >>> reflect("copper").colours[AT_NORMAL].round(3).tolist()
    [0.932, 0.623, 0.522]
    """
    viewing = viewing or Viewing()
    preset, constants = require_measured(what)
    n, k = constants.at(observers.WAVELENGTH_NM)
    if viewing.medium != 1.0:
        if constants.normal_only:
            raise FacetFilmError("{material} is known by its reflectance in air alone: none in another medium follows; "
                                 "take data of n and k.", material=preset.title)
        outside = index_of_medium(viewing.medium)
        n, k = n / outside, k / outside
    from_normal_reflectance = from_normal_reflectance or constants.normal_only
    colours = mirror_spectra(ANGLES, n, k, from_normal_reflectance) @ viewing.weights
    mapped, report = viewing.map(colours)
    return Reflected(preset, constants, viewing, n, k, from_normal_reflectance, colours, mapped, report)


def _medium(what):
    """A medium as a number of at least 1, or what names a material; None, "" and "air" are 1."""
    if what is None or isinstance(what, str) and what.strip().lower() in {"", "air", "vacuum"}:
        return 1.0
    if isinstance(what, str):
        try:
            what = float(what.replace(",", "."))
        except ValueError:
            return what.strip()
    if isinstance(what, optical_constants.OpticalConstants):
        return what
    if isinstance(what, bool) or not isinstance(what, numbers.Real) or not LEAST_MEDIUM <= what <= LARGEST_MEDIUM:
        raise FacetFilmError("The medium outside is a number from 1 to 4 or a clear material, such as 1.33 or 'water', "
                             "not {value!r}.", value=what)
    return float(what)


def index_of_medium(medium):
    """n of the medium outside at 360 to 780 nm: ``(421,)``, or a number.

    medium  a number, or what names a clear material

    Raises FacetFilmError for a material that absorbs.

    >>> index_of_medium(1.33)
    1.33
    """
    if isinstance(medium, float):
        return medium
    preset, constants = require_measured(medium)
    n, k = constants.at(observers.WAVELENGTH_NM)
    if constants.normal_only or k.max() > LARGEST_K_OF_A_MEDIUM or n.min() < LEAST_MEDIUM - 1e-3:
        raise FacetFilmError("{material} absorbs light, so it cannot be the medium outside; name a clear one, such as "
                             "'water', or its index, such as 1.33.", material=preset.title)
    return n


def mirror_spectra(cos_theta, n, k, from_normal_reflectance=False):
    """F(λ,θ), ``(A, W)``, at cos θ ``(A,)`` of n and k ``(W,)``; see :func:`reflect`.

    >>> mirror_spectra(np.ones(1), np.array([1.5]), np.zeros(1)).round(6).tolist()
    [[0.04]]
    """
    c = cos_theta[:, None]
    if from_normal_reflectance:
        return fresnel.dielectric_from_normal(c, fresnel.conductor(1.0, n, k))
    return fresnel.conductor(c, n, k)
