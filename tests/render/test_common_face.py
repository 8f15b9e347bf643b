"""The face where two clear bodies touch: by the API, by the menu of a material, and cut out of two objects."""

import bpy
import numpy as np
import pytest

import addon
from addon import api
from addon.blender.operators import common_face
from addon.errors import FacetFilmError
from tools.clear_scenes import tube

GLASS_IOR, WATER_IOR = 1.523, 1.333


@pytest.fixture
def bodies():
    """(water, a tube of it, glass, a thick tube whose hole it fills), the extension registered."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    addon.register()
    corners, faces = tube(0.8, 2.0, 24)
    outside, caps = tube(1.0, 2.4, 24)
    hole = [tuple(corner + 48 for corner in face[::-1]) for face in faces[2:]]
    yield (_object("Water", corners, faces, "water"),
           _object("Glass", np.concatenate([outside, corners]), [*caps, *hole], "window_glass"))
    addon.unregister()


def _object(name, corners, faces, preset):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(corners.tolist(), [], faces)
    mesh.materials.append(api.create_material(preset=preset))
    found = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(found)
    return found


def _select(active, *others):
    for one in bpy.context.scene.objects:
        one.select_set(one in (active, *others))
    bpy.context.view_layer.objects.active = active


def _outside(material):
    return api.record_of(material).parameters.outside


def test_two_clear_materials_give_that_of_their_common_face(bodies):
    water, glass = (body.active_material for body in bodies)
    made = api.common_face(water, glass)
    assert made.name == "Water against Window glass" or made.name.startswith("Water against")
    assert _outside(made) == pytest.approx(GLASS_IOR, abs=2e-3)
    assert api.record_of(made).parameters.ior == pytest.approx(WATER_IOR, abs=2e-3)
    assert _outside(water) == 1.0 and _outside(api.common_face(made, None)) == 1.0
    with pytest.raises(FacetFilmError, match="is no clear body"):
        api.common_face(water, api.create_material(preset="gold"))
    with pytest.raises(FacetFilmError, match="not a material of Facet"):
        api.common_face(water, bpy.data.materials.new("Own"))


def test_the_menu_of_a_material_says_what_its_face_is_against(bodies):
    water, glass = bodies
    _select(water)
    assert common_face.shown_outside(water.active_material) == "Air"
    assert bpy.ops.facet_film.touch(outside=glass.active_material.name) == {"FINISHED"}
    assert water.active_material.name == "Water" and _outside(water.active_material) > 1.5
    assert common_face.shown_outside(water.active_material).startswith("n = 1.52")
    assert bpy.ops.facet_film.touch(outside=common_face.AIR) == {"FINISHED"}
    assert _outside(water.active_material) == 1.0


def test_a_material_that_others_use_stays_and_selected_faces_get_their_own(bodies):
    water, glass = bodies
    shared = water.active_material
    glass.data.materials.append(shared)
    _select(water)
    bpy.ops.facet_film.touch(outside=glass.active_material.name)
    assert water.active_material != shared and _outside(shared) == 1.0
    water.data.materials.clear()
    water.data.materials.append(shared)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="DESELECT")
    bpy.ops.object.mode_set(mode="OBJECT")
    water.data.polygons[5].select = True
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.facet_film.touch(outside=glass.active_material.name)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert [face.index for face in water.data.polygons if face.material_index] == [5]
    assert _outside(water.data.materials[1]) > 1.5 and _outside(shared) == 1.0


def test_the_common_face_of_two_objects_is_there_once(bodies):
    water, glass = bodies
    glass.location.x = water.location.x = 3.0
    bpy.context.view_layer.update()
    before = len(glass.data.polygons)
    _select(water, glass)
    assert bpy.ops.facet_film.common_face() == {"FINISHED"}
    sides = [face for face in water.data.polygons if face.material_index == 1]
    assert len(sides) == 24 and len(glass.data.polygons) == before - 24
    assert _outside(water.data.materials[1]) == pytest.approx(GLASS_IOR, abs=2e-3)
    assert _outside(water.data.materials[0]) == 1.0


def test_objects_that_do_not_touch_are_told_so_and_stay(bodies):
    water, glass = bodies
    water.location.x = 5.0
    bpy.context.view_layer.update()
    _select(water, glass)
    with pytest.raises(RuntimeError, match="No face of Water lies on Glass"):
        bpy.ops.facet_film.common_face()
    assert len(water.data.materials) == 1 and len(glass.data.polygons) == 50
    _select(water)
    assert not bpy.ops.facet_film.common_face.poll()
    water.data.materials[0] = api.create_material(preset="gold")
    assert not bpy.ops.facet_film.touch.poll()


def test_undo_takes_the_common_face_back(bodies):
    water, glass = bodies
    bpy.context.preferences.edit.use_global_undo = True
    _select(water, glass)
    bpy.ops.ed.undo_push(message="before")
    bpy.ops.facet_film.common_face("EXEC_DEFAULT", True)
    bpy.ops.ed.undo()
    assert len(bpy.data.objects["Glass"].data.polygons) == 50
