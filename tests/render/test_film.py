"""Films in Blender: what their groups render, what a file keeps, and every door to them."""

import subprocess
import sys
from pathlib import Path

import bpy
import numpy as np
import pytest

from addon import api
from addon.blender import compat
from addon.blender.datablocks import groups, materials, pictures
from addon.catalogue import presets
from addon.errors import FacetFilmError
from addon.models.film.tables import table_of
from addon.models.making import made
from addon.verify import film_checks
from tests.render import probes

ROOT = Path(__file__).resolve().parents[2]
TITANIA = "TiO2 0-200 nm / Ti"


@pytest.fixture(autouse=True)
def empty_file():
    bpy.ops.wm.read_factory_settings(use_empty=True)


@pytest.mark.parametrize("check", [check for check in film_checks.checks(["fast", "exact"])
                                   if "120 nm" in check.name or "R + T" in check.name], ids=lambda check: check.title)
def test_what_is_rendered_is_the_spectrum_at_each_facet(check):
    outcome = check.run()
    assert outcome.passed, outcome.figures


def test_another_thickness_fails_the_check():
    check = next(check for check in film_checks.checks(["fast"]) if "120 nm" in check.name)
    assert not check.run(thickness=110.0).passed


def ball(*words, **more):
    """(scene, material) of a ball in an even world."""
    scene = probes.empty_scene(24, samples=4)
    material = api.create_material(*words, **more)
    probes.add_sphere(material)
    probes.set_world(scene, 1.0)
    return scene, material


def test_a_saved_file_renders_the_same_without_the_extension(tmp_path):
    scene, _ = ball(preset="anodised_titanium")
    before = probes.render(scene)
    file, picture = tmp_path / "film.blend", tmp_path / "film.npy"
    bpy.ops.wm.save_as_mainfile(filepath=str(file))
    code = f"""
import bpy, numpy as np
bpy.ops.wm.open_mainfile(filepath={str(file)!r})
from tests.render import probes
import sys
np.save({str(picture)!r}, probes.render(bpy.context.scene))
"""
    subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=True, capture_output=True)
    assert np.abs(np.load(picture) - before).max() < 1e-6


def see_through():
    """The presets that are seen through and absorb nothing."""
    films = {name: made(preset=name).parameters for name in presets.of_model("film")}
    return [name for name, film in films.items()
            if film.see_through > 0.0 and not table_of(film.stack, {}).absorbs]


@pytest.mark.parametrize("preset", see_through())
def test_what_a_clear_film_reflects_and_lets_through_is_all_of_an_even_world(preset):
    """One sheet at 45°: in a closed body light would go to and fro until its last bounce."""
    scene = probes.empty_scene(16, samples=512, extent=0.5)
    bpy.ops.mesh.primitive_plane_add(size=20.0, rotation=(0.0, np.pi / 4, 0.0))
    bpy.context.object.data.materials.append(api.create_material(preset=preset))
    probes.set_world(scene, 1.0)
    np.testing.assert_allclose(probes.render(scene).mean(axis=(0, 1)), 1.0, atol=1e-3)


@pytest.mark.parametrize("realisation", ["exact", "osl"])
@pytest.mark.parametrize("preset", ["soap_bubble", "coated_lens"])
def test_nor_is_light_lost_towards_grazing_where_facets_are_drawn(realisation, preset):
    """On films as smooth as these single precision knows no slope by its cosine; by that 0.6 % were lost at 80°."""
    scene = probes.empty_scene(8, samples=2048, extent=0.5, osl=realisation == "osl")
    bpy.ops.mesh.primitive_plane_add(size=20.0, rotation=(0.0, np.radians(80.0), 0.0))
    bpy.context.object.data.materials.append(api.create_material(preset=preset, realisation=realisation))
    probes.set_world(scene, 1.0)
    np.testing.assert_allclose(probes.render(scene).mean(axis=(0, 1)), 1.0, atol=1e-3)


