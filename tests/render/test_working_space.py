"""The same material in files of different working spaces: measured, converted, appended; XYZ is compared.

A configuration of one's own is read when Blender starts, so those tests run in a second one.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import bpy
import numpy as np
import pytest

import addon
from addon import api
from addon.bake.colour import delta_e_2000, lab, rgb_to_xyz, space_of_matrix
from addon.blender import compat
from addon.blender.datablocks import groups, spaces
from addon.blender.operators.user_presets import material_of, preset_text
from addon.models.making import made
from addon.models.model import Renderer
from addon.models.moving import moved, space_of
from tests.ocio_configuration import AP1, P3, write_configuration
from tests.render import probes

ROOT = Path(__file__).resolve().parents[2]
FIVE = {"gold": {"preset": "gold"}, "copper": {"preset": "copper"},
        "film": {"model": "film", "stack": "SiO2 0-400 nm / Si", "thickness": 100.0},
        "glass": {"preset": "crown_glass"}, "plastic": {"preset": "kapton"}}
TINTED = {"preset": "green_glass", "scene_scale": 0.01}
SPACES = {"Rec.709": "Linear Rec.709", "Rec.2020": "Linear Rec.2020", "ACEScg": "ACEScg"}
SAME = 0.5
"""Mean CIEDE2000 that a material may differ by from space to space."""
can_change = pytest.mark.skipif(not compat.converts_colours(),
                                reason="a file of Blender 4.5 has its configuration's space: tested below")


@pytest.fixture(scope="module", autouse=True)
def enabled():
    """The operators are there."""
    addon.register()
    yield
    addon.unregister()


def set_space(space, convert=True):
    """Change the file's working space, as File, Scene properties does."""
    if space != compat.working_space():
        bpy.ops.wm.set_working_color_space(working_space=SPACES[space], convert_colors=convert)


def in_a_file(space, **parameters):
    """(scene, material) of a ball under an even sky in a file of this space."""
    scene = probes.empty_scene(8, samples=8)
    set_space(space)
    material = api.create_material(**parameters)
    probes.add_sphere(material)
    probes.set_world(scene, 1.0)
    return scene, material


def seen(scene):
    """L*a*b* of what the scene renders, in the file's space."""
    return lab(probes.render(scene)[2:6, 2:6], compat.working_space())


def difference(one, other):
    return float(delta_e_2000(one, other).mean())


@can_change
@pytest.mark.parametrize("name", FIVE)
def test_a_material_looks_alike_in_every_space(name):
    """Would catch numbers for another space than the file's, in any parameter, and a click that does not mend them.

    Gold is outside of Rec.709, and compared among the others.
    """
    spaces_of_it = ("Rec.2020", "ACEScg") if name == "gold" else ("Rec.709", "Rec.2020", "ACEScg")
    scene, material = in_a_file(spaces_of_it[0], **FIVE[name])
    gamut = api.record_of(material).baked["gamut"]
    assert gamut == "nearest" or gamut["outside"] < 0.01
    first = seen(scene)
    set_space("ACEScg")
    assert spaces.is_foreign(material) and "ACEScg" in spaces.said_of_space(material)
    assert bpy.ops.facet_film.match_space() == {"FINISHED"}
    assert not spaces.is_foreign(material) and not spaces.said_of_space(material)
    found = {"converted, one click": difference(first, seen(scene))}
    found.update({space: difference(first, seen(in_a_file(space, **FIVE[name])[0])) for space in spaces_of_it[1:]})
    print(name, spaces_of_it[0], {where: round(apart, 3) for where, apart in found.items()})
    assert max(found.values()) <= SAME


@can_change
def test_a_tinted_glass_differs_by_no_more_than_its_fits():
    """Three exponentials are another curve over depth in each space; each is fitted to the spectrum."""
    scene, material = in_a_file("Rec.709", **TINTED)
    plain, first = seen(scene), api.record_of(material).baked["attenuation"]["delta_e_2000_max"]
    scene, material = in_a_file("ACEScg", **TINTED)
    print("green glass", round(difference(plain, seen(scene)), 2))
    assert difference(plain, seen(scene)) <= first + api.record_of(material).baked["attenuation"]["delta_e_2000_max"]


