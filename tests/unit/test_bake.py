"""Baking against colour-science and against plain loops."""

import colour
import numpy as np
import pytest

from addon.bake import bake
from addon.bake.colour import delta_e_2000, lab, rgb_to_xyz
from addon.bake.curve import knots
from addon.bake.gamut import METHODS, map_colours
from addon.bake.reflected import COMPARED, Viewing, reflect
from addon.errors import FacetFilmError
from addon.models.making import made
from addon.reflectance import fresnel
from addon.spectra import optical_constants

SHAPE = colour.SpectralShape(360, 780, 1)
CMFS = colour.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"].copy().align(SHAPE)
D65 = colour.SDS_ILLUMINANTS["D65"].copy().align(SHAPE)


def independent_rgb(dataset, cos_theta, space="ITU-R BT.709"):
    """Linear RGB by colour-science, of the conductor equation in complex numbers."""
    constants = optical_constants.load(dataset)
    index = (np.interp(SHAPE.wavelengths, constants.wavelength_nm, constants.n)
             + 1j * np.interp(SHAPE.wavelengths, constants.wavelength_nm, constants.k))
    inside = np.sqrt(1.0 - (1.0 - cos_theta**2) / index**2)
    r_s = (cos_theta - index * inside) / (cos_theta + index * inside)
    r_p = (index * cos_theta - inside) / (index * cos_theta + inside)
    reflectance = (abs(r_s) ** 2 + abs(r_p) ** 2) / 2.0
    xyz = colour.colorimetry.msds_to_XYZ_integration(reflectance[None], CMFS, D65, shape=SHAPE)[0] / 100.0
    return np.linalg.inv(colour.RGB_COLOURSPACES[space].matrix_RGB_to_XYZ) @ xyz


@pytest.mark.parametrize("dataset", ["main/Cu/Johnson", "main/Au/Babar", "organic/polyvinil_chloride/Zhang"])
def test_f0_f82_and_the_curve_against_colour_science(dataset):
    baked = bake(dataset, gamut="leave")
    f0, f82 = independent_rgb(dataset, 1.0), independent_rgb(dataset, 1.0 / 7.0)
    assert np.allclose(baked.f0, f0, atol=1e-5)
    assert np.allclose(baked.f82_tint, f82 / (f0 + (1 - f0) * (6 / 7) ** 5), atol=1e-5)
    for cos_theta in np.linspace(0.003, 0.997, 60):
        curve = baked.fresnel
        from_curve = [np.interp(cos_theta, curve.cos_theta, channel) for channel in zip(*curve.rgb)]
        assert np.allclose(from_curve, independent_rgb(dataset, cos_theta), atol=1e-3)


def test_the_copper_fit_looks_like_copper():
    baked = bake("copper")
    assert baked.conductor.delta_e_2000_max <= 0.2
    assert not baked.gamut.outside
    cos_theta = np.cos(np.radians(np.arange(90.0)))[:, None]
    fitted = fresnel.conductor(cos_theta, np.array(baked.conductor.n), np.array(baked.conductor.k))
    exact = np.array([independent_rgb("main/Cu/Johnson", c) for c in cos_theta[:, 0]])
    matrix = colour.RGB_COLOURSPACES["ITU-R BT.709"].matrix_RGB_to_XYZ
    labs = [colour.XYZ_to_Lab(rgb @ matrix.T, [0.3127, 0.3290]) for rgb in (exact, fitted)]
    assert colour.delta_E(*labs, method="CIE 2000").max() < baked.conductor.delta_e_2000_max + 0.03


def test_gold_is_out_of_rec_709_and_says_so():
    baked = bake("gold")
    assert baked.gamut.outside and baked.gamut.method == "nearest" and baked.gamut.largest_change > 0.05
    assert max(baked.f0) > 1.0
    assert np.max(baked.fresnel.rgb) <= 1.0 and max(baked.normal_rgb) <= 1.0
    wide = bake("gold", space="Rec.2020")
    assert not wide.gamut.outside and wide.conductor.delta_e_2000_max <= 0.2


def test_desaturation_keeps_luminance_and_dominant_wavelength():
    rgb = np.array([[1.2, 0.6, 0.1], [0.5, -0.1, 0.3], [0.2, 0.3, 0.4]])
    mapped, report = map_colours(rgb, "desaturate")
    luminance = rgb_to_xyz("Rec.709")[1]
    assert np.allclose(mapped @ luminance, rgb @ luminance)
    neutral = (rgb @ luminance)[:, None]
    for before, after in zip(rgb - neutral, mapped - neutral):
        assert np.allclose(np.cross(before, after), 0.0, atol=1e-12) and before @ after > 0.0
    assert np.allclose(mapped[2], rgb[2]) and report.outside
    assert mapped.min() >= 0.0 and mapped.max() <= 1.0


