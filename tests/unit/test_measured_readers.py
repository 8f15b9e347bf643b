"""Readers of measured BRDFs: against files made here, against Mitsuba's plugin, and on files that cannot be used."""

import os
from pathlib import Path

import numpy as np
import pytest
from brdf_files import container, direction, merl_bytes, points_text, rgl_fields

from addon.bake.colour import delta_e_2000
from addon.errors import FacetFilmError
from addon.measured import half_difference, merl, points, rgl, tensor_file
from addon.measured.reading import read_brdf_bytes
from addon.models import named

UP = np.array([0.0, 0.0, 1.0])
PAINT = named("cook_torrance").parameters(n=(1.5, 1.7, 2.0), k=(0.0, 0.2, 0.5), specular=0.6, diffuse=(0.5, 0.3, 0.1),
                                          slopes=((0.25, 0.7), (0.5, 0.3)))
FOLDER = os.environ.get("FACET_FILM_BRDF_FOLDER", "")
"""Of real .bsdf files to hold against Mitsuba as well; none where nothing is said."""
REAL = sorted(Path(FOLDER).glob("*_rgb.bsdf")) if FOLDER else []


def paint(v, l):
    return named("cook_torrance").evaluate(PAINT, UP, v, l)


def one_way(v, l):
    """A BRDF that is not reciprocal, so that a reader that swaps directions is seen."""
    return paint(v, l) * (1.0 + v[:, 2:]) * (1.0, 1.2, 0.8)


@pytest.fixture(scope="module")
def bsdf():
    return container(rgl_fields(one_way))


@pytest.fixture(scope="module")
def binary():
    return merl_bytes(paint)


def directions(count=400, steepest=75.0, seed=3):
    rng = np.random.default_rng(seed)
    theta = np.arccos(rng.uniform(np.cos(np.radians(steepest)), 1.0, (2, count)))
    return [direction(t, p) for t, p in zip(theta, rng.uniform(-np.pi, np.pi, (2, count)))]


def by_mitsuba(path, v, l):
    """f·cos θo of Mitsuba's plugin, ``(N, 3)``."""
    mitsuba = pytest.importorskip("mitsuba", exc_type=ImportError)
    mitsuba.set_variant("scalar_rgb")
    bsdf = mitsuba.load_dict({"type": "measured", "filename": str(path)})
    context, at = mitsuba.BSDFContext(), mitsuba.SurfaceInteraction3f()
    found = np.empty((len(v), 3))
    for i, (one, other) in enumerate(zip(v.tolist(), l.tolist())):
        at.wi = mitsuba.Vector3f(one)
        found[i] = np.array(bsdf.eval(context, at, mitsuba.Vector3f(other)))
    return found


def held_against_mitsuba(data, path):
    """The reader and Mitsuba are of one mind: what an agreement is."""
    v, l = directions()
    wanted = np.maximum(by_mitsuba(path, v, l), 0.0)  # a few of a real file's entries are below 0
    found = read_brdf_bytes(data, "x.bsdf").brdf(v, l) * l[:, 2:]
    difference = np.abs(found - wanted) / (np.abs(wanted) + 1e-3 * np.abs(wanted).max())
    assert np.median(difference) < 2e-5 and np.percentile(difference, 95) < 1e-3, np.median(difference)


def held_against_formula(data):
    v, l = directions()
    found, wanted = read_brdf_bytes(data, "x.bsdf").brdf(v, l), one_way(v, l)
    assert np.median(np.abs(found / wanted - 1.0)) < 0.03


def held_against_table(data):
    """MERL's entries are where the paper puts them, and as bright."""
    v, l = directions()
    found, wanted = read_brdf_bytes(data, "x.binary").brdf(v, l), paint(v, l)
    assert np.percentile(np.abs(found / wanted - 1.0), 99) < 5e-3
    samples = read_brdf_bytes(data, "x.binary").samples
    np.testing.assert_allclose(samples.f, paint(samples.v, samples.l), rtol=1e-9)


def test_a_bsdf_is_what_was_put_into_it(bsdf):
    held_against_formula(bsdf)


def test_a_bsdf_is_what_mitsuba_reads(bsdf, tmp_path):
    path = tmp_path / "x.bsdf"
    path.write_bytes(bsdf)
    held_against_mitsuba(bsdf, path)


@pytest.mark.skipif(not REAL, reason="FACET_FILM_BRDF_FOLDER names no folder of real .bsdf files")
def test_real_files_are_what_mitsuba_reads():
    for path in REAL:
        held_against_mitsuba(path.read_bytes(), path)


def test_a_binary_is_what_was_put_into_it(binary):
    held_against_table(binary)


