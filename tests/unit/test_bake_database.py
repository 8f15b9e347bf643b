"""Bakes of many datasets against an independent calculation, and how close the fits come."""

import json
import re

import colour
import numpy as np
import pytest

from addon.bake import bake
from addon.bake.colour import SPACES, adaptation, rgb_to_xyz, spectral_weights
from addon.spectra import illuminants, observers, optical_constants, tables

IDS = optical_constants.dataset_ids()
WAVELENGTH_NM = np.arange(360.0, 781.0)
METALS = [dataset for dataset in IDS if optical_constants.load(dataset).has_k
          and np.median(optical_constants.load(dataset).at(WAVELENGTH_NM)[1]) > 1.0]


def complex_fresnel(cos_theta, index):
    inside = np.sqrt(1.0 - (1.0 - cos_theta**2) / index**2)
    r_s = (cos_theta - index * inside) / (cos_theta + index * inside)
    r_p = (index * cos_theta - inside) / (index * cos_theta + inside)
    return (abs(r_s) ** 2 + abs(r_p) ** 2) / 2.0


@pytest.mark.parametrize("dataset", ["main/He/Mansfield", "other/air/Ciddor", "main/Zn/Querry",
                                     "main/C/Djurisic-o", "main/Cs/Ives", "main/Au/Babar",
                                     "main/ZnSe/Marple", "organic/SQIB/Funke-β"])
def test_the_curve_holds_between_its_points_down_to_grazing(dataset):
    cos_theta = np.linspace(0.0, 1.0, 600) ** 2
    n, k = optical_constants.load(dataset).at(WAVELENGTH_NM)
    exact = complex_fresnel(cos_theta[:, None], n + 1j * k) @ spectral_weights()
    curve = bake(dataset, gamut="leave").fresnel
    found = np.stack([np.interp(cos_theta, curve.cos_theta, channel) for channel in zip(*curve.rgb)], axis=1)
    assert np.abs(found - exact).max() <= 1e-3


def test_any_dataset_against_an_independent_calculation():
    shape = colour.SpectralShape(360, 780, 1)
    cmfs = colour.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"].copy().align(shape)
    weights = cmfs.values * colour.SDS_ILLUMINANTS["D65"].copy().align(shape).values[:, None]
    to_rgb = np.linalg.inv(colour.RGB_COLOURSPACES["ITU-R BT.709"].matrix_RGB_to_XYZ)
    weights = weights / weights[:, 1].sum() @ to_rgb.T
    cos_theta = np.linspace(0.0, 1.0, 41)[1:]
    for dataset in IDS[::40]:
        constants = optical_constants.load(dataset)
        index = (np.interp(WAVELENGTH_NM, constants.wavelength_nm, constants.n)
                 + 1j * np.interp(WAVELENGTH_NM, constants.wavelength_nm, constants.k))
        exact = complex_fresnel(cos_theta[:, None], index) @ weights
        f82 = complex_fresnel(1.0 / 7.0, index) @ weights
        baked = bake(dataset, gamut="leave")
        assert np.allclose(baked.f0, exact[-1], atol=1e-5), dataset
        schlick = exact[-1] + (1 - exact[-1]) * (6 / 7) ** 5
        assert np.allclose(baked.f82_tint, f82 / schlick, atol=2e-5), dataset
        channels = zip(*baked.fresnel.rgb)
        curve = np.array([np.interp(cos_theta, baked.fresnel.cos_theta, c) for c in channels]).T
        assert np.abs(curve - exact).max() <= 1e-3, dataset


@pytest.mark.parametrize("illuminant", "A D50 D55 D65 D75 E F2 F7 F11 LED-B3 HP1".split())
@pytest.mark.parametrize("observer", ["1931", "1964"])
def test_every_choice_of_light_and_observer_against_colour_science(illuminant, observer):
    title = f"CIE {observer} {'2' if observer == '1931' else '10'} Degree Standard Observer"
    shape = colour.SpectralShape(360, 780, 1)
    power = colour.SDS_ILLUMINANTS[illuminant.replace("F", "FL")].copy().align(shape)
    reflectance = np.linspace(0.1, 0.9, 421) ** 2
    xyz = colour.sd_to_XYZ(colour.SpectralDistribution(reflectance, WAVELENGTH_NM),
                           colour.MSDS_CMFS[title].copy().align(shape), power, method="Integration") / 100.0
    ours = rgb_to_xyz("Rec.709") @ (reflectance @ spectral_weights(illuminant, observer))
    assert np.allclose(ours, xyz, atol=1e-5)


