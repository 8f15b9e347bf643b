"""Cook-Torrance Reference without salt: no pixel of few samples shines out of its surroundings under a small lamp."""

import numpy as np
import pytest

from addon import api
from tests.render import cook_torrance_scenes as scenes
from tests.render import probes

RESOLUTION = 24
SEEDS = 10
SAMPLES = 256
MOST = 8.0
"""Local standard deviations by which a pixel may exceed what it converges to."""
FINISHES = {"default": ((0.2, 1.0),), "1982": scenes.FIGURE_6B}


def salt(pictures, mask):
    """By how many local standard deviations each pixel exceeds the mean of the other pictures, ``(seeds, pixels)``.

    pictures  of independent seeds, ``(seeds, height, width)``
    The local deviation is that of a pixel and its eight neighbours over all pictures but the one in question.
    """
    found = []
    for number, picture in enumerate(pictures):
        others = np.delete(pictures, number, axis=0)
        variance = np.pad(others.var(axis=0, ddof=1), 1, mode="edge")
        height, width = picture.shape
        local = np.mean([variance[i:i + height, j:j + width] for i in range(3) for j in range(3)], axis=0)
        found.append(((picture - others.mean(axis=0)) / np.sqrt(np.maximum(local, 1e-12)))[mask])
    return np.array(found)


def test_a_speck_is_found():
    """Of 20 local deviations, among even noise."""
    pictures = 1.0 + 0.01 * np.random.default_rng(1).standard_normal((SEEDS, 20, 20))
    everywhere = np.ones((20, 20), bool)
    assert salt(pictures, everywhere).max() < MOST
    pictures[3, 10, 10] += 0.2
    assert salt(pictures, everywhere).max() > MOST


@pytest.mark.parametrize("diameter", [0.5, 5.0])
@pytest.mark.parametrize("finish", FINISHES)
def test_no_pixel_shines_out(finish, diameter):
    scene = probes.empty_scene(RESOLUTION, samples=SAMPLES)
    probes.add_sphere(api.create_material(preset="copper", realisation="exact", slopes=FINISHES[finish]))
    probes.add_sun(scene, np.radians(45.0), diameter=np.radians(diameter))
    pictures = probes.render_seeds(scene, SEEDS)
    inside = probes.pixel_normals(RESOLUTION)[1]
    worst = salt(pictures[..., :3].mean(axis=-1), inside).max()
    assert worst <= MOST, f"{worst:.1f} local standard deviations"
