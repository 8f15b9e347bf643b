"""Clear materials in Cycles against numbers, and what Blender is told of them."""

import json

import bpy
import numpy as np
import pytest

from addon import api
from addon.blender.datablocks import materials
from addon.verify import clear_checks, scenes

CHECKS = clear_checks.checks(("fast", "dispersive"))


@pytest.mark.parametrize("check", CHECKS, ids=lambda check: check.title)
def test_the_checks_pass(check):
    outcome = check.run()
    assert outcome.passed, outcome.figures


def test_the_checks_see_another_index_and_another_absorption():
    by_name = {check.name: check for check in CHECKS if check.realisation == "fast"}
    assert not by_name["slab"].run(absorption=(30.0, 120.0, 320.0)).passed
    assert not by_name["thin wall at 60°"].run(ior=1.6).passed
    assert not by_name["see-through shadow"].run(see_through=0.0).passed


@pytest.mark.parametrize("name", ["glass", "water", "ice", "diamond", "acrylic", "oil", "sapphire"])
def test_what_people_type_is_clear_and_told_to_eevee(name):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    material = api.create_material(preset=name)
    assert materials.model_of(material).name == "clear"
    assert material.use_raytrace_refraction
    targets = {node.target for node in material.node_tree.nodes if node.bl_idname == "ShaderNodeOutputMaterial"}
    assert targets == {"CYCLES", "EEVEE"}


def test_another_preset_takes_the_refraction_back():
    material = api.create_material(preset="glass")
    api.create_material(preset="copper", material=material)
    assert not material.use_raytrace_refraction


@pytest.mark.parametrize("preset, given, method", [
    ("cobalt_glass", {"walls": "thin"}, "BLENDED"), ("cobalt_glass", {}, "DITHERED"), ("soap_bubble", {}, "BLENDED"),
    ("copper", {}, "DITHERED"),
])
def test_a_sheet_is_blended_in_eevee_which_dithers_without_colour(preset, given, method):
    material = api.create_material(preset="soap_bubble" if method == "DITHERED" else "copper")
    assert api.create_material(preset=preset, material=material, **given).surface_render_method == method


def test_a_file_that_has_glass_as_an_opaque_mirror_bakes_again():
    material = api.create_material("cook_torrance", preset="window_glass")
    assert api.record_of(api.rebake(material) or material).model == "cook_torrance"


def test_a_record_comes_back_and_leaves_as_json():
    material = api.create_material(preset="red_wine", roughness=0.2, realisation="dispersive")
    record = api.record_of(material)
    assert np.allclose(record.parameters.absorption, (116.0, 252.0, 294.0))
    held = json.loads(api.export(material, "json"))
    assert {"d", "cauchy", "error_max"} == set(held["ior"]) and held["openpbr"]["specular_ior"] == pytest.approx(1.345)
    assert held["gltf"]["extensions"]["KHR_materials_volume"]["attenuationDistance"] > 0.0


@pytest.mark.parametrize("realisation", ["fast", "dispersive"])
def test_a_body_sunk_in_a_floor_throws_its_own_colour_and_not_the_inverse(realisation):
    scene = scenes.empty_scene(8, samples=64, extent=1.6)
    scene.cycles.diffuse_bounces = scene.cycles.transparent_max_bounces = scene.cycles.max_bounces = 16
    scenes.set_world(scene, 1.0)
    scenes.add_sphere(api.create_material("clear", realisation=realisation, ior=1.5, scene_scale=0.01,
                                          absorption=(600.0, 60.0, 300.0)), segments=32)
    white = bpy.data.materials.new("White")
    for place, turned in (((0.0, 0.0, -1.4), 0.0), ((0.4, 0.0, 0.0), 0.5 * np.pi)):  # backdrop; floor, through the ball
        bpy.ops.mesh.primitive_plane_add(size=40.0, location=place, rotation=(0.0, turned, 0.0))
        bpy.context.object.data.materials.append(white)
    scene.camera.location.z = -1.1
    seen = scenes.render(scene)[:, :3]
    assert seen.max() < 1.0, "more light than the world gives"
    assert (seen.mean(axis=(0, 1))[[0, 2]] < seen.mean(axis=(0, 1))[1]).all(), "a green body, and green light"


def test_what_is_embedded_is_lit_through_the_whole_of_the_body_about_it():
    lit = []
    for absorption in ((0.0, 0.0, 0.0), (50.0, 50.0, 50.0)):
        scene = scenes.empty_scene(4, samples=256, extent=0.2)
        scene.cycles.diffuse_bounces = 0
        scenes.add_sun(scene, 0.0)
        scenes.add_sphere(api.create_material("clear", ior=1.0001, scene_scale=0.01, absorption=absorption),
                          segments=64)
        bpy.ops.mesh.primitive_plane_add(size=0.5, location=(0.0, 0.0, 0.3))
        scene.camera.location.z = 0.6
        lit.append(scenes.render(scene).mean())
    assert lit[1] / lit[0] == pytest.approx(np.exp(-0.7 * 0.5), rel=0.01)
