"""The library of groups, and switching a material between realisations."""

import bpy
import numpy as np
import pytest

from addon import api
from addon.blender import groups, materials
from tests.render import probes
from tools.build_groups import STAMP, source_stamp


@pytest.fixture(autouse=True)
def empty_file():
    bpy.ops.wm.read_factory_settings(use_empty=True)


BUILT = [identifier for identifier, place in groups.GROUPS.items() if "osl" not in place]


@pytest.mark.parametrize("identifier", BUILT)
def test_library_is_built_from_the_sources_as_they_are(identifier):
    """`make assets` brings it up to date."""
    with bpy.data.libraries.load(str(groups.library_file(identifier))) as (source, target):
        target.texts = [name for name in source.texts if name == STAMP]
    assert target.texts[0].as_string().strip() == source_stamp()


def test_library_holds_nothing_else():
    assert {file.stem for file in groups.LIBRARY.iterdir()} == set(BUILT)


@pytest.mark.parametrize("identifier", BUILT)
def test_library_group_is_the_built_one(identifier):
    """Also where the library comes from another Blender version."""
    found = groups._from_library(identifier)
    assert groups.fingerprint(found) == groups.fingerprint(groups.build_group(identifier))
    assert groups.edited(found) == (identifier in groups.FAST_OF)  # those are fingerprinted once they are whole


def test_every_lane_of_a_group_is_named_and_no_node_lies_on_another():
    tree = groups.build_group("cook_torrance_exact")
    nodes = [node for node in tree.nodes if node.bl_idname != "NodeFrame"]
    places = {tuple(np.round(node.location, 1)) for node in nodes}
    assert len(places) == len(nodes)
    assert {"F", "G", "H"} <= {frame.label for frame in tree.nodes if frame.bl_idname == "NodeFrame"}


MODELS = {"cook_torrance": {"slopes": [(0.35, 0.5), (0.15, 0.4)], "specular": 0.75, "distribution": "gaussian",
                            "n": (1.0, 2.0, 3.0), "k": (4.0, 5.0, 6.0), "diffuse": (0.1, 0.2, 0.3)},
          "layered_rgb": {"thickness_range": (60.0, 90.0), "ior": (1.3, 1.4, 1.5), "exponent_r": 40.0,
                          "deviation": 0.1, "azimuth": 0.2, "specular": 0.5, "correlated": True}}


@pytest.mark.parametrize("model", MODELS)
def test_switching_keeps_what_the_user_set(model):
    material = api.create_material(model, **MODELS[model])
    first = materials.parameters_of(material)
    tree = material.node_tree
    texture = tree.nodes.new("ShaderNodeTexNoise")
    linked = groups.socket_named(materials.our_node(material), "Specular")
    tree.links.new(texture.outputs[0], linked)
    for realisation in ("exact", "osl", "osl_fast", "fast", "osl", "exact", "fast"):
        api.switch_realisation(material, realisation)
        node = materials.our_node(material)
        assert materials.realisation_of(material) == realisation
        assert materials.parameters_of(material).changed(sampling_width=first.sampling_width) == first
        assert groups.socket_named(node, "Specular").links[0].from_node == texture
        outputs = [n for n in tree.nodes if n.bl_idname == "ShaderNodeOutputMaterial"]
        assert sorted(n.target for n in outputs) == (["ALL"] if realisation == "fast" else ["CYCLES", "EEVEE"])
    assert not [group.name for group in bpy.data.node_groups if group.name[-4:] == ".001"]


def test_switching_bakes_again_for_the_formula_that_the_realisation_evaluates():
    material = api.create_material(preset="copper")
    api.switch_realisation(material, "exact")
    assert materials.parameters_of(material).n == pytest.approx(api.bake("copper", formula="exact").conductor.n, rel=1e-6)
    api.switch_realisation(material, "fast")
    assert materials.parameters_of(material).n == pytest.approx(api.bake("copper").conductor.n, rel=1e-6)


def test_switching_leaves_a_changed_index_alone():
    material = api.create_material(preset="copper", n=(0.3, 0.4, 0.5))
    api.switch_realisation(material, "exact")
    assert materials.parameters_of(material).n == pytest.approx((0.3, 0.4, 0.5), rel=1e-6)


def test_a_saved_material_renders_the_same_without_the_extension(tmp_path):
    """Nothing of the render depends on the extension: no handler, no driver, no code but what the file holds."""
    scene = probes.empty_scene(16, samples=16)
    probes.add_sphere(api.create_material(preset="copper", realisation="exact"), 32)
    probes.set_world(scene, 0.5)
    before = probes.render(scene)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "saved.blend"))
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "saved.blend"))
    assert np.allclose(probes.render(bpy.context.scene), before, atol=1e-6)
