"""How far given parameters lie from a measured material, and measurements of one from each other."""

import dataclasses
import re

import numpy as np

from ..catalogue.resolving import resolve_widely
from ..errors import FacetFilmError, choice, numbers_of
from ..reflectance import fresnel
from ..spectra import names, optical_constants
from .baking import CURVE_TOLERANCE, FORMULAS, FresnelCurve, plain
from .colour import delta_e_2000, lab, rgb_to_xyz
from .curve import knots
from .gamut import DEFAULT
from .reflected import ANGLES, AT_82, AT_NORMAL, COMPARED, COS_THETA, Viewing, reflect
from .srgb import decoded

__all__ = ["Check", "check", "colour_given", "Measurement", "Spread", "spread"]


LARGEST_LINEAR = 4.0
"""Of a linear colour: no mirror is brighter in one channel; from there on numbers are those of sRGB, to 255."""


@dataclasses.dataclass(frozen=True)
class Check:
    """Colours of given parameters beside those of a measured material.

    f0, f82, f82_tint    of what was given: colour at 0°, at cos θ = 1/7, and that over Schlick's
    fresnel              its FresnelCurve
    against, dataset     the material it is held against, and the data of that
    against_f0, against_f82, against_f82_tint  the same of that
    delta_e_2000_normal  CIEDE2000 between the two at 0°
    delta_e_2000_max     the largest from 0 to 89°, and at_degrees where that is
    """

    given: str
    f0: tuple
    f82: tuple
    f82_tint: tuple
    fresnel: FresnelCurve
    against: str
    dataset: str
    against_f0: tuple
    against_f82: tuple
    against_f82_tint: tuple
    delta_e_2000_normal: float
    delta_e_2000_max: float
    at_degrees: float
    illuminant: str
    observer: str
    space: str

    def to_dict(self):
        """The same as dicts and lists, ready for JSON."""
        return plain(dataclasses.asdict(self))


def check(against, *, n=None, k=None, f0=None, tint=None, preset=None, formula="exact",
          illuminant="D65", observer="1931", space="Rec.709", adapt=False, gamut=DEFAULT, medium=1.0):
    """The Check of n and k, of F0 and F82 tint, or of a material, against a measured material.

    against  what names a material: see addon.catalogue.resolving
    n, k     RGB, ``(3,)`` each, n above 0, k at or above 0; evaluated by the formula "exact" or "blender-4.5"
    f0, tint RGB, ``(3,)`` each, linear; above 1 where a colour is outside the gamut; or "#ffd98b", or 0 to 255 as
             sRGB has them; the tint is 1 where it is not given
    preset   what names a material: see addon.catalogue.resolving
    medium   what the surfaces are in, as :func:`~addon.bake.baking.bake` has it

    One of n with k, f0, and preset is given.  Colours of materials are those
    after gamut mapping: what can be rendered.  Raises FacetFilmError otherwise.

    >>> round(check("copper", n=(0.2, 1.0, 1.3), k=(3.2, 2.6, 2.4)).delta_e_2000_max, 1)
    0.5
    """
    viewing = Viewing(illuminant, observer, space, adapt, gamut, medium)
    space = viewing.space
    target = reflect(against, viewing)
    given, rgb = _given(n, k, f0, tint, preset, formula, viewing)
    difference = delta_e_2000(lab(target.mapped, space), lab(rgb, space))
    worst = COMPARED[difference[COMPARED].argmax()]
    chosen = knots(COS_THETA, rgb[:len(COS_THETA)], CURVE_TOLERANCE)
    return Check(
        given, *_anchors(rgb),
        FresnelCurve(tuple(COS_THETA[chosen].tolist()), tuple(map(tuple, rgb[chosen].tolist()))),
        target.preset.title, target.constants.dataset, *_anchors(target.mapped),
        float(difference[AT_NORMAL]), float(difference[worst]),
        round(float(np.degrees(np.arccos(ANGLES[worst]))), 1), viewing.illuminant, viewing.observer, space)


def _given(n, k, f0, tint, preset, formula, viewing):
    """(what it is in words, linear RGB at ANGLES) of what the user gave."""
    if sum(thing is not None for thing in (n, f0, preset)) != 1 or (n is None) != (k is None):
        raise FacetFilmError("A check takes one of: n with k, F0 with or without a tint, a material.")
    c = ANGLES[:, None]
    if n is not None:
        n, k = numbers_of("n", n, 3, above=0), numbers_of("k", k, 3, low=0)
        return "n and k", FORMULAS[choice("formula", formula, FORMULAS)](c, np.array(n), np.array(k))
    if f0 is not None:
        f0 = colour_given("F0", f0, viewing.space)
        tint = colour_given("F82 tint", (1, 1, 1) if tint is None else tint, viewing.space)
        b = fresnel.f82_factor(np.array(f0), np.array(tint))
        return "F0 and F82 tint", viewing.map(fresnel.f82_unclamped(c, np.array(f0), b))[0]
    reflected = reflect(preset, viewing)
    return f"{reflected.preset.title} ({reflected.constants.dataset})", reflected.mapped


