"""From a measured material to what a renderer takes: colours over angle, and parameters fitted to them."""

import functools
from typing import NamedTuple

import numpy as np

from ..catalogue.resolving import require_measured
from ..errors import choice
from ..reflectance import fresnel
from .colour import lab
from .curve import knots
from .fit import colour_metric, family_of, fit, largest_delta_e, linear_family_of
from .gamut import DEFAULT, GamutReport
from .reflected import ANGLES, AT_82, AT_NORMAL, COMPARED, COS_THETA, Viewing, reflect

__all__ = ["Bake", "Source", "ConductorFit", "F82Fit", "FresnelCurve", "bake", "plain", "bake_with_index",
           "conductor_of_curve", "FORMULAS"]

FORMULAS = {"exact": fresnel.conductor, "blender-4.5": fresnel.conductor_blender_4_5}
"""What the renderer evaluates for a conductor: exact from Blender 5.0, before that an approximation."""

FITTED = COMPARED[::2]
CURVE_TOLERANCE = 8.8e-4
"""Of the sampled curve; leaves room for what lies between the samples, within 0.001 in all."""
SHARPEST_BEND = 2e-3
"""Second difference of a curve's samples near grazing above which that room is not enough."""
NEAR_GRAZING = 12.0 / 255.0 * np.linspace(0.0, 1.0, 97)[:-1] ** 2
"""cos θ of the finer samples that such a curve gets: gases, whose n is nearly 1, bend within a degree."""
N_RANGE, K_RANGE = (1e-3, 20.0), (0.0, 40.0)


class Source(NamedTuple):
    """Where the measured data is from."""

    dataset: str
    citation: str
    licence: str
    wavelength_range_nm: tuple
    covers_visible: bool  # 400 to 700 nm; else the ends are held
    assumed: tuple = ()  # what a reader of files took for granted, a line each


class ConductorFit(NamedTuple):
    """n and k a channel, ``(3,)`` each, for the named formula, and how far off they are at worst."""

    n: tuple
    k: tuple
    formula: str
    delta_e_2000_max: float


class F82Fit(NamedTuple):
    """F0 and F82 tint a channel, ``(3,)`` each, and how far off they are at worst."""

    f0: tuple
    tint: tuple
    delta_e_2000_max: float


class FresnelCurve(NamedTuple):
    """Colour of the mirror over angle: cos θ ``(K,)`` ascending, rgb ``(K, 3)``, straight lines between."""

    cos_theta: tuple
    rgb: tuple