MATCHED = {"stack": "1.52 0-200 nm / 1.52", "thickness": 100.0, "see_through": 1.0, "ior_below": 1.52}
"""A coat that optics do not see."""


@pytest.mark.parametrize("realisation", ["fast", "exact", "osl"])
def test_a_frosted_body_below_has_its_lamps_once(realisation):
    """As frosted glass has, which is held to Mitsuba: by straight shadows and by refraction it would be twice."""
    means = []
    for make in (lambda: api.create_material("film", realisation=realisation, roughness=0.3, **MATCHED),
                 lambda: api.create_material("clear", ior=1.52, roughness=0.3)):
        scene = probes.empty_scene(24, samples=128, osl=realisation == "osl")
        probes.add_sphere(make())
        probes.add_sun(scene, np.radians(160.0), diameter=np.radians(20.0))
        means.append(probes.render(scene).mean())
    assert means[0] == pytest.approx(means[1], rel=0.03)


@pytest.mark.parametrize("preset, method, refracts", [
    ("coated_lens", "DITHERED", True), ("soap_bubble", "BLENDED", False), ("anodised_titanium", "DITHERED", False)])
def test_eevee_is_told_which_films_are_sheets_and_which_coat_a_body(preset, method, refracts):
    material = api.create_material(preset=preset)
    assert (material.surface_render_method, material.use_raytrace_refraction) == (method, refracts)


LOOKS = {"titanium": {"preset": "anodised_titanium", "roughness": 0.4},
         "soap": {"preset": "soap_bubble", "roughness": 0.3},
         "two slopes": {"preset": "heat_tinted_steel", "roughness": 0.35, "second_weight": 0.4},
         "stretched": {"preset": "anodised_titanium_blue", "roughness": 0.4, "anisotropy": 0.7, "rotation": 0.1},
         "mixed": {"preset": "anodised_niobium", "specular": 0.6, "tint": (0.9, 0.6, 0.8)}}


@pytest.mark.filterwarnings("ignore:Open Shading Language")
@pytest.mark.parametrize("look", LOOKS)
def test_the_script_renders_what_reference_does(look):
    """By independent seeds: the means of blocks differ by their noise, as far as three in a hundred of all light."""
    means, errors = [], []
    for realisation in ("exact", "osl"):
        scene = probes.empty_scene(16, samples=128, osl=realisation == "osl")
        probes.add_sphere(api.create_material(realisation=realisation, **LOOKS[look]), 64)
        probes.set_world(scene, 0.5)
        pictures_of = probes.render_seeds(scene, 4, first=1 if realisation == "exact" else 101)
        blocks = pictures_of.reshape(4, 4, 4, 4, 4, 3).mean(axis=(2, 4))
        means.append(blocks.mean(axis=0))
        errors.append(blocks.std(axis=0, ddof=1) / 2.0)
    off = np.abs(means[1] - means[0])
    assert (off / np.hypot(*errors).clip(1e-4)).mean() < 2.0
    assert off.max() < 0.03 * means[0].max()


def stand_in_of(tree):
    """The group that EEVEE shows, within another one."""
    nested = [node.node_tree for node in tree.nodes if node.bl_idname == "ShaderNodeGroup"]
    return next(group for group in nested if groups.group_id(group) == "film_eevee")


def test_films_of_one_stack_share_an_image_and_a_group():
    first, second, other = (api.create_material(preset=name) for name in (
        "anodised_titanium_blue", "anodised_titanium_gold", "heat_tinted_steel"))
    trees = [materials.our_node(material).node_tree for material in (first, second, other)]
    assert trees[0] == trees[1] != trees[2]
    assert len(bpy.data.images) == 2
    assert pictures.image_in(trees[0]) != pictures.image_in(trees[2])
    for tree in trees:
        assert not groups.edited(tree)
        stand_in = stand_in_of(tree)
        assert pictures.image_in(stand_in) == pictures.image_in(tree)


