"""Clear materials in Cycles against numbers, and what Blender is told of them."""

import json

import bpy
import numpy as np
import pytest

from addon import api
from addon.blender.datablocks import materials
from addon.verify import clear_checks

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
