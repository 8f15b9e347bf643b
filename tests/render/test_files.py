"""Materials that travel: saved, loaded, appended, linked, copied, without the extension, and from an older version."""

import json

import bpy
import numpy as np
import pytest

import addon
from addon import api
from addon.blender.datablocks import fingerprints, groups, materials
from addon.blender.datablocks import versions as updates
from tests.render import old_files

MADE = {
    "copper": dict(preset="copper", realisation="fast"),
    "copper exact": dict(preset="copper", realisation="exact"),
    "nacre": dict(model="layered_rgb", preset="nacre", realisation="exact"),
}


@pytest.fixture
def empty():
    """An empty file."""
    bpy.ops.wm.read_factory_settings(use_empty=True)


@pytest.fixture
def enabled(empty):
    """The extension registered."""
    addon.register()
    yield
    addon.unregister()


def picture(material, folder):
    """A few pixels of a ball of this material, with a seed of their own."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.seed, scene.cycles.use_adaptive_sampling = 4, 3, False
    scene.render.resolution_x = scene.render.resolution_y = 24
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    if scene.camera is None:
        bpy.ops.mesh.primitive_uv_sphere_add(segments=16, ring_count=8)
        bpy.context.active_object.name = "Ball"
        bpy.ops.object.light_add(type="SUN", rotation=(0.6, 0.4, 0.0))
        bpy.ops.object.camera_add(location=(0.0, 0.0, 6.0))
        scene.camera = bpy.context.active_object
    ball = bpy.data.objects["Ball"]
    ball.data.materials.clear()
    ball.data.materials.append(material)
    scene.render.filepath = str(folder / "picture.exr")
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath)
    pixels = np.array(image.pixels[:])
    bpy.data.images.remove(image)
    assert pixels.max() > 0.05
    return pixels


@pytest.fixture
def saved(empty, tmp_path):
    """A file that holds the materials, and their pictures before it was saved."""
    file, pictures = tmp_path / "saved.blend", {}
    for name, recipe in MADE.items():
        pictures[name] = picture(api.create_material(name=name, **recipe), tmp_path)
        bpy.data.materials[name].use_fake_user = True
    bpy.ops.wm.save_as_mainfile(filepath=str(file))
    return file, pictures


def test_they_render_the_same_when_loaded_again_without_the_extension(saved, tmp_path):
    file, pictures = saved
    bpy.ops.wm.open_mainfile(filepath=str(file))
    assert not hasattr(bpy.types.WindowManager, "facet_film")
    for name, before in pictures.items():
        np.testing.assert_array_equal(picture(bpy.data.materials[name], tmp_path), before)


def whole_groups():
    """The names of the groups that are no part of others; each part is there once."""
    parts = [tree for tree in bpy.data.node_groups if fingerprints.PART_KEY in tree]
    assert len({part[fingerprints.PART_KEY] for part in parts}) == len(parts) and all(part.users for part in parts)
    return {tree.name for tree in bpy.data.node_groups if tree not in parts}


@pytest.mark.parametrize("link", (False, True), ids=("appended", "linked"))
def test_they_render_the_same_in_another_file(saved, tmp_path, link):
    file, pictures = saved
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with bpy.data.libraries.load(str(file), link=link) as (_, target):
        target.materials = list(MADE)
    for name, material in zip(MADE, target.materials):
        np.testing.assert_array_equal(picture(material, tmp_path), pictures[name])
        assert materials.baked_of(material)["title"]


def test_they_are_copied_between_files_by_the_clipboard(saved, tmp_path):
    """An object copied in one file and pasted into another, which has our groups too: they become one again."""
    file, pictures = saved
    bpy.ops.wm.open_mainfile(filepath=str(file))
    bpy.data.objects["Ball"].data.materials[0] = bpy.data.materials["copper exact"]
    bpy.ops.object.select_all(action="DESELECT")
    bpy.data.objects["Ball"].select_set(True)
    assert bpy.ops.view3d.copybuffer() == {"FINISHED"}
    bpy.ops.wm.read_factory_settings(use_empty=True)
    gold = api.create_material(preset="gold", realisation="exact")
    assert bpy.ops.view3d.pastebuffer() == {"FINISHED"}
    bpy.data.objects.remove(bpy.data.objects["Ball"])
    pasted = bpy.data.materials["copper exact"]
    assert materials.baked_of(pasted)["title"] == "Copper"
    np.testing.assert_array_equal(picture(pasted, tmp_path), pictures["copper exact"])
    api.create_material(preset="silver", realisation="exact")
    assert whole_groups() == {"Cook-Torrance Reference", "Cook-Torrance Standard"}
    assert materials.our_node(pasted).node_tree == materials.our_node(gold).node_tree


@pytest.fixture
def of_blender_4_5(empty):
    """The file that Blender 4.5 saved, opened."""
    bpy.ops.wm.open_mainfile(filepath=str(old_files.FILE))
    assert bpy.data.version[:2] == (4, 5)
    return json.loads(old_files.COLOURS.read_text(encoding="utf-8"))


def test_a_file_of_blender_4_5_renders_the_same_without_the_extension(of_blender_4_5, tmp_path):
    """Every model and realisation that there was then; the noise of the ball's mean colour is 0.2 %."""
    assert not hasattr(bpy.types.WindowManager, "facet_film")
    now = old_files.colours(tmp_path)
    assert set(now) == set(of_blender_4_5)
    for name, then in of_blender_4_5.items():
        np.testing.assert_allclose(now[name], then, rtol=0.006, err_msg=name)