@can_change
@pytest.mark.parametrize("preset", ["nacre", "tempered_steel"])
def test_a_layer_of_three_channels_comes_nearer(preset):
    """It cannot be the same, as its channels mix in no other space; indices and wavelengths do what they can."""
    scene, material = in_a_file("Rec.709", preset=preset)
    first = seen(scene)
    set_space("ACEScg")
    assert spaces.is_foreign(material)
    before = difference(first, seen(scene))
    assert bpy.ops.facet_film.match_space() == {"FINISHED"} and not spaces.is_foreign(material)
    after = difference(first, seen(scene))
    print(preset, round(before, 2), "after the click", round(after, 2))
    assert after < 0.5 * before
    assert difference(seen(scene), seen(in_a_file("ACEScg", preset=preset)[0])) < SAME


@can_change
def test_without_the_click_gold_is_another_color():
    scene, _ = in_a_file("Rec.709", preset="gold")
    plain = seen(scene)
    set_space("ACEScg")
    assert difference(plain, seen(scene)) > 4.0


@can_change
def test_an_asset_of_another_space_arrives_right(tmp_path):
    in_a_file("Rec.709", preset="copper", name="From Elsewhere", specular=0.9)
    file = tmp_path / "elsewhere.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(file))
    probes.empty_scene(8)
    set_space("ACEScg")
    bpy.ops.wm.append(directory=f"{file}/Material/", filename="From Elsewhere")
    arrived = api.record_of(bpy.data.materials["From Elsewhere"])
    fresh = api.record_of(api.create_material(preset="copper", specular=0.9))
    assert arrived.viewing["space"] == "ACEScg" and arrived.parameters.specular == pytest.approx(0.9)
    assert np.allclose((arrived.parameters.n, arrived.parameters.k), (fresh.parameters.n, fresh.parameters.k))
    assert np.allclose(arrived.parameters.diffuse, fresh.parameters.diffuse, atol=1e-4)


@can_change
def test_re_bake_takes_the_files_space_and_a_saved_preset_arrives_in_it():
    _, material = in_a_file("Rec.709", preset="copper", tint=(1.0, 0.5, 0.2), viewing={"illuminant": "A"})
    saved = preset_text(material)
    set_space("ACEScg")
    converted = api.record_of(material).parameters.tint  # by Blender
    api.rebake(material)
    viewing = api.record_of(material).viewing
    assert (viewing["space"], viewing["illuminant"]) == ("ACEScg", "A")
    arrived = api.record_of(material_of(saved))
    assert (arrived.viewing["space"], arrived.viewing["illuminant"]) == ("ACEScg", "A")
    assert np.allclose(arrived.parameters.tint, converted, atol=1e-3)
    assert np.allclose(arrived.parameters.n, api.record_of(material).parameters.n)


@can_change
def test_our_groups_are_still_ours_in_a_converted_file():
    """Blender converts colors inside of node groups too: they must not pass for edited by hand."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    ours = [groups.node_group(group.identifier) for group in groups.all_groups() if not group.osl]
    set_space("ACEScg")
    assert [tree.name for tree in ours if groups.edited(tree)] == []


def test_what_the_user_changed_is_moved_along():
    tuned = made(preset="copper", n=(0.4, 0.9, 1.1), specular=0.6, diffuse=(0.5, 0.2, 0.1))
    there = moved(tuned, Renderer(space="ACEScg"))
    seen_here, seen_there = (np.array(one.parameters.diffuse) @ rgb_to_xyz(space).T
                             for one, space in ((tuned, "Rec.709"), (there, "ACEScg")))
    assert np.allclose(seen_here, seen_there, atol=1e-5) and there.parameters.specular == 0.6
    assert there.parameters.n != made(preset="copper", renderer=Renderer(space="ACEScg")).parameters.n
    from addon.reflectance.fresnel import conductor
    mirror = [conductor(1.0, np.array(one.parameters.n), np.array(one.parameters.k)) for one in (tuned, there)]
    assert delta_e_2000(lab(mirror[0]), lab(mirror[1], "ACEScg")) < 1.0
    assert moved(tuned, Renderer(space="ACEScg"), colours=False).parameters.diffuse == tuned.parameters.diffuse


def test_a_preset_that_is_stated_and_not_measured_is_moved_too():
    felt = made(preset="felt_white", roughness=0.4)
    there = moved(felt, Renderer(space="ACEScg"))
    fresh = made(preset="felt_white", renderer=Renderer(space="ACEScg"))
    assert (there.viewing, there.parameters.roughness) == ({"space": "ACEScg"}, 0.4)
    assert (there.parameters.n, there.parameters.diffuse) == (fresh.parameters.n, fresh.parameters.diffuse)
    seen_here, seen_there = (lab(np.array(one.parameters.diffuse), space_of(one)) for one in (felt, there))
    assert delta_e_2000(seen_here, seen_there) < 0.1


def test_a_matrix_is_known_again_or_kept_as_primaries():
    for space in ("Rec.709", "Rec.2020", "ACEScg"):
        assert space_of_matrix(rgb_to_xyz(space)) == space
    turned = rgb_to_xyz("Rec.709")[:, [2, 0, 1]]
    assert np.allclose(rgb_to_xyz(space_of_matrix(turned)), turned, atol=2e-6)


BY_CONFIGURATION = """
import json, sys
import bpy
from addon import api
from addon.blender import compat
from tests.render import probes
from tests.render.test_working_space import FIVE, in_a_file, seen
import numpy as np
found = {"space": compat.working_space(), "converts": compat.converts_colours()}
for name in ("copper", "film", "plastic"):
    scene, material = in_a_file(compat.working_space(), **FIVE[name])
    found[name] = seen(scene).reshape(-1, 3).tolist()
