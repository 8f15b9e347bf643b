"""The panels and their operators: pickers, several objects, linked data, light and gamut, groups, the status of a
scene.
"""

import re

import bpy
import pytest

import addon
from addon import api
from addon.blender import compat
from addon.blender import settings as settings_module
from addon.blender.datablocks import materials, menu
from addon.blender.datablocks.groups import node_group
from addon.blender.datablocks.locked import why_locked
from addon.blender.missing import what_is_missing
from addon.blender.operators.apply_to_node import takes_presets, write_preset
from addon.blender.panels import picker
from addon.catalogue.search import search as spectra_search
from addon.errors import FacetFilmError


@pytest.fixture
def objects():
    """Two selected meshes and a selected empty, the first active, the extension registered."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    addon.register()
    made = [bpy.data.objects.new(name, bpy.data.meshes.new(name) if name != "Empty" else None)
            for name in ("First", "Second", "Empty")]
    for target in made:
        bpy.context.scene.collection.objects.link(target)
        target.select_set(True)
    bpy.context.view_layer.objects.active = made[0]
    yield made
    addon.unregister()


def settings():
    return bpy.context.window_manager.facet_film


def test_search_finds_presets_and_datasets(objects):
    assert picker.search("gold babar")[:2] == [("gold", "Gold"), ("main/Au/Babar", picker.search("gold babar")[1][1])]
    settings().preset = "main/Au/Babar · Gold"
    assert settings().preset == "main/Au/Babar"
    assert ("soap_film", "Soap film") in picker.search("soap")


def kept_by_blender(line, typed):
    """Whether Blender's own list shows a line: each word typed begins one of its words."""
    words = line.casefold().replace("/", " ").split()
    return all(any(word.startswith(part) for word in words) for part in typed.casefold().split())


@pytest.mark.parametrize("typed", [
    "gold babar", "quicksilver", "Fe₂O₃", "tungstn", "oxide", "aluminum", "1985", "schott n-bk7", "johnson",
    "bolts and", "stainless ste", "Café", "tio2", "hematite", "soap", "nacre"])
def test_whatever_the_search_finds_is_listed_while_one_types(objects, typed):
    found = picker.search(typed)
    listed = settings_module.search_presets(None, None, typed)
    assert [picker.name_in(line) for line in listed] == [name for name, _ in found]
    assert all(kept_by_blender(line, typed) for line in listed), listed
    assert found == [(one.id, one.title) for one in spectra_search(typed, picker.LISTED)]


def test_a_word_of_an_alias_or_note_is_shown_where_the_title_lacks_it(objects):
    assert picker.lines("quicksilver")[0].startswith("mercury · Mercury · quicksilver")
    assert picker.lines("mercury")[0] == "mercury · Mercury"
    settings().preset = picker.lines("quicksil")[0]
    assert settings().preset == "mercury"


def test_baking_puts_one_material_on_all_selected_objects(objects):
    assert bpy.ops.facet_film.bake_preset(preset="copper") == {"FINISHED"}
    first, second, _ = objects
    assert first.active_material is not None and first.active_material == second.active_material
    assert len(bpy.data.materials) == 1


def test_what_someone_made_by_hand_survives(objects):
    """Shared with another object or not; the slot gets a material of its own, named as what it is."""
    first, second, _ = objects
    second.select_set(False)
    by_hand = bpy.data.materials.new("By Hand")
    compat.enable_nodes(by_hand)
    nodes = [node.name for node in by_hand.node_tree.nodes]
    for target in (first, second):
        target.data.materials.append(by_hand)
    assert bpy.ops.facet_film.bake_preset(preset="gold") == {"FINISHED"}
    assert first.active_material.name == "Gold" and second.active_material == by_hand
    assert [node.name for node in by_hand.node_tree.nodes] == nodes and materials.our_node(by_hand) is None


def test_one_of_ours_is_made_over_where_nothing_else_uses_it(objects):
    first, second, _ = objects
    bpy.ops.facet_film.bake_preset(preset="copper")
    both = first.active_material
    bpy.ops.facet_film.bake_preset(preset="gold")
    assert first.active_material == second.active_material == both and both.name == "Gold"
    second.select_set(False)
    bpy.ops.facet_film.bake_preset(preset="silver")
    assert second.active_material == both and both.name == "Gold" and first.active_material.name == "Silver"
    assert len(bpy.data.materials) == 2


def test_light_and_gamut_reach_the_bake(objects):
    bpy.ops.facet_film.bake_preset(preset="copper", illuminant="A", observer="1964", space="Rec.2020", gamut="clip")
    material = objects[0].active_material
    record = materials.baked_of(material)
    assert (record["illuminant"], record["observer"], record["space"]) == ("A", "1964", "Rec.2020")
    assert record["gamut"]["method"] == "clip"
    assert record["f0"] == pytest.approx(api.bake("copper", illuminant="A", observer="1964", space="Rec.2020").f0)
    n = materials.parameters_of(material).n
    assert bpy.ops.facet_film.rebake() == {"FINISHED"}
    assert materials.baked_of(material)["illuminant"] == "D65"
    assert materials.parameters_of(material).n != n