@pytest.mark.parametrize("space", ["Rec.709", "ACEScg"])
def test_nearest_is_the_colour_inside_that_looks_most_alike(space):
    """Against a search over the faces of the cube, for colours as far outside as measured metals and films are."""
    rng = np.random.default_rng(3)
    rgb = np.array([[1.059, 0.773, 0.307], [1.1, 0.6, -0.02], [0.5, -0.03, 0.3], [1.05, 1.02, 0.9], [-0.02, 0.3, 1.02],
                    [0.2, 0.3, 0.4]])
    mapped, report = map_colours(rgb, "nearest", space)
    assert report.outside and mapped.min() >= 0.0 and mapped.max() <= 1.0
    assert np.array_equal(mapped[-1], rgb[-1])
    found = delta_e_2000(lab(mapped, space), lab(rgb, space))
    near = np.clip(mapped[:, None] + rng.normal(0.0, 0.02, (6, 20000, 3)), 0.0, 1.0)
    best = delta_e_2000(lab(near, space), lab(rgb, space)[:, None]).min(axis=1)
    assert np.all(found <= 1.02 * best + 0.02), (found, best)


def test_gold_looks_more_alike_by_nearest_than_by_any_other_method():
    exact = reflect("gold", Viewing(gamut="leave"))
    target = lab(exact.mapped, "Rec.709")

    def mean(method):
        mapped = reflect("gold", Viewing(gamut=method)).mapped
        return delta_e_2000(lab(mapped, "Rec.709"), target)[COMPARED].mean()
    assert mean("nearest") < 0.4 < 0.6 < mean("clip") < mean("scale") < mean("desaturate")


def test_a_material_inside_the_gamut_is_the_same_by_every_method():
    for method in METHODS:
        assert np.allclose(reflect("copper", Viewing(gamut=method)).mapped, reflect("copper").mapped, atol=3e-4)


def test_knots_are_enough_and_not_too_many():
    x = np.linspace(0.0, 1.0, 60)
    y = np.stack([x**4, np.sqrt(x)], axis=1)
    kept = knots(x, y, 1e-2)
    lines = np.stack([np.interp(x, x[kept], channel[kept]) for channel in y.T], axis=1)
    assert np.abs(lines - y).max() <= 1e-2
    assert len(knots(x, np.stack([x, 1 - x], axis=1), 1e-5)) == 2


def test_ciede2000_is_colour_sciences():
    rng = np.random.default_rng(1)
    a = rng.uniform([0, -100, -100], [100, 100, 100], (500, 3))
    b = a + rng.normal(0, 20, (500, 3))
    a[:3, 1:] = 0.0
    assert np.allclose(delta_e_2000(a, b), colour.delta_E(a, b, method="CIE 2000"), atol=1e-9)


def test_white_is_white_in_every_space():
    for space in ("Rec.709", "Rec.2020", "ACEScg"):
        mirror = optical_constants.OpticalConstants([400.0, 700.0], [1.0, 1.0], [1e7, 1e7], "mirror")
        assert np.allclose(bake(mirror, space=space).f0, 1.0, atol=5e-4)
    assert np.allclose(bake(mirror, illuminant="A", adapt=True, gamut="leave").f0, 1.0, atol=5e-4)
    assert np.allclose(lab(np.ones(3), "ACEScg"), [100.0, 0.0, 0.0], atol=1e-9)


@pytest.mark.parametrize("options", [{"space": "P3"}, {"illuminant": "D66"}, {"observer": "1965"},
                                     {"gamut": "cut"}, {"formula": "blender"}])
def test_unknown_choices_are_clear_errors(options):
    (name, value), = options.items()
    with pytest.raises(FacetFilmError, match=f"{name} {value!r}"):
        bake("copper", **options)


def test_an_unknown_preset_is_answered_with_what_fits_its_words():
    with pytest.raises(FacetFilmError, match="did you mean 'copper'"):
        bake("coper")
    with pytest.raises(FacetFilmError, match="'main/Au/Werner'"):
        bake("gold werner")
    with pytest.raises(FacetFilmError, match="did you mean .main/Cu/"):
        bake("main/Cu")
    for nothing in ("", " ", None, 3):
        with pytest.raises(FacetFilmError):
            bake(nothing)


