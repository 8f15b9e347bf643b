"""Fits of measured BRDFs: seeded parameters come back from files, and what is reported is so."""

import json
import os
from pathlib import Path

import numpy as np
import pytest
from brdf_files import container, merl_bytes, points_text, rgl_fields

from addon.bake.colour import delta_e_2000, lab
from addon.bake.film_curve import curve_in_words, curve_table, knots_of
from addon.catalogue.presets import Preset
from addon.catalogue.resolving import resolve
from addon.cli import main
from addon.errors import FacetFilmError
from addon.measured import fit, fit_steps, read_brdf
from addon.measured.ball import ball
from addon.measured.forms import form_of
from addon.measured.lights import FITTED, HELD_OUT, LIGHTS
from addon.measured.reading import read_brdf_bytes
from addon.models import named
from addon.models.film.fits import DEGREES
from addon.models.film.formulas import slopes_of
from addon.models.making import made
from addon.models.record import from_dict
from addon.reflectance.fresnel import conductor

UP = np.array([0.0, 0.0, 1.0])
FOLDER = os.environ.get("FACET_FILM_BRDF_FOLDER", "")
"""Of real .bsdf files whose fits have to be as good as is promised; none where nothing is said."""
REAL = sorted(Path(FOLDER).glob("*_rgb.bsdf")) if FOLDER else []


def surface(model="cook_torrance", **parameters):
    checked = named(model).parameters(**parameters)
    return checked, lambda v, l: named(model).evaluate(checked, UP, v, l)


def seeded(seed, slopes, fresnel, distribution="beckmann"):
    """Parameters of a surface, by chance: slopes apart, no share next to nothing."""
    rng = np.random.default_rng(seed)
    m = 0.12 * np.cumprod(rng.uniform(1.7, 2.2, slopes))
    w = rng.uniform(0.4, 0.7, slopes)
    n = rng.uniform(1.4, 2.2, 3) if fresnel == "f0" else rng.uniform(0.5, 1.2, 3)
    k = np.zeros(3) if fresnel == "f0" else rng.uniform(1.5, 3.0, 3)
    return {"n": tuple(n), "k": tuple(k), "specular": rng.uniform(0.4, 0.8), "diffuse": tuple(rng.uniform(0.1, 0.9, 3)),
            "slopes": tuple(zip(m, w / w.sum())), "distribution": distribution}


def flat(parameters, names=("n", "k", "specular", "diffuse", "slopes")):
    return np.concatenate([np.ravel(getattr(parameters, name)) for name in names])


@pytest.mark.parametrize("seed, slopes, fresnel, distribution", [
    (1, 1, "f0", "beckmann"), (2, 2, "f0", "beckmann"), (3, 3, "f0", "beckmann"), (4, 1, "n_k", "beckmann"),
    (5, 2, "n_k", "beckmann"), (6, 2, "f0", "gaussian"), (7, 1, "n_k", "gaussian")])
def test_seeded_parameters_come_back_from_points(seed, slopes, fresnel, distribution):
    wanted, brdf = surface(**seeded(seed, slopes, fresnel, distribution))
    measurement = read_brdf_bytes(points_text(brdf, 900, seed).encode(), "x.txt")
    found = fit(measurement, fresnel=fresnel, slopes=slopes, distribution=distribution)
    np.testing.assert_allclose(flat(found.parameters), flat(wanted), atol=1e-3)
    assert found.mean < 0.02 and found.verdict == "alike"


@pytest.mark.parametrize("seed, slopes, fresnel", [(8, 2, "f0"), (4, 1, "n_k"), (3, 3, "f0")])
def test_seeded_parameters_come_back_from_a_binary(seed, slopes, fresnel):
    wanted, brdf = surface(**seeded(seed, slopes, fresnel))
    found = fit(read_brdf_bytes(merl_bytes(brdf), "x.binary"), fresnel=fresnel, slopes=slopes)
    np.testing.assert_allclose(flat(found.parameters), flat(wanted), atol=1e-3)
    assert found.form == "MERL" and found.mean < 0.1


@pytest.mark.parametrize("seed, slopes, fresnel", [(9, 1, "f0"), (2, 2, "f0"), (3, 3, "f0"), (4, 1, "n_k"),
                                                   (5, 2, "n_k")])
def test_seeded_parameters_come_back_from_a_bsdf(seed, slopes, fresnel):
    """All of them, from a coarse file: what is fitted to are the file's own entries, not what lies between them."""
    wanted, brdf = surface(**seeded(seed, slopes, fresnel))
    found = fit(read_brdf_bytes(container(rgl_fields(brdf, angles=12, side=32)), "x.bsdf"), fresnel=fresnel,
                slopes=slopes)
    np.testing.assert_allclose(flat(found.parameters), flat(wanted), atol=1e-3)


def test_n_and_k_are_of_a_body_no_thinner_than_air():
    """Blender 4.5's conductor misses thinner ones by far."""
    form = form_of("n_k")
    rng = np.random.default_rng(1)
    for _ in range(50):
        p = form.checked(rng.uniform(form.low, form.high))
        assert np.all(np.square(p.n) + np.square(p.k) > 1.0 - 1e-6)


