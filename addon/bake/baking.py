"""From a measured material to what a renderer takes: colours over angle, and parameters fitted to them."""

import dataclasses
import functools

import numpy as np

from ..errors import choice
from ..reflectance import fresnel
from ..spectra import illuminants, observers, optical_constants, presets
from .colour import rgb_to_xyz, spectral_weights
from .curve import knots
from .fit import colour_metric, family_of, fit, largest_delta_e
from .gamut import GamutReport, map_colours

__all__ = ["Bake", "Source", "ConductorFit", "F82Fit", "FresnelCurve", "bake", "FORMULAS"]

FORMULAS = {"exact": fresnel.conductor, "blender-4.5": fresnel.conductor_blender_4_5}
"""What the renderer evaluates for a conductor: exact from Blender 5.0, before that an approximation."""

_STEPS = np.concatenate([np.arange(0, 24), np.arange(24, 48, 2), np.arange(48, 96, 4), np.arange(96, 255, 8), [255]])
COS_THETA = _STEPS / 255.0
"""Where the curve may have its points, grazing to normal: dense near grazing, where Fresnel
curves bend most, and where the renderer's table of 256 entries has its own."""
ANGLES = np.concatenate([COS_THETA, [fresnel.COS_THETA_82, np.cos(np.radians(89.0))]])
AT_NORMAL, AT_82 = len(COS_THETA) - 1, len(COS_THETA)
COMPARED = np.flatnonzero(ANGLES >= np.cos(np.radians(89.0)) - 1e-12)
"""The angles over which colour differences count: 0 to 89°."""
FITTED = COMPARED[::2]
CURVE_TOLERANCE = 9e-4
"""Of the sampled curve; leaves room for what lies between the samples, within 0.001 in all."""

N_RANGE, K_RANGE = (1e-3, 20.0), (0.0, 40.0)


@dataclasses.dataclass(frozen=True)
class Source:
    """Where the measured data is from."""

    dataset: str
    citation: str
    licence: str
    wavelength_range_nm: tuple


@dataclasses.dataclass(frozen=True)
class ConductorFit:
    """n and k a channel, ``(3,)`` each, for the named formula, and how far off they are at worst."""

    n: tuple
    k: tuple
    formula: str
    delta_e_2000_max: float


@dataclasses.dataclass(frozen=True)
class F82Fit:
    """F0 and F82 tint a channel, ``(3,)`` each, and how far off they are at worst."""

    f0: tuple
    tint: tuple
    delta_e_2000_max: float


@dataclasses.dataclass(frozen=True)
class FresnelCurve:
    """Colour of the mirror over angle: cos θ ``(K,)`` ascending, rgb ``(K, 3)``, straight lines between."""

    cos_theta: tuple
    rgb: tuple


@dataclasses.dataclass(frozen=True)
class Bake:
    """What a material is for a renderer.

    f0 and f82_tint are colorimetric, before colours are brought into the
    gamut; conductor, f82, fresnel and normal_rgb are after.  best names the
    closer one of "conductor" and "f82".  diffuse_rgb is the diffuse colour, None
    where the material has none.
    """

    name: str
    title: str
    kind: str
    source: Source
    illuminant: str
    observer: str
    space: str
    f0: tuple
    f82_tint: tuple
    conductor: ConductorFit
    f82: F82Fit
    fresnel: FresnelCurve
    gamut: GamutReport
    normal_rgb: tuple
    best: str
    adapted: bool = False
    diffuse_rgb: tuple = None

    def to_dict(self):
        """The same as dicts, lists, numbers and text, ready for JSON.

        >>> sorted(bake("copper").to_dict()["gamut"])
        ['largest_change', 'method', 'outside']
        """
        return _plain(dataclasses.asdict(self))


