"""create_material: what it makes, reuses, refuses and leaves behind."""

import bpy
import numpy as np
import pytest

from addon import api
from addon.blender import compat
from addon.blender.datablocks import materials
from addon.catalogue import presets
from addon.errors import FacetFilmError
from tests.render import probes


@pytest.fixture(autouse=True)
def empty_file():
    bpy.ops.wm.read_factory_settings(use_empty=True)


def test_preset_sets_what_was_baked():
    material = api.create_material(preset="copper")
    baked = api.bake("copper")
    found = materials.parameters_of(material)
    assert material.name == "Copper"
    assert found.n == pytest.approx(baked.conductor.n, rel=1e-6)
    assert found.k == pytest.approx(baked.conductor.k, rel=1e-6)
    assert np.allclose(found.slopes, presets.find("copper").parameters["slopes"])
    assert materials.baked_of(material)["source"]["dataset"] == "main/Cu/Johnson"
    assert materials.realisation_of(material) == "fast"


def test_metals_are_told_apart_in_the_solid_viewport():
    """Copper is redder than skin, gold yellow, silver far brighter than steel, steel than chromium; plastic is none."""
    metals = [api.create_material(preset=name) for name in ("copper", "gold", "silver", "stainless_steel", "chromium")]
    copper, gold, silver, steel, chromium = (np.array(material.diffuse_color[:3]) for material in metals)
    assert copper[0] > 2.0 * copper[1] > 2.0 * copper[2] and gold[0] > gold[1] > 4.0 * gold[2]
    assert silver.mean() > 2.0 * steel.mean() > 2.0 * 1.25 * chromium.mean() and np.ptp(silver) < 0.05
    assert all(0.3 < material.metallic < 0.6 for material in metals)
    assert metals[-1].roughness < 0.8 * metals[-2].roughness  # plated, and rolled
    for name in ("vinyl", "plastic_blue", "window_glass", "diamond"):
        assert api.create_material(preset=name).metallic < 0.1


def test_parameters_go_over_the_preset():
    material = api.create_material(preset="copper", name="Mine", slopes=[(0.3, 0.5), (0.1, 0.5)], specular=0.5,
                                   scale="published", distribution="gaussian", gaussian_c=2.0)
    found = materials.parameters_of(material)
    assert np.allclose(found.slopes, [(0.3, 0.5), (0.1, 0.5)])
    assert (found.specular, found.scale, found.distribution, found.gaussian_c) == (0.5, "published", "gaussian", 2.0)


def test_groups_are_reused_but_an_edited_one_is_left_alone():
    first = materials.our_node(api.create_material(preset="copper")).node_tree
    second = materials.our_node(api.create_material(preset="gold")).node_tree
    assert first == second
    edited = next(node for node in first.nodes if node.bl_idname == "ShaderNodeMath" and not node.inputs[1].is_linked)
    edited.inputs[1].default_value += 0.25
    third = materials.our_node(api.create_material(preset="gold")).node_tree
    assert third != first


def test_making_over_a_material_keeps_one_output():
    material = api.create_material(preset="copper")
    api.create_material(preset="gold", material=material)
    assert len(bpy.data.materials) == 1
    kinds = sorted(node.bl_idname for node in material.node_tree.nodes)
    assert kinds == ["ShaderNodeGroup", "ShaderNodeOutputMaterial"]


BAD = {
    "unknown preset": ({"preset": "coper"}, "copper"),
    "unknown model": ({"model": "cook_torence"}, "cook_torrance"),
    "unknown realisation": ({"realisation": "referense"}, "'reference'"),
    "unknown parameter": ({"slope": [(0.2, 1.0)]}, "slopes"),
    "slope of nothing": ({"slopes": [(0.0, 1.0)]}, "slope m 1"),
    "negative slope": ({"slopes": [(-0.1, 1.0)]}, "above 0"),
    "no weight": ({"slopes": [(0.2, 0.0)]}, "more than 0"),
    "too much weight": ({"slopes": [(0.2, 0.7), (0.3, 0.7)]}, "at most 1"),
    "five slopes": ({"slopes": [(0.2, 0.2)] * 5}, "one to 4"),
    "fraction above one": ({"specular": 1.5}, "0 to 1"),
    "NaN": ({"specular": float("nan")}, "specular"),
    "two numbers": ({"n": (1.0, 2.0)}, "3 numbers"),
    "index of nothing": ({"n": (0.0, 1.0, 1.0)}, "n[0]"),
    "negative k": ({"k": (-1.0, 1.0, 1.0)}, "k[0]"),
    "text": ({"diffuse": "red"}, "diffuse"),
    "distribution": ({"distribution": "ggx"}, "beckmann"),
    "scale": ({"scale": "print"}, "published"),
    "name": ({"name": ""}, "name"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_input_is_one_clear_sentence_and_leaves_nothing(case):
    parameters, said = BAD[case]
    with pytest.raises(FacetFilmError) as error:
        api.create_material(**parameters)
    assert said in str(error.value) and "\n" not in str(error.value)
    assert not bpy.data.materials and not bpy.data.node_groups


def test_ramp_is_the_baked_curve_within_what_the_renderer_tables():
    scene = probes.empty_scene(64, pixel_centres=True)
    tree = api.create_fresnel_ramp("copper")
    assert api.create_fresnel_ramp("copper") == tree
    material = bpy.data.materials.new("Ramp")
    compat.enable_nodes(material)
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    group = nodes.new("ShaderNodeGroup")
    group.node_tree = tree
    emission = nodes.new("ShaderNodeEmission")
    links.new(group.outputs["Color"], emission.inputs["Color"])
    links.new(emission.outputs["Emission"], nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    probes.add_sphere(material)
    picture = probes.render(scene)
    normals, mask = probes.pixel_normals(64)
    curve = api.bake("copper").fresnel
    reference = np.stack([np.interp(normals[:, :, 0, 2], curve.cos_theta, channel)
                          for channel in np.transpose(curve.rgb)], axis=-1)
    assert np.abs(picture - reference)[mask].max() < 1e-3


def test_dielectric_takes_the_closure_that_comes_closest():
    """Vinyl head on, and near grazing, where 4.5's conductor is off by a tenth."""
    scene = probes.empty_scene(32, samples=64)
    probes.add_sphere(api.create_material(preset="vinyl", slopes=[(0.02, 1.0)], specular=1.0))
    probes.set_world(scene, 1.0)
    picture = probes.render_seeds(scene, 2).mean(axis=0)
    normals, mask = probes.pixel_normals(32, subsamples=4)
    exact = api.bake("vinyl", formula="exact").fresnel
    reference = np.stack([np.interp(normals[..., 2], exact.cos_theta, channel).mean(axis=2)
                          for channel in np.transpose(exact.rgb)], axis=-1)
    mask &= normals[..., 2].min(axis=2) > 0.15
    assert np.abs(picture - reference)[mask].max() < 0.03