@pytest.mark.parametrize("second", [{}, {"second_ratio": 2.5, "second_weight": 0.4}])
def test_a_curve_comes_back(second):
    rows = 0.6 + 0.3 * np.cos(np.radians(DEGREES)[:, None] * 2.0 + (0.0, 1.0, 2.0))
    wanted, brdf = surface("film", stack=curve_in_words(DEGREES, rows), roughness=0.45, specular=0.8,
                           diffuse=(0.3, 0.5, 0.2), **second)
    found = fit(read_brdf_bytes(points_text(brdf, 1500).encode(), "x.txt"), fresnel="curve", slopes=1 + bool(second))
    assert found.model == "film"
    # s F and (1 − s) Rd are what is seen: F is free at every angle, so that it may be larger and s smaller.
    seen = [np.r_[np.ravel(slopes_of(p)), (1.0 - p.specular) * np.array(p.diffuse),
                  p.specular * knots_of(p.stack)[1][:6].ravel()] for p in (found.parameters, wanted)]
    np.testing.assert_allclose(*seen, atol=1e-3)


def test_noise_of_five_per_cent_is_borne_by_four_hundred_points():
    _, brdf = surface(**seeded(2, 2, "f0"))
    found = fit(read_brdf_bytes(points_text(brdf, 400, noise=0.05).encode(), "x.txt"), fresnel="f0")
    assert found.used == 400
    shown = ball(12, 24, 32, 24)
    off = shown.differences(shown.of_brdf(brdf), named(found.model).evaluate(found.parameters, UP, shown.v, shown.l),
                            HELD_OUT)
    assert shown.mean(off) < 1.0


def test_the_shares_sum_to_one_at_most():
    """A diffuse part and a mirror that reflect more than arrives are not to be had."""
    def too_bright(v, l):
        return surface(specular=0.98, n=(3.0,) * 3, k=(3.0,) * 3)[1](v, l) + 0.9 / np.pi
    p = fit(read_brdf_bytes(points_text(too_bright).encode(), "x.txt")).parameters
    assert p.specular + (1.0 - p.specular) * max(p.diffuse) <= 1.0 + 1e-9
    assert sum(w for _, w in getattr(p, "slopes", ((0.1, 1.0),))) <= 1.0 + 1e-9


@pytest.mark.parametrize("fresnel", ["f0", "n_k", "curve"])
def test_what_the_search_moves_is_what_the_model_evaluates(fresnel):
    form = form_of(fresnel, 3)
    p = form.low + 0.4 * (form.high - form.low)
    v, l = ball(8, 8, 8, 8).v, ball(8, 8, 8, 8).l
    np.testing.assert_array_equal(form.evaluate(p, v, l), form.model.evaluate(form.checked(p), UP, v, l))


@pytest.fixture(scope="module")
def wrap(tmp_path_factory):
    """A file of a wrap whose colour changes with the angle, and its fit."""
    rows = 0.5 + 0.4 * np.cos(np.radians(DEGREES)[:, None] * 3.0 + (0.0, 2.0, 4.0))
    _, brdf = surface("film", stack=curve_in_words(DEGREES, rows), roughness=0.5, specular=0.9, diffuse=(0.1, 0.1, 0.2))
    file = tmp_path_factory.mktemp("brdf") / "wrap_rgb.bsdf"
    file.write_bytes(container(rgl_fields(brdf, side=48, description="A wrap")))
    return file, fit(str(file))


def test_where_colour_changes_with_the_angle_the_curve_is_taken(wrap):
    _, found = wrap
    assert (found.fresnel, found.model, found.title) == ("curve", "film", "A wrap")
    assert found.tried["curve"] < 0.5 * min(found.tried["f0"], found.tried["n_k"])


def test_a_fit_is_the_same_each_time(wrap):
    file, found = wrap
    assert fit(str(file)).to_dict() == found.to_dict()


def test_a_fit_tells_how_far_it_is_and_can_be_stopped(wrap):
    file, _ = wrap
    shares = list(fit_steps(read_brdf(file), fresnel="f0"))
    assert shares == sorted(shares) and 0.0 <= shares[0] and 0.5 < shares[-1] <= 1.0 and len(shares) > 10
    told = []
    with pytest.raises(FacetFilmError, match="stopped"):
        fit(str(file), progress=lambda share: told.append(share) or len(told) < 3)
    assert len(told) == 3


def test_the_report_is_under_a_light_that_was_not_fitted_to(wrap):
    _, found = wrap
    assert HELD_OUT not in FITTED and set(FITTED) < set(LIGHTS)
    report = found.to_dict()
    assert report["light"] == HELD_OUT and report["samples"] == {"used": found.used, "rejected": 0}
    assert 0.0 < report["delta_e_2000"]["mean"] < report["delta_e_2000"]["p95"]
    assert report["worst"]["delta_e_2000"] >= report["delta_e_2000"]["mean"]
    json.dumps(report, allow_nan=False)