def test_materials_of_a_file_of_blender_4_5_can_be_worked_on(of_blender_4_5, tmp_path):
    addon.register()
    try:
        outdated = updates.outdated_groups()
        if outdated:
            assert bpy.ops.facet_film.update() == {"FINISHED"}
        for name in of_blender_4_5:
            material = bpy.data.materials[name]
            model, _, realisation = name.partition(" ")
            assert (materials.model_of(material).name, materials.realisation_of(material)) == (model, realisation)
            parameters = materials.parameters_of(material)
            if realisation != "exact":
                api.switch_realisation(material, "exact")
                assert materials.parameters_of(material).specular == parameters.specular
        now = old_files.colours(tmp_path)
        for name in of_blender_4_5:
            exact = of_blender_4_5[f"{name.split()[0]} exact"]
            np.testing.assert_allclose(now[name], exact, rtol=0.05 if outdated else 0.006, err_msg=name)
    finally:
        addon.unregister()


def test_an_appended_group_takes_the_place_of_its_equal(saved):
    file, _ = saved
    bpy.ops.wm.read_factory_settings(use_empty=True)
    api.create_material(preset="gold")
    with bpy.data.libraries.load(str(file)) as (_, target):
        target.materials = ["copper"]
    assert "Cook-Torrance Standard.001" in bpy.data.node_groups
    api.create_material(preset="silver")
    assert whole_groups() == {"Cook-Torrance Standard"}
    assert materials.realisation_of(target.materials[0]) == "fast"


def test_a_group_is_known_by_what_it_is_and_not_by_its_name(enabled):
    """As files from before hold it, where the Standard group was called Fast; or as someone has renamed it."""
    tree = materials.our_node(api.create_material(preset="gold")).node_tree
    tree.name = "Cook-Torrance Fast"
    silver = api.create_material(preset="silver")
    assert materials.our_node(silver).node_tree == tree
    assert whole_groups() == {"Cook-Torrance Fast"}
    assert materials.realisation_of(silver) == "fast" and updates.outdated_groups() == []


def older(material):
    """Make the material's group one of an older version, which lacked an input and reckoned otherwise."""
    tree = materials.our_node(material).node_tree
    tree.interface.remove(next(item for item in tree.interface.items_tree if item.name == "Gaussian c"))
    tree[groups.VERSION_KEY] = 0
    tree[groups.FINGERPRINT_KEY] = fingerprints.fingerprint(tree)
    return tree


def test_nothing_is_outdated_in_a_file_of_this_version(enabled):
    api.create_material(preset="copper", realisation="exact")
    assert updates.outdated_groups() == []
    assert not bpy.ops.facet_film.update.poll()


@pytest.mark.parametrize("realisation", ("fast", "exact"))
def test_an_older_file_is_updated_on_request(enabled, tmp_path, realisation):
    material = api.create_material(preset="copper", realisation=realisation)
    picture(material, tmp_path)
    older(material)
    material.use_fake_user = True
    colour = material.node_tree.nodes.new("ShaderNodeRGB")
    node = materials.our_node(material)
    material.node_tree.links.new(colour.outputs[0], groups.socket_named(node, "Diffuse Color"))
    groups.socket_named(node, "Roughness").default_value = 0.33 ** 0.5
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "older.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "older.blend"))

    material = bpy.data.materials["Copper"]
    now = groups.group_of(f"cook_torrance_{realisation}").version
    assert [(group.found, group.now) for group in updates.outdated_groups()] == [(0, now)]
    assert bpy.ops.facet_film.update() == {"FINISHED"}
    assert updates.outdated_groups() == []
    assert materials.parameters_of(material).slopes[0][0] == pytest.approx(0.33)
    node = materials.our_node(material)
    assert groups.socket_named(node, "Diffuse Color").links[0].from_node.bl_idname == "ShaderNodeRGB"
    outputs = [n for n in material.node_tree.nodes if n.bl_idname == "ShaderNodeOutputMaterial"]
    assert all(output.inputs[0].is_linked for output in outputs)
    assert whole_groups() <= {"Cook-Torrance Reference", "Cook-Torrance Standard"}
    picture(material, tmp_path)


def test_groups_that_a_user_edited_stay(enabled):
    material = api.create_material(preset="copper")
    tree = older(material)
    tree.nodes.new("ShaderNodeMath")
    assert updates.update() == (0, [f"{tree.name} was edited by hand and stays as it is"])
    assert materials.our_node(material).node_tree == tree


def test_a_newer_version_is_left_alone(enabled):
    material = api.create_material(preset="copper")
    materials.our_node(material).node_tree[groups.VERSION_KEY] = 99
    updated, (reason,) = updates.update()
    assert updated == 0 and "newer Facet & Film" in reason