def test_illuminants_are_all_that_colour_science_has_of_the_cie():
    theirs = {name.replace("FL", "F") for name in colour.SDS_ILLUMINANTS if not name.startswith("ISO")}
    assert set(illuminants.names()) == theirs
    assert list(map(json.loads, tables.lines("cie", "illuminants"))) == list(illuminants.names())
    assert observers.names() == ("1931", "1964")


def test_illuminants_are_what_their_titles_say():
    for name in illuminants.names():
        stated = re.search(r"(\d+) K", illuminants.title(name))
        if stated is None:
            assert name == "E"
            continue
        xyz = observers.colour_matching_functions().T @ illuminants.power(name)
        uv = colour.UCS_to_uv(colour.XYZ_to_UCS(xyz / xyz[1]))
        temperature = colour.temperature.uv_to_CCT_Ohno2013(uv)[0]
        assert temperature == pytest.approx(float(stated[1]), rel=0.01), name


@pytest.mark.parametrize("space, name", [("Rec.709", "ITU-R BT.709"), ("Rec.2020", "ITU-R BT.2020"),
                                         ("ACEScg", "ACEScg")])
def test_spaces_are_colour_sciences_with_white_adapted_to_d65(space, name):
    rng = np.random.default_rng(2)
    rgb = rng.uniform(0, 1, (20, 3))
    theirs = colour.RGB_to_XYZ(rgb, colour.RGB_COLOURSPACES[name], [0.3127, 0.3290], "Bradford")
    assert np.allclose(rgb @ rgb_to_xyz(space).T, theirs, atol=1e-4)
    assert set(SPACES) == {"Rec.709", "Rec.2020", "ACEScg"}


def test_adaptation_is_bradfords():
    xyz = np.array([0.4, 0.35, 0.2])
    white_a = observers.colour_matching_functions().T @ illuminants.power("A")
    white_a = white_a / white_a[1]
    d65 = colour.xy_to_XYZ([0.3127, 0.3290])
    adapted = colour.chromatic_adaptation(xyz, white_a, d65, transform="Bradford")
    reflectance = np.full(421, 0.5)
    ours = rgb_to_xyz() @ (reflectance @ spectral_weights("A", adapt=True))
    assert np.allclose(ours, 0.5 * d65, atol=1e-6)
    assert np.allclose(adaptation(white_a, d65) @ xyz, adapted, atol=1e-4)


def test_fits_of_metals():
    assert len(METALS) > 300
    bakes = [bake(dataset) for dataset in METALS]
    best = {b.name: min(b.conductor.delta_e_2000_max, b.f82.delta_e_2000_max) for b in bakes}
    inside = np.array([best[b.name] for b in bakes if not b.gamut.outside])
    assert np.mean(inside <= 0.2) >= 0.95
    assert max(best.values()) <= 0.7
    for baked in bakes:
        if baked.gamut.outside:
            assert baked.gamut.largest_change > 0.0
            wide = bake(baked.name, space="Rec.2020")
            assert not wide.gamut.outside, baked.name
            assert min(wide.conductor.delta_e_2000_max, wide.f82.delta_e_2000_max) <= 0.2, baked.name


@pytest.mark.parametrize("dataset", ["organic/polyvinil_chloride/Zhang", "main/C/Phillip",
                                     "main/SiO2/Malitson"])
def test_dielectrics_in_blender_4_5_take_the_closer_closure(dataset):
    approximate, exact = bake(dataset, formula="blender-4.5"), bake(dataset)
    assert exact.best == "conductor" and exact.conductor.delta_e_2000_max < 0.05
    assert approximate.conductor.delta_e_2000_max > exact.conductor.delta_e_2000_max
    errors = {"conductor": approximate.conductor.delta_e_2000_max, "f82": approximate.f82.delta_e_2000_max}
    assert approximate.best == min(errors, key=errors.get)