def bake(preset, *, illuminant="D65", observer="1931", space="Rec.709", adapt=False, gamut="desaturate",
         formula="exact", from_normal_reflectance=False):
    """Bake a material: F(λ,θ) to linear RGB at every angle, and per channel the closest parameters.

    preset      a preset's name, a dataset's id "shelf/book/page", or OpticalConstants
    illuminant  a CIE illuminant; observer "1931" (2°) or "1964" (10°)
    space       scene-linear space: "Rec.709", "Rec.2020" or "ACEScg"; neutral
                is a perfect reflector in D65 in each, as in Blender
    adapt       whether the eye is adapted to the illuminant, so that a perfect
                reflector is neutral in any light
    gamut       what to do with colours outside [0, 1]: "desaturate", "scale", "clip", "leave"
    formula     "exact" (Blender 5.0 and later) or "blender-4.5": for which n and k are fitted
    from_normal_reflectance  the paper's way where only the normal reflectance
                is known: k = 0 and an effective n a wavelength

    Spectra are integrated from 360 to 780 nm in 1 nm steps.  Returns a Bake.
    Raises FacetFilmError for anything unknown, with the nearest names.
    Cook and Torrance 1982, sections "Spectral composition" and "Color".

    >>> [round(x, 3) for x in bake("copper").f0]
    [0.932, 0.623, 0.522]
    """
    choice("formula", formula, FORMULAS)
    choice("space", space, ("Rec.709", "Rec.2020", "ACEScg"))
    record, constants = material(preset)
    weights = spectral_weights(illuminants.canonical(illuminant), str(observer), space, bool(adapt))
    n, k = constants.at(observers.WAVELENGTH_NM)
    measured = reflectance_rgb(n, k, weights, from_normal_reflectance or constants.normal_only)
    mapped, gamut_report = map_colours(measured, gamut, space)
    metric = colour_metric(mapped[FITTED], space)
    conductor_fit = fit_conductor(mapped, n, k, weights, formula, space, metric)
    f82_fit = fit_f82(mapped, space, metric)
    chosen = knots(COS_THETA, mapped[:len(COS_THETA)], CURVE_TOLERANCE)
    return Bake(
        name=record.name, title=record.title, kind=record.kind,
        source=Source(constants.dataset, constants.citation, constants.licence, constants.range_nm),
        illuminant=illuminants.canonical(illuminant), observer=str(observer), space=space,
        f0=tuple(measured[AT_NORMAL].tolist()),
        f82_tint=tuple(fresnel.f82_tint_of(measured[AT_NORMAL], measured[AT_82]).tolist()),
        conductor=conductor_fit, f82=f82_fit,
        fresnel=FresnelCurve(tuple(COS_THETA[chosen].tolist()), tuple(map(tuple, mapped[chosen].tolist()))),
        gamut=gamut_report, normal_rgb=tuple(mapped[AT_NORMAL].tolist()),
        best="conductor" if conductor_fit.delta_e_2000_max <= f82_fit.delta_e_2000_max else "f82",
        adapted=bool(adapt), diffuse_rgb=diffuse_colour(record, mapped[AT_NORMAL], weights, gamut, space))


def material(preset):
    """(Preset, OpticalConstants) of a preset's name, a dataset's id or OpticalConstants."""
    if isinstance(preset, optical_constants.OpticalConstants):
        return _unnamed(preset), preset
    if isinstance(preset, str) and preset.count("/") >= 2:
        constants = optical_constants.load(preset)
        return _unnamed(constants), constants
    record = presets.find(preset)
    return record, optical_constants.load(record.dataset)


def _unnamed(constants):
    return presets.Preset(constants.dataset, constants.title or constants.dataset, "measured", constants.dataset)


def reflectance_rgb(n, k, weights, from_normal_reflectance=False):
    """Linear RGB at every angle of ANGLES, ``(A, 3)``, of n and k at 360 to 780 nm, ``(421,)`` each."""
    c = ANGLES[:, None]
    if from_normal_reflectance:
        return fresnel.dielectric_from_normal(c, fresnel.conductor(1.0, n, k)) @ weights
    return fresnel.conductor(c, n, k) @ weights


def fit_conductor(rgb, n, k, weights, formula, space, metric):
    """The ConductorFit of colours over angle; n, k and weights of the spectrum say where to start.

    The search is over n and k²: reflectance has a slope over k² at k = 0, but none over k.
    """
    reflectance = FORMULAS[formula]
    share = np.maximum(weights, 0.0)
    share = share / share.sum(axis=0)
    start = np.stack([n @ share, (k @ share) ** 2])
    family = family_of(lambda c, n, k2: reflectance(c, n, np.sqrt(k2)), ANGLES[FITTED])
    n, k2 = fit(family, rgb[FITTED], start, (N_RANGE[0], K_RANGE[0] ** 2), (N_RANGE[1], K_RANGE[1] ** 2), metric)
    delta_e = largest_delta_e(reflectance(ANGLES[COMPARED, None], n, np.sqrt(k2)), rgb[COMPARED], space)
    return ConductorFit(tuple(n.tolist()), tuple(np.sqrt(k2).tolist()), formula, delta_e)


def fit_f82(rgb, space, metric):
    """The F82Fit of colours over angle."""
    start = np.stack([rgb[AT_NORMAL], fresnel.f82_tint_of(rgb[AT_NORMAL], rgb[AT_82])])
    parameters = fit(family_of(fresnel.f82, ANGLES[FITTED]), rgb[FITTED], start, (0.0, 0.0), (1.0, 1.0), metric)
    fitted = fresnel.f82(ANGLES[COMPARED, None], *parameters)
    return F82Fit(*map(tuple, parameters.tolist()), largest_delta_e(fitted, rgb[COMPARED], space))


def diffuse_colour(record, specular_rgb, weights, gamut, space):
    """π·Rd of a preset, or None: its own numbers, or a normal reflectance (Cook and Torrance 1982)."""
    if record.diffuse is None:
        return None
    if record.diffuse == "specular":
        return tuple(specular_rgb.tolist())
    if isinstance(record.diffuse, str):
        n, k = optical_constants.load(record.diffuse).at(observers.WAVELENGTH_NM)
        rgb = fresnel.conductor(1.0, n, k) @ weights
    else:
        rgb = np.linalg.solve(rgb_to_xyz(space), rgb_to_xyz("Rec.709") @ np.array(record.diffuse))
    return tuple(map_colours(rgb[None], gamut, space)[0][0].tolist())


def _plain(value):
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, (tuple, list)):
        return [_plain(item) for item in value]
    return value
