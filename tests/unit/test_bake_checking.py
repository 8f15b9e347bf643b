"""The checker, the spread of measurements, and the paper's own ways."""

import numpy as np
import pytest

from addon.bake import bake, check, spread, ways
from addon.errors import FacetFilmError
from addon.reflectance import fresnel
from addon.spectra.optical_constants import OpticalConstants, load


def test_a_bakes_own_fit_checks_as_the_bake_says():
    baked = bake("copper")
    checked = check("copper", n=baked.conductor.n, k=baked.conductor.k)
    assert checked.delta_e_2000_max == pytest.approx(baked.conductor.delta_e_2000_max, abs=1e-9)
    assert np.allclose(checked.against_f0, baked.normal_rgb)
    checked = check("copper", f0=baked.f82.f0, tint=baked.f82.tint)
    assert checked.delta_e_2000_max == pytest.approx(baked.f82.delta_e_2000_max, abs=1e-9)
    assert np.allclose(checked.f0, baked.f82.f0) and np.allclose(checked.f82_tint, baked.f82.tint)


def test_a_material_against_itself_is_nothing_off():
    assert check("gold", preset="gold").delta_e_2000_max == 0.0
    assert check("gold", preset="main/Au/Johnson").delta_e_2000_max > 1.0


@pytest.mark.parametrize("given", [{}, {"n": (1, 1, 1)}, {"n": (1, 1, 1), "k": (1, 1)},
                                   {"n": (1, 0, 1), "k": (1, 1, 1)}, {"n": (1, 1, 1), "k": (1, -1, 1)},
                                   {"f0": (5, 1, 1.5)}, {"f0": "#ffd9"},
                                   {"f0": "gold"}, {"f0": (256, 0, 0)}, {"f0": (float("nan"), 1, 1)},
                                   {"f0": (1, 1, 1), "preset": "gold"}])
def test_wrong_parameters_are_clear_errors(given):
    with pytest.raises(FacetFilmError):
        check("gold", **given)


def test_gold_differs_from_lab_to_lab():
    found = spread("gold")
    assert found.reference == "main/Au/Babar" and len(found.measurements) > 20
    assert found.measurements[0].dataset == "main/Au/Babar" and found.measurements[0].delta_e_2000_max == 0.0
    assert found.farthest_delta_e_2000 > 5.0
    assert all(load(measurement.dataset).has_k for measurement in found.measurements)
    assert spread("tungsten").material == "Tungsten"
    with pytest.raises(FacetFilmError):
        spread("xyzzyq")
    with pytest.raises(FacetFilmError, match="no dataset of the database"):
        spread(OpticalConstants([400.0, 700.0], [1.5, 1.5], [0.0, 0.0], "mine.csv"))


def test_ways_of_a_grey_dielectric_agree():
    """Where n is the same at every wavelength and k is 0, the paper's short cuts are exact."""
    glass = OpticalConstants([360.0, 780.0], [1.5, 1.5], [0.0, 0.0], "glass")
    found = {way.name: way for way in ways(glass).ways}
    for name in ("exact", "normal_reflectance", "colour_shift", "three_wavelengths"):
        assert found[name].delta_e_2000_max < 0.05, name
    assert found["schlick"].delta_e_2000_max > 1.0


def test_the_papers_ways_by_hand_for_copper():
    """Both short cuts are exact at 0°; the colour shift by hand at 89°."""
    found = {way.name: way for way in ways("copper").ways}
    normal = np.array(found["exact"].rgb[0])
    for name in ("normal_reflectance", "colour_shift", "schlick"):
        assert np.allclose(found[name].rgb[0], normal, atol=1e-12)
    n, k = load("main/Cu/Johnson").at(np.arange(360.0, 781.0))
    average = np.mean(((n - 1) ** 2 + k**2) / ((n + 1) ** 2 + k**2))
    index = (1 + np.sqrt(average)) / (1 - np.sqrt(average))
    f = float(fresnel.dielectric(np.cos(np.radians(89.0)), index))
    by_hand = normal + (np.array([1, 1, 1]) - normal) * max(0.0, f - average) / (1 - average)
    assert np.allclose(found["colour_shift"].rgb[89], by_hand, atol=3e-4)


def test_baking_from_the_normal_reflectance_alone():
    exact, paper = bake("main/Cu/Johnson"), bake("main/Cu/Johnson", from_normal_reflectance=True)
    assert np.allclose(exact.f0, paper.f0, atol=1e-12)
    assert not np.allclose(exact.f82_tint, paper.f82_tint, atol=0.05)
    measured = OpticalConstants([400.0, 700.0], [11.0, 11.0], [0.0, 0.0], "r", normal_only=True)
    assert np.allclose(bake(measured).f0, (10 / 12) ** 2, atol=1e-3)


def test_a_colour_is_taken_as_people_have_it():
    """Linear numbers above one, as of gold outside the gamut; sRGB as hex and from 0 to 255."""
    gold = bake("gold")
    assert max(gold.f0) > 1.0 and check("gold", f0=gold.f0, tint=gold.f82_tint).delta_e_2000_normal < 0.05
    assert check("gold", f0=(0.9, 0.7, 0.3), tint=(1.1, 1.0, 1.0)).delta_e_2000_max > 0.0
    by_hex, by_bytes = check("gold", f0="#ffd98b"), check("gold", f0=(255, 217, 139))
    assert by_hex.f0 == by_bytes.f0 and np.allclose(by_hex.f0, (1.0, 0.694, 0.258), atol=1e-3)
    wide = check("gold", f0="#ffd98b", space="Rec.2020")
    assert wide.delta_e_2000_normal == pytest.approx(check("gold", f0="#ffd98b", space="Rec.2020").delta_e_2000_normal)
    assert abs(wide.f0[0] - 1.0) > 0.02
