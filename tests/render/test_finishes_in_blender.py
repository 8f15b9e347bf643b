"""Finishes in Blender: what their groups vary over a surface, and what a material keeps of them."""

import bpy
import numpy as np
import pytest

from addon import api, finishes
from addon.blender.datablocks import groups, materials
from addon.blender.operators import user_presets
from addon.blender.operators.apply_to_node import write_preset
from addon.finishes import feeding
from addon.finishes.groups import GROUPS
from tests.render import probes

IDENTIFIERS = [group.identifier for group in GROUPS]
SIDE = 32


@pytest.fixture(autouse=True)
def empty_file():
    bpy.ops.wm.read_factory_settings(use_empty=True)


def probe(identifier, scale=(1.0, 1.0, 1.0), applied=False, **values):
    """(roughness, 1 − cosine of the tilt, cosine of the tangent to the normal) over a ball, ``(pixels, 3)``."""
    scene = probes.empty_scene(SIDE, samples=4, extent=2.2 * max(scale))
    material = bpy.data.materials.new("Probe")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    node = tree.nodes.new("ShaderNodeGroup")
    node.node_tree = groups.node_group(identifier)
    for name, value in values.items():
        node.inputs[name].default_value = value
    own = tree.nodes.new("ShaderNodeNewGeometry").outputs["Normal"]
    together = tree.nodes.new("ShaderNodeCombineXYZ")
    tree.links.new(node.outputs["Roughness"], together.inputs[0])
    for number, name in enumerate(("Normal", "Tangent"), 1):
        if name in node.outputs:
            dot = tree.nodes.new("ShaderNodeVectorMath")
            dot.operation = "DOT_PRODUCT"
            tree.links.new(node.outputs[name], dot.inputs[0])
            tree.links.new(own, dot.inputs[1])
            tree.links.new(dot.outputs["Value"], together.inputs[number])
    emission = tree.nodes.new("ShaderNodeEmission")
    tree.links.new(together.outputs[0], emission.inputs["Color"])
    tree.links.new(emission.outputs[0], tree.nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    ball = probes.add_sphere(material, segments=64)
    if applied:
        for vertex in ball.data.vertices:
            vertex.co = [x * s for x, s in zip(vertex.co, scale)]
    else:
        ball.scale = scale
    y, x = (np.mgrid[:SIDE, :SIDE] + 0.5) / SIDE * 2.0 - 1.0
    inside = np.hypot(x * 1.1, y * 1.1) < 0.85 * min(scale) / max(scale)
    return probes.render(scene)[inside]


@pytest.mark.parametrize("identifier", IDENTIFIERS)
def test_a_group_varies_what_it_drives_about_what_it_was_given(identifier):
    drives = feeding._module(identifier).DRIVES
    roughness, tilt, along = probe(identifier, Roughness=0.3).T
    assert np.isfinite(roughness).all() and roughness.std() > 0.004
    assert roughness.min() >= 0.0 and 0.2 < roughness.mean() < 0.4
    if "Normal" in drives:
        assert (1.0 - tilt).max() > 1e-3 and tilt.mean() > 0.8
    if "Tangent" in drives:
        assert np.abs(along).max() < 0.02  # it lies on the surface


@pytest.mark.parametrize("identifier, none", [
    ("finish_brushed", {"Unevenness": 0.0, "Depth": 0.0}),
    ("finish_brushed_circular", {"Unevenness": 0.0, "Depth": 0.0}),
    ("finish_cast", {"Unevenness": 0.0, "Depth": 0.0}), ("finish_sandblasted", {"Unevenness": 0.0, "Depth": 0.0}),
    ("finish_scratched", {"Amount": 0.0})])
def test_controls_at_zero_leave_the_surface_as_it_was(identifier, none):
    roughness, tilt, _ = probe(identifier, Roughness=0.4, **none).T
    assert np.abs(roughness - 0.4).max() < 1e-3 and np.abs(1.0 - tilt).max() < 1e-3


@pytest.mark.parametrize("identifier, control, value", [
    ("finish_brushed", "Scale", 7.0), ("finish_brushed", "UV", 1.0), ("finish_brushed_circular", "UV", 1.0),
    ("finish_hammered", "Scale", 3.0), ("finish_cast", "Pits", 1.0), ("finish_scratched", "Amount", 1.0),
    ("finish_smudged", "Wipe Marks", 0.0), ("finish_worn_edges", "Wear", 1.0)])
def test_each_control_changes_the_marks(identifier, control, value):
    usual, other = probe(identifier), probe(identifier, **{control: value})
    assert np.abs(usual - other).max() > 0.01


@pytest.mark.parametrize("identifier", ["finish_brushed", "finish_hammered"])
def test_an_objects_scale_stretches_nothing(identifier):
    """The marks of a scaled object are those of a mesh that has the scale itself."""
    stretched, grown = (probe(identifier, (2.0, 1.0, 1.0), applied, Scale=2.0) for applied in (False, True))
    assert np.abs(stretched[:, 0] - grown[:, 0]).mean() < 0.1 * stretched[:, 0].std() + 1e-4


def finish_links(material):
    node = materials.our_node(material)
    return {link.to_socket.name for link in material.node_tree.links if link.to_node == node
            and link.from_node == materials.finish_node(material)}


@pytest.mark.parametrize("preset", ["copper", "vinyl", "anodised_titanium"])
def test_any_material_takes_any_finish(preset):
    material = api.create_material(preset=preset)
    realisation = materials.realisation_of(material)
    sockets = {socket.name for socket in materials.model_of(material).sockets(realisation)}
    for finish in finishes.all_finishes():
        api.apply_finish(material, finish.name)
        assert api.record_of(material).finish == materials.finish_of(material) == finish.name
        driven = feeding._module(finish.group).DRIVES if finish.group else ()
        assert finish_links(material) == set(driven) & sockets
        assert len([n for n in material.node_tree.nodes if finishes.of_group(groups.group_id(
            getattr(n, "node_tree", None)))]) == bool(finish.group)
    api.apply_finish(material, "")
    assert api.record_of(material).parameters == api.record_of(api.create_material(preset=preset)).parameters
    assert materials.finish_of(material) == "" and materials.finish_node(material) is None


def test_preset_and_finish_are_two_choices():
    material = api.create_material(preset="anodised_titanium", finish="hammered")
    materials.finish_node(material).inputs["Scale"].default_value = 9.0
    materials.finish_node(material).inputs["Roughness"].default_value = 0.5
    api.create_material(preset="gold", material=material)
    found = api.record_of(material)
    assert (found.finish, found.controls, found.baked["name"]) == ("hammered", {"Scale": 9.0}, "gold")
    api.create_material(preset="gold", material=material, finish="")
    assert api.record_of(material).finish == ""


def test_a_preset_written_into_a_node_keeps_its_finish():
    material = api.create_material(preset="copper", finish="brushed")
    write_preset(materials.our_node(material), "silver", {}, material)
    assert api.record_of(material).finish == "brushed" and api.record_of(material).baked["name"] == "silver"


def test_the_finish_survives_what_one_does_to_a_material(tmp_path):
    material = api.create_material(preset="anodised_titanium", finish="cast")
    materials.finish_node(material).inputs["Scale"].default_value = 9.0
    materials.finish_node(material).inputs["Roughness"].default_value = 0.25

    def holds(other):
        found = api.record_of(other)
        return (found.finish, found.controls) == ("cast", {"Scale": 9.0}) and abs(
            found.parameters.roughness - 0.25) < 1e-6

    assert holds(material)
    api.switch_realisation(material, "exact")
    assert holds(material) and finish_links(material) == {"Roughness", "Normal"}
    api.rebake(material, {"illuminant": "A"})
    assert holds(material)
    assert holds(user_presets.material_of(user_presets.preset_text(material)))
    material.use_fake_user = True
    name, file = material.name, tmp_path / "finish.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(file))
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.wm.open_mainfile(filepath=str(file))
    assert holds(bpy.data.materials[name])


def test_a_texture_goes_through_the_finish_and_comes_back():
    material = api.create_material(preset="anodised_titanium")
    tree = material.node_tree
    texture = tree.nodes.new("ShaderNodeTexNoise")
    tree.links.new(texture.outputs[0], groups.socket_named(materials.our_node(material), "Roughness"))
    api.apply_finish(material, "hammered")
    assert materials.finish_node(material).inputs["Roughness"].links[0].from_node == texture
    api.apply_finish(material, "smudged")
    assert materials.finish_node(material).inputs["Roughness"].links[0].from_node == texture
    api.apply_finish(material, "satin")
    assert groups.socket_named(materials.our_node(material), "Roughness").links[0].from_node == texture


def test_a_finish_whose_node_someone_took_away_is_gone():
    material = api.create_material(preset="anodised_titanium", finish="cast")
    material.node_tree.nodes.remove(materials.finish_node(material))
    assert api.record_of(material).finish == materials.finish_of(material) == ""


def test_a_finished_surface_renders_otherwise():
    def ball(**more):
        scene = probes.empty_scene(24, samples=8)
        probes.add_sphere(api.create_material(preset="anodised_titanium", **more))
        probes.add_sun(scene, 0.6, diameter=0.3)
        return probes.render(scene)

    assert np.abs(ball(finish="hammered") - ball(finish="satin")).max() > 0.05