from addon.verify import film_checks
check = next(one for one in film_checks.checks(["fast"]) if "120 nm" in one.name)
found["verified"] = check.run().passed
print("FOUND", json.dumps(found))
"""


def under(configuration):
    """What a Blender that was started with an OpenColorIO configuration finds."""
    run = subprocess.run([sys.executable, "-c", BY_CONFIGURATION], cwd=ROOT, capture_output=True, text=True,
                         env={**os.environ, "OCIO": str(configuration)}, check=True)
    return json.loads(next(line for line in run.stdout.splitlines() if line.startswith("FOUND"))[6:])


@pytest.fixture(scope="module")
def opencolorio():
    """The module that comes with Blender."""
    folder = f"{bpy.utils.resource_path('LOCAL')}/python/lib/python{sys.version_info.major}.{sys.version_info.minor}"
    sys.path.append(f"{folder}/site-packages")
    import PyOpenColorIO
    sys.path.pop()
    return PyOpenColorIO


def verified(configuration, folder):
    """What `python -m addon verify` says of the data under a configuration."""
    return subprocess.run([sys.executable, "-m", "addon", "verify", "--only", "data"], cwd=folder, capture_output=True,
                          text=True, env={**os.environ, "OCIO": str(configuration), "PYTHONPATH": str(ROOT)})


def test_verification_passes_or_says_why_it_cannot(tmp_path, opencolorio):
    """The second configuration has no space of data: what is written to a file comes back as something else."""
    file = tmp_path / "own.ocio"
    write_configuration(file, P3, opencolorio)
    passed = verified(file, tmp_path)
    assert passed.returncode == 0 and "Green" in passed.stdout, passed.stdout + passed.stderr
    config = opencolorio.Config.CreateFromFile(str(file))
    config.removeColorSpace("Raw")
    config.setRole("data", "Screen")
    file.write_text(config.serialize(), encoding="utf-8")
    failed = verified(file, tmp_path)
    assert failed.returncode == 2 and "use one that has a role for data" in failed.stderr, failed.stderr


@pytest.mark.parametrize("linear, name", [(P3, "primaries 0.68"), (AP1, "ACEScg")], ids=["P3", "ACEScg"])
def test_a_configuration_of_ones_own(linear, name, tmp_path, opencolorio):
    """Would catch names in place of the measured matrix, and "Non-Color", which this configuration calls otherwise."""
    file = tmp_path / "own.ocio"
    write_configuration(file, linear, opencolorio)
    found = under(file)
    assert found["space"].startswith(name) and found["verified"]
    for preset in ("copper", "film", "plastic"):
        here = seen(in_a_file("Rec.709", **FIVE[preset])[0]).reshape(-1, 3)
        assert difference(np.array(found[preset]), here) <= SAME