def colour_given(name, value, space="Rec.709"):
    """Linear RGB, ``(3,)``, of a colour as people give it: linear numbers, sRGB as "#ffd98b", or as 0 to 255.

    >>> colour_given("F0", (1.059, 0.773, 0.307)), [round(x, 3) for x in colour_given("F0", "#ffffff")]
    ((1.059, 0.773, 0.307), [1.0, 1.0, 1.0])
    """
    if isinstance(value, str):
        digits = value.strip().removeprefix("#").removeprefix("0x")
        digits = "".join(2 * digit for digit in digits) if len(digits) == 3 else digits
        if not re.fullmatch("[0-9a-fA-F]{6}", digits):
            raise FacetFilmError("{name} {value!r} is no colour; give three numbers, or one such as '#ffd98b'.",
                                 name=name, value=value)
        return _linear_of_srgb([int(digits[at:at + 2], 16) for at in (0, 2, 4)], space)
    numbers = numbers_of(name, value, 3, -1, 255)
    if max(numbers) <= LARGEST_LINEAR:
        return numbers
    if min(numbers) < 0 or any(number != round(number) for number in numbers):
        raise FacetFilmError("{name} {value!r} is no colour: linear numbers go to {most}, "
                             "and whole ones to 255 are sRGB.",
                             name=name, value=value, most=f"{LARGEST_LINEAR:g}")
    return _linear_of_srgb(numbers, space)


def _linear_of_srgb(of_255, space):
    """Linear RGB in a space of sRGB numbers from 0 to 255."""
    linear = decoded(np.array(of_255, float) / 255.0)
    return tuple(np.linalg.solve(rgb_to_xyz(space), rgb_to_xyz("Rec.709") @ linear).tolist())


def _anchors(rgb):
    """F0, F82 and F82 tint of colours at ANGLES."""
    f0, f82 = rgb[AT_NORMAL], rgb[AT_82]
    return tuple(f0.tolist()), tuple(f82.tolist()), tuple(fresnel.f82_tint_of(f0, f82).tolist())


@dataclasses.dataclass(frozen=True)
class Measurement:
    """One of several measurements of a material.

    f0                   colour at normal incidence, before gamut mapping
    f82_tint             its F82 tint
    outside              whether that is outside the gamut
    delta_e_2000_normal  CIEDE2000 from the reference at 0°
    delta_e_2000_max     the largest from 0 to 89°
    """

    dataset: str
    title: str
    citation: str
    f0: tuple
    f82_tint: tuple
    outside: bool
    delta_e_2000_normal: float
    delta_e_2000_max: float


@dataclasses.dataclass(frozen=True)
class Spread:
    """Measurements of one material side by side.

    reference        the dataset that the differences are from
    measurements     by their difference from it
    farthest         the two datasets that differ most at normal incidence
    farthest_delta_e_2000  and how much
    """

    material: str
    reference: str
    measurements: tuple
    farthest: tuple
    farthest_delta_e_2000: float
    illuminant: str
    observer: str
    space: str

    def to_dict(self):
        """The same as dicts and lists, ready for JSON."""
        return plain(dataclasses.asdict(self))


def spread(what, *, illuminant="D65", observer="1931", space="Rec.709", adapt=False):
    """The Spread of all measurements of a material.

    what  a preset's name, a dataset's id, or words that a search understands:
          it, or the best that was found, is the reference

    Differences are between colours before gamut mapping.  Where some of a
    material's datasets have k, those that have none stay out, and so do those
    that were calculated from first principles ("-DFT").  Raises FacetFilmError
    where nothing is found.

    >>> spread("gold").reference
    'main/Au/Babar'
    """
    viewing = Viewing(illuminant, observer, space, adapt, "leave")
    space = viewing.space
    reference = _dataset_of(what)
    found = [reflect(dataset, viewing) for dataset in _same_material(reference)]
    labs = lab(np.stack([reflected.colours for reflected in found]), space)
    at = [reflected.constants.dataset for reflected in found].index(reference)
    differences = delta_e_2000(labs[at], labs)
    between = delta_e_2000(labs[:, None, AT_NORMAL], labs[None, :, AT_NORMAL])
    first, second = np.unravel_index(between.argmax(), between.shape)
    measurements = [_measurement(*pair) for pair in zip(found, differences)]
    return Spread(
        names.material_names(reference)[0], reference,
        tuple(sorted(measurements, key=lambda measurement: measurement.delta_e_2000_max)),
        (found[first].constants.dataset, found[second].constants.dataset), float(between.max()),
        viewing.illuminant, viewing.observer, space)


def _dataset_of(what):
    """The dataset of whatever names a material, or of the best that a search finds."""
    preset, constants = resolve_widely(what)
    if not preset.dataset:
        raise FacetFilmError("{preset} has no dataset of the database, so there is nothing to compare: its "
                             "values are the preset's own. Name another preset, or a dataset such as 'main/Au/Babar'.",
                             preset=preset.title)
    if constants.dataset not in optical_constants.dataset_ids():
        raise FacetFilmError("{dataset!r} is no dataset of the database; name one, or a material of it.",
                             dataset=constants.dataset or what)
    return constants.dataset


def _same_material(dataset):
    """The ids of all measured datasets of this one's book; those without k only where this has none."""
    book = dataset.rsplit("/", 1)[0] + "/"
    ids = [other for other in optical_constants.dataset_ids()
           if other.startswith(book) and (other == dataset or not other.endswith("-DFT"))]
    with_k = [other for other in ids if optical_constants.load(other).has_k]
    return with_k if dataset in with_k else ids


def _measurement(reflected, differences):
    f0, _, tint = _anchors(reflected.colours)
    constants = reflected.constants
    return Measurement(constants.dataset, constants.title, constants.citation, f0, tint,
                       reflected.gamut.outside, float(differences[AT_NORMAL]),
                       float(differences[COMPARED].max()))