def test_the_record_has_the_documented_keys():
    record = bake("copper").to_dict()
    assert set(record) >= {"name", "title", "kind", "source", "illuminant", "observer", "space", "f0",
                           "f82_tint", "conductor", "f82", "fresnel", "gamut"}
    assert set(record["source"]) >= {"dataset", "citation", "licence", "wavelength_range_nm"}
    assert set(record["conductor"]) == {"n", "k", "formula", "delta_e_2000_max"}
    assert set(record["f82"]) == {"f0", "tint", "delta_e_2000_max"}
    assert set(record["fresnel"]) == {"cos_theta", "rgb"}
    assert set(record["gamut"]) == {"outside", "method", "largest_change"}


def test_a_preset_brings_the_parameters_of_its_material():
    plastic = made(preset="figure_6a").parameters
    assert plastic.specular == 0.1 and plastic.slopes == ((0.15, 1.0),)
    assert np.allclose(plastic.diffuse, bake("copper").normal_rgb)
    assert np.allclose(plastic.n, bake("vinyl").conductor.n, rtol=1e-12, atol=0.0)
    metal = made(preset="copper", viewing={"space": "ACEScg"}).parameters
    assert np.allclose(metal.diffuse, bake("copper", space="ACEScg").normal_rgb)


@pytest.mark.parametrize("options, canonical", [
    ({"space": "rec709"}, "Rec.709"), ({"space": "sRGB"}, "Rec.709"), ({"space": "Linear Rec.709"}, "Rec.709"),
    ({"space": "acescg"}, "ACEScg"), ({"space": "AP1"}, "ACEScg"), ({"space": "BT.2020"}, "Rec.2020"),
    ({"observer": 2}, "1931"), ({"observer": "10°"}, "1964"), ({"illuminant": "TL84"}, "F11"),
    ({"illuminant": "CWF"}, "F2"),
    ({"illuminant": "Illuminant A"}, "A"), ({"illuminant": "led-b3"}, "LED-B3")])
def test_spaces_observers_and_illuminants_as_people_write_them(options, canonical):
    (name, _), = options.items()
    assert getattr(bake("copper", **options), name) == canonical


@pytest.mark.parametrize("space, nearest", [
    ("P3", "Rec.2020"), ("Display P3", "Rec.2020"), ("ACES2065-1", "ACEScg"), ("AP0", "ACEScg")])
def test_a_space_that_is_not_there_is_answered_with_the_nearest(space, nearest):
    with pytest.raises(FacetFilmError, match=f"did you mean '{nearest}'"):
        bake("copper", space=space)


def test_gold_in_water_and_under_lacquer():
    """In air it is 1.038 .728 .365; worked out apart: |(n + ik - m)/(n + ik + m)|² at every nm."""
    in_water = (1.031, 0.687, 0.285)
    for medium, f0 in ((1.333, in_water), ("main/H2O/Hale", in_water), (1.5, (1.027, 0.673, 0.260))):
        baked = bake("main/Au/Johnson", medium=medium)
        assert np.allclose(baked.f0, f0, atol=1.5e-3) and baked.medium == medium
    assert bake("main/Au/Johnson", medium="air").f0 == bake("main/Au/Johnson").f0
    glass = optical_constants.OpticalConstants([400.0, 700.0], [1.5, 1.5], [0.0, 0.0], "glass")
    assert np.allclose(bake(glass, medium=1.5).f0, 0.0, atol=1e-9)
    assert np.allclose(bake(glass, medium=1.333).f0, ((1.5 - 1.333) / (1.5 + 1.333)) ** 2, atol=1e-6)
    air = optical_constants.OpticalConstants([400.0, 700.0], [1.0, 1.0], [0.0, 0.0], "air")
    bubble = bake(air, medium=1.333, gamut="leave")
    assert np.allclose(bubble.fresnel.rgb[0], 1.0, atol=1e-3)
    assert np.allclose(bubble.f0, (0.333 / 2.333) ** 2, atol=1e-5)


@pytest.mark.parametrize("medium, says", [
    ("gold", "absorbs light"), ("main/Au/Johnson", "absorbs light"), (0.5, "from 1 to 4"), (True, "from 1 to 4"),
    (float("nan"), "from 1 to 4"), ("xyzzy", "unknown")])
def test_a_medium_that_cannot_be_outside_is_refused_in_a_sentence(medium, says):
    with pytest.raises(FacetFilmError, match=says):
        bake("copper", medium=medium)


def test_a_reflectance_alone_says_nothing_of_another_medium():
    mirror = optical_constants.from_normal_reflectance([400.0, 700.0], [0.9, 0.9], "mirror", title="Mirror")
    with pytest.raises(FacetFilmError, match="Mirror is known by its reflectance in air alone"):
        bake(mirror, medium=1.333)
