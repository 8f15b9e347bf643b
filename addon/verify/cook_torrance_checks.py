"""The checks of Cook-Torrance: furnaces and spheres of every realisation against quadrature of the formula."""

import functools

import numpy as np

from .. import api
from ..blender import compat
from ..models.cook_torrance import formulas as ct
from ..models.cook_torrance.albedo import cook_torrance_albedo
from ..reflectance import fresnel
from . import cook_torrance_scenes as probes
from . import scenes
from .checks import Check, Figure, Outcome, Picture
from .statistics import CHANCE, relative_rms, z_test

__all__ = ["checks"]

MODEL = "cook_torrance"
CLOSURES = ("fast", "osl_fast")
FORMULA = ("exact", "osl")

SHARP_SUN = np.radians(60.0)
SOFT_SUN = (np.radians(45.0), np.radians(30.0))
FAST_RESOLUTION, RESOLUTION = 64, 24
RIM = 0.2
"""N·V below which a pixel's normal turns by degrees, so that its value is not one formula's."""

QUADRATURE = 1e-3
"""Relative error allowed to references of spheres: sub-pixels, lamps as points, the sphere's facets."""

WORTH_COMPARING = 0.02
"""Of the brightest part of a sphere: darker ones are left out."""

BLUR = 0.02
"""Relative bias that the default Sampling Width may have."""

FAST_RMS, FAST_BIAS = 0.02, 0.015
"""Of one closure a slope, up to slopes of 0.4; and of its albedo."""

FURNACE_BIAS, ZERO_SIZE_BIAS = 0.005, 0.03

TWO_SLOPES = {"slopes": probes.FIGURE_6B, **probes.COPPER}
ROUGH = {"slopes": ((0.4, 1.0),), **probes.COPPER}
VASE = {"slopes": probes.FIGURE_6B, "specular": 0.3, "diffuse": (0.9, 0.6, 0.5), **probes.COPPER}
GAUSSIAN = {"slopes": ((0.3, 1.0),), "distribution": "gaussian", **probes.COPPER}
PUBLISHED = {**GAUSSIAN, "scale": "published", "gaussian_c": 2.0}
ANISOTROPIC = {"slopes": ((0.2, 1.0),), "anisotropy": 0.7, **probes.COPPER}
WHITE = {"slopes": probes.FIGURE_6B, "n": (1e-3,) * 3, "k": (100.0,) * 3}


def checks(realisations):
    """The checks of these realisations."""
    found = []
    for realisation in realisations:
        found += _of_closures(realisation) if realisation in CLOSURES else _of_the_formula(realisation)
    return found


def _of_closures(realisation):
    sharp = ("a sphere under a sharp sun at 60°, free of noise, against the formula; rms over rms where N·V is above "
             "0.2")
    found = [Check(MODEL, realisation, name, sharp, sphere_without_noise, parameters) for name, parameters in (
        ("two slopes", TWO_SLOPES), ("slope 0.4", ROUGH), ("figure 6b's slopes over a diffuse part", VASE),
        ("Gaussian", GAUSSIAN), ("published scale and c", PUBLISHED), ("anisotropic", ANISOTROPIC))]
    found.append(Check(MODEL, realisation, "energy", "a perfect reflector in an even white world: eight tiles, "
                       "none brighter than the world", closure_furnace, WHITE))
    return found


