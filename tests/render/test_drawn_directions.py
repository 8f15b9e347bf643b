"""The directions that Cycles draws by the nodes of Reference, at Sampling Width 0, against their densities.

The facet's normal H, which the nodes give to their Glossy BSDF, and the weight
are shown as light on a tile that fills the view: every pixel of one sample is
one draw, and a 32-bit picture keeps it as it was.  Of the two sides of a groove
that Cook-Torrance draws it is the first; how well V sees it is in its weight.
"""

import bpy
import numpy as np
import pytest

from addon import api
from addon.blender.datablocks import materials
from addon.blender.datablocks.groups import socket_named
from addon.models.layered_rgb import formulas as layered
from addon.models.layered_rgb import sampler as layered_sampler
from addon.reflectance.directions import half_vector, mirrored
from addon.reflectance.masking import v_cavity_one_side
from addon.reflectance.slopes import along_across, beckmann, elliptic_beckmann, elliptic_gaussian, gaussian
from tests.chi_square import bin_centres, direction_p_value
from tests.render import probes
from tests.render.cook_torrance_scenes import COPPER, FIGURE_6B
from tests.render.layered_scenes import material as layered_material

RESOLUTION = 256
LEAST_CHANCE = 1e-3
OBLIQUE = 1.2
UP, EAST, NORTH = np.eye(3)[[2, 0, 1]]


def way_to(kind, tree):
    """The first node of a kind in a group or the parts in it, after the nodes of the parts that it is in."""
    for node in tree.nodes:
        if node.bl_idname == kind:
            return [node]
        inner = way_to(kind, node.node_tree) if node.bl_idname == "ShaderNodeGroup" else []
        if inner:
            return [node, *inner]
    return []


def give_out(tree, source):
    """Have a group give what leaves a node by this socket in place of its first output."""
    output = next(node for node in tree.nodes if node.bl_idname == "NodeGroupOutput")
    tree.links.new(source, output.inputs[0])


def shown(material, angle, socket):
    """What feeds a socket of the group's Glossy BSDF, halved and raised by ½, one draw a pixel, ``(draws, 3)``."""
    scene = probes.empty_scene(RESOLUTION, samples=1, extent=2.0)
    made = material()
    *parts, glossy = way_to("ShaderNodeBsdfAnisotropic", materials.our_node(made).node_tree)
    tree = glossy.id_data
    source = next(found for found in glossy.inputs if found.identifier == socket).links[0].from_socket
    encoded = tree.nodes.new("ShaderNodeVectorMath")
    encoded.operation = "MULTIPLY_ADD"
    encoded.inputs[1].default_value = encoded.inputs[2].default_value = (0.5,) * 3
    tree.links.new(source, encoded.inputs[0])
    light = tree.nodes.new("ShaderNodeEmission")
    tree.links.new(encoded.outputs[0], light.inputs["Color"])
    give_out(tree, light.outputs[0])
    for part in parts:
        give_out(part.id_data, part.outputs[0])
    bpy.ops.mesh.primitive_plane_add(size=2.4, rotation=(0.0, angle, 0.0))
    tile = bpy.context.object
    tile.scale = (1.0 / np.cos(angle), 1.0, 1.0)
    tile.data.materials.append(made)
    return probes.render(scene, seed=3).reshape(-1, 3) * 2.0 - 1.0


def drawn(material, angle):
    """L of each draw in the tile's frame, those that carry no light left out, and the count of all."""
    normal, weight = shown(material, angle, "Normal"), shown(material, angle, "Color")
    np.testing.assert_allclose(np.linalg.norm(normal, axis=-1), 1.0, atol=1e-4)
    light = mirrored(probes.VIEW, normal)
    turned = np.array([[np.cos(angle), 0.0, -np.sin(angle)], [0.0, 1.0, 0.0], [np.sin(angle), 0.0, np.cos(angle)]])
    return (light @ turned.T)[weight.max(axis=-1) > 1e-6], len(light)


def view(angle):
    """V in the tile's frame."""
    return np.array([-np.sin(angle), 0.0, np.cos(angle)])


def drawn_gaussian(n_h, m):
    """What is drawn for the Gaussian: even in the plane of angles, so α/(sin α cos α) of it; the weight has
    the rest.
    """
    alpha = np.arccos(np.clip(n_h, 0.0, 1.0 - 1e-12))
    return gaussian(n_h, m, 1.0 / m ** 2) * alpha / (np.sin(alpha) * n_h)


def share_of_area(n_h, n_v, v_h):
    """How much of the surface facets cover, over N·V: that N·H of D which is drawn, whoever looks at it."""
    return n_h * n_v / np.maximum(v_h, 1e-9)


def facets(angle, slopes, distribution="beckmann", share=share_of_area):
    """p(L) = D N·H/(4π V·H) of one side of the grooves."""
    v = view(angle)
    h = half_vector(v, bin_centres())
    n_h, v_h = h[..., 2], h @ v
    d = sum(w * (beckmann if distribution == "beckmann" else drawn_gaussian)(n_h, m) for m, w in slopes)
    return d * share(n_h, v[2], v_h) / (4.0 * np.pi * v[2])


COOK_TORRANCE = [(0.0, FIGURE_6B, "beckmann"), (0.8, FIGURE_6B, "beckmann"), (1.2, ((0.4, 1.0),), "beckmann"),
                 (0.8, ((0.3, 1.0),), "gaussian")]


def exact_copper(slopes, distribution):
    return lambda: api.create_material(realisation="exact", slopes=slopes, distribution=distribution,
                                       sampling_width=0.0, **COPPER)


