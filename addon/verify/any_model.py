"""The checks that any model has to pass: what its groups render, held against its own `evaluate`.

A model with a file of checks of its own, <model>_checks.py, is held to that one instead.
"""

import functools

import numpy as np

from ..blender.datablocks import materials
from ..models import named
from ..models.making import made
from . import scenes
from .checks import Check, Figure, Outcome, Picture

__all__ = ["checks"]

RESOLUTION, SAMPLES, SEEDS = 24, 256, 4
SUN = np.radians(45.0), np.radians(30.0)
"""Angle and diameter of the sun: soft, so that a formula drawn by mirrors is lit by it."""
WORTH_COMPARING = 0.05
"""Of the brightest pixel: darker ones are left out."""
MOST = 0.05
"""Relative difference in the mean of a ring; closures that only come near their formula need a bar of their own."""
RINGS = 6


def checks(model, realisations):
    """The checks of a model, by its name, in these realisations."""
    what = ("a sphere under a sun of 30° at 45° against evaluate(): largest relative difference in the means of six "
            "rings")
    measure = functools.partial(soft_sun, model=model)
    return [Check(model, realisation, "sphere under a soft sun", what, measure) for realisation in realisations]


def soft_sun(realisation, rendered, parameters, *, model):
    """Means of rings, which noise does not move much."""
    record = made(model, realisation=realisation, **rendered)
    formula = named(model).parameters().changed(**parameters)
    scene = scenes.empty_scene(RESOLUTION, samples=SAMPLES, osl=realisation.startswith("osl"))
    scenes.add_sphere(materials.create(record))
    angle, diameter = SUN
    towards = scenes.add_sun(scene, angle, diameter=diameter)
    picture = scenes.render_seeds(scene, SEEDS).mean(axis=0)
    reference, mask = _reference(named(model).evaluate, formula, towards, diameter)
    picture[~mask] = 0.0
    found, expected = _rings(picture, mask), _rings(reference, mask)
    bright = expected > WORTH_COMPARING * expected.max()
    largest = float(np.abs(found / np.maximum(expected, 1e-9) - 1.0)[bright].max())
    return Outcome((Figure("largest difference from the formula", largest, MOST, True),), Picture(reference, picture))


def _reference(evaluate, parameters, towards, diameter):
    """(the sphere under a sun of irradiance 1, the mask of pixels wholly on it)."""
    normals, mask = scenes.pixel_normals(RESOLUTION, subsamples=3)
    picture = np.zeros((RESOLUTION, RESOLUTION, 3))
    n = normals[mask]
    view = np.broadcast_to(scenes.VIEW, n.shape)
    for light, irradiance in zip(*scenes.sun_directions(towards, diameter, rings=4)):
        cosine = np.maximum(n @ light, 0.0)[..., None]
        brdf = evaluate(parameters, n, view, np.broadcast_to(light, n.shape))
        picture[mask] += irradiance * (brdf * cosine).mean(axis=1)
    return picture, mask


def _rings(picture, mask):
    """Means over rings of equal area about the sphere's middle, ``(RINGS, 3)``."""
    at = (np.arange(RESOLUTION) + 0.5) / RESOLUTION * 2.0 - 1.0
    y, x = np.meshgrid(at, at, indexing="ij")
    which = np.minimum(((x * x + y * y) * RINGS).astype(int), RINGS - 1)
    return np.stack([picture[mask & (which == ring)].mean(axis=0) for ring in range(RINGS)])