def image_nodes(tree):
    """The Image Texture nodes of a group and its parts, without those of the group that EEVEE shows."""
    inside = [node.node_tree for node in tree.nodes if node.bl_idname == "ShaderNodeGroup"]
    return [node for node in tree.nodes if node.bl_idname == "ShaderNodeTexImage"] + [
        node for group in inside if not groups.group_id(group) for node in image_nodes(group)]


def test_the_parts_that_look_colours_up_are_there_once_for_each_image():
    """Also for what comes in from another file with parts of its own."""
    first, second = (api.create_material(preset=name) for name in ("anodised_titanium", "heat_tinted_steel"))
    api.switch_realisation(second, "exact")
    api.create_material(preset="anodised_titanium", realisation="exact")
    for material in bpy.data.materials:
        tree = materials.our_node(material).node_tree
        assert {node.image for node in image_nodes(tree)} == {pictures.image_in(tree)}
    tables = [tree for tree in bpy.data.node_groups if tree.name.startswith(".Film's Table") and "Bl" not in tree.name]
    assert len(tables) == len({pictures.image_in(tree) for tree in tables}) == 2
    assert pictures.image_in(materials.our_node(first).node_tree) in {pictures.image_in(tree) for tree in tables}


def test_films_of_another_file_share_the_parts_that_are_there(tmp_path):
    material = api.create_material(preset="anodised_titanium")
    material.use_fake_user = True  # what nobody uses is not saved
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "films.blend"), copy=True)
    here = {tree.name for tree in bpy.data.node_groups}
    with bpy.data.libraries.load(str(tmp_path / "films.blend")) as (_, target):
        target.materials = [material.name]
    assert {tree.name for tree in bpy.data.node_groups} > here
    groups.merge_groups()
    assert {tree.name for tree in bpy.data.node_groups} == here


def test_the_image_is_packed_and_holds_numbers():
    api.create_material(preset="soap_bubble")
    image, = bpy.data.images
    assert image.packed_file and image.is_float
    assert image.colorspace_settings.is_data and image.alpha_mode == "NONE"
    assert tuple(image.size) == (512, 128)  # the table, and what is absorbed above it


def test_a_group_whose_image_someone_changed_is_not_reused():
    first = api.create_material("film", stack=TITANIA)
    tree = materials.our_node(first).node_tree
    pictures.put_image(tree, bpy.data.images.new("mine", 8, 8))
    again = materials.our_node(api.create_material("film", stack=TITANIA)).node_tree
    assert again != tree and pictures.image_in(again) is not None


def test_a_record_comes_back_switched_and_baked_again():
    material = api.create_material("film", stack=TITANIA, thickness=41.0, roughness=0.4)
    record = api.record_of(material)
    assert (record.parameters.stack, record.parameters.thickness) == (TITANIA, 41.0)
    assert record.source.name == TITANIA and record.measured
    natively = {"lobes", "native"} if compat.has_native_film() else set()
    assert set(record.baked["realisations"]) == {"standard", "reference"} | natively
    api.switch_realisation(material, "exact")
    assert api.record_of(material).parameters.changed(sampling_width=0.2) == record.parameters
    before = pictures.image_in(materials.our_node(material).node_tree)
    api.rebake(material, {"illuminant": "A"})
    assert api.record_of(material).viewing["illuminant"] == "A"
    assert pictures.image_in(materials.our_node(material).node_tree) != before
    assert api.record_of(material).parameters.changed(sampling_width=0.2) == record.parameters


def test_a_gradient_becomes_a_constant_thickness():
    material = api.create_material(preset="anodised_titanium")
    assert api.record_of(material).parameters.thickness_range == (10.0, 175.0)
    constant = api.create_material(preset="anodised_titanium", thickness=60.0)
    assert api.record_of(constant).parameters.thickness_range is None


