"""A prism that throws the spectrum of a slit onto a screen."""

import numpy as np

from .clear_bodies import clear_scene, mesh_object
from .cut_stone import box, prism
from .job import Figure
from .studio import add_camera, matt, set_sky

__all__ = ["FIGURES"]


def lamp(name, corners, radiance):
    """A rectangle that shines."""
    material = matt(name, 0.0)
    tree = material.node_tree
    shine = tree.nodes.new("ShaderNodeEmission")
    shine.inputs["Strength"].default_value = radiance
    tree.links.new(shine.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
    return mesh_object(name, corners, [(0, 1, 2, 3)], material)


def spectrum(job):
    """White light from a slit, by SF11 of a prism in the least deviation, on a white screen: true paths of light."""
    from addon import api
    scene = clear_scene(job, 960, 540, 1024, noise=0.01)
    cycles = scene.cycles
    cycles.caustics_refractive = True
    cycles.use_guiding = cycles.use_surface_guiding = True
    cycles.guiding_training_samples = 256
    glass = api.create_material(preset="flint_glass", realisation="dispersive", see_through=0.0)
    n = api.record_of(glass).parameters.ior
    deviation = 2.0 * np.arcsin(0.5 * n) - np.radians(60.0)
    solid = mesh_object("Prism", *prism(1.6, 1.6), glass)
    solid.location = (0.0, 0.0, 0.8)
    arrives = np.array([np.cos(0.5 * deviation), np.sin(0.5 * deviation), 0.0])
    leaves = arrives * (1.0, -1.0, 1.0)
    across = np.array([-arrives[1], arrives[0], 0.0])
    up = np.array([0.0, 0.0, 1.0])
    far, near = -16.0 * arrives, -1.6 * arrives
    lamp("Lamp", [far + i * 0.11 * across + k * up for i, k in ((-1, 0.0), (1, 0.0), (1, 4.0), (-1, 4.0))], 900.0)
    black = matt("Black", 0.02)
    for side in (-1.0, 1.0):
        jaw = mesh_object("Jaw of the slit", *box(0.04, 6.0, 3.0), black)
        jaw.location = near + side * (3.0 + 0.05) * across + 1.5 * up
        jaw.rotation_euler = (0.0, 0.0, 0.5 * deviation)
    screen = mesh_object("Screen", *box(0.05, 3.4, 2.4), matt("White", 0.85))
    screen.location = 6.0 * leaves + 1.2 * up
    screen.rotation_euler = (0.0, 0.0, -0.5 * deviation)
    mesh_object("Table", [(-40, -40, 0), (40, -40, 0), (40, 40, 0), (-40, 40, 0)], [(0, 1, 2, 3)], matt("Table", 0.12))
    set_sky(scene, (0.012, 0.013, 0.016), (0.010, 0.010, 0.012), (0.005, 0.005, 0.005))
    add_camera(scene, (0.6, 6.5, 3.6), (2.6, -1.5, 0.75), 38.0)
    job.write(job.render(scene, "spectrum"), "clear_spectrum.jpg")
    job.save_scene("clear_spectrum")


FIGURES = (Figure("clear_spectrum", "The spectrum of a prism on a screen", 240.0, spectrum),)
