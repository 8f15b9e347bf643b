"""Tables of films: fast colours against exact ones, errors between the nodes, gamut, sizes."""

import json

import numpy as np
import pytest

from addon.bake import film_colours
from addon.bake.colour import delta_e_2000, lab, rgb_to_xyz
from addon.bake.film_gamut import desaturate_smoothly, map_film_colours
from addon.bake.film_table import curve_over_angle, film_table, smallest_table
from addon.bake.gamut import map_colours
from addon.bake.reflected import Viewing, mirror_spectra
from addon.bake.stack_notation import parse, written
from addon.errors import FacetFilmError
from addon.spectra.observers import WAVELENGTH_NM
from addon.spectra.optical_constants import load

VIEWING = Viewing()
COS_THETA = np.cos(np.radians([0.0, 35.0, 60.0, 80.0, 88.0]))
MIRROR = "water | 1.5+0.2i 5 nm / (TiO2 40-75 nm / SiO2 65-122 nm)x3 / MgF2 40 nm / Si"


@pytest.mark.parametrize("text", [
    "TiO2 0-500 nm / Ti", "soap 0-2000 nm / air", "SiO2 100 nm / main/TiO2/Siefke 0-500 nm / SiO2 80 nm / Si",
    "SiO2 100 nm / TiO2 20 nm / 2.0+3.0i 0-100 nm / glass", "TiO2 0-90 nm / MgF2 50 nm / TiO2 30-90 nm / Ti", MIRROR])
@pytest.mark.parametrize("of", ["reflected", "transmitted"])
@pytest.mark.parametrize("count", [2, 33])
def test_fast_colours_are_the_exact_ones(text, count, of):
    stack = parse(text, load)
    fast = film_colours.colours(stack, VIEWING, COS_THETA, count, of=of)
    thickness = np.linspace(*stack.thickness_range_nm, count)
    exact = film_colours.exact_colours(stack, VIEWING, COS_THETA[:, None], thickness, of)
    assert fast.shape == (5, count, 3) and np.allclose(fast, exact, atol=2e-5)


def test_fast_colours_of_a_part_of_the_range():
    stack = parse("TiO2 20-220 nm / Ti", load)
    fast = film_colours.colours(stack, VIEWING, COS_THETA, 5, 40.0, 80.0)
    exact = film_colours.exact_colours(stack, VIEWING, COS_THETA[:, None], np.array([40.0, 50.0, 60.0, 70.0, 80.0]))
    assert np.allclose(fast, exact, atol=2e-5)


def test_a_bare_surface_has_the_colours_of_the_other_bake():
    n, k = load("main/Cu/Johnson").at(WAVELENGTH_NM)
    bare = film_colours.exact_colours(parse("main/Cu/Johnson", load), VIEWING, COS_THETA, 0.0)
    assert np.allclose(bare, mirror_spectra(COS_THETA, n, k) @ VIEWING.weights, atol=1e-12)


@pytest.mark.parametrize("text, widest", [("TiO2 0-200 nm / Ti", 6), ("SiO2 0-1000 nm / Si", 6),
                                          ("SiO2 0-3000 nm / Si", 2), ("main/Si3N4/Philipp 0-5000 nm / Si", 1)])
def test_the_wavelength_step_follows_the_optical_thickness(text, widest):
    stack = parse(text, load)
    step = film_colours.step_for(stack, VIEWING, np.linspace(0.1, 1.0, 30))
    assert step == widest
    angles = np.linspace(0.12, 0.98, 9)
    fine, wide = (film_colours.colours(stack, VIEWING, angles, 50, step=s).astype(float) for s in (1, step))
    assert delta_e_2000(lab(fine), lab(wide)).max() < 0.1
    if widest == 1:
        wide = film_colours.colours(stack, VIEWING, angles, 50, step=4).astype(float)
        assert delta_e_2000(lab(fine), lab(wide)).max() > 0.5


def test_spectra_between_coarse_wavelengths_are_cubics():
    weights = VIEWING.weights
    for step, off in ((2, 3e-6), (4, 5e-5), (6, 3e-4)):
        wavelength, coarse = film_colours.coarse_weights(weights, step)
        wave, all_of_it = (np.cos(2e4 / at) for at in (wavelength, WAVELENGTH_NM))
        assert np.allclose(wave @ coarse, all_of_it @ weights, atol=off)
        cubic, all_of_it = (((at - 570.0) / 210.0) ** 3 for at in (wavelength, WAVELENGTH_NM))
        assert np.allclose(cubic @ coarse, all_of_it @ weights, atol=1e-9)


def test_a_coarse_step_with_fluorescent_light_keeps_its_lines():
    stack, lamp = parse("TiO2 0-200 nm / Ti", load), Viewing("F11")
    fine, wide = (film_colours.colours(stack, lamp, COS_THETA, 40, step=s).astype(float) for s in (1, 6))
    assert delta_e_2000(lab(fine), lab(wide)).max() < 0.1


