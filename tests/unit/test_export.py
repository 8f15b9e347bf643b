"""What is written for other programs: whole, readable again, and true to the bake."""

import csv
import io
import json
import math
import os
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

from addon.bake import bake
from addon.catalogue import presets
from addon.errors import FacetFilmError
from addon.export import curve_csv, json_text, materialx, principled, spectrum_csv, write_text, writing
from addon.models.making import exported, made, rebaked
from addon.models.standins import standin_of
from addon.spectra import optical_constants
from addon.spectra.readers import read_text

ONE_SLOPE = ((0.2, 1.0),)


def materialx_of(preset, **parameters):
    """The MaterialX of a preset with parameters of one's own."""
    return exported(made(preset=preset, **parameters), "materialx")


def test_json_is_the_bake():
    baked = bake("gold")
    assert json.loads(json_text(baked.to_dict())) == baked.to_dict()


@pytest.mark.parametrize("dataset", ["main/Au/Babar", "main/SiO2/Malitson", "main/Cu/Johnson"])
def test_a_spectrum_comes_back_identical(dataset):
    constants = optical_constants.load(dataset)
    again = read_text(spectrum_csv(constants))
    for name in ("wavelength_nm", "n", "k"):
        np.testing.assert_array_equal(getattr(again, name), getattr(constants, name))
    assert again.has_k == constants.has_k
    assert bake(again).f0 == bake(dataset).f0


def test_every_dataset_of_a_shelf_comes_back_identical():
    for dataset in [name for name in optical_constants.dataset_ids() if name.startswith("main/")][::12]:
        constants = optical_constants.load(dataset)
        again = read_text(spectrum_csv(constants))
        assert np.array_equal(again.wavelength_nm, constants.wavelength_nm), dataset
        assert np.array_equal(again.n, constants.n) and np.array_equal(again.k, constants.k), dataset


def test_a_normal_reflectance_comes_back_as_one():
    constants = optical_constants.from_normal_reflectance([400.0, 550.5, 700.0], [0.04, 0.5, 0.98], "x")
    written = spectrum_csv(constants)
    again = read_text(written)
    assert written.startswith("wavelength_nm,R\n") and again.normal_only
    np.testing.assert_array_equal(again.wavelength_nm, constants.wavelength_nm)
    np.testing.assert_allclose(again.n, constants.n, rtol=1e-12)


def test_the_curve_as_a_table():
    baked = bake("copper")
    rows = list(csv.DictReader(io.StringIO(curve_csv(baked))))
    assert tuple(float(row["cos_theta"]) for row in rows) == baked.fresnel.cos_theta
    assert tuple(tuple(float(row[c]) for c in "rgb") for row in rows) == baked.fresnel.rgb


def inputs_of(document, kind):
    """Values by input of the first node of a kind."""
    node = ElementTree.fromstring(document).find(kind)
    return {one.get("name"): one.get("value") for one in node}


def test_materialx_holds_the_fits():
    baked = bake("copper")
    document = materialx_of("copper")
    conductor = inputs_of(document, "conductor_bsdf")
    schlick = inputs_of(document, "generalized_schlick_bsdf")

    def numbers(value):
        return [float(number) for number in value.split(",")]
    np.testing.assert_allclose(numbers(conductor["ior"]), baked.conductor.n, rtol=1e-5)
    np.testing.assert_allclose(numbers(conductor["extinction"]), baked.conductor.k, rtol=1e-5)
    np.testing.assert_allclose(numbers(schlick["color0"]), baked.f82.f0, rtol=1e-5)
    np.testing.assert_allclose(numbers(schlick["color82"]), baked.f82.tint, rtol=1e-5)
    assert numbers(schlick["color90"]) == [1, 1, 1] and float(schlick["exponent"]) == 5
    assert numbers(inputs_of(materialx_of("copper", slopes=[(0.3, 1.0)]), "conductor_bsdf")["roughness"]) == [0.3, 0.3]
    assert ElementTree.fromstring(document).get("colorspace") == "lin_rec709"
    wide = materialx(bake("gold", space="ACEScg"), slopes=ONE_SLOPE)
    assert ElementTree.fromstring(wide).get("colorspace") == "acescg"


def test_the_weights_of_materialx_are_those_of_the_model():
    surface = made(preset="figure_7_copper").parameters
    root = ElementTree.fromstring(materialx_of("figure_7_copper"))
    lobes = [{one.get("name"): one.get("value") for one in node} for node in root.findall("conductor_bsdf")]
    assert len(lobes) == len(surface.slopes) > 1
    for lobe, (m, w) in zip(lobes, surface.slopes):
        assert math.isclose(float(lobe["weight"]), surface.specular * w, rel_tol=1e-5)
        assert float(lobe["roughness"].split(",")[0]) == pytest.approx(m)
    diffuse = inputs_of(materialx_of("figure_6a"), "oren_nayar_diffuse_bsdf")
    assert float(diffuse["weight"]) == pytest.approx(1 - made(preset="figure_6a").parameters.specular)


def test_materialx_refuses_parameters_of_another_formula():
    with pytest.raises(FacetFilmError, match="bake with the formula 'exact'"):
        materialx(bake("copper", formula="blender-4.5"), slopes=ONE_SLOPE)


def test_materialx_of_a_material_with_a_strange_name():
    document = materialx_of(read_text("400,1.5,2\n700,1.4,2\n", "1 <ä>--&.csv"))
    names = [node.get("name") for node in ElementTree.fromstring(document).iter() if node.get("name")]
    assert all(name.isidentifier() and name.isascii() for name in names)