class Bake(NamedTuple):
    """What a material is for a renderer.

    f0 and f82_tint are colorimetric, before colours are brought into the
    gamut; conductor, f82, fresnel and normal_rgb (the colour at normal incidence)
    are after.  best names the closer one of "conductor" and "f82".  white is
    what a perfect reflector is in this light: neutral in D65 and where adapted.
    estimated says what of the preset is no measurement, and from what it was
    guessed; "" where all is measured.  medium is the index of what is outside,
    or the dataset of it.
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
    adapted: bool
    white: tuple
    estimated: str
    medium: object = 1.0

    def to_dict(self):
        """The same as dicts, lists, numbers and text, ready for JSON.

        >>> sorted(bake("copper").to_dict()["gamut"])
        ['largest_change', 'method', 'outside']
        """
        return plain(self)


def bake(preset, *, illuminant="D65", observer="1931", space="Rec.709", adapt=False, gamut=DEFAULT,
         formula="exact", from_normal_reflectance=False, medium=1.0):
    """Bake a material: F(λ,θ) to linear RGB at every angle, and per channel the closest parameters.

    preset      what :func:`addon.catalogue.resolving.resolve` understands: a preset's name, a dataset's id
                "shelf/book/page", a file, OpticalConstants
    illuminant, observer, space, adapt, gamut  as for :class:`~addon.bake.reflected.Viewing`
    formula     "exact" (Blender 5.0 and later) or "blender-4.5": for which n and k are fitted
    from_normal_reflectance  the paper's way where only the normal reflectance
                is known: k = 0 and an effective n a wavelength
    medium      what the surface is in: its index, or a clear material; n and k are relative to it

    Returns a Bake.  Raises FacetFilmError for anything unknown, with the nearest names.

    >>> [round(x, 3) for x in bake("copper").f0]
    [0.932, 0.623, 0.522]
    """
    choice("formula", formula, FORMULAS)
    viewing = Viewing(illuminant, observer, space, adapt, gamut, medium)
    found = require_measured(preset)
    reflected, metric, target_lab, f82, curve = _whatever_the_formula(found, viewing, from_normal_reflectance)
    colours, mapped = reflected.colours, reflected.mapped
    conductor = fit_conductor(reflected, formula, metric, target_lab)
    constants, record = reflected.constants, reflected.preset
    return Bake(
        name=record.name, title=record.title, kind=record.kind,
        source=Source(constants.dataset, constants.citation, constants.licence, constants.range_nm,
                      constants.covers_visible, constants.assumed),
        illuminant=viewing.illuminant, observer=viewing.observer, space=viewing.space,
        f0=tuple(colours[AT_NORMAL].tolist()),
        f82_tint=tuple(fresnel.f82_tint_of(colours[AT_NORMAL], colours[AT_82]).tolist()),
        conductor=conductor, f82=f82,
        fresnel=curve,
        gamut=reflected.gamut, normal_rgb=tuple(mapped[AT_NORMAL].tolist()),
        best="conductor" if conductor.delta_e_2000_max <= f82.delta_e_2000_max else "f82",
        adapted=viewing.adapt, white=tuple(viewing.weights.sum(axis=0).tolist()),
        estimated=record.estimated, medium=getattr(viewing.medium, "dataset", viewing.medium))


def bake_with_index(preset, n, k, **viewing):
    """The Bake of a material whose n and k, ``(3,)`` each, someone has changed, for the exact equation.

    preset, viewing  as :func:`bake` has them

    Colours, curve and F82 are those of n and k; the differences stay those from the measurement.

    >>> glass = bake_with_index("copper", (1.5,) * 3, (0.0,) * 3)
    >>> [round(x, 3) for x in glass.f0], glass.conductor.delta_e_2000_max > 20.0
    ([0.04, 0.04, 0.04], True)
    """
    found, seen = require_measured(preset), Viewing(**viewing)
    space = seen.space
    reflected, _, target_lab, _, _ = _whatever_the_formula(found, seen, False)
    rgb = fresnel.conductor(ANGLES[:, None], np.array(n), np.array(k))
    changed_lab = lab(rgb, space)
    metric = colour_metric(rgb[FITTED], changed_lab[FITTED], space)
    f82 = fit_f82(reflected._replace(colours=rgb, mapped=rgb), metric, changed_lab[COMPARED])
    f82 = f82._replace(delta_e_2000_max=largest_delta_e(
        fresnel.f82(ANGLES[COMPARED, None], np.array(f82.f0), np.array(f82.tint)), target_lab, space))
    conductor = ConductorFit(tuple(n), tuple(k), "exact", largest_delta_e(rgb[COMPARED], target_lab, space))
    chosen = knots(COS_THETA, rgb[:len(COS_THETA)], CURVE_TOLERANCE)
    return bake(found, **viewing)._replace(
        conductor=conductor, f82=f82, f0=tuple(rgb[AT_NORMAL].tolist()), normal_rgb=tuple(rgb[AT_NORMAL].tolist()),
        f82_tint=tuple(fresnel.f82_tint_of(rgb[AT_NORMAL], rgb[AT_82]).tolist()),
        fresnel=FresnelCurve(tuple(COS_THETA[chosen].tolist()), tuple(map(tuple, rgb[chosen].tolist()))),
        gamut=GamutReport(False, viewing.get("gamut", Viewing.gamut), 0.0),
        best="conductor" if conductor.delta_e_2000_max <= f82.delta_e_2000_max else "f82")


@functools.lru_cache(maxsize=4)
def _whatever_the_formula(found, viewing, from_normal_reflectance):
    """(Reflected, metric, Lab to hold fits against, F82Fit, FresnelCurve); kept, as a material is baked for two."""
    reflected = reflect(found, viewing, from_normal_reflectance)
    target_lab = lab(reflected.mapped, viewing.space)
    metric = colour_metric(reflected.mapped[FITTED], target_lab[FITTED], viewing.space)
    target_lab = target_lab[COMPARED]
    return reflected, metric, target_lab, fit_f82(reflected, metric, target_lab), curve_of(reflected)


def curve_of(reflected):
    """The FresnelCurve of a Reflected, after gamut mapping."""
    cos_theta, rgb = COS_THETA, reflected.mapped[:len(COS_THETA)]
    if np.abs(rgb[0] - 2.0 * rgb[1] + rgb[2]).max() > SHARPEST_BEND:
        beyond = COS_THETA > NEAR_GRAZING[-1]
        cos_theta = np.concatenate([NEAR_GRAZING, COS_THETA[beyond]])
        rgb = np.concatenate([reflected.mapped_at(NEAR_GRAZING), rgb[beyond]])
    chosen = knots(cos_theta, rgb, CURVE_TOLERANCE)
    return FresnelCurve(tuple(cos_theta[chosen].tolist()), tuple(map(tuple, rgb[chosen].tolist())))


def fit_conductor(reflected, formula, metric, target_lab):
    """The ConductorFit of a Reflected; the means of its spectrum of n and k say where to start.

    The search is over n and k²: reflectance has a slope over k² at k = 0, but none over k.
    """
    reflectance = FORMULAS[formula]
    share = np.maximum(reflected.viewing.weights, 0.0)
    share = share / share.sum(axis=0)
    start = np.stack([reflected.n @ share, (reflected.k @ share) ** 2])
    family = family_of(lambda c, n, k2: reflectance(c, n, np.sqrt(k2)), ANGLES[FITTED])
    n, k2 = fit(family, reflected.mapped[FITTED], start, (N_RANGE[0], K_RANGE[0] ** 2),
                (N_RANGE[1], K_RANGE[1] ** 2), metric)
    fitted = reflectance(ANGLES[COMPARED, None], n, np.sqrt(k2))
    delta_e = largest_delta_e(fitted, target_lab, reflected.viewing.space)
    return ConductorFit(tuple(n.tolist()), tuple(np.sqrt(k2).tolist()), formula, delta_e)


def conductor_of_curve(rgb, n, k, space):
    """The ConductorFit, by the exact equation, of a curve of one's own.

    rgb   linear RGB at ANGLES, ``(A, 3)``
    n, k  where the search starts, ``(3,)`` each
    """
    target = lab(rgb, space)
    family = family_of(lambda c, n, k2: fresnel.conductor(c, n, np.sqrt(k2)), ANGLES[FITTED])
    found, k2 = fit(family, rgb[FITTED], np.stack([n, k * k]), (N_RANGE[0], K_RANGE[0] ** 2),
                    (N_RANGE[1], K_RANGE[1] ** 2), colour_metric(rgb[FITTED], target[FITTED], space))
    curve = fresnel.conductor(ANGLES[COMPARED, None], found, np.sqrt(k2))
    return ConductorFit(tuple(found.tolist()), tuple(np.sqrt(k2).tolist()), "exact",
                        largest_delta_e(curve, target[COMPARED], space))


F82_CURVES = linear_family_of(fresnel.f82_unclamped, ANGLES[FITTED])


def fit_f82(reflected, metric, target_lab):
    """The F82Fit of a Reflected; the search is over F0 and the model's factor b, in which it is linear."""
    rgb = reflected.mapped
    at_82 = fresnel.schlick(fresnel.COS_THETA_82, rgb[AT_NORMAL])
    start = np.stack([rgb[AT_NORMAL], (at_82 - rgb[AT_82]) / fresnel.F82_LOBE])
    f0, b = fit(F82_CURVES, rgb[FITTED], start, (0.0, 0.0), (1.0, 1.0 / fresnel.F82_LOBE), metric)
    tint = np.clip(1.0 - b * fresnel.F82_LOBE / fresnel.schlick(fresnel.COS_THETA_82, f0), 0.0, 1.0)
    fitted = fresnel.f82(ANGLES[COMPARED, None], f0, tint)
    delta_e = largest_delta_e(fitted, target_lab, reflected.viewing.space)
    return F82Fit(tuple(f0.tolist()), tuple(tint.tolist()), delta_e)


def plain(value):
    """A record as dicts, lists, numbers and text, all the way down.

    >>> plain({"source": GamutReport(False, "clip", 0.0), "f0": (0.1, 0.2)})
    {'source': {'outside': False, 'method': 'clip', 'largest_change': 0.0}, 'f0': [0.1, 0.2]}
    """
    if hasattr(value, "_asdict"):
        value = value._asdict()
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, (tuple, list)):
        return [plain(item) for item in value]
    return value
