"""The curated presets: their names, data, citations and ranges, how closely they are fitted, the paper's figures."""

import collections
import importlib.util
import pathlib
import re
import warnings

import numpy as np
import pytest

from addon.bake import bake
from addon.catalogue import presets
from addon.catalogue.categories import CATEGORIES
from addon.catalogue.kinds import KINDS
from addon.errors import FacetFilmError
from addon.models.making import made
from addon.spectra import optical_constants, tables

ROOT = pathlib.Path(__file__).resolve().parents[2]
ALL = presets.all_presets()
PRESETS = {name: preset for name, preset in ALL.items() if preset.measured}
MIRRORS = {name: preset for name, preset in PRESETS.items() if preset.model == "cook_torrance"}
FIGURE_6B = ((0.4, 0.4), (0.2, 0.6))
TABLE_I = {"carbon": (0.3, 0.7, 0.40), "rubber": (0.4, 0.6, 0.30), "obsidian": (0.8, 0.2, 0.15),
           "lunar_dust": (0.0, 1.0, None), "olive_drab": (0.3, 0.7, 0.50), "rust": (0.2, 0.8, 0.35)}
AMERICAN = {"aluminium": "aluminum", "sulphide": "sulfide", "caesium": "cesium", "haematite": "hematite",
            "grey": "gray"}


@pytest.fixture(scope="module")
def baked():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return {name: bake(name) for name in PRESETS}


@pytest.fixture(scope="module")
def surfaces():
    """The parameters that each preset's materials have."""
    return {name: made(preset=name).parameters for name in PRESETS}


def diffuse_of(preset):
    """Where a preset's diffuse colour is from."""
    return preset.parameters.get("diffuse", "specular")


def test_there_are_as_many_as_promised_of_every_kind():
    count = collections.Counter(preset.kind for preset in ALL.values())
    assert set(count) == set(KINDS)
    assert len(PRESETS) >= 100 and count["metal"] + count["alloy"] >= 35
    assert sum(not preset.variant_of and preset.category != "figure" for preset in ALL.values()) >= 250
    assert min(count.values()) >= 6


def test_every_category_is_used_and_every_variant_is_of_a_material_beside_it():
    assert {preset.category for preset in ALL.values()} == set(CATEGORIES)
    for preset in ALL.values():
        if preset.variant_of:
            main = ALL[preset.variant_of]
            assert not main.variant_of and main.category == preset.category, preset.name


def test_no_material_is_counted_twice():
    sources = [(preset.dataset, preset.parameters.get("anisotropy")) for preset in MIRRORS.values()
               if preset.dataset and preset.kind != "figure" and not preset.variant_of]
    assert len(sources) == len(set(sources))


@pytest.mark.parametrize("name", """
    bronze tungsten copper tin nickel stainless_steel brass gold silver aluminium iron titanium chromium platinum
    zinc mercury titanium_nitride silicon germanium haematite cuprite tenorite crown_glass window_glass diamond
    sapphire water ethanol vinyl acrylic polycarbonate polystyrene nylon figure_6a figure_6b""".split())
def test_what_people_ask_for_is_there(name):
    assert name in PRESETS


def test_names_are_plain_and_every_name_means_one_preset():
    called = collections.defaultdict(set)
    for preset in ALL.values():
        assert re.fullmatch("[a-z0-9]+(_[a-z0-9]+)*", preset.name)
        for name in (preset.name, preset.title, *preset.aliases):
            assert name == name.strip() and name
            found = presets.find(name)
            assert found is presets.find(preset.name) and found.name == preset.name, name
            called[presets._plain(name)].add(preset.name)
    assert {name: found for name, found in called.items() if len(found) > 1} == {"tin": {"tin", "titanium_nitride"}}


@pytest.mark.parametrize("alias, name", [
    ("Cu", "copper"), ("aluminum", "aluminium"), ("TiN", "titanium_nitride"), ("TIN", "tin"), ("Sn", "tin"),
    ("plexiglass", "acrylic"), ("pvc", "vinyl"), ("titanium oxide", "titanium_dioxide"), ("Rust", "rust"),
    ("ITO", "indium_tin_oxide"), ("BK7", "crown_glass"), ("H2O", "water"), ("hematite", "haematite"),
    ("chrome", "chromium"), ("quicksilver", "mercury"), ("bronze vase", "figure_7_bronze"),
])
def test_aliases(alias, name):
    assert presets.find(alias).name == name


def test_british_titles_have_their_american_names_too():
    for preset in PRESETS.values():
        title = preset.title.lower()
        for british, american in AMERICAN.items():
            if british in title:
                assert any(american in alias.lower() for alias in preset.aliases), preset.name


def test_what_has_a_dataset_has_its_citation_from_the_database(baked):
    _, index, _ = tables.read("refractiveindex")
    citations = {record[0]: index["citations"][record[2]] for record in index["records"]}
    for name, preset in PRESETS.items():
        if preset.dataset:
            source = baked[name].source
            assert source.dataset == preset.dataset and source.citation == citations[preset.dataset]
            assert re.search(r"\b(1[89]|20)\d\d\b", source.citation) or preset.dataset.startswith(
                ("specs/", "popular_glass/", "other/Microchem")), source.citation


def test_what_has_no_dataset_says_that_it_is_estimated_and_from_what(baked):
    without = {name for name, preset in MIRRORS.items() if not preset.dataset}
    assert {"tin", "cuprite", "rubber", "rust", "rose_gold", "car_paint_red", "patina"} <= without
    for name in without:
        record = baked[name].to_dict()
        assert record["estimated"].startswith("Estimated: ") and len(record["estimated"]) > 60
        assert record["source"]["citation"] == record["estimated"]
        assert record["source"]["dataset"] == f"preset {name}"
        assert "measured" not in PRESETS[name].note


