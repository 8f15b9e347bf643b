"""The library of groups, and switching a material between realisations."""

import json

import bpy
import numpy as np
import pytest

from addon import api
from addon.bake import bake
from addon.blender import compat
from addon.blender.datablocks import fingerprints, groups, materials
from tests.render import probes
from tools import build_groups, stamps


@pytest.fixture(autouse=True)
def empty_file():
    bpy.ops.wm.read_factory_settings(use_empty=True)


GROUPS = {group.identifier: group for group in groups.all_groups()}
BUILT = [identifier for identifier, group in GROUPS.items() if not group.osl]
RECORDED = json.loads(build_groups.VERSIONS.read_text(encoding="utf-8"))


def test_the_library_is_current_and_holds_nothing_else():
    assert stamps.is_current(build_groups.STAMP)
    assert {file.stem for file in groups.LIBRARY.glob("*.blend")} == set(BUILT)


@pytest.mark.parametrize("module", ["addon/models/cook_torrance/parameters.py", "addon/models/cook_torrance/sampler.py",
                                    "addon/models/parameters.py", "addon/reflectance/slopes.py", "addon/operands.py",
                                    "addon/nodes/builder.py", "addon/models/layered_rgb/lobes.py"])
def test_the_stamp_covers_what_building_loads(module):
    """The modules that hold defaults, too."""
    assert module in json.loads(build_groups.STAMP.read_text(encoding="utf-8"))["sources"]


def test_a_stamp_is_out_of_date_once_a_source_changes(tmp_path, monkeypatch):
    monkeypatch.setattr(stamps, "ROOT", tmp_path)
    source, stamp = tmp_path / "source.py", tmp_path / "stamp.json"
    source.write_text("1")
    stamps.write(stamp, {source})
    assert stamps.is_current(stamp)
    monkeypatch.setattr(stamps, "blender", lambda: [4, 4])
    assert not stamps.is_current(stamp)  # made by a newer Blender
    monkeypatch.undo()
    monkeypatch.setattr(stamps, "ROOT", tmp_path)
    source.write_text("2")
    assert not stamps.is_current(stamp)
    assert not stamps.is_current(tmp_path / "nothing.json")


@pytest.mark.parametrize("identifier", GROUPS)
def test_a_group_computes_what_its_version_is_recorded_for(identifier):
    """Raise the version in the model's __init__.py, then run `python tools/build_groups.py --record`."""
    tree = groups.node_group(identifier)
    now = {"version": GROUPS[identifier].version, "fingerprint": fingerprints.fingerprint(tree)}
    assert now == RECORDED[identifier], f"{identifier}: raise the version"
    assert not groups.edited(tree)


@pytest.mark.parametrize("identifier", BUILT)
def test_library_group_is_the_built_one(identifier):
    """Also where the library comes from another Blender version."""
    found = groups._from_library(GROUPS[identifier])
    assert fingerprints.fingerprint(found) == fingerprints.fingerprint(groups.build_group(identifier))


def test_changed_physics_change_the_fingerprint(monkeypatch):
    """A constant of the sampler that no socket shows."""
    before = fingerprints.fingerprint(groups.build_group("cook_torrance_exact"))
    monkeypatch.setattr("addon.models.cook_torrance.exact.HEADROOM", 0.9)
    after = fingerprints.fingerprint(groups.build_group("cook_torrance_exact"))
    assert after != before
    recorded = {"cook_torrance_exact": {"version": 1, "fingerprint": before}}
    now = {"cook_torrance_exact": {"version": 1, "fingerprint": after}}
    assert "raise its version" in build_groups.why_not_recorded(now, recorded)["cook_torrance_exact"]


def test_every_kind_of_node_in_our_groups_is_known_to_the_fingerprint():
    """So that none of its settings is forgotten."""
    kinds = {node.bl_idname for group in GROUPS.values() for node in groups.node_group(group.identifier).nodes}
    assert kinds - {"NodeFrame"} <= set(fingerprints.SETTINGS)


@pytest.mark.parametrize("change", [
    lambda tree, item: setattr(item, "default_value", 0.35), lambda tree, item: setattr(item, "max_value", 0.9),
    lambda tree, item: setattr(item, "name", "Rms Slope"), lambda tree, item: tree.interface.remove(item),
    lambda tree, item: setattr(next(n for n in tree.nodes if n.bl_idname == "ShaderNodeBsdfMetallic"), "distribution",
                               "GGX"),
])
def test_the_fingerprint_sees_the_interface_and_settings(change):
    tree = groups.build_group("cook_torrance_fast")
    before = fingerprints.fingerprint(tree)
    change(tree, next(item for item in tree.interface.items_tree if item.name == "Roughness"))
    assert fingerprints.fingerprint(tree) != before


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


@pytest.mark.parametrize("formula", ["exact", "blender-4.5"])
def test_switching_bakes_again_for_the_formula_that_the_realisation_evaluates(formula, monkeypatch):
    """Whatever this Blender's own formula is, the test knows both."""
    monkeypatch.setattr(compat, "conductor_formula", lambda: formula)
    native, exact = (bake("copper", formula=name).conductor.n for name in (formula, "exact"))
    assert (native == pytest.approx(exact, rel=1e-5)) == (formula == "exact")
    material = api.create_material(preset="copper")
    for realisation, n in (("fast", native), ("exact", exact), ("fast", native), ("osl", exact)):
        api.switch_realisation(material, realisation)
        assert materials.parameters_of(material).n == pytest.approx(n, rel=1e-6)


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
