"""Cycles with baked metals against the same spheres rendered spectrally by Mitsuba 3, as recorded and as it renders
now.
"""

import numpy as np
import pytest

from addon import api
from tools import compare_renderers as compare

ABOUT, REFERENCE = compare.record()
IN_GAMUT = [metal for metal in ABOUT["datasets"] if not api.bake(metal).gamut.outside]
MOST_MEAN, MOST = 0.5, 1.0
"""CIEDE2000 over the sphere, rim aside."""


def differences(material, metal, light):
    """(mean, largest) CIEDE2000 of a material from the spectral sphere of a metal."""
    perfect = REFERENCE[f"perfect/{light}"]
    picture = compare.cycles_sphere(material, light, len(perfect), np.radians(ABOUT["sun_angle"]))
    return compare.difference(picture, REFERENCE[f"{metal}/{light}"], perfect)


def passes(found):
    return found[0] <= MOST_MEAN and found[1] <= MOST


def test_at_least_eight_metals_are_in_gamut_and_recorded():
    assert len(IN_GAMUT) >= 8 and "gold" not in IN_GAMUT
    assert ABOUT["datasets"] == {metal: api.bake(metal).source.dataset for metal in ABOUT["datasets"]}


@pytest.mark.parametrize("light", compare.LIGHTS)
@pytest.mark.parametrize("metal", IN_GAMUT)
def test_baked_metal_is_the_spectral_sphere(metal, light):
    found = differences(lambda: compare.baked(metal, ABOUT["slope"]), metal, light)
    print(f"{metal}, {light}: CIEDE2000 {found[0]:.2f} mean, {found[1]:.2f} largest")
    assert passes(found)


def test_gold_is_as_near_as_the_gamut_allows():
    """Outside of Rec.709: the nearest colour inside stays below 2.0 on the mean, where the others go further."""
    sky = {gamut: differences(lambda gamut=gamut: api.create_material(
        preset="gold", slopes=[(ABOUT["slope"], 1.0)], viewing={"gamut": gamut}), "gold", "sky")
        for gamut in ("nearest", "clip", "desaturate")}
    for gamut, (mean, most) in sky.items():
        print(f"gold, sky, {gamut}: CIEDE2000 {mean:.2f} mean, {most:.2f} largest")
    assert sky["nearest"][0] <= 1.2 and sky["nearest"][1] <= 2.0
    assert sky["nearest"][0] < sky["clip"][0] < sky["desaturate"][0]
    assert differences(lambda: compare.baked("gold", ABOUT["slope"]), "gold", "sky") == sky["nearest"]


@pytest.mark.parametrize("metal", IN_GAMUT)
def test_a_metal_inside_the_gamut_is_the_same_by_any_mapping(metal):
    nearest, left = (api.bake(metal, gamut=gamut).conductor for gamut in ("nearest", "leave"))
    assert np.allclose(nearest.n, left.n, rtol=1e-3) and np.allclose(nearest.k, left.k, rtol=1e-3)


@pytest.mark.parametrize("what, material", [
    ("another slope", lambda: compare.baked("copper", 0.23)),
    ("another measurement", lambda: compare.baked("main/Cu/McPeak", 0.2)),
    ("another metal", lambda: compare.baked("brass", 0.2)),
    ("n and k at three wavelengths", lambda: compare.three_wavelengths("copper", 0.2)),
    ("published colours", lambda: compare.published("copper", 0.2))])
def test_the_comparison_fails_for(what, material):
    assert not all(passes(differences(material, "copper", light)) for light in compare.LIGHTS)


def test_mitsuba_still_renders_what_is_recorded():
    """A small sphere of one metal; its pixels, means over 4 × 4 of the recorded ones, within a per cent."""
    from tools import mitsuba_spheres
    found = mitsuba_spheres.spheres(["copper"], samples=512, resolution=8)["copper"]
    for light in compare.LIGHTS:
        recorded = REFERENCE[f"copper/{light}"].reshape(8, 4, 8, 4, 3).mean(axis=(1, 3))
        inside = slice(2, 6)
        np.testing.assert_allclose(found[light][inside, inside], recorded[inside, inside], rtol=0.08, atol=0.02)
