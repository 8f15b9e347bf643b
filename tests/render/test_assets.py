"""The asset libraries as they ship: what is in them, and what becomes of an asset in a file of this Blender."""

import re

import bpy
import pytest

import addon
from addon import api
from addon.blender import asset_library, compat, groups, materials
from addon.layered_presets import PRESETS
from addon.spectra import presets
from tools import build_assets

FILES = {name: asset_library.ROOT / name / build_assets.FILE for name in asset_library.FOLDERS}


@pytest.fixture
def empty():
    """An empty file."""
    bpy.ops.wm.read_factory_settings(use_empty=True)


@pytest.fixture
def enabled(empty):
    """The extension registered."""
    addon.register()
    yield
    addon.unregister()


def loaded(file, **names):
    """Datablocks appended from a library; `True` for all of a kind."""
    with bpy.data.libraries.load(str(file)) as (source, target):
        for kind, wanted in names.items():
            setattr(target, kind, list(getattr(source, kind)) if wanted is True else wanted)
    return target


@pytest.mark.parametrize("name", FILES)
def test_it_was_built_from_what_the_checkout_holds(empty, name):
    text, = loaded(FILES[name], texts=[build_assets.STAMP]).texts
    assert text.as_string() == build_assets.stamp(), "run tools/build_assets.py"


@pytest.mark.parametrize("name", FILES)
def test_every_preset_and_group_is_an_asset_with_all_that_belongs_to_it(empty, name):
    assets = loaded(FILES[name], materials=True, node_groups=True)
    lines = (asset_library.ROOT / name / "blender_assets.cats.txt").read_text(encoding="utf-8").splitlines()
    catalogues = {line.split(":")[0] for line in lines if re.match(r"[0-9a-f-]{36}:", line)}
    titles = {preset.title for preset in presets.all_presets().values()} | {p.title for p in PRESETS.values()}
    assert {material.name for material in assets.materials} == titles
    assert len(assets.materials) == len(presets.all_presets()) + len(PRESETS)
    assert {"Cook-Torrance Fast", "Cook-Torrance Exact", "Layered RGB Fast", "Layered RGB Exact", "Layer Thickness",
            "Fresnel Ramp Copper"} <= {tree.name for tree in assets.node_groups}
    for asset in (*assets.materials, *assets.node_groups):
        about = asset.asset_data
        assert about.author == build_assets.AUTHOR and about.license == "CC0-1.0", asset.name
        assert about.catalog_id in catalogues, asset.name
        assert len(about.tags) >= 2, asset.name
        assert tuple(asset.preview.image_size) == (96, 96), asset.name
    assert all(material.asset_data.description for material in assets.materials
               if materials.model_of(material) == "layered_rgb")


@pytest.mark.parametrize("name", FILES)
def test_materials_share_their_groups(empty, name):
    used = {materials.our_node(material).node_tree.name for material in loaded(FILES[name], materials=True).materials}
    assert used <= {"Cook-Torrance Fast", "Cook-Torrance Fast F82", "Layered RGB Fast"}


def test_an_asset_is_what_the_preset_gives_in_this_blender(empty):
    folder = asset_library.folder()
    for title, preset in (("Copper", "copper"), ("Sapphire", "sapphire"), ("Gold", "gold")):
        asset, = loaded(folder / build_assets.FILE, materials=[title]).materials
        made = api.create_material(preset=preset)
        assert materials.our_node(asset).node_tree == materials.our_node(made).node_tree
        assert materials.parameters_of(asset).n == pytest.approx(materials.parameters_of(made).n, rel=1e-5)
        assert materials.record_of(asset)["source"]["dataset"] == api.bake(preset).source.dataset
    assert not [tree.name for tree in bpy.data.node_groups if tree.name[-4:] == ".001"]


def test_a_dragged_asset_can_be_switched(empty):
    asset, = loaded(asset_library.folder() / build_assets.FILE, materials=["Copper"]).materials
    assert not groups.edited(materials.our_node(asset).node_tree)
    api.switch_realisation(asset, "exact")
    assert materials.realisation_of(asset) == "exact"


def test_the_library_is_added_by_its_button_alone_and_goes_with_the_extension(empty):
    libraries = bpy.context.preferences.filepaths.asset_libraries
    before = [library.name for library in libraries]
    addon.register()
    assert [library.name for library in libraries] == before
    assert bpy.ops.facet_film.add_asset_library() == {"FINISHED"}
    assert libraries[-1].name == "Facet & Film" and (asset_library.folder() / build_assets.FILE).exists()
    assert not bpy.ops.facet_film.add_asset_library.poll()
    assert bpy.ops.facet_film.remove_asset_library() == {"FINISHED"}
    bpy.ops.facet_film.add_asset_library()
    addon.unregister()
    assert [library.name for library in libraries] == before


def test_this_blender_gets_the_materials_fitted_for_it(empty):
    assert asset_library.FOLDERS[asset_library.folder().name] == compat.conductor_formula()


def test_the_catalogues_are_the_same_whenever_they_are_built():
    for name in FILES:
        text = (asset_library.ROOT / name / "blender_assets.cats.txt").read_text(encoding="utf-8")
        assert text == build_assets.catalogue_text()