def test_what_the_model_cannot_is_said_with_a_reason():
    def cloth(v, l):  # light goes back where it came from
        return 0.1 + 2.0 * np.exp(-20.0 * (1.0 - np.sum(v * l, axis=-1, keepdims=True))) * np.array([1.0, 0.9, 0.8])
    found = fit(read_brdf_bytes(points_text(cloth, 900).encode(), "x.txt"))
    assert found.mean > 3.0 and found.verdict.startswith("this model cannot, because ")


def test_a_fit_becomes_a_material_that_says_what_it_is_of(wrap):
    _, found = wrap
    record = found.record()
    assert record.parameters == found.parameters and from_dict(record.to_dict()) == record
    assert record.title == "A wrap" and "wrap_rgb.bsdf" in record.baked["note"]
    assert record.baked["fitted"]["delta_e_2000"]["mean"] == found.mean
    assert resolve(found.preset()).preset.model == "film"


def test_a_fit_of_cook_torrance_is_for_the_working_space():
    from addon.models.model import Renderer
    _, brdf = surface(**{**seeded(2, 2, "f0"), "n": (3.0, 1.6, 1.5)})
    found = fit(read_brdf_bytes(points_text(brdf).encode(), "x.txt"), fresnel="f0")
    wide = made(preset=found.preset(), renderer=Renderer(space="Rec.2020")).parameters
    to_wide = np.array([[0.6274, 0.3293, 0.0433], [0.0691, 0.9195, 0.0114], [0.0164, 0.0880, 0.8956]])
    np.testing.assert_allclose(wide.diffuse, to_wide @ found.parameters.diffuse, atol=1e-3)
    f0 = [conductor(1.0, np.array(p.n), np.array(p.k)) for p in (wide, found.parameters)]
    assert delta_e_2000(lab(f0[0], "Rec.2020"), lab(to_wide @ f0[1], "Rec.2020")) < 1.0
    assert delta_e_2000(lab(f0[0], "Rec.2020"), lab(f0[1], "Rec.2020")) > 1.5
    assert made(preset=found.preset()).parameters == found.parameters


def test_an_older_blender_takes_the_closure_that_is_closer_and_the_numbers_stay():
    """Blender 4.5's conductor misses dielectrics, where F82 comes close."""
    from addon.models.model import Renderer
    old = Renderer(formula="blender-4.5")
    for n, k, group in (((1.5,) * 3, (0.0,) * 3, "f82"), ((0.2, 0.9, 1.1), (3.9, 2.4, 2.1), "fast")):
        preset = Preset(name="x", title="X", kind="surface", model="cook_torrance", parameters={"n": n, "k": k})
        record = made(preset=preset, renderer=old, realisation="fast")
        assert record.group.endswith(group) and record.parameters.n == n
        assert made(preset=preset, renderer=old, realisation="exact").group == "cook_torrance_exact"


def test_a_curve_in_words_is_checked():
    for text in ("Fresnel 0° 1 1 / 90° 1 1 1", "Fresnel 0° 1 1 2 / 90° 1 1 1",
                 "Fresnel 90° 1 1 1 / 0° 1 1 1", "Fresnel a / b"):
        with pytest.raises(FacetFilmError, match="A Fresnel curve is"):
            resolve(text)
    table = curve_table("Fresnel 0° 0.25 0.5 0.75 / 90° 1 1 1")
    np.testing.assert_allclose(table.at(np.array([1.0, 0.0]), 0.0), [[0.25, 0.5, 0.75], [1, 1, 1]])
    assert made(model="film", stack=table.text).parameters.stack == table.text


def test_the_shell_fits(wrap, tmp_path, capsys):
    file, found = wrap
    picture = tmp_path / "both.png"
    assert main(["fit", str(file), "--json", "--picture", str(picture)]) == 0
    assert json.loads(capsys.readouterr().out) == json.loads(json.dumps(found.to_dict()))
    assert picture.read_bytes()[:4] == b"\x89PNG"
    assert main(["fit", str(file), "--fresnel", "f0", "--slopes", "1"]) == 0
    said = capsys.readouterr().out
    assert "A wrap" in said and "verdict" in said and "left out" in said
    assert main(["fit", str(tmp_path / "nothing.bsdf")]) == 2
    assert main(["fit", str(file), "--slopes", "4"]) == 2
    assert main(["fit", str(file), "--fresnel", "fo"]) == 2


@pytest.mark.skipif(not REAL, reason="FACET_FILM_BRDF_FOLDER names no folder of real .bsdf files")
def test_real_materials_are_fitted_as_well_as_is_promised():
    """Two slopes with F0 at most 2.4 on average, the best of three at most 1.6."""
    measurements = [read_brdf(file) for file in REAL]
    two_slopes = [fit(measurement, fresnel="f0").mean for measurement in measurements]
    best = [fit(measurement).mean for measurement in measurements]
    print(f"{len(REAL)} files: F0 {np.mean(two_slopes):.3f}, best {np.mean(best):.3f}")
    assert np.mean(two_slopes) <= 2.4 and np.mean(best) <= 1.6