@pytest.mark.parametrize("text, most", [
    ("TiO2 0-500 nm / Ti", 0.5), ("SiO2 0-1000 nm / Si", 0.5), ("Fe3O4 0-200 nm / Fe", 0.5),
    ("Nb2O5 0-300 nm / Nb", 0.5), ("soap 5-1000 nm / air", 1.0)])
def test_the_error_between_the_nodes_is_small_and_what_random_places_show(text, most):
    stack = parse(text, load)
    table = film_table(stack)
    assert table.size == (64, 512) and table.delta_e_2000_mean < 0.06
    assert 0.01 < table.delta_e_2000_max <= most
    rng = np.random.default_rng(2)
    cos_theta = rng.uniform(np.cos(np.radians(88.5)), 1.0, 150)
    thickness = rng.uniform(*stack.thickness_range_nm, 150)
    exact = map_film_colours(film_colours.exact_colours(stack, VIEWING, cos_theta, thickness), VIEWING)[0]
    random = delta_e_2000(lab(exact), lab(table.at(cos_theta, thickness)))
    assert random.max() < 1.3 * table.delta_e_2000_max and random.mean() < 0.06


def test_a_coarse_table_says_that_it_is_off():
    assert film_table(parse("TiO2 0-500 nm / Ti", load), rows=16, columns=64).delta_e_2000_max > 2.0


def test_the_smallest_table_that_is_good_enough():
    stack = parse("TiO2 0-120 nm / Ti", load)
    small = smallest_table(stack)
    assert small.delta_e_2000_max <= 0.5 and small.rgb.size < film_table(stack).rgb.size / 4
    assert smallest_table(stack, tolerance=0.0).size == (64, 1024) and smallest_table(stack.at(50.0)).size[1] == 1


def test_a_table_is_read_at_its_nodes_and_held_beyond_its_ends():
    table = film_table(parse("SiO2 100-300 nm / Si", load), rows=16, columns=64)
    assert np.allclose(table.at((5 / 15) ** 2, 100.0 + 200.0 * 40 / 63), table.rgb[5, 40], atol=1e-6)
    assert np.allclose(table.at(1.0, [0.0, 100.0]), table.rgb[15, 0])
    assert np.allclose(table.at(1.0, 1e5), table.rgb[15, -1])
    pixels = table.pixels()
    assert np.allclose(pixels[..., :3] ** 2, table.rgb, atol=1e-6) and np.all(pixels[..., 3] == 1.0)


@pytest.mark.parametrize("text", ["soap 5-1000 nm / air", "MgF2 0-300 nm / glass",
                                  "(TiO2 40-75 nm / SiO2 65-122 nm)x4 / glass"])
def test_what_is_seen_through_loses_nothing(text):
    """Before gamut mapping R + T is the light's white, from either side."""
    for stack in (parse(text, load), parse(text, load).from_below()):
        reflected, transmitted = (film_colours.colours(stack, VIEWING, COS_THETA, 40, of=of)
                                  for of in ("reflected", "transmitted"))
        assert np.allclose(reflected + transmitted, VIEWING.weights.sum(axis=0), atol=2e-4)
        tables = [film_table(stack, rows=16, columns=32, of=of).rgb for of in ("reflected", "transmitted")]
        assert np.allclose(sum(tables), 1.0, atol=1e-3)  # nor after it


def test_gold_on_polycarbonate_lets_green_through_and_absorbs_some():
    stack = parse("main/Au/Rosenblatt-21nm 5-50 nm / 1.585", load)
    reflected, transmitted = (film_table(stack, of=of) for of in ("reflected", "transmitted"))
    r, t = reflected.at(1.0, 25.0), transmitted.at(1.0, 25.0)
    assert t[1] > t[0] and r[0] > r[2] and np.all(r + t < 0.98)
    assert transmitted.delta_e_2000_max < 0.5 and transmitted.to_dict()["of"] == "transmitted"
    assert np.all(np.diff(transmitted.rgb[-1, :, 1]) < 0.0)
    with pytest.raises(FacetFilmError, match="did you mean 'transmitted'"):
        film_table(stack, of="transmited")
    with pytest.raises(FacetFilmError, match="must not absorb"):
        parse("SiO2 10 nm / Ti", load).from_below()


def test_where_nothing_varies_the_table_is_a_curve():
    stack = parse("TiO2 120 nm / Ti", load)
    table = film_table(stack)
    assert table.size == (64, 1) and table.thickness_range_nm == (120.0, 120.0) and table.delta_e_2000_max < 0.1
    assert np.allclose(table.at(COS_THETA, 7.0), curve_over_angle(stack, VIEWING, 120.0, COS_THETA), atol=5e-4)