MUTANTS = {
    "directions swapped": (rgl.Rgl, "f_cos", lambda real: lambda self, v, l: real(self, l, v)),
    "f for f cos": (rgl.Rgl, "brdf", lambda real: rgl.Rgl.f_cos),
    "θ without its root": (rgl, "_unit", lambda real: lambda theta: theta * (2.0 / np.pi)),
    "no jacobian": (rgl.Rgl, "__init__", lambda real: lambda self, fields: real(
        self, {**fields, "jacobian": np.zeros(1, "u1")})),
}
MERL_MUTANTS = {
    "MERL's scale missing": (merl, "SCALE", lambda real: np.ones(3) / 1500.0),
    "θh without its root": (merl.Merl, "angles", lambda real: lambda self, i, j, k: (
        i / 90 * np.pi / 2.0, j / 90 * np.pi / 2.0, k / 180 * np.pi)),
    "V and L in place of the half angles": (merl, "angles_of", lambda real: lambda v, l: (
        np.arccos(v[:, 2]), np.arccos(l[:, 2]), np.zeros(len(v)))),
}


@pytest.mark.parametrize("mutant", MUTANTS)
def test_mutants_of_the_bsdf_reader_are_found(mutant, bsdf, tmp_path, monkeypatch):
    path = tmp_path / "x.bsdf"
    path.write_bytes(bsdf)
    place, name, change = MUTANTS[mutant]
    monkeypatch.setattr(place, name, change(getattr(place, name)))
    with pytest.raises(AssertionError):
        held_against_formula(bsdf)
    with pytest.raises(AssertionError):
        held_against_mitsuba(bsdf, path)


@pytest.mark.parametrize("mutant", MERL_MUTANTS)
def test_mutants_of_the_merl_reader_are_found(mutant, binary, monkeypatch):
    place, name, change = MERL_MUTANTS[mutant]
    monkeypatch.setattr(place, name, change(getattr(place, name)))
    with pytest.raises(AssertionError):
        held_against_table(binary)


def test_points_say_which_direction_is_the_light():
    samples = read_brdf_bytes(b"theta_i phi_i theta_o phi_o R G B\n" + b"60 0 20 180 1 2 3\n" * 100, "x.txt").samples
    np.testing.assert_allclose(samples.l[0], direction(np.radians(60.0), 0.0), atol=1e-12)
    np.testing.assert_allclose(samples.v[0], direction(np.radians(20.0), np.pi), atol=1e-12)
    assert samples.f[0].tolist() == [1.0, 2.0, 3.0]


@pytest.mark.parametrize("degrees", [True, False])
@pytest.mark.parametrize("heading", [True, False])
def test_points_in_degrees_or_radians_with_or_without_a_heading(degrees, heading):
    measurement = read_brdf_bytes(points_text(paint, degrees=degrees, heading=heading).encode(), "x.txt")
    np.testing.assert_allclose(measurement.samples.f, paint(measurement.samples.v, measurement.samples.l), rtol=1e-6)
    assert measurement.notes == ("angles in degrees" if degrees else "angles in radians",)


def test_points_by_wavelength_are_seen_in_daylight():
    rows = "".join(f"{angle} 0 {angle} 180 0.2 0.2 0.2 0.2\n" for angle in np.linspace(5, 70, 120))
    samples = read_brdf_bytes(b"theta_i,phi_i,theta_o,phi_o,400,500,600,700\n" + rows.encode(), "x.csv").samples
    np.testing.assert_allclose(samples.f, 0.2, atol=1e-3)
    red = rows.replace("0.2 0.2 0.2 0.2", "0 0 0.2 0.2")
    f = read_brdf_bytes(b"theta_i phi_i theta_o phi_o 400nm 500nm 600nm 700nm\n" + red.encode(), "x.txt").samples.f
    assert f[0, 0] > 2.5 * f[0, 1]


def test_points_below_the_horizon_and_negative_ones_are_left_out_and_counted():
    text = points_text(paint, 300) + "95 0 20 180 1 1 1\n20 0 20 180 -1 1 1\n20 0 20 180 nan 1 1\n"
    measurement = read_brdf_bytes(text.encode(), "x.txt")
    assert (len(measurement.samples.f), measurement.rejected) == (300, 3)


def test_points_in_one_plane_are_said_to_be():
    rows = "".join(f"{angle} 0 {angle} 180 0.2 0.2 0.2\n" for angle in np.linspace(5, 70, 120))
    assert "plane of incidence" in read_brdf_bytes(rows.encode(), "x.txt").notes[-1]


def changed(**fields):
    return container({**rgl_fields(paint, 4, 8), **fields})


def without(name):
    return container({key: value for key, value in rgl_fields(paint, 4, 8).items() if key != name})