@pytest.mark.parametrize("words", [
    {"preset": "main/TiO2/Jolivet-anatase 60 nm / main/Ti/Palm"}, {"preset": "water | MgF2 100 nm / glass"},
    {"model": "film"}, {"model": "film", "stack": "SiO2 0-1000 nm / Si", "thickness": 300.0}])
def test_every_door_takes_a_stack(words):
    material = api.create_material(**words)
    assert materials.model_of(material).name == "film"
    assert api.export(material, "csv").startswith("cos_theta,r,g,b\n")


@pytest.mark.parametrize("words, said", [
    ({"preset": "Foo 10 nm / Si"}, "At 'Foo 10 nm'"), ({"preset": "Ag | SiO2 10 nm / Si"}, "must not absorb"),
    ({"preset": "SiO2 -5 nm / Si"}, "a thickness is from 0 nm on"),
    ({"preset": "no/such/file.csv 10 nm / Si"}, "At 'no/such/file.csv 10 nm'"),
    ({"preset": "soap_bubble", "stack": TITANIA}, "give one of them"),
    ({"preset": TITANIA, "thickness": -1.0}, "thickness must be")])
def test_bad_input_is_one_sentence_and_makes_nothing(words, said):
    with pytest.raises(FacetFilmError, match=said):
        api.create_material(**words)
    assert not bpy.data.materials and not bpy.data.images


def test_eevee_and_cycles_agree_on_a_gradient():
    """Linear look-ups are off by 10 where the thickness changes from pixel to pixel."""
    scene, material = ball("film", stack=TITANIA, roughness=0.05, thickness_range=(20.0, 180.0), gradient=1.0)
    tree = materials.our_node(material).node_tree
    eevee = stand_in_of(tree)
    for group, filters in ((tree, {"Linear"}), (eevee, {"Closest"})):
        assert {node.interpolation for node in image_nodes(group)} == filters
    cycles = probes.render(scene)
    node = materials.our_node(material)
    outputs = [n for n in material.node_tree.nodes if n.bl_idname == "ShaderNodeOutputMaterial"]
    output = next(n for n in outputs if n.target == "CYCLES")
    material.node_tree.links.new(node.outputs[1], output.inputs[0])
    stand_in = probes.render(scene)
    assert compat.eevee_engine()
    _, mask = probes.pixel_normals(24)
    assert np.abs(cycles - stand_in)[mask].mean() < 0.01


def test_thickness_laws_are_what_their_groups_render():
    from addon.spectra.thickness_laws import ANODISING, HEAT_TINTS
    anodised = {metal.capitalize(): law.thickness(30.0) for metal, law in ANODISING.items()}
    tinted = {metal.title(): law.thickness(300.0) for metal, law in HEAT_TINTS.items()}
    for identifier, values, wanted in (("film_anodising", {"Voltage": 30.0}, anodised),
                                       ("film_heat_tint", {"Temperature": 300.0, "Time": 1.0}, tinted)):
        for output, nm in wanted.items():
            assert rendered(identifier, values, output) == pytest.approx(float(nm), rel=1e-4)


def rendered(identifier, values, output):
    """What a group's output is, as the radiance of a ball."""
    scene = probes.empty_scene(8)
    material = bpy.data.materials.new("output")
    compat.enable_nodes(material)
    tree = material.node_tree
    tree.nodes.clear()
    node, emission, surface = (tree.nodes.new(kind) for kind in (
        "ShaderNodeGroup", "ShaderNodeEmission", "ShaderNodeOutputMaterial"))
    node.node_tree = groups.node_group(identifier)
    for name, value in values.items():
        node.inputs[name].default_value = value
    tree.links.new(node.outputs[output], emission.inputs["Color"])
    tree.links.new(emission.outputs[0], surface.inputs["Surface"])
    probes.add_sphere(material)
    return probes.render(scene)[4, 4, 0]
