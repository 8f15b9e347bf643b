"""The film of the Metallic BSDF, in Blenders that have one: its pixels, and the links that wait for it."""

import bpy
import numpy as np
import pytest

from addon import api, models
from addon.bake.film_track import NativeFilm, native_colours
from addon.blender import compat
from addon.blender.datablocks import groups, materials
from addon.blender.datablocks.fingerprints import fingerprint
from addon.nodes import newcomers
from addon.verify import scenes

THIN_FILM = ("Thin Film IOR", "Thin Film Thickness")
FILMS = ((1.6, 100.0, (2.0, 2.0, 2.0), (2.5, 2.5, 2.5)), (2.5, 120.0, (1.7, 1.86, 2.1), (1.85, 2.07, 2.32)),
         (2.2, 0.4, (0.9, 1.7, 1.8), (3.2, 2.5, 1.6)))


@pytest.fixture(autouse=True)
def empty_file():
    bpy.ops.wm.read_factory_settings(use_empty=True)


@pytest.mark.parametrize("index, thickness, n, k", FILMS)
def test_the_double_of_the_native_film_is_what_cycles_renders(index, thickness, n, k):
    """A smooth ball in a white world shows its film at N·V; in Blender 4.5 its metal has none."""
    scene = scenes.empty_scene(32, samples=1, pixel_centres=True)
    scenes.add_sphere(_metal(index, thickness, n, k))
    scenes.set_world(scene, 1.0)
    picture = scenes.render(scene)
    normals, mask = scenes.pixel_normals(32)
    cosine = normals[mask][..., 2].reshape(mask.sum(), -1)[:, 0]
    film = NativeFilm(np.array(index), np.array(thickness), np.array(n), np.array(k))
    if not compat.has_native_film():
        assert not any(_socket(_metals(bpy.data.materials[0].node_tree)[0], name) for name in THIN_FILM)
        return
    seen = cosine > 0.2
    off = np.abs(picture[mask][seen] - native_colours(film, cosine[seen], "Rec.709"))
    assert np.percentile(off, 95) < 1e-3 and off.mean() < 2e-4, (off.mean(), off.max())


def test_the_links_of_the_native_film_are_there_where_blender_takes_them():
    material = api.create_material("film", stack="TiO2 0-200 nm / Ti", roughness=0.6)
    tree = materials.our_node(material).node_tree
    waiting = list(_waiting(tree))
    assert len(waiting) >= 3 and not groups.edited(tree)
    for node, identifier in waiting:
        socket = _socket(node, identifier)
        assert bool(socket and socket.is_linked) == compat.has_native_film(), (node.name, identifier)


@pytest.mark.parametrize("model", models.all_models(), ids=lambda model: model.name)
def test_a_model_whose_groups_have_such_links_says_so(model):
    trees = [groups.node_group(group.identifier) for group in model.groups if not group.osl]
    assert any(any(_waiting(tree)) for tree in trees) == model.newcomers


def test_a_group_is_the_same_whether_its_links_are_there_or_wait():
    tree = groups.node_group("film_fast")
    before = fingerprint(tree)
    newcomers.settle(tree, False)
    assert fingerprint(tree) == before and not groups.edited(tree)
    assert not any(_socket(node, identifier).is_linked for node, identifier in _waiting(tree)
                   if _socket(node, identifier))
    assert groups.node_group("film_fast") == tree  # which brings them back
    assert fingerprint(tree) == before
    node, identifier = next(iter(_waiting(tree)))
    newcomers.defer(node, identifier, node, node.outputs[0].identifier)
    assert fingerprint(tree) != before


def test_a_bake_settles_a_group_that_another_blender_wrote():
    material = api.create_material("film", stack="TiO2 0-200 nm / Ti", roughness=0.6)
    tree = materials.our_node(material).node_tree
    newcomers.settle(tree, False)
    is_there = next(node for node, _ in _waiting(tree) if node.bl_idname == "ShaderNodeMath")
    assert not is_there.inputs[0].is_linked
    api.rebake(material)
    assert materials.our_node(material).node_tree == tree
    assert is_there.inputs[0].is_linked == compat.has_native_film()


@pytest.mark.parametrize("roughness, changes", [(0.7, compat.has_native_film()), (0.2, False)])
def test_a_rough_film_is_the_native_one_and_a_smooth_one_is_not(roughness, changes):
    """Taken apart, a rough film changes where Blender has a native film; a smooth one does not in any."""
    scene, material = _ball(roughness=roughness, thickness=120.0)
    before = scenes.render(scene)
    newcomers.settle(materials.our_node(material).node_tree, False)
    assert (np.abs(scenes.render(scene) - before).max() > 0.01) == changes


@pytest.mark.parametrize("tint", [(0.5, 0.5, 0.5), (0.9, 0.6, 0.3)])
def test_a_tint_dyes_the_native_film_as_it_does_the_lobes(tint):
    """But for what both differ by, as the part that a native film cannot be dyed with is the lobes'."""
    _, ball = scenes.pixel_normals(12)
    white, dyed = (scenes.render(_ball(roughness=0.6, thickness=60.0, tint=one)[0])[ball]
                   for one in ((1.0, 1.0, 1.0), tint))
    np.testing.assert_allclose(dyed, white * np.array(tint), atol=0.02)
    assert white.max() > 0.2


def _ball(**parameters):
    """(scene, material) of a ball in a white world."""
    scene = scenes.empty_scene(12, samples=256)
    material = api.create_material("film", stack="TiO2 0-200 nm / Ti", **parameters)
    scenes.add_sphere(material)
    scenes.set_world(scene, 1.0)
    return scene, material


def _metal(index, thickness, n, k):
    material = bpy.data.materials.new("metal")
    compat.enable_nodes(material)
    material.node_tree.nodes.clear()
    metal = material.node_tree.nodes.new("ShaderNodeBsdfMetallic")
    metal.distribution, metal.fresnel_type = "BECKMANN", "PHYSICAL_CONDUCTOR"
    for name, value in (("IOR", n), ("Extinction", k), ("Roughness", 0.0), *zip(THIN_FILM, (index, thickness))):
        if _socket(metal, name):
            _socket(metal, name).default_value = value
    output = material.node_tree.nodes.new("ShaderNodeOutputMaterial")
    material.node_tree.links.new(metal.outputs[0], output.inputs[0])
    return material


def _metals(tree):
    return [node for node in tree.nodes if node.bl_idname == "ShaderNodeBsdfMetallic"]


def _socket(node, identifier):
    return next((socket for socket in node.inputs if socket.identifier == identifier), None)


def _waiting(tree):
    """(node, identifier of an input) of everything that waits in a group and the groups in it."""
    for node in tree.nodes:
        yield from ((node, identifier) for identifier in newcomers.deferred(node))
        if node.bl_idname == "ShaderNodeGroup" and node.node_tree is not None:
            yield from _waiting(node.node_tree)
