"""Thickness fields: noise and textures stay between the two thicknesses; the lower normal follows their gradient."""

import numpy as np

from addon.blender.datablocks import groups, materials
from addon.models.layered_rgb import formulas as layered
from tests.render import probes
from tests.render.layered_scenes import material

RANGE = (1.0, 60.0)
"""Nanometres over which the diffuse albedo falls steadily."""
INDEX = (1.5, 1.5, 1.5)
DIFFUSE = dict(thickness_range=RANGE, ior=INDEX, specular=0.0, diffuse=1.0)


def albedo(thickness):
    return layered.rho_d_eq16(np.array(INDEX), thickness, np.array(layered.WAVELENGTHS))


def pixels(change=None, **parameters):
    """The sphere's pixels under an even sky, free of noise for a diffuse material."""
    scene = probes.empty_scene(48, samples=4)
    made = material("exact", **parameters)
    if change is not None:
        change(made)
    probes.add_sphere(made)
    probes.set_world(scene, 1.0)
    scene.world.cycles.sampling_method = "NONE"
    _, mask = probes.pixel_normals(48)
    return probes.render(scene)[mask]


def field_of(made):
    link = groups.socket_named(materials.our_node(made), "Thickness").links[0]
    return link.from_node


def test_noise_varies_between_the_two_thicknesses():
    seen = pixels(**DIFFUSE)
    thick, thin = albedo(RANGE[1]), albedo(RANGE[0])
    assert (seen >= thick - 1e-3).all() and (seen <= thin + 1e-3).all()
    spread = seen.max(axis=0) - seen.min(axis=0)
    assert (spread > 0.6 * (thin - thick)).all()


def test_noise_scale_and_detail_change_the_field():
    plain = pixels(**DIFFUSE)
    assert np.abs(pixels(**DIFFUSE, noise_scale=9.0) - plain).max() > 0.05
    assert np.abs(pixels(**DIFFUSE, noise_detail=8.0) - plain).max() > 0.01


def test_a_texture_takes_the_place_of_the_noise():
    def use_texture(made):
        field = field_of(made)
        groups.socket_named(field, "Texture").default_value = 0.25
        groups.socket_named(field, "Texture Share").default_value = 1.0
    seen = pixels(use_texture, **DIFFUSE)
    expected = albedo(RANGE[0] + 0.25 * (RANGE[1] - RANGE[0]))
    np.testing.assert_allclose(seen, np.broadcast_to(expected, seen.shape), atol=2e-3)


def test_correlated_deviation_tilts_along_the_gradient():
    """Tilted lower boundaries send the light elsewhere; a field without a gradient tilts nothing."""
    phong = dict(thickness_range=(70.0, 70.0), specular=1.0, diffuse=0.0, deviation=0.2, noise_scale=2.0)

    def flat(made):
        groups.socket_named(field_of(made), "Texture Share").default_value = 1.0
    parallel = pixels(**{**phong, "deviation": 0.0}).mean(axis=0)
    tilted = pixels(**phong, correlated=True).mean(axis=0)
    untilted = pixels(flat, **phong, correlated=True).mean(axis=0)
    assert np.abs(untilted - parallel).max() < 0.01
    assert np.abs(tilted - parallel).max() > 0.02
