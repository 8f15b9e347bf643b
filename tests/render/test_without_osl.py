"""A material by OSL where no script runs: it is the other realisation then, and not black."""

import warnings

import bpy
import numpy as np
import pytest

from addon import api, models
from addon.blender import compat
from addon.blender.missing import why_no_script_runs
from addon.models.realisations import REALISATIONS
from tests.render import probes

SCRIPTED = [(model.name, realisation) for model in models.all_models() for realisation in model.realisations
            if REALISATIONS[realisation].osl]


def pictures(model, realisation, osl, count=1, samples=4, link=lambda material: None):
    scene = probes.empty_scene(12, samples=samples, osl=osl)
    material = api.create_material(model, realisation=realisation)
    link(material)
    probes.add_sphere(material, 32)
    probes.set_world(scene, 0.3)
    probes.add_sun(scene, np.radians(45.0), diameter=np.radians(5.0))
    return probes.render_seeds(scene, count)


@pytest.mark.filterwarnings("ignore:Open Shading Language")
@pytest.mark.parametrize("model, realisation", SCRIPTED)
def test_it_shows_the_other_realisation_to_the_last_bit(model, realisation):
    without = pictures(model, realisation, osl=False)
    other = pictures(model, REALISATIONS[realisation].without_osl, osl=False)
    assert without.max() > 0.1
    assert np.array_equal(without, other)


def without_the_other(material):
    """Take away what the group shows where no script runs."""
    group = next(node for node in material.node_tree.nodes if node.bl_idname == "ShaderNodeGroup").node_tree
    mix = next(node for node in group.nodes if node.bl_idname == "ShaderNodeMixShader")
    group.links.remove(mix.inputs[1].links[0])


@pytest.mark.filterwarnings("ignore:Open Shading Language")
@pytest.mark.parametrize("model, realisation", SCRIPTED)
def test_the_script_alone_renders_where_it_runs(model, realisation):
    inside = (5, 5)
    with_script = pictures(model, realisation, osl=True)
    assert np.array_equal(with_script, pictures(model, realisation, osl=True, link=without_the_other))
    assert pictures(model, realisation, osl=False, link=without_the_other)[0][inside].max() == 0.0


@pytest.mark.filterwarnings("ignore:Open Shading Language")
@pytest.mark.parametrize("model", sorted({model for model, _ in SCRIPTED}))
def test_it_is_the_same_material_with_and_without(model):
    """Means over the sphere."""
    means = [pictures(model, "osl", osl, count=4, samples=256).mean(axis=(1, 2)) for osl in (False, True)]
    assert np.abs(means[0].mean(axis=0) / means[1].mean(axis=0) - 1.0).max() < 0.03


def test_a_script_is_told_once_and_knows_where_it_was_called():
    scene = probes.empty_scene(4, osl=False)
    exact, fast = REALISATIONS["exact"].title, REALISATIONS["fast"].title
    with pytest.warns(UserWarning, match=f"{exact} is shown in its place until you switch it on") as told:
        material = api.create_material(preset="copper", realisation="osl")
    assert [warning.filename for warning in told] == [__file__]
    with pytest.warns(UserWarning, match=f"{fast} is shown"):
        api.switch_realisation(material, "osl_fast")
    scene.render.engine = compat.eevee_engine()
    assert why_no_script_runs(scene, "osl")  # Cycles may be chosen afterwards
    scene.cycles.shading_system = True
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        api.create_material(preset="copper", realisation="osl")
        scene.cycles.shading_system = False
        api.create_material(preset="copper", realisation="exact")
    assert bpy.context.scene == scene
