"""Normals that face away from the viewer, as bumps and smoothed outlines have them, make no bright specks."""

import numpy as np
import pytest

from addon import api
from tests.render import probes

CASES = [
    ("cook_torrance", {"slopes": [(0.1, 1.0)]}), ("cook_torrance", {"slopes": [(0.4, 0.4), (0.2, 0.6)]}),
    ("layered_rgb", {"preset": "figure_5_79_106_nm"}), ("layered_rgb", {"preset": "nacre"})]
BRIGHTEST = 3.0
"""Of a pixel under a white sky: no drawn facet weighs more than 5, and no material reflects more than twice what
arrives.
"""


def with_normals_all_over(material):
    """The material with normals that point anywhere, half of them away from the viewer."""
    nodes, links = material.node_tree.nodes, material.node_tree.links
    group = next(node for node in nodes if node.bl_idname == "ShaderNodeGroup")
    noise, centred = nodes.new("ShaderNodeTexWhiteNoise"), nodes.new("ShaderNodeVectorMath")
    place = nodes.new("ShaderNodeTexCoord")
    links.new(place.outputs["Object"], noise.inputs["Vector"])
    centred.operation = "SUBTRACT"
    centred.inputs[1].default_value = (0.5, 0.5, 0.5)
    links.new(noise.outputs["Color"], centred.inputs[0])
    links.new(centred.outputs["Vector"], group.inputs["Normal"])
    return material


@pytest.mark.parametrize("realisation", api.REALISATIONS)
@pytest.mark.parametrize("model, parameters", CASES)
def test_no_bright_specks(model, parameters, realisation):
    scene = probes.empty_scene(48, samples=64, osl=realisation.startswith("osl"))
    probes.set_world(scene, 1.0)
    probes.add_sphere(with_normals_all_over(api.create_material(model, realisation=realisation, **parameters)))
    picture = probes.render(scene, 1)
    assert np.isfinite(picture).all()
    assert picture.max() < BRIGHTEST
    assert picture[20:28, 20:28].mean() > 0.1


@pytest.mark.parametrize("realisation", api.REALISATIONS)
@pytest.mark.parametrize("model, parameters", CASES)
def test_the_outline_of_a_smoothed_coarse_ball(model, parameters, realisation):
    """Its interpolated normals face away in a wide rim: as bright as the rest of it, each pixel."""
    scene = probes.empty_scene(48, samples=256, osl=realisation.startswith("osl"))
    probes.set_world(scene, 1.0)
    probes.add_sphere(api.create_material(model, realisation=realisation, **parameters), 12)
    picture = probes.render(scene, 1)
    assert np.isfinite(picture).all()
    assert picture.max() < 1.6
