"""The asset library as it ships: what is in it, and what becomes of an asset in a file of this Blender."""

import re

import bpy
import numpy as np
import pytest

import addon
from addon import api
from addon.bake.baking import FORMULAS
from addon.blender import compat
from addon.blender.assets import library
from addon.blender.assets.imported import STAND_IN_KEY
from addon.blender.assets.names import asset_name, preset_of
from addon.blender.datablocks import groups, materials
from addon.blender.datablocks.pictures import image_in
from addon.catalogue import presets
from tools import build_assets


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


def loaded(**names):
    """Datablocks appended from the library; `True` for all of a kind."""
    with bpy.data.libraries.load(str(library.FILE)) as (source, target):
        for kind, wanted in names.items():
            setattr(target, kind, list(getattr(source, kind)) if wanted is True else wanted)
    return target


def test_every_preset_and_group_is_an_asset_with_all_that_belongs_to_it(empty):
    assets = loaded(materials=True, node_groups=True)
    lines = build_assets.CATALOGUE_FILE.read_text(encoding="utf-8").splitlines()
    catalogues = {line.split(":")[0] for line in lines if re.match(r"[0-9a-f-]{36}:", line)}
    everything = build_assets.shown()
    assert {material.name for material in assets.materials} == {asset_name(preset) for preset in everything}
    assert len(assets.materials) == len(everything) > len(build_assets.held()) > 230
    assert {"Cook-Torrance Standard", "Cook-Torrance Reference", "Layered RGB Standard", "Layered RGB Reference",
            "Layer Thickness", "Fresnel Ramp Copper"} <= {tree.name for tree in assets.node_groups}
    for asset in (*assets.materials, *(tree for tree in assets.node_groups if tree.asset_data)):
        about = asset.asset_data
        assert about.author == build_assets.AUTHOR and about.license == "CC0-1.0", asset.name
        assert about.catalog_id in catalogues, asset.name
        assert len(about.tags) >= 2, asset.name
        assert tuple(asset.preview.image_size) in {(96, 96)}, asset.name
    assert all(material.asset_data.description for material in assets.materials
               if materials.model_of(material).name == "layered_rgb")


def test_materials_share_their_groups(empty):
    """And of films those that show the same image; what has its rainbow by default has one of its own."""
    used = {materials.our_node(material).node_tree for material in loaded(materials=True).materials}
    assert {tree.name.partition(".")[0] for tree in used} == {
        "Clear Standard", "Clear Dispersive", "Cook-Torrance Standard", "Film Standard", "Layered RGB Standard"}
    assert len(used) == 4 + len({image_in(tree) for tree in used if image_in(tree)})


def reflected(material):
    """What n and k of a material reflect in this Blender, over angle; n alone says little of a near perfect mirror."""
    found, cos_theta = materials.parameters_of(material), np.linspace(0.05, 1.0, 20)[:, None]
    return FORMULAS[compat.conductor_formula()](cos_theta, np.array(found.n), np.array(found.k))


def test_an_asset_is_what_the_preset_gives_in_this_blender(enabled):
    """Also in 4.5, whose conductor Fresnel is another one: there it is baked again when it comes in."""
    for preset in ("copper", "obsidian", "gold", "vinyl"):
        asset, = loaded(materials=[asset_name(presets.find(preset))]).materials
        assert asset.name == presets.find(preset).title
        made = api.create_material(preset=preset)
        assert materials.our_node(asset).node_tree == materials.our_node(made).node_tree
        assert reflected(asset) == pytest.approx(reflected(made), abs=1e-6)
        assert materials.baked_of(asset)["source"]["dataset"] == api.bake(preset).source.dataset
        found, expected = materials.baked_of(asset)["conductor"], materials.baked_of(made)["conductor"]
        assert found["formula"] == expected["formula"]
    assert not [tree.name for tree in bpy.data.node_groups if tree.name[-4:] == ".001"]