def test_a_diffuse_colour_of_ones_own_is_called_estimated(surfaces):
    for name, preset in PRESETS.items():
        diffuse = diffuse_of(preset)
        if not isinstance(diffuse, str):
            assert len(diffuse) == 3 and all(0.0 <= channel <= 1.0 for channel in diffuse)
            assert re.search("diffuse|drawn by eye", preset.estimated), name
            assert np.allclose(surfaces[name].diffuse, diffuse, atol=1e-6)
        elif diffuse != "specular":
            assert diffuse in optical_constants.dataset_ids()


def test_the_visible_is_covered_or_the_note_says_what_is_held(baked):
    held = {name for name in PRESETS if not baked[name].source.covers_visible}
    assert held == {name for name, preset in PRESETS.items() if "the end is held" in preset.note}
    assert len(held & set(MIRRORS)) <= 5


def test_parameters_are_in_range(surfaces):
    for name, preset in MIRRORS.items():
        surface = surfaces[name]
        assert surface.slopes == preset.parameters["slopes"]
        assert surface.specular == preset.parameters.get("specular", 1.0)
        assert sum(weight for _, weight in surface.slopes) == pytest.approx(1.0)
        assert all(0.02 <= m <= 0.5 for m, _ in surface.slopes), name
        assert surface.distribution == "beckmann"


def test_what_is_transparent_is_clear_and_opaque_plastics_say_that_they_are():
    assert not [name for name, preset in MIRRORS.items() if preset.kind in {"crystal", "glass", "liquid"}]
    for name in ("vinyl", "polyethylene", "polypropylene", "teflon", "nylon"):
        assert "Opaque" in PRESETS[name].note


def test_all_bake_for_blender_4_5_without_a_warning():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for name in PRESETS:
            fitted = bake(name, formula="blender-4.5").conductor
            assert fitted.formula == "blender-4.5" and np.all(np.isfinite(fitted.n + fitted.k)), name


def test_metals_are_fitted_closely(baked):
    metals = [bake for name, bake in baked.items() if PRESETS[name].kind in {"metal", "alloy"}]
    in_gamut = np.array([bake.conductor.delta_e_2000_max for bake in metals if not bake.gamut.outside])
    assert np.mean(in_gamut <= 0.2) >= 0.95 and in_gamut.max() <= 0.7
    assert max(bake.conductor.delta_e_2000_max for bake in metals) <= 0.7
    for bake_709 in metals:
        if bake_709.gamut.outside:
            wide = bake(bake_709.name, space="ACEScg")
            assert not wide.gamut.outside and wide.conductor.delta_e_2000_max <= 0.2, bake_709.name


def test_everything_else_is_fitted_closely(baked):
    assert max(bake.conductor.delta_e_2000_max for bake in baked.values()) <= 0.7


def test_figure_6a(surfaces):
    plastic, surface = presets.find("figure 6a"), surfaces["figure_6a"]
    assert (surface.specular, surface.slopes, surface.distribution) == (0.1, ((0.15, 1.0),), "beckmann")
    assert plastic.dataset == PRESETS["vinyl"].dataset and diffuse_of(plastic) == PRESETS["copper"].dataset


def test_figure_6b(surfaces):
    vase, surface = presets.find("figure 6b"), surfaces["figure_6b"]
    assert (surface.specular, surface.slopes, surface.distribution) == (1.0, FIGURE_6B, "beckmann")
    assert vase.dataset == diffuse_of(vase) == PRESETS["copper"].dataset


@pytest.mark.parametrize("metal", "bronze tungsten copper tin nickel stainless_steel".split())
def test_metals_of_figure_7_are_figure_6b_but_for_the_spectrum(metal, baked, surfaces):
    vase, surface = baked[f"figure_7_{metal}"], surfaces[f"figure_7_{metal}"]
    assert (surface.specular, surface.slopes, surface.distribution) == (1.0, FIGURE_6B, "beckmann")
    assert vase.f0 == pytest.approx(baked[metal].f0, abs=1e-9)
    assert vase.estimated == baked[metal].estimated


@pytest.mark.parametrize("name", TABLE_I)
def test_table_i(name, baked, surfaces):
    specular, diffuse, slope = TABLE_I[name]
    preset, surface = PRESETS[name], surfaces[name]
    assert surface.specular == specular and 1.0 - surface.specular == pytest.approx(diffuse)
    assert slope is None or surface.slopes == ((slope, 1.0),)
    assert surface.distribution == "beckmann" and diffuse_of(preset) == "specular"
    assert np.allclose(surface.diffuse, baked[name].normal_rgb)
    assert "table I" in preset.note and presets.find(f"figure 7 {preset.title}") is presets.find(name)


def test_colours_of_the_estimated_are_what_their_names_say(baked):
    red, green, blue = baked["rust"].normal_rgb
    assert red > 2 * green > 2 * blue
    red, green, blue = baked["olive_drab"].normal_rgb
    assert 0.0 < blue < 0.6 * green and abs(red - green) < 0.03
    for name in ("rubber", "obsidian"):
        assert np.ptp(baked[name].normal_rgb) < 1e-3


def test_no_name_leads_nowhere():
    with pytest.raises(FacetFilmError, match="did you mean 'brass'"):
        presets.find("bras")


def test_the_catalogue_is_what_its_tool_builds(tmp_path):
    spec = importlib.util.spec_from_file_location("build_catalogue", ROOT / "tools" / "build_catalogue.py")
    tool = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(tool)
    tool.main(tmp_path / "materials.md")
    assert (tmp_path / "materials.md").read_text("utf-8") == (ROOT / "docs" / "materials.md").read_text("utf-8")
