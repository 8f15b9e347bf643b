"""Cook-Torrance Reference without salt: no pixel of few samples shines out of its surroundings under a small lamp."""

import numpy as np
import pytest

from addon import api
from addon.blender.datablocks import groups
from addon.models.cook_torrance import exact
from tests.render import cook_torrance_scenes as scenes
from tests.render import probes
from tests.salt import MOST, salt

RESOLUTION = {"default": 16, "1982": 32, "brushed": 16}
"""The rougher, the rarer are the facets that a lamp lights, and the more samples find a speck."""
SEEDS = 12
SAMPLES = 256
FINISHES = {"default": {}, "1982": {"slopes": scenes.FIGURE_6B},
            "brushed": {"slopes": ((0.2, 1.0),), "anisotropy": 0.8}}


def worst_pixel(finish, diameter, realisation="exact"):
    """Of a copper sphere under a sun of this diameter in degrees, in local standard deviations."""
    scene = probes.empty_scene(RESOLUTION[finish], samples=SAMPLES, osl=realisation == "osl")
    probes.add_sphere(api.create_material(preset="copper", realisation=realisation, **FINISHES[finish]), 64)
    probes.add_sun(scene, np.radians(45.0), diameter=np.radians(diameter))
    pictures = probes.render_seeds(scene, SEEDS)[..., :3].mean(axis=-1)
    return salt(pictures, probes.pixel_normals(RESOLUTION[finish])[1]).max()


def test_a_speck_is_found():
    """Of 20 local deviations, among even noise."""
    pictures = 1.0 + 0.01 * np.random.default_rng(1).standard_normal((SEEDS, 20, 20))
    everywhere = np.ones((20, 20), bool)
    assert salt(pictures, everywhere).max() < MOST
    pictures[3, 10, 10] += 0.2
    assert salt(pictures, everywhere).max() > MOST


@pytest.mark.parametrize("finish, diameter, realisation", [
    *((finish, diameter, "exact") for finish in FINISHES for diameter in (0.5, 5.0)),
    ("1982", 5.0, "osl")])
def test_no_pixel_shines_out(finish, diameter, realisation):
    worst = worst_pixel(finish, diameter, realisation)
    assert worst <= MOST, f"{worst:.1f} local standard deviations"


def test_facets_drawn_as_d_has_them_leave_salt(monkeypatch):
    """What bounds a sample is that facets are drawn from the flanks: without that the test above would fail."""
    monkeypatch.setattr(exact, "FLANKS", 0.0)
    monkeypatch.setattr(groups, "_from_library", lambda group: None)
    assert worst_pixel("1982", 0.5) > MOST