@pytest.mark.parametrize("angle, slopes, distribution", COOK_TORRANCE)
def test_facets_are_drawn_by_their_density(angle, slopes, distribution):
    directions, count = drawn(exact_copper(slopes, distribution), angle)
    chance = direction_p_value(directions, facets(angle, slopes, distribution), count)
    assert chance > LEAST_CHANCE


def brushed_copper(m, anisotropy, distribution):
    """Copper by Reference whose slopes are longer along the tile's Y axis."""
    def make():
        made = api.create_material(realisation="exact", slopes=((m, 1.0),), anisotropy=anisotropy,
                                   distribution=distribution, sampling_width=0.0, **COPPER)
        axis = made.node_tree.nodes.new("ShaderNodeCombineXYZ")
        axis.inputs["Y"].default_value = 1.0
        made.node_tree.links.new(axis.outputs[0], socket_named(materials.our_node(made), "Tangent"))
        return made
    return make


def brushed_facets(angle, m, anisotropy, distribution="beckmann"):
    """The same density of elliptic slopes, along the Y axis."""
    v = view(angle)
    h = half_vector(v, bin_centres())
    n_h, v_h = h[..., 2], h @ v
    along, across = along_across(m, anisotropy)
    if distribution == "beckmann":
        d = elliptic_beckmann(h[..., 1], h[..., 0], n_h, along, across)
    else:  # even in the plane of angles, as of drawn_gaussian
        alpha = np.arccos(np.clip(n_h, 0.0, 1.0 - 1e-12))
        d = elliptic_gaussian(h[..., 1], h[..., 0], n_h, along, across, 1.0 / (along * across))
        d = d * alpha / (np.sin(alpha) * n_h)
    return d * share_of_area(n_h, v[2], v_h) / (4.0 * np.pi * v[2])


@pytest.mark.parametrize("angle, m, anisotropy, distribution", [
    (0.0, 0.2, 0.8, "beckmann"), (0.8, 0.2, 0.8, "beckmann"), (1.2, 0.3, 0.5, "beckmann"), (0.8, 0.2, 0.8, "gaussian")])
def test_brushed_facets_are_drawn_by_their_density(angle, m, anisotropy, distribution):
    directions, count = drawn(brushed_copper(m, anisotropy, distribution), angle)
    chance = direction_p_value(directions, brushed_facets(angle, m, anisotropy, distribution), count)
    assert chance > LEAST_CHANCE
    assert direction_p_value(directions, brushed_facets(angle, m, 0.9 * anisotropy, distribution), count) < 1e-6


@pytest.fixture(scope="module")
def oblique_facets():
    return drawn(exact_copper(FIGURE_6B, "beckmann"), OBLIQUE)


BROKEN_FACETS = {
    "slope": {"slopes": ((0.43, 0.4), (0.2, 0.6))},
    "weights": {"slopes": ((0.4, 0.48), (0.2, 0.52))},
    "distribution": {"slopes": FIGURE_6B, "distribution": "gaussian"},
    "as seen": {"slopes": FIGURE_6B, "share": v_cavity_one_side},
}


@pytest.mark.parametrize("what", [None, *BROKEN_FACETS])
def test_another_density_of_facets_fails(what, oblique_facets):
    directions, count = oblique_facets
    density = facets(OBLIQUE, **BROKEN_FACETS.get(what, {"slopes": FIGURE_6B}))
    chance = direction_p_value(directions, density, count)
    assert chance > LEAST_CHANCE if what is None else chance < 1e-6


# --- The layered model ---

DEVIATED = {"ior": (1.4, 1.45, 1.6), "thickness": 92.0, "exponent_r": 90.0, "exponent_t": 170.0, "diffuse": 0.0}


def exact_layer(deviation):
    return lambda: layered_material("exact", **DEVIATED, deviation=deviation, sampling_width=0.0)


def layered_density(angle, deviation, **changed):
    """p(L) of the mixture of lobes, where the layer reflects anything."""
    p = {**DEVIATED, **changed}
    r1, e0, e1, v = np.array(p["ior"]), p["exponent_r"], p["exponent_t"], view(angle)
    # The azimuth counts from the world's X axis along the tile, which is the tile's own.
    n1 = layered.tilted_normal(UP, EAST, NORTH, deviation, 0.0)
    lobes = layered_sampler.proposal(v, UP, n1, r1, e0, e1)
    narrow = layered_sampler.narrowed(lobes, r1, e0, e1, 0.0)
    cosines = layered.inner_products(bin_centres(), v, UP, n1, r1)
    lit = layered.layered_specular(cosines, r1, p["thickness"], layered.WAVELENGTHS, e0, e1).max(axis=-1) > 0.0
    return np.where(lit, layered_sampler._density(lobes, narrow, cosines, r1), 0.0)


@pytest.mark.parametrize("angle, deviation", [(0.0, 0.0), (0.7, 0.0), (0.4, 0.17), (-0.5, 0.17)])
def test_the_layers_lobes_are_drawn_by_their_density(angle, deviation):
    directions, count = drawn(exact_layer(deviation), angle)
    chance = direction_p_value(directions, layered_density(angle, deviation), count)
    assert chance > LEAST_CHANCE


@pytest.fixture(scope="module")
def oblique_layer():
    return drawn(exact_layer(0.17), 0.4)


@pytest.mark.parametrize("changed", [{"exponent_t": 150.0}, {"exponent_r": 20.0}, {"ior": (1.4, 1.55, 1.6)},
                                     {"deviation": 0.19}])
def test_another_density_of_lobes_fails(changed, oblique_layer):
    directions, count = oblique_layer
    assert direction_p_value(directions, layered_density(0.4, **{"deviation": 0.17, **changed}), count) < 1e-6
