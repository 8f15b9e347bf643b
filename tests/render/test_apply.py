"""A click on a picture: what gets the material, what stays as it was, what is said, and what undo takes back."""

import bpy
import pytest

import addon
from addon import api
from addon.blender import compat
from addon.blender.assets.names import asset_name
from addon.blender.assets.search_items import items
from addon.blender.datablocks import materials
from addon.blender.datablocks.untouched import is_untouched
from addon.blender.operators.apply import slot_of_face
from addon.blender.operators.targets import put, put_said
from addon.blender.panels.shelves import FACET_FILM_AST_picker
from addon.catalogue.presets import find

apply = bpy.ops.facet_film.apply


@pytest.fixture
def objects():
    """Two selected cubes and a selected lamp, the first cube active, the extension registered."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    addon.register()
    for name in ("First", "Second"):
        bpy.ops.mesh.primitive_cube_add()
        bpy.context.active_object.name = bpy.context.active_object.data.name = name
    lamp = bpy.data.objects.new("Lamp", bpy.data.lights.new("Lamp", "POINT"))
    bpy.context.scene.collection.objects.link(lamp)
    first, second = bpy.data.objects["First"], bpy.data.objects["Second"]
    for target in (first, second, lamp):
        target.select_set(True)
    bpy.context.view_layer.objects.active = first
    yield first, second, lamp
    addon.unregister()


def by_hand():
    """A material with a texture in it."""
    found = bpy.data.materials.new("By Hand")
    compat.enable_nodes(found)
    found.node_tree.nodes.new("ShaderNodeTexNoise")
    return found


def picture_of(preset):
    """As the shelf names what was clicked."""
    return f"facet_film_assets.blend/Material/{asset_name(find(preset))}"


def test_a_click_on_a_picture_puts_it_on_all_that_is_selected(objects):
    first, second, lamp = objects
    assert apply(relative_asset_identifier=picture_of("aluminium")) == {"FINISHED"}
    assert first.active_material == second.active_material and first.active_material.name == "Aluminium"
    assert materials.baked_of(first.active_material)["name"] == "aluminium"


def test_it_says_in_plain_words_what_is_where(objects):
    done = put(bpy.context, lambda material: api.create_material(preset="gold", material=material))
    assert put_said(done) == ("WARNING", "Gold on First, Second. Left out, as they take no materials or are linked: "
                                         "Lamp")
    objects[2].select_set(False)
    assert put_said(put(bpy.context, lambda material: material)) == ("INFO", "Gold on First, Second")


def test_a_lamp_alone_is_told_that_it_takes_none(objects):
    for target in objects[:2]:
        target.select_set(False)
    bpy.context.view_layer.objects.active = objects[2]
    assert not apply.poll()


def test_the_active_object_may_be_one_that_takes_none(objects):
    bpy.context.view_layer.objects.active = objects[2]
    assert apply(preset="gold") == {"FINISHED"}
    assert objects[1].active_material.name == "Gold"


def test_what_someone_made_by_hand_stays_and_is_kept_in_the_file(objects):
    first, second, _ = objects
    second.select_set(False)
    shared, alone = by_hand(), by_hand()
    for target in (first, second):
        target.data.materials.append(shared)
    second.data.materials.append(alone)
    assert apply(preset="gold") == {"FINISHED"}
    assert first.active_material.name == "Gold" and second.material_slots[0].material == shared
    first.select_set(False)
    second.select_set(True)
    second.active_material_index = 1
    bpy.context.view_layer.objects.active = second
    assert apply(preset="silver") == {"FINISHED"}
    assert alone.use_fake_user and not shared.use_fake_user
    assert len(alone.node_tree.nodes) == 3 and materials.our_node(alone) is None


def test_what_blender_made_is_not_kept():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    fresh = bpy.data.materials.new("Material")
    compat.enable_nodes(fresh)
    assert is_untouched(fresh) and len(bpy.data.materials) == 1
    next(node for node in fresh.node_tree.nodes if node.inputs.get("Roughness")).inputs["Roughness"].default_value = 0.1
    assert not is_untouched(fresh) and not is_untouched(by_hand())


def test_one_of_ours_is_made_over_only_where_all_its_slots_are_meant(objects):
    first, second, _ = objects
    apply(preset="copper")
    copper = first.active_material
    first.data.materials.append(copper)
    apply(preset="gold")
    assert first.material_slots[1].material == copper and copper.name == "Copper"
    assert first.material_slots[0].material == second.active_material and second.active_material.name == "Gold"
    apply(preset="silver")
    assert second.active_material.name == "Silver" and len(bpy.data.materials) == 2


@pytest.mark.parametrize("to, expected", [
    ("SLOT", ["By Hand", "Gold"]), ("NEW_SLOT", ["By Hand", "By Hand", "Gold"]), ("ALL_SLOTS", ["Gold", "Gold"])])
def test_slots(objects, to, expected):
    first, second, _ = objects
    second.select_set(False)
    hand = by_hand()
    for _ in range(2):
        first.data.materials.append(hand)
    first.active_material_index = 1
    assert apply(preset="gold", to=to) == {"FINISHED"}
    assert [slot.material.name for slot in first.material_slots] == expected


def test_in_place_makes_over_what_is_there_wherever_it_is_used(objects):
    first, second, _ = objects
    second.select_set(False)
    hand = by_hand()
    for target in (first, second):
        target.data.materials.append(hand)
    assert apply(preset="gold", to="IN_PLACE") == {"FINISHED"}
    assert first.active_material == second.active_material == hand and materials.baked_of(hand)["name"] == "gold"


def test_a_new_slot_takes_the_faces_that_are_selected(objects):
    first, second, _ = objects
    second.select_set(False)
    apply(preset="copper")
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_mode(type="FACE")
    bpy.ops.mesh.select_all(action="DESELECT")
    bpy.ops.object.mode_set(mode="OBJECT")
    first.data.polygons[2].select = True
    bpy.ops.object.mode_set(mode="EDIT")
    assert apply(preset="gold", to="NEW_SLOT") == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    assert [polygon.material_index for polygon in first.data.polygons] == [0, 0, 1, 0, 0, 0]
    assert [slot.material.name for slot in first.material_slots] == ["Copper", "Gold"]
    assert [slot_of_face(first, face) for face in (0, 2, 99)] == [0, 1, 1]


def test_it_renders_as_what_it_replaces_where_it_can(objects):
    apply(preset="copper")
    api.switch_realisation(objects[0].active_material, "exact")
    apply(preset="gold")
    assert materials.realisation_of(objects[0].active_material) == "exact"
    apply(preset="water")
    assert materials.realisation_of(objects[0].active_material) == "fast"


def test_the_search_lists_every_material_by_all_its_names(objects):
    listed = {name: text for name, text, *_ in items()}
    assert {"gold", "water", "soap_bubble", "nacre"} <= set(listed)
    assert "aluminum" in listed["aluminium"] and "Kupfer" not in listed["aluminium"]
    assert bpy.ops.facet_film.search(preset="gold") == {"FINISHED"}
    assert objects[0].active_material.name == "Gold"
    again = next(name for name, text, *_ in items() if text == "Window glass ▸ glass")
    assert bpy.ops.facet_film.search(preset=again) == {"FINISHED"}
    assert objects[0].active_material.name == "Window glass"


def test_the_shelf_takes_our_materials_alone():
    from types import SimpleNamespace

    from addon.blender.assets import library
    ours = SimpleNamespace(id_type="MATERIAL", full_path=f"{library.FILE}/Material/Gold")
    assert FACET_FILM_AST_picker.asset_poll(ours)
    for kind, file in (("NODETREE", str(library.FILE)), ("MATERIAL", "")):
        assert not FACET_FILM_AST_picker.asset_poll(SimpleNamespace(id_type=kind, full_path=file))


def test_a_name_that_is_no_materials_is_told(objects):
    with pytest.raises(RuntimeError, match="no material of Facet & Film called"):
        apply(relative_asset_identifier="facet_film_assets.blend/Material/Suzanne")
