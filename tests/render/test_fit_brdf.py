"""A fit as a material: by the operator, and in Cycles held against the file's own ball."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "unit"))

import balls  # noqa: E402
from brdf_files import container, rgl_fields  # noqa: E402

import addon  # noqa: E402
from addon import api  # noqa: E402
from addon.bake.film_curve import curve_in_words  # noqa: E402
from addon.blender import compat  # noqa: E402
from addon.blender.datablocks import materials  # noqa: E402
from addon.blender.operators.fit_brdf import VERDICTS  # noqa: E402
from addon.measured import fit, read_brdf  # noqa: E402
from addon.measured.fit import REASONS  # noqa: E402
from addon.models import named  # noqa: E402
from addon.models.film.fits import DEGREES  # noqa: E402
from addon.verify import scenes  # noqa: E402

UP = np.array([0.0, 0.0, 1.0])
RESOLUTION, SAMPLES = 16, 1500
NOISE, MOST_OF_CYCLES = 0.2, {"fast": 0.5, "exact": 0.7}
"""CIEDE2000: of so many samples, and that with what Standard and Reference blur."""
FOLDER = os.environ.get("FACET_FILM_BRDF_FOLDER", "")
REAL = sorted(path.stem for path in Path(FOLDER).glob("*_rgb.bsdf")) if FOLDER else []


def surface(model, **parameters):
    checked = named(model).parameters(**parameters)
    return lambda v, l: named(model).evaluate(checked, UP, v, l)


def gloss(v, l):
    """A paint with a bit that no model here has: light that goes back where it came from."""
    back = 0.1 * np.exp(-8.0 * (1.0 - np.sum(v * l, axis=-1, keepdims=True))) * (1.0, 0.6, 0.3)
    return back + surface("cook_torrance", n=(1.5, 1.5, 1.5), k=(0.0,) * 3, specular=0.5, diffuse=(0.7, 0.2, 0.1),
                          slopes=((0.2, 0.7), (0.5, 0.3)))(v, l)


def wrap(v, l):
    """One whose colour changes with the angle."""
    rows = 0.5 + 0.3 * np.cos(np.radians(DEGREES)[:, None] * 1.5 + (0.0, 1.0, 2.0))
    return surface("film", stack=curve_in_words(DEGREES, rows), roughness=0.4, specular=0.9, diffuse=(0.3, 0.1, 0.2),
                   )(v, l) * (1.0 + 0.3 * np.sum(v * l, axis=-1, keepdims=True))


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """{name: path} of two files."""
    folder, found = tmp_path_factory.mktemp("brdf"), {}
    for name, brdf in (("gloss", gloss), ("wrap", wrap)):
        found[name] = folder / f"{name}_rgb.bsdf"
        found[name].write_bytes(container(rgl_fields(brdf, 16, 48, f"A {name}")))
    return {**found, **{name: Path(FOLDER) / f"{name}.bsdf" for name in REAL}}


@pytest.fixture(scope="module")
def fitted(files):
    """{name: (Fit, Measurement)}."""
    return {name: (fit(str(path)), read_brdf(path)) for name, path in files.items()}


def in_cycles(found, realisation):
    """The ball of a fit as Cycles renders it in the held-out light."""
    scene = scenes.empty_scene(RESOLUTION, samples=SAMPLES)
    scenes.add_sphere(api.create_material(preset=found.preset(), realisation=realisation))
    light, _ = balls.surrounding()
    image = bpy.data.images.new("Light", light.shape[1], light.shape[0], float_buffer=True, is_data=True)
    pixels = np.ones((*light.shape, 4), np.float32)
    pixels[..., :3] = light[..., None]
    image.pixels.foreach_set(pixels.ravel())
    tree = scene.world.node_tree
    texture = tree.nodes.new("ShaderNodeTexEnvironment")
    texture.image = image
    background = scenes.set_world(scene, 1.0)
    tree.links.new(texture.outputs["Color"], background.inputs["Color"])
    return scenes.render(scene)


@pytest.mark.parametrize("realisation", ["fast", "exact"])
@pytest.mark.parametrize("name", ["gloss", "wrap", *REAL])
def test_a_fit_in_cycles_is_as_near_to_the_file_as_its_report_says(name, realisation, fitted):
    found, measurement = fitted[name]
    measured, formula, exposure = balls.images_of(found, measurement.brdf)
    if realisation == "fast":
        formula = balls.standard_of(found, compat.conductor_formula())
        reported = found.standard[compat.conductor_formula()]
    else:
        reported = found.mean
    measured, inside = balls.pixels_of(measured, RESOLUTION)
    formula, _ = balls.pixels_of(formula, RESOLUTION)
    picture = in_cycles(found, realisation)
    from_file = balls.difference(measured, picture, inside, exposure)
    from_formula = balls.difference(formula, picture, inside, exposure)
    said = balls.difference(measured, formula, inside, exposure)
    print(f"{name} {realisation}: {found.fresnel}, reported {reported:.2f}, in these pixels {said:.2f}, rendered "
          f"{from_file:.2f}; rendered from what was said {from_formula:.2f}")
    # Two differences that know nothing of each other add up by their squares.
    assert from_formula < MOST_OF_CYCLES[realisation] and abs(from_file - np.hypot(said, from_formula)) < NOISE


def test_another_material_is_farther_off(fitted):
    """What the comparison would catch: the fit of the other file."""
    measured, _, exposure = balls.images_of(fitted["gloss"][0], fitted["gloss"][1].brdf)
    measured, inside = balls.pixels_of(measured, RESOLUTION)
    assert balls.difference(measured, in_cycles(fitted["wrap"][0], "fast"), inside, exposure) > 5.0


@pytest.fixture
def cube(monkeypatch, tmp_path):
    """An active object, the extension registered, the user's presets in a folder of the test."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    addon.register()
    target = bpy.data.objects.new("Cube", bpy.data.meshes.new("Cube"))
    bpy.context.scene.collection.objects.link(target)
    bpy.context.view_layer.objects.active = target
    folder = tmp_path / "presets" / "facet_film"
    folder.mkdir(parents=True)
    monkeypatch.setattr(bpy.utils, "user_resource", lambda *_a, **_k: str(folder))
    yield target
    addon.unregister()