def test_the_record_is_ready_for_json_and_f0_is_before_mapping():
    table = film_table(parse("TiO2 40-60 nm / Ti", load), rows=16, columns=16)
    record = json.loads(json.dumps(table.to_dict()))
    assert record["table"]["size"] == [16, 16] and record["table"]["thickness_range_nm"] == [40.0, 60.0]
    assert record["table"]["delta_e_2000_max"] == table.delta_e_2000_max
    assert record["f0"] == pytest.approx([-0.023, 0.103, 0.370], abs=1e-3)  # Rec.709 does not hold it
    assert table.rgb[-1, 0].min() >= 0.0 and record["gamut"]["outside"] > 0.02
    assert dict(map(tuple, record["gamut"]["outside_elsewhere"]))["Rec.2020"] == 0.0
    assert record["stack"] == "TiO2 40-60 nm / Ti" and record["k_left_out_outside"] == 0.0
    assert [layer["dataset"] for layer in record["layers"]] == ["1", "main/TiO2/Jolivet-anatase", "main/Ti/Palm"]


def test_water_outside_says_what_k_was_left_out():
    left_out = film_table(parse("water | MgF2 50-100 nm / glass", load), rows=16, columns=16).to_dict()
    assert 0.0 < left_out["k_left_out_outside"] < 1e-6


def test_progress_goes_from_0_to_1():
    told = []
    film_table(parse("SiO2 0-100 nm / Si", load), rows=16, columns=100, progress=told.append)
    assert told == sorted(told) and told[0] > 0.0 and told[-1] == pytest.approx(1.0) and len(told) > 10


def test_wide_spaces_hold_what_rec_709_does_not():
    stack = parse("TiO2 0-250 nm / Ti", load)
    narrow, wide = (film_table(stack, Viewing(space=space), rows=16, columns=128).gamut
                    for space in ("Rec.709", "ACEScg"))
    assert narrow.outside > 0.03 and narrow.delta_e_2000_max > 1.0
    assert wide.outside < 0.01 and dict(wide.outside_elsewhere)["Rec.709"] == pytest.approx(narrow.outside, abs=0.01)


def kink(rgb):
    """Largest second difference of L*a*b* along a gradient."""
    return np.linalg.norm(np.diff(lab(rgb), 2, axis=0), axis=1).max()


def test_smooth_desaturation_kinks_less_and_keeps_hue_and_luminance():
    stack = parse("TiO2 0-250 nm / Ti", load)
    raw = film_colours.colours(stack, VIEWING, np.ones(1), 501)[0].astype(float)
    luminance = rgb_to_xyz()[1]
    smooth, hard = desaturate_smoothly(raw, luminance), map_colours(raw)[0]
    assert smooth.min() >= 0.0 and smooth.max() <= 1.0
    assert kink(smooth) < 0.7 * kink(hard)
    assert np.allclose(smooth @ luminance, raw @ luminance, atol=1e-9)
    inside = ((raw > 0.0) & (raw < 1.0)).all(axis=-1)
    assert 0.1 < np.mean(~inside) < 0.3 and delta_e_2000(lab(raw), lab(smooth))[inside].mean() < 0.2
    away, kept = raw - (raw @ luminance)[:, None], smooth - (raw @ luminance)[:, None]
    assert np.allclose(np.cross(away, kept), 0.0, atol=1e-9)


@pytest.mark.parametrize("gamut", ["scale", "clip", "leave"])
def test_other_ways_into_the_gamut_are_as_elsewhere(gamut):
    rgb = np.array([[1.2, 0.5, -0.1], [0.3, 0.2, 0.1]])
    mapped, report = map_film_colours(rgb, Viewing(gamut=gamut))
    assert np.allclose(mapped, np.maximum(map_colours(rgb, gamut)[0], 0.0)) and report.method == gamut
    assert report.outside == 0.5


@pytest.mark.parametrize("size, said", [
    ({"rows": 4}, "rows must be a number from 8"), ({"columns": 7}, "columns must be"),
    ({"rows": 4096, "columns": 512}, "at most 1048576 entries, not 4096 × 512")])
def test_sizes_that_no_table_has(size, said):
    with pytest.raises(FacetFilmError, match=said):
        film_table(parse("SiO2 0-100 nm / Si", load), **size)


def test_thicknesses_beyond_the_range_are_refused():
    stack = parse("SiO2 50-100 nm / Si", load)
    for thickness in (49.0, 101.0, np.nan):
        with pytest.raises(FacetFilmError, match="must be from 50 to 100 nm"):
            stack.thicknesses(thickness)
    assert stack.at(75.0).films[0].high == 75.0 and not stack.at(75.0).varying


def test_from_below_the_layers_come_in_reverse():
    assert written(parse("MgF2 100 nm / TiO2 0-50 nm / glass", load).from_below()) == \
        "glass | TiO2 0-50 nm / MgF2 100 nm / air"


def test_films_that_vary_together_share_the_sum():
    stack = parse("(TiO2 40-75 nm / SiO2 60-120 nm)x2 / MgF2 10 nm / glass", load)
    assert stack.thickness_range_nm == (200.0, 390.0)
    assert stack.thicknesses(295.0) == [57.5, 90.0, 57.5, 90.0, 10.0]
