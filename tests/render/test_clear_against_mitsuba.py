"""Clear materials in Cycles against Mitsuba's pictures, a wavelength at a time, as recorded and as it renders now."""

import numpy as np
import pytest

from addon import api
from addon.verify import scenes
from tools import compare_clear as compare
from tools.clear_scenes import SCENES

ABOUT, REFERENCE = compare.record()
SAMPLES, BLOCK = {"brilliant": 2048}, 4
"""So few samples have noise besides: means of blocks are compared; tools/compare_clear.py compares pixels."""


def off(name, make):
    scene = compare.cycles_scene(name, lambda *_: make(SCENES[name]().material), len(REFERENCE[name]),
                                 SAMPLES.get(name, 256))
    return compare.difference(scenes.render_seeds(scene, 2), REFERENCE[name], BLOCK)


@pytest.mark.parametrize("name", compare.MOST)
def test_dispersive_is_the_spectral_picture(name):
    found = off(name, compare.dispersive)
    print(f"{name}: mean CIEDE2000 {found:.2f}")
    assert found <= compare.MOST[name]


def test_a_brilliant_has_half_the_noise_of_three_glasses():
    """Each path has its one wavelength, whatever it meets inside."""
    def noise(make):
        scene = compare.cycles_scene("brilliant", lambda *_: make("diamond"), len(REFERENCE["brilliant"]), 256)
        return compare.noise(scenes.render_seeds(scene, 2))
    found = noise(compare.dispersive) / noise(compare.three_glasses)
    print(f"brilliant: {found:.2f} times the noise of three Glass BSDFs")
    assert found <= compare.MOST_NOISE


def test_the_comparison_fails_for_one_index():
    assert off("prism", compare.standard) > 2.0 * compare.MOST["prism"]


def test_water_in_a_glass_is_one_common_face():
    reference = REFERENCE["water in a glass"]
    picture = compare.water_in_a_glass(reference.shape[1], 512)
    assert compare.column_error(picture, reference) <= compare.MOST_COLUMN


def test_a_frosted_ball_has_its_lamps_once():
    """Whether shadows go straight or not; Mitsuba's roughdielectric of the same slope gives the mean."""
    import mitsuba

    from tools import compare_rough_glass
    mitsuba.set_variant("scalar_rgb")
    slope, index = 0.35, 2.417
    expected = compare_rough_glass.mitsuba_ball(slope, index, 1, samples=64).mean()
    for straight in (0.0, 1.0):
        scene = compare.cycles_scene("ball", lambda *_, s=straight: api.create_material(
            "clear", realisation="fast", roughness=slope**0.5, ior=index, see_through=s), 32, 64)
        assert scenes.render(scene, 1).mean() == pytest.approx(expected, rel=0.03)


def test_mitsuba_still_renders_what_is_recorded():
    import mitsuba

    from tools import mitsuba_clear
    mitsuba.set_variant("scalar_rgb")
    found = mitsuba_clear.nested(resolution=24, samples=256)
    recorded = REFERENCE["water in a glass"].reshape(6, 4, 24, 4).mean(axis=(1, 3))
    assert np.abs((found - recorded).mean(axis=0)).max() < 0.03