def test_the_operator_fits_and_saves_a_preset_of_the_users_own(cube, files, fitted, tmp_path):
    for _ in range(2):  # the second time replaces the first one's preset
        assert bpy.ops.facet_film.fit_brdf(filepath=str(files["gloss"])) == {"FINISHED"}
    material = cube.active_material
    found = fitted["gloss"][0]
    said = materials.baked_of(material)
    assert said["title"] == "A gloss" and said["fitted"]["file"] == "gloss_rgb.bsdf"
    assert said["fitted"]["delta_e_2000"]["mean"] == found.mean
    saved, = (tmp_path / "presets" / "facet_film").iterdir()
    cube.active_material = None
    assert bpy.ops.facet_film.apply_user_preset(filepath=str(saved)) == {"FINISHED"}
    assert materials.baked_of(cube.active_material) == said
    assert materials.parameters_of(cube.active_material).specular == pytest.approx(found.parameters.specular)


def test_the_operator_makes_nothing_of_what_is_no_measurement(cube, tmp_path):
    file = tmp_path / "page.bsdf"
    file.write_text("<!doctype html>")
    with pytest.raises(RuntimeError, match="is a web page"):
        bpy.ops.facet_film.fit_brdf(filepath=str(file))
    assert cube.active_material is None and not list((tmp_path / "presets" / "facet_film").iterdir())


def test_every_verdict_has_its_sentence_in_the_interface():
    reasons = [f"this model cannot, because {reason}" for reason in REASONS.values()]
    assert set(VERDICTS) == {"alike", "good", "fair", *reasons}