def _of_the_formula(realisation):
    exact, width = {"sampling_width": 0.0}, {}
    furnace_text = "eight tiles in an even white world against the albedo by quadrature, at Sampling Width 0"
    found = [Check(MODEL, realisation, name, furnace_text, furnace, {**parameters, **exact}) for name, parameters in (
        ("furnace, two slopes", TWO_SLOPES), ("furnace, diffuse part", VASE),
        ("furnace, Gaussian in the published scale", PUBLISHED))]
    found += [
        Check(MODEL, realisation, "energy", "a perfect reflector in an even white world: its albedo is the formula's, "
              "below one", furnace, {**WHITE, **exact}),
        Check(MODEL, realisation, "sphere under a soft sun", "a sphere under a sun of 30° at 45°, at Sampling Width 0",
              soft_sun, {**TWO_SLOPES, **exact}),
        Check(MODEL, realisation, "sphere under an area lamp", "a sphere under a square lamp, at Sampling Width 0",
              area_lamp, {**TWO_SLOPES, **exact}),
        Check(MODEL, realisation, "anisotropic", "an anisotropic sphere under a sun of 30° at 45°, at Sampling Width 0",
              soft_sun, {**ANISOTROPIC, **exact}),
        Check(MODEL, realisation, "default width under a sun of no size", "a sphere under a sharp sun at 45°, "
              "at the default Sampling Width: means of six rings", zero_size_sun, {**TWO_SLOPES, **width}),
    ]
    return found


# --- What is measured ---

def sphere_without_noise(realisation, rendered, parameters):
    """The closures sample lamps of no size without noise: one sample in the middle of each pixel."""
    scene = scenes.empty_scene(FAST_RESOLUTION, osl=realisation.startswith("osl"), pixel_centres=True)
    scenes.add_sphere(api.create_material(realisation=realisation, **rendered))
    towards = scenes.add_sun(scene, SHARP_SUN)
    picture = scenes.render(scene)
    normals, mask = scenes.pixel_normals(FAST_RESOLUTION)
    normals = normals[:, :, 0, :]
    reference = np.nan_to_num(probes.times_cosine(normals, towards, **_formula(parameters),
                                                  fresnel=_renderer_fresnel()))
    mask &= normals[..., 2] > RIM
    reference[~mask] = picture[~mask] = 0.0
    return Outcome((Figure("rms difference over rms", relative_rms(picture, reference, mask), FAST_RMS, True),),
                   Picture(reference, picture))


def closure_furnace(realisation, rendered, parameters):
    """Multiple seeds of the tiles, against the formula's albedo."""
    means = _tiles(realisation, rendered, samples=256, seeds=4)
    expected = _albedos(parameters, 128, fresnel=_renderer_fresnel())
    return Outcome((Figure("albedo above one", float(means.mean(axis=0).max() - 1.0), 1e-3, True),
                    Figure("largest difference from the formula", _largest(means, expected), FAST_BIAS, True)),
                   _tile_picture(expected, means))


def furnace(realisation, rendered, parameters):
    """At Sampling Width 0 every mean is the albedo, within its standard error and within 0.5 %."""
    means = _tiles(realisation, rendered, samples=512, seeds=6)
    expected = _albedos(parameters, 256)
    test = z_test(means, expected, systematic=3e-4, alpha=CHANCE)
    figures = [Figure("largest |z|", test.largest, test.limit),
               Figure("largest difference from the formula", _largest(means, expected), FURNACE_BIAS, True)]
    if parameters.get("scale", "energy") == "energy":
        figures.append(Figure("albedo of the formula above one", float(expected.max() - 1.0), 1e-6, True))
    return Outcome(tuple(figures), _tile_picture(expected, means))


def soft_sun(realisation, rendered, parameters):
    """Bands of the sphere that reflect equally much, within their standard errors."""
    angle, diameter = SOFT_SUN
    pictures, towards = _sphere(realisation, rendered, 512, lambda scene: scenes.add_sun(
        scene, angle, diameter=diameter), seeds=10)
    reference, mask = probes.sun_reference(RESOLUTION, towards, diameter, **_formula(parameters))
    return _compare_bands(pictures, reference, mask)


def area_lamp(realisation, rendered, parameters):
    """The same under a square lamp."""
    pictures, lamp = _sphere(realisation, rendered, 512, probes.LAMPS["area lamp"], seeds=10)
    reference, mask = probes.lamp_reference(RESOLUTION, lamp, **_formula(parameters))
    return _compare_bands(pictures, reference, mask)