SMALL = rgl_fields(paint, 4, 8)
UNUSABLE = {
    "anisotropic": ("a.bsdf", lambda: changed(phi_i=np.zeros(8, "<f4")), "anisotropic"),
    "spectral": ("a.bsdf", lambda: container({**{k: v for k, v in SMALL.items() if k != "rgb"},
                                              "spectra": SMALL["rgb"]}), "holds spectra"),
    "lacks a table": ("a.bsdf", lambda: without("vndf"), "lacks some of its tables"),
    "wrong dimensions": ("a.bsdf", lambda: changed(rgb=SMALL["rgb"][:, :2]), "wrong dimensions"),
    "NaN": ("a.bsdf", lambda: changed(rgb=SMALL["rgb"] * np.float32("nan")), "no numbers"),
    "all negative": ("a.bsdf", lambda: changed(rgb=-np.abs(SMALL["rgb"]) - 1), "no value above 0"),
    "truncated": ("a.bsdf", lambda: container(SMALL)[:-500], "ends too early"),
    "truncated header": ("a.bsdf", lambda: container(SMALL)[:40], "ends too early"),
    "empty": ("a.bsdf", lambda: b"", "ends too early"),
    "pointer": ("a.bsdf", lambda: b"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n", "Git LFS"),
    "page": ("a.bsdf", lambda: b"<!DOCTYPE html><html></html>", "web page"),
    "MERL of another size": ("a.binary", lambda: np.array([90, 90, 90], "<i4").tobytes() + bytes(80), "90 × 90 × 90"),
    "MERL truncated": ("a.binary", lambda: np.array([90, 90, 180], "<i4").tobytes() + bytes(8000), "ends too early"),
    "forty points": ("a.txt", lambda: points_text(paint, 40).encode(), "40 usable points"),
    "prose": ("a.txt", lambda: b"There is nothing here.\n", "no measured BRDF"),
    "a picture": ("a.txt", lambda: b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\xff\xff", "no measured BRDF"),
    "columns without names": ("a.txt", lambda: b"1 2 3 4 5 6 7 8\n" * 200, "8 columns"),
    "angles missing": ("a.txt", lambda: b"theta_i phi_i R G B x y\n" + b"1 2 3 4 5 6 7\n" * 200, "does not name"),
    "no wavelengths": ("a.txt", lambda: b"theta_i phi_i theta_o phi_o a b c\n" + b"1 2 3 4 5 6 7\n" * 200,
                       "by wavelengths"),
    "points all negative": ("a.txt", lambda: b"10 0 20 180 -1 -1 -1\n" * 200, "no value above 0"),
}


@pytest.mark.parametrize("what", UNUSABLE)
def test_what_cannot_be_used_is_said_in_a_sentence(what):
    name, make, said = UNUSABLE[what]
    with pytest.raises(FacetFilmError) as error:
        read_brdf_bytes(make(), name)
    sentence = str(error.value)
    assert said in sentence and name in sentence and sentence.endswith(".") and "\n" not in sentence


def test_damage_anywhere_is_one_sentence():
    """Bytes changed at random: a Measurement or a sentence, nothing else."""
    rng, good = np.random.default_rng(5), container(SMALL)
    for _ in range(200):
        data = bytearray(good[:rng.integers(1, len(good))] if rng.random() < 0.3 else good)
        for place in rng.integers(0, min(len(data), 700), 3):
            data[place] = rng.integers(0, 256)
        try:
            with np.errstate(all="ignore"):
                read_brdf_bytes(bytes(data), "x.bsdf")
        except FacetFilmError:
            pass


def test_the_container_is_written_as_it_is_read():
    fields = {"a": np.arange(6, dtype="<f4").reshape(2, 3), "name": np.frombuffer(b"text", "u1")}
    assert container(fields) == tensor_file.tensor_bytes(fields)


def test_angles_and_directions_are_each_others_inverse():
    v, l = directions()
    again = half_difference.directions_of(*half_difference.angles_of(v, l))
    np.testing.assert_allclose(np.sum(again[0] * again[1], axis=-1), np.sum(v * l, axis=-1), atol=1e-9)
    assert np.allclose(paint(*again), paint(v, l), rtol=1e-6)


def test_the_fewest_points_stand_in_the_sentence():
    assert points.FEWEST == 100


def test_where_numbers_lie_in_memory_changes_no_bit_of_them():
    """numpy goes by another way where a strided array lies next to what it writes; see addon.columns."""
    reader = rgl.Rgl(tensor_file.fields_of(container(rgl_fields(paint, side=16)), "x.bsdf"))
    rng, kept = np.random.default_rng(3), []
    v, l = directions(1718)
    functions = {"angles_of": lambda: half_difference.angles_of(v, l), "f_cos": lambda: reader.f_cos(v, l),
                 "delta_e_2000": lambda: delta_e_2000(100.0 * v, 100.0 * l)}
    found = {name: set() for name in functions}
    for _ in range(400):
        kept.append(rng.random(rng.integers(1, 4000)).astype(np.float32))
        for name, function in functions.items():
            found[name].add(np.asarray(function()).tobytes())
    assert {name: len(values) for name, values in found.items()} == dict.fromkeys(functions, 1)
