"""The library of groups, and switching a material between realisations."""

import json
import re
from types import SimpleNamespace

import bpy
import numpy as np
import pytest

from addon import api
from addon.bake import bake
from addon.blender import compat
from addon.blender.datablocks import fingerprints, groups, materials, parts
from addon.models.parameters import Socket
from addon.nodes.builder import GroupBuilder
from addon.operands import part
from tests.render import probes
from tools import build_groups, stamps


@pytest.fixture(autouse=True)
def empty_file():
    bpy.ops.wm.read_factory_settings(use_empty=True)


GROUPS = {group.identifier: group for group in groups.all_groups()}
BUILT = [identifier for identifier, group in GROUPS.items() if not group.osl]
MOST_NODES = 40
"""Of one level, as many as a person can follow."""
RECORDED = json.loads(build_groups.VERSIONS.read_text(encoding="utf-8"))


def test_the_library_is_current_and_holds_nothing_else():
    assert stamps.is_current(build_groups.STAMP)
    assert set(groups.LIBRARY.glob("*.blend")) == set(map(groups.library_file, BUILT))


@pytest.mark.parametrize("module", ["addon/models/cook_torrance/parameters.py", "addon/models/cook_torrance/sampler.py",
                                    "addon/models/parameters.py", "addon/reflectance/slopes.py", "addon/operands.py",
                                    "addon/nodes/builder.py", "addon/models/layered_rgb/pairs.py"])
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
    kinds = {node.bl_idname for group in GROUPS.values() for level in levels(groups.node_group(group.identifier))
             for node in level.nodes}
    assert kinds - {"NodeFrame"} <= set(fingerprints.SETTINGS)


@pytest.mark.parametrize("change", [
    lambda tree, item: setattr(item, "default_value", 0.35), lambda tree, item: setattr(item, "max_value", 0.9),
    lambda tree, item: setattr(item, "name", "Rms Slope"), lambda tree, item: tree.interface.remove(item),
    lambda tree, item: setattr(next(node for level in levels(tree) for node in level.nodes
                                    if node.bl_idname == "ShaderNodeBsdfMetallic"), "distribution", "GGX"),
])
def test_the_fingerprint_sees_the_interface_and_settings(change):
    tree = groups.build_group("cook_torrance_fast")
    before = fingerprints.fingerprint(tree)
    change(tree, next(item for item in tree.interface.items_tree if item.name == "Roughness"))
    assert fingerprints.fingerprint(tree) != before


def levels(tree):
    """A group and all parts in it, each once."""
    found = {tree.name: tree}
    for node in tree.nodes:
        if node.bl_idname == "ShaderNodeGroup" and node.node_tree.name not in found:
            found.update({level.name: level for level in levels(node.node_tree)})
    return list(found.values())


def nodes_of(tree):
    return [node for node in tree.nodes if node.bl_idname != "NodeFrame"]


@pytest.mark.parametrize("identifier", [name for name in BUILT if name.startswith(
    ("cook_torrance", "clear", "film", "finish", "layer"))])
def test_a_person_can_follow_every_level_of_a_group(identifier):
    """No node lies on another, nothing is too much at a time, and every part and socket is named."""
    for level in levels(groups.node_group(identifier)):
        nodes = nodes_of(level)
        assert len({tuple(np.round(node.location, 1)) for node in nodes}) == len(nodes)
        assert len(nodes) <= MOST_NODES, level.name
        sockets = [(item.in_out, item.name) for item in level.interface.items_tree if item.item_type == "SOCKET"]
        assert all(name for _, name in sockets) and len(set(sockets)) == len(sockets), level.name
        for node in nodes:
            assert node.bl_idname != "ShaderNodeGroup" or node.label or groups.group_id(node.node_tree)


def test_terms_have_their_names():
    names = {level.name for level in levels(groups.node_group("cook_torrance_exact"))}
    assert {".Fresnel F", ".Facet on a Side", ".Native Lobe", ".Sharpened G", ".D native / D"} <= names


def test_equal_parts_are_there_once():
    """Whatever groups they came in with; menus, which leave out names with a dot, do not offer them."""
    for identifier in BUILT:
        groups.node_group(identifier)
    found = [tree for tree in bpy.data.node_groups if fingerprints.PART_KEY in tree]
    assert all(fingerprints.fingerprint(part) == part[fingerprints.PART_KEY] for part in found)
    assert len({part[fingerprints.PART_KEY] for part in found}) == len(found)
    assert all(re.fullmatch(r"\.[^.]+", part.name) for part in found)


def test_a_part_comes_into_its_equals_place_in_groups_and_materials():
    """Where people copied it to from a group, too."""
    whole = groups.node_group("cook_torrance_fast")
    first = next(tree for tree in bpy.data.node_groups if tree.name == ".Seen From")
    second = first.copy()
    users = [node for node in whole.nodes if getattr(node, "node_tree", None) == first]
    plain = bpy.data.materials.new("Plain")
    compat.enable_nodes(plain)
    users += [plain.node_tree.nodes.new("ShaderNodeGroup")]
    for node in users:
        node.node_tree = second
    parts.merge_parts()
    assert len(users) > 1 and all(node.node_tree == first for node in users)
    assert [tree.name for tree in bpy.data.node_groups if tree.name.startswith(".Seen")] == [".Seen From"]


def test_a_part_that_someone_edited_is_left_alone():
    first = groups.node_group("cook_torrance_fast")
    part = next(tree for tree in bpy.data.node_groups if tree.name == ".Tinted Index")
    part.nodes.new("ShaderNodeMath")
    assert groups.edited(first)
    second = groups.node_group("cook_torrance_fast")
    assert second != first and not groups.edited(second) and groups.edited(first)


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


def test_arguments_of_one_name_have_sockets_of_their_own():
    """One of them within a namespace, whichever comes first."""
    builder = GroupBuilder("Whole")
    one, other = (builder.input(Socket(name, name, "FLOAT", 0.0, "")) for name in ("One", "Other"))
    difference = part("Difference")(lambda pair, e: pair.e - e)
    builder.output("Difference", difference(SimpleNamespace(e=one), other))
    node = next(node for node in builder.finish().nodes if node.bl_idname == "ShaderNodeGroup")
    assert [(socket.name, socket.links[0].from_socket.name) for socket in node.inputs] == [
        ("Pair e", "One"), ("e", "Other")]