def zero_size_sun(realisation, rendered, parameters):
    """The default width may blur the formula by 3 % in the mean of a ring, beyond what chance explains."""
    pictures, towards = _sphere(realisation, rendered, 512, lambda scene: scenes.add_sun(scene, np.radians(45.0)))
    reference, mask = probes.sun_reference(RESOLUTION, towards, 0.0, **_formula(parameters))
    return _compare(_rings(pictures, mask), _rings(reference, mask), pictures, reference, mask, ZERO_SIZE_BIAS)


# --- Renders, formulas and comparisons ---

def _tiles(realisation, parameters, samples, seeds):
    scene = probes.furnace(lambda: api.create_material(realisation=realisation, **parameters), samples,
                           osl=realisation.startswith("osl"))
    return probes.tile_means(scenes.render_seeds(scene, seeds))


def _sphere(realisation, parameters, samples, light, seeds=6):
    scene = scenes.empty_scene(RESOLUTION, samples=samples, osl=realisation.startswith("osl"))
    scenes.add_sphere(api.create_material(realisation=realisation, **parameters))
    described = light(scene)
    return scenes.render_seeds(scene, seeds), described


def _formula(parameters):
    """create_material's parameters as the formula has them."""
    found = {"slopes": parameters["slopes"], "n": parameters["n"], "k": parameters["k"],
             "specular": parameters.get("specular", 1.0), "diffuse": parameters.get("diffuse", (0.0,) * 3),
             "distribution": parameters.get("distribution", "beckmann"),
             "anisotropy": parameters.get("anisotropy", 0.0)}
    if parameters.get("scale", "energy") == "published":
        found.update(scale=ct.PUBLISHED, printed_c=parameters["gaussian_c"])
    return found


def _albedos(parameters, count, **terms):
    """Of the tiles, ``(8, 3)``; the realisations share them."""
    return _albedos_of(tuple(sorted({**_formula(parameters), **terms}.items())), count)


@functools.lru_cache
def _albedos_of(parameters, count):
    found = dict(parameters)
    for ours, theirs in (("n", "index"), ("k", "extinction"), ("specular", "s"), ("diffuse", "normal_reflectance")):
        found[theirs] = found.pop(ours)
    return cook_torrance_albedo(np.cos(probes.FURNACE_ANGLES), **found, count=count)


def _renderer_fresnel():
    """The conductor Fresnel that this Blender's closures evaluate."""
    return {"exact": fresnel.conductor, "blender-4.5": fresnel.conductor_blender_4_5}[compat.conductor_formula()]


def _largest(means, expected):
    return float(np.abs(means.mean(axis=0) / expected - 1.0).max())


def _tile_picture(expected, means):
    tile = np.ones((probes.TILE_PIXELS, probes.TILE_PIXELS, 1))
    return Picture(*(np.concatenate([tile * value for value in row], axis=1) for row in (expected, means.mean(axis=0))))


def _compare_bands(pictures, reference, mask):
    return _compare(probes.bands(pictures, reference, mask), probes.bands(reference, reference, mask),
                    pictures, reference, mask)


def _compare(found, expected, pictures, reference, mask, tolerance=0.0):
    """The z-test of the means over parts; with a tolerance, of what they differ by beyond it."""
    bright = (expected > WORTH_COMPARING * expected.max(axis=0)).all(axis=-1)
    found, expected = found[:, bright], expected[bright]
    test = z_test(found, expected, systematic=QUADRATURE, tolerance=tolerance, alpha=CHANCE)
    beyond = f" beyond {tolerance:.0%}" if tolerance else ""
    picture = pictures.mean(axis=0)
    picture[~mask] = 0.0
    return Outcome((Figure("largest |z|" + beyond, test.largest, test.limit),), Picture(reference, picture))


def _rings(picture, mask, count=6):
    """Means over rings of equal area about the sphere's middle, (..., rings, 3)."""
    radius2 = 1.0 - scenes.pixel_normals(RESOLUTION)[0][:, :, 0, 2] ** 2
    which = np.minimum((radius2 * count).astype(int), count - 1)
    return np.stack([picture[..., mask & (which == ring), :].mean(axis=-2) for ring in range(count)], axis=-2)