def test_re_baking_keeps_what_the_user_set(objects):
    bpy.ops.facet_film.bake_preset(preset="gold", illuminant="A", realisation="exact")
    material = objects[0].active_material
    record = materials.record_of(material)
    materials.write(material, record.changed(
        parameters=record.parameters.changed(slopes=((0.33, 1.0),), specular=0.5)))
    other = api.create_material(preset="silver", viewing={"illuminant": "A"})
    assert bpy.ops.facet_film.rebake_all() == {"FINISHED"}
    found = materials.parameters_of(material)
    assert found.slopes[0][0] == pytest.approx(0.33) and found.specular == pytest.approx(0.5)
    assert materials.realisation_of(material) == "exact"
    assert {materials.baked_of(one)["illuminant"] for one in (material, other)} == {"D65"}


def test_linked_and_overridden_data_say_why_they_cannot_be_changed(objects, tmp_path):
    bpy.ops.facet_film.bake_preset(preset="copper")
    file = str(tmp_path / "source.blend")
    bpy.data.libraries.write(file, {objects[0]})
    with bpy.data.libraries.load(file, link=True) as (_, target):
        target.objects = ["First"]
    linked = target.objects[0]
    bpy.context.scene.collection.objects.link(linked)
    for other in objects:
        other.select_set(False)
    bpy.context.view_layer.objects.active = linked
    for operator in (bpy.ops.facet_film.bake_preset, bpy.ops.facet_film.switch_realisation, bpy.ops.facet_film.rebake):
        assert not operator.poll()
    assert "linked" in why_locked(linked) and "linked" in why_locked(linked.active_material)
    assert "override" in why_locked(linked.override_create())


def test_the_panel_says_what_the_scene_lacks(objects):
    scene = bpy.context.scene
    scene.render.engine = "BLENDER_WORKBENCH"
    assert "Cycles" in what_is_missing(scene, "fast")
    scene.render.engine = "CYCLES"
    scene.cycles.shading_system = False
    assert "Open Shading Language" in what_is_missing(scene, "osl")
    assert what_is_missing(scene, "exact") == ""
    scene.cycles.shading_system = True
    assert what_is_missing(scene, "osl") == ""
    scene.cycles.device = "GPU"
    assert "OptiX" in what_is_missing(scene, "osl")


def test_every_group_of_the_add_menu_is_there_and_is_reused(objects):
    for identifier, _, _ in menu.group_items():
        if identifier == "fresnel_ramp":
            assert api.create_fresnel_ramp("gold") == api.create_fresnel_ramp("gold")
        else:
            assert node_group(identifier) == node_group(identifier)
    assert not [tree.name for tree in bpy.data.node_groups if re.search(r"\.\d{3}$", tree.name)]


def test_a_preset_goes_into_a_single_node(objects):
    material = bpy.data.materials.new("Mixed")
    compat.enable_nodes(material)
    node = material.node_tree.nodes.new("ShaderNodeGroup")
    node.node_tree = node_group("cook_torrance_exact")
    assert takes_presets(node)
    write_preset(node, "gold", {})
    assert tuple(node.inputs["Refractive Index n"].default_value) == pytest.approx(
        api.bake("gold", formula="exact").conductor.n)
    node.node_tree = api.create_fresnel_ramp("gold")
    write_preset(node, "copper", {})
    assert node.node_tree == api.create_fresnel_ramp("copper")


def test_a_spread_of_a_preset_without_dataset_says_so():
    from addon.bake import spread
    from addon.catalogue.presets import all_presets
    without = next(preset.name for preset in all_presets().values() if not preset.dataset)
    with pytest.raises(FacetFilmError, match="has no dataset"):
        spread(without)


def test_presets_of_the_user_are_saved_applied_renamed_and_deleted(objects, tmp_path, monkeypatch):
    monkeypatch.setattr(bpy.utils, "user_resource", lambda *_a, path="", **_k: str(_made(tmp_path / path)))
    monkeypatch.setattr(bpy.utils, "preset_paths", lambda subdir: [str(_made(tmp_path / "presets" / subdir))])
    bpy.ops.facet_film.bake_preset(preset="gold", realisation="exact")
    kept = materials.parameters_of(objects[0].active_material)
    assert bpy.ops.facet_film.save_user_preset(name="My gold") == {"FINISHED"}
    bpy.ops.facet_film.bake_preset(preset="copper")
    assert bpy.ops.facet_film.rename_user_preset(old="My gold", new="Ring") == {"FINISHED"}
    file = tmp_path / "presets" / "facet_film" / "Ring.py"
    assert bpy.ops.facet_film.apply_user_preset(filepath=str(file)) == {"FINISHED"}
    material = objects[0].active_material
    assert materials.parameters_of(material) == kept
    assert materials.baked_of(material)["name"] == "gold"
    assert materials.realisation_of(material) == "exact"
    bpy.ops.facet_film.save_user_preset(name="Ring", remove_name=True)
    assert not file.exists()
    file.write_text("no preset")
    with pytest.raises(RuntimeError, match="no preset of Facet"):
        bpy.ops.facet_film.apply_user_preset(filepath=str(file))


def _made(folder):
    folder.mkdir(parents=True, exist_ok=True)
    return folder
