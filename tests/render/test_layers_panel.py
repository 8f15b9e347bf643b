"""The panel of layers: list and text say the same, and Bake makes the material of them."""

import time

import bpy
import pytest

import addon
from addon import api
from addon.blender import layers
from addon.blender.assets import swatches
from addon.blender.datablocks import materials
from addon.blender.datablocks.pictures import image_in, key_of

MIRROR = "water | (TiO2 40-75 nm / SiO2 94 nm)x2 / glass"


@pytest.fixture
def film():
    """A cube of anodised titanium, shown by the panel, the extension registered."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    addon.register()
    bpy.ops.mesh.primitive_cube_add()
    material = api.create_material(preset="anodised_titanium", roughness=0.5)
    bpy.context.active_object.data.materials.append(material)
    layers.load(material)
    yield material
    addon.unregister()


def settings():
    return bpy.context.window_manager.facet_film


def listed():
    return [(layer.material, layer.thickness, layer.greatest if layer.varies else None) for layer in settings().layers]


def test_the_list_is_what_the_text_says(film):
    assert settings().layers_text == "TiO2 0-200 nm / Ti"
    assert listed() == [("TiO2", 0.0, 200.0)] and settings().layers_below == "Ti"
    settings().layers_text = MIRROR
    assert listed() == [("TiO2", 40.0, 75.0), ("SiO2", 94.0, None)] * 2
    assert (settings().layers_outside, settings().layers_below) == ("water", "glass")


def test_the_text_is_what_the_list_says(film):
    layer = settings().layers[0]
    layer.thickness = 12.5
    assert settings().layers_text == "TiO2 12.5-200 nm / Ti"
    layer.varies = False
    layer.material = "main/TiO2/Siefke · Titanium dioxide"  # as a line that was chosen from the list
    assert settings().layers_text == "main/TiO2/Siefke 12.5 nm / Ti"
    settings().layers_outside = "water"
    settings().layers_below = "steel"
    assert settings().layers_text == "water | main/TiO2/Siefke 12.5 nm / steel"


def test_layers_are_added_moved_and_removed(film):
    change = bpy.ops.facet_film.change_layers
    change(what="ADD")
    settings().layers[1].material = "SiO2"
    assert settings().layers_text == "TiO2 0-200 nm / SiO2 100 nm / Ti" and settings().layer == 1
    change(what="UP")
    assert settings().layers_text == "SiO2 100 nm / TiO2 0-200 nm / Ti" and settings().layer == 0
    change(what="UP")
    change(what="DOWN")
    assert settings().layers_text == "TiO2 0-200 nm / SiO2 100 nm / Ti"
    change(what="REMOVE")
    change(what="REMOVE")
    change(what="REMOVE")
    assert settings().layers_text == "Ti" and not listed()
    change(what="ADD")
    assert settings().layers_text == "SiO2 100 nm / Ti"


@pytest.mark.parametrize("text, said", [
    ("Foo 10 nm / Si", "At 'Foo 10 nm'"), ("SiO2 / Si", "At 'SiO2'"), ("SiO2 10 nm /  / Si", "a layer is missing"),
    ("Ag | SiO2 10 nm / Si", "must not absorb"), ("copper", "stack must be layers"), ("", "stack must be layers")])
def test_what_cannot_be_baked_is_told_where_it_is_typed(film, text, said):
    settings().layers_text = text
    assert said in layers.why_not(film, text)
    with pytest.raises(RuntimeError, match=said):
        bpy.ops.facet_film.bake_layers(text=text)
    assert layers.made_of(film) == "TiO2 0-200 nm / Ti"


def test_bake_makes_the_material_of_the_layers_and_keeps_the_rest(film):
    settings().layers_text = "Nb2O5 0-350 nm / Nb"
    assert bpy.ops.facet_film.bake_layers(text=settings().layers_text) == {"FINISHED"}
    record = api.record_of(film)
    assert layers.made_of(film) == record.parameters.stack == record.source.name == "Nb2O5 0-350 nm / Nb"
    assert record.parameters.roughness == pytest.approx(0.5) and record.parameters.thickness_range == (10.0, 175.0)
    assert record.baked["layers"][1]["dataset"] == "main/Nb2O5/Lemarchand"
    bpy.ops.facet_film.bake_layers(text="SiO2 300-400 nm / Si")
    assert api.record_of(film).parameters.thickness_range is None
    assert materials.our_node(film).inputs["Thickness"].default_value == pytest.approx(350.0)
    assert not materials.our_node(film).inputs["Thickness"].is_linked


def test_a_file_of_ones_own_is_a_layer(film, tmp_path):
    file = tmp_path / "my oxide.csv"
    file.write_text("wavelength_nm,n,k\n360,2.5,0.1\n780,2.3,0.0\n", encoding="utf-8")
    assert bpy.ops.facet_film.layer_file(filepath=str(file)) == {"FINISHED"}
    assert settings().layers_text == f"{file} 0-200 nm / Ti"
    assert bpy.ops.facet_film.bake_layers(text=settings().layers_text) == {"FINISHED"}
    file.unlink()
    layers._why_not.cache_clear()
    assert layers.why_not(film, settings().layers_text) == ""  # the material keeps what it held
    api.rebake(film, {"illuminant": "A"})
    assert str(file) in api.record_of(film).parameters.own_layers
    with pytest.raises(RuntimeError):
        bpy.ops.facet_film.layer_file(filepath=str(tmp_path / "none.csv"))


def test_other_materials_have_no_layers(film):
    bpy.context.active_object.active_material = api.create_material(preset="copper")
    assert not bpy.ops.facet_film.bake_layers.poll()
    assert layers.made_of(bpy.context.active_object.active_material) == ""


def test_the_strip_is_drawn_once_for_an_image(film):
    key = key_of(image_in(materials.our_node(film).node_tree))
    assert swatches.swatch_icon(film, key) is None
    swatches.draw(film, key)
    shown = swatches.swatch_icon(film, key)
    assert (shown.over, shown.first, shown.last, shown.unit, shown.has_angles) == ("thickness", 0.0, 200.0, "nm", True)
    start = time.perf_counter()
    for _ in range(100):
        swatches.swatch_icon(film, key)
    assert time.perf_counter() - start < 0.05