def test_what_a_user_has_set_comes_in_as_it_is(enabled, tmp_path):
    """A material of another Blender, with an index of the user's own."""
    mine = api.create_material(preset="copper", name="Mine", n=(0.3, 0.4, 0.5), specular=0.7)
    bpy.data.libraries.write(str(tmp_path / "mine.blend"), {mine})
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with bpy.data.libraries.load(str(tmp_path / "mine.blend")) as (_, target):
        target.materials = ["Mine"]
    found = materials.parameters_of(target.materials[0])
    assert found.n == pytest.approx((0.3, 0.4, 0.5)) and found.specular == pytest.approx(0.7)


def test_a_stand_in_becomes_what_its_picture_shows(enabled):
    """A film whose image no other preset shares: the library leaves it out, and it is baked when it comes in."""
    whole = build_assets.held()
    preset = next(preset for preset in build_assets.shown() if preset not in whole)
    asset, = loaded(materials=[asset_name(preset)]).materials
    made = api.create_material(preset=preset.name)
    assert asset.name == preset.title and STAND_IN_KEY not in asset
    assert api.record_of(asset) == api.record_of(made)
    assert materials.our_node(asset).node_tree == materials.our_node(made).node_tree


def test_two_of_the_same_asset_share_a_group_and_can_be_changed_apart(enabled):
    name = asset_name(presets.find("copper"))
    first, second = (loaded(materials=[name]).materials[0] for _ in range(2))
    assert first != second and (first.name, second.name) == ("Copper", "Copper.001")
    assert materials.our_node(first).node_tree == materials.our_node(second).node_tree
    assert not [tree.name for tree in bpy.data.node_groups if tree.name[-4:] == ".001"]
    api.switch_realisation(first, "exact")
    assert materials.realisation_of(second) == "fast"


def test_an_assets_name_leads_back_to_its_preset():
    everything = presets.all_presets().values()
    assert [preset_of(asset_name(preset)) for preset in everything] == [preset.name for preset in everything]
    assert all(len(asset_name(preset).encode()) <= 63 for preset in everything)


def test_a_linked_asset_is_made_local_by_a_button(enabled):
    """With the groups that it needs, in every slot that has it."""
    name = asset_name(presets.find("copper"))
    with bpy.data.libraries.load(str(library.FILE), link=True) as (_, target):
        target.materials = [name]
    both = [bpy.data.objects.new(where, bpy.data.meshes.new(where)) for where in ("First", "Second")]
    for each in both:
        bpy.context.scene.collection.objects.link(each)
        each.data.materials.append(target.materials[0])
    bpy.context.view_layer.objects.active = both[0]
    assert not bpy.ops.facet_film.switch_realisation.poll()
    assert bpy.ops.facet_film.make_local() == {"FINISHED"}
    local = both[0].active_material
    assert local.library is None and both[1].active_material == local and local.name == "Copper"
    assert materials.our_node(local).node_tree.library is None
    assert bpy.ops.facet_film.switch_realisation(realisation="exact") == {"FINISHED"}
    assert not bpy.ops.facet_film.make_local.poll()


def test_a_dragged_asset_can_be_switched(enabled):
    asset, = loaded(materials=[asset_name(presets.find("copper"))]).materials
    assert not groups.edited(materials.our_node(asset).node_tree)
    api.switch_realisation(asset, "exact")
    assert materials.realisation_of(asset) == "exact"


def shown():
    """Names of the libraries that Blender shows."""
    return [found.name for found in bpy.context.preferences.filepaths.asset_libraries if compat.is_enabled(found)]


def test_the_library_is_added_on_request_alone_and_goes_with_the_extension(empty):
    before = shown()
    addon.register()
    assert shown() == before and not library.is_shown()
    assert bpy.ops.facet_film.add_asset_library() == {"FINISHED"}
    assert shown() == [*before, "Facet & Film"] and library.FILE.exists() and library.is_shown()
    assert library.ours()[0].import_method == "APPEND" and not library.add()
    assert not bpy.ops.facet_film.add_asset_library.poll()
    assert bpy.ops.facet_film.remove_asset_library() == {"FINISHED"}
    assert shown() == before and not bpy.ops.facet_film.remove_asset_library.poll()
    assert library.add() and len(library.ours()) == 1
    addon.unregister()
    assert shown() == before


def test_the_catalogues_are_the_same_whenever_they_are_built():
    assert build_assets.CATALOGUE_FILE.read_text(encoding="utf-8") == build_assets.catalogue_text()
