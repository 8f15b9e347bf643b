"""The checks of clear materials: white furnaces, a slab's absorption, thin walls, see-through shadows, by numbers."""

import bpy
import numpy as np

from .. import api
from ..reflectance import fresnel, transmission
from . import scenes
from .checks import Check, Figure, Outcome

__all__ = ["checks"]

MODEL = "clear"
SIGMA = (30.0, 120.0, 300.0)
BODY = {"ior": 1.5, "scene_scale": 0.01, "cauchy_b": 0.0042}
FURNACE = {"fast": 0.002, "dispersive": 0.01}
"""Most that an even white world may differ from 1 behind a body that absorbs nothing."""
THICK = 0.3
"""Of the slab, in scene units."""


def checks(realisations):
    """The checks of these realisations."""
    found = []
    for realisation in realisations:
        found += [
            Check(MODEL, realisation, "furnace, solid", "a smooth ball that absorbs nothing in an even white world: "
                  "it is not seen", furnace, BODY),
            Check(MODEL, realisation, "furnace, thin wall", "the same as one sheet", furnace,
                  {**BODY, "walls": "thin"}),
            Check(MODEL, realisation, "slab", "a slab over a lit floor against Fresnel and Beer–Lambert, at four "
                  "depths", slab, {**BODY, "absorption": SIGMA}),
            Check(MODEL, realisation, "thin wall at 60°", "transmittance of an absorbing sheet against the slab "
                  "formula", thin_wall, {**BODY, "walls": "thin", "absorption": SIGMA, "thickness": 0.002}),
            Check(MODEL, realisation, "see-through shadow", "the floor under a slab in the sun, against one way "
                  "straight through", shadow, {**BODY, "absorption": SIGMA}),
            Check(MODEL, realisation, "shadow of a ball", "the floor under a ball in an even sky, its shadow straight, "
                  "against all paths through it", shadow_of_a_ball, BODY)]
    return found


def _scene(samples=256, extent=2.0, resolution=16):
    scene = scenes.empty_scene(resolution, samples=samples, extent=extent)
    for kind in ("max", "transmission", "glossy"):
        setattr(scene.cycles, f"{kind}_bounces", 64)
    scene.cycles.transparent_max_bounces = 64
    scene.cycles.min_light_bounces = 64  # no roulette
    return scene


def furnace(realisation, rendered, parameters):
    """The mean over a picture of a ball, which holds noise where wavelengths are drawn."""
    scene = _scene(resolution=32)
    scenes.set_world(scene, 1.0)
    scenes.add_sphere(api.create_material(MODEL, realisation=realisation, **rendered), segments=64)
    mean = scenes.render(scene).mean(axis=(0, 1))
    return Outcome((Figure("difference from 1", float(np.abs(mean - 1.0).max()), FURNACE[realisation], True),))


def slab(realisation, rendered, parameters):
    """Straight down through slabs of four depths, whose inner reflections go back and forth."""
    found, expected = [], []
    for share in (0.25, 0.5, 1.0, 2.0):
        scene = _scene()
        _box(api.create_material(MODEL, realisation=realisation, **rendered), share * THICK)
        _floor(-2.0, shining=1.0)
        found.append(scenes.render(scene).mean(axis=(0, 1)))
        expected.append(_through(parameters, 1.0, share * THICK))
    return _largest(found, expected, 0.01 if realisation == "fast" else 0.03)


def thin_wall(realisation, rendered, parameters):
    """A tilted sheet before a shining floor."""
    scene = _scene(resolution=8, extent=0.2)
    sheet = _plane(8.0, api.create_material(MODEL, realisation=realisation, **rendered))
    sheet.rotation_euler = (np.radians(60.0), 0.0, 0.0)
    _floor(-9.0, shining=1.0, side=4.0)
    thickness = parameters["thickness"] / parameters["scene_scale"]
    return _largest([scenes.render(scene).mean(axis=(0, 1))], [_through(parameters, 0.5, thickness)], 0.005)


def shadow(realisation, rendered, parameters):
    """A white floor in the sun from straight above, seen beside the slab's own reflections: from below it."""
    scene = _scene(resolution=8, extent=0.2)
    scene.camera.location.z = -0.5
    scene.cycles.diffuse_bounces = 0  # the floor's own light comes back from the slab
    box = _box(api.create_material(MODEL, realisation=realisation, **rendered), THICK)
    box.visible_camera = False
    floor = _floor(-1.0)
    floor.visible_shadow = True
    scenes.add_sun(scene, 0.0)
    one_way = (1.0 - fresnel.dielectric(1.0, parameters["ior"])) ** 2 * _passage(parameters, 1.0, THICK)
    return _largest([scenes.render(scene).mean(axis=(0, 1))], [0.5 / np.pi * one_way], 0.005)


def shadow_of_a_ball(realisation, rendered, parameters):
    """A floor close below a ball, seen from between them; what true paths give is rendered, too."""
    found = []
    for shown in (rendered, {**parameters, "see_through": 0.0}):
        scene = _scene(samples=4096, resolution=8, extent=1.6)
        scene.camera.location.z = -1.05
        scenes.set_world(scene, 1.0)
        scenes.add_sphere(api.create_material(MODEL, realisation=realisation, **shown), segments=64)
        _floor(-1.2)
        found.append(scenes.render(scene).mean(axis=(0, 1)))
    return _largest(found[:1], found[1:], 0.02)


def _passage(parameters, cos_theta, thickness):
    inside = transmission.cos_inside(cos_theta, parameters["ior"])
    return np.exp(-np.array(parameters["absorption"]) * parameters["scene_scale"] * thickness / inside)


def _through(parameters, cos_theta, thickness):
    r = fresnel.dielectric(cos_theta, parameters["ior"])
    return transmission.slab_transmittance(r, _passage(parameters, cos_theta, thickness))


def _largest(found, expected, limit):
    difference = float(np.abs(np.array(found) / np.array(expected) - 1.0).max())
    return Outcome((Figure("largest relative difference", difference, limit, True),))


def _box(material, thickness, side=20.0):
    h, t = 0.5 * side, 0.5 * thickness
    corners = [(x, y, z) for z in (-t, t) for y in (-h, h) for x in (-h, h)]
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return _object("Slab", corners, faces, material)


def _plane(side, material, z=0.0):
    h = 0.5 * side
    return _object("Plane", [(-h, -h, z), (h, -h, z), (h, h, z), (-h, h, z)], [(0, 1, 2, 3)], material)


def _floor(z, shining=0.0, side=40.0):
    """A floor that shines, or a diffuse one of albedo 0.5."""
    material = bpy.data.materials.new("Floor")
    if material.node_tree is None:
        material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    shader = tree.nodes.new("ShaderNodeEmission" if shining else "ShaderNodeBsdfDiffuse")
    shader.inputs["Color"].default_value = (shining or 0.5,) * 3 + (1.0,)
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(shader.outputs[0], output.inputs[0])
    return _plane(side, material, z)


def _object(name, corners, faces, material):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(corners, [], faces)
    mesh.materials.append(material)
    made = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(made)
    return made