def test_what_is_exported_is_what_the_node_holds_in_the_light_it_was_baked_in():
    """Not a bake in the default light with the preset's own slopes."""
    viewing = {"illuminant": "A", "observer": "1964", "gamut": "leave"}
    tuned = made(preset="gold", viewing=viewing, slopes=[(0.33, 1.0)], specular=0.5, diffuse=(0.1, 0.2, 0.3))
    held = json.loads(exported(tuned, "json"))
    expected = bake("gold", **viewing)
    assert held["f0"] == list(expected.f0) and held["fresnel"] == expected.to_dict()["fresnel"]
    assert (held["illuminant"], held["observer"], held["gamut"]["method"]) == ("A", "1964", "leave")
    assert (held["slopes"], held["specular"], held["diffuse_rgb"]) == ([[0.33, 1.0]], 0.5, [0.1, 0.2, 0.3])
    root = ElementTree.fromstring(exported(tuned, "materialx"))
    assert [float(one.get("value").split(",")[0]) for one in root.iter("input") if one.get("name") == "roughness"] \
        == [0.33, 0.33]
    assert exported(tuned, "csv") == curve_csv(expected)


def test_an_index_of_the_users_own_is_exported_with_its_distance_from_the_measurement():
    tuned = made(preset="copper", n=(1.5,) * 3, k=(0.0,) * 3)
    held = json.loads(exported(tuned, "json"))
    assert held["conductor"]["n"] == [1.5] * 3 and held["f0"] == pytest.approx([0.04] * 3)
    assert held["conductor"]["delta_e_2000_max"] > 20.0
    assert json.loads(exported(rebaked(tuned), "json"))["conductor"]["delta_e_2000_max"] < 1.0


def test_principled_of_a_conductor():
    told, slopes = standin_of(made(preset="copper")), made(preset="copper").parameters.slopes
    settings = principled(told)
    assert settings["Base Color"][:3] == pytest.approx(bake("copper").f82.f0, abs=0.02) and told.delta_e[0] < 0.3
    assert settings["Metallic"] == 1.0
    slope = sum(w * m * m for m, w in slopes) ** 0.5
    assert settings["Roughness"] == pytest.approx(math.sqrt(slope))


def test_principled_of_a_dielectric():
    glossy = made(preset="vinyl", specular=1.0, diffuse=(0.0, 0.0, 0.0))
    settings = principled(standin_of(glossy))
    assert settings["Metallic"] == 0.0 and settings["Base Color"][:3] == pytest.approx((0.0,) * 3, abs=2e-3)
    assert settings["IOR"] == pytest.approx(glossy.parameters.n[1], abs=0.01)


def test_principled_of_every_preset_is_in_the_sockets_ranges():
    for preset in [preset for preset in presets.all_presets().values() if preset.measured]:
        record = made(preset=preset.name)
        for socket, value in principled(standin_of(record)).items():
            values = value if isinstance(value, tuple) else (value,)
            highest = 10.0 if socket == "IOR" else 1.0
            assert all(0.0 <= one <= highest for one in values), (preset.name, socket, value)


def test_a_file_is_written_whole(tmp_path):
    path = tmp_path / "µ.csv"
    assert write_text(path, "a\nµ\n") == str(path)
    assert path.read_bytes() == "a\nµ\n".encode()
    path.chmod(0o640)
    write_text(str(path), "b")
    assert path.read_text() == "b" and path.stat().st_mode & 0o777 == 0o640
    assert os.listdir(tmp_path) == ["µ.csv"]


def test_a_link_is_followed(tmp_path):
    (tmp_path / "real.csv").write_text("old")
    (tmp_path / "link.csv").symlink_to(tmp_path / "real.csv")
    write_text(tmp_path / "link.csv", "new")
    assert (tmp_path / "real.csv").read_text() == "new" and (tmp_path / "link.csv").is_symlink()


@pytest.mark.parametrize("step", ["open", "replace"])
def test_a_write_that_fails_changes_nothing(step, tmp_path, monkeypatch):
    path = tmp_path / "a.csv"
    path.write_text("old")

    def fail(*_, **__):
        raise OSError(28, "No space left on device")
    monkeypatch.setattr(*{"open": ("builtins.open", fail), "replace": (writing.os, "replace", fail)}[step])
    with pytest.raises(FacetFilmError, match="no space left on device"):
        write_text(path, "new")
    monkeypatch.undo()
    assert path.read_text() == "old" and os.listdir(tmp_path) == ["a.csv"]


@pytest.mark.parametrize("path, says", [
    ("none/a.csv", "does not exist"), (".", "is a folder"), ("", "named by its path"),
    (None, "named by its path"), ("a\0.csv", "named by its path"), (b"a.csv", "named by its path"),
    ("/dev/null", "no ordinary file"),
    ("x" * 300, "too long")])
def test_where_nothing_can_be_written_is_said(path, says, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(FacetFilmError, match=says):
        write_text(path, "x")
    assert not os.listdir(tmp_path)


def test_a_protected_file_stays(tmp_path, monkeypatch):
    path = tmp_path / "a.csv"
    path.write_text("old")
    monkeypatch.setattr(writing.os, "access", lambda *_: False)  # root may write anywhere
    with pytest.raises(FacetFilmError, match="protected"):
        write_text(path, "new")
    assert path.read_text() == "old"
