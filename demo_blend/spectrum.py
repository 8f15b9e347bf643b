"""A prism that throws the spectrum of a slit onto a screen."""

import numpy as np

from .clear import clear_scene, mesh_object
from .cut_stone import box, prism
from .job import Figure
from .studio import add_camera, add_softbox, matt, set_sky

__all__ = ["FIGURES"]

SIDE = 1.6
"""Of the prism's triangle."""


def lamp(name, corners, radiance):
    """A rectangle that shines."""
    material = matt(name, 0.0)
    tree = material.node_tree
    shine = tree.nodes.new("ShaderNodeEmission")
    shine.inputs["Strength"].default_value = radiance
    tree.links.new(shine.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
    return mesh_object(name, corners, [(0, 1, 2, 3)], material)


def screen_of_gain(source):
    """A material that sends what comes from near the source, level, towards the camera, as a projection screen does.

    An even white would do as well, of a hundred times the samples: hardly a ray that it scatters finds the slit.
    """
    material = matt("Screen", 0.6)
    tree = material.node_tree

    def node(kind, *inputs, **settings):
        made = tree.nodes.new(kind)
        for name, value in settings.items():
            setattr(made, name, value)
        for socket, value in zip(made.inputs, inputs):
            if hasattr(value, "is_linked"):
                tree.links.new(value, socket)
            elif value is not None:
                socket.default_value = value
        return made.outputs
    place = node("ShaderNodeNewGeometry")
    level = node("ShaderNodeVectorMath", place["Position"], (1.0, 1.0, 0.0), operation="MULTIPLY")[0]
    away = node("ShaderNodeVectorMath", tuple(source), level, operation="SUBTRACT")[0]
    towards = node("ShaderNodeVectorMath", away, operation="NORMALIZE")[0]
    both = node("ShaderNodeVectorMath", towards, place["Incoming"], operation="ADD")[0]
    halfway = node("ShaderNodeVectorMath", both, operation="NORMALIZE")[0]
    lobe = tree.nodes.new("ShaderNodeBsdfAnisotropic")
    lobe.distribution, lobe.inputs["Roughness"].default_value = "BECKMANN", 0.13
    tree.links.new(halfway, lobe.inputs["Normal"])
    output = tree.nodes["Material Output"].inputs["Surface"]
    tree.links.new(node("ShaderNodeAddShader", output.links[0].from_socket, lobe.outputs[0])[0], output)
    return material


def spectrum(job):
    """White light from a slit, by SF11 of a prism in the least deviation, on a screen: true paths of light."""
    from addon import api
    scene = clear_scene(job, 560, 315, 160, noise=0.02)
    cycles = scene.cycles
    cycles.caustics_refractive = True
    cycles.blur_glossy = cycles.sample_clamp_indirect = 0.0  # sharp paths, bright and rare
    glass = api.create_material(preset="flint_glass", realisation="dispersive", see_through=0.0)
    n = api.record_of(glass).parameters.ior
    deviation = 2.0 * np.arcsin(0.5 * n) - np.radians(60.0)
    solid = mesh_object("Prism", *prism(SIDE, 1.6), glass)
    solid.location = (0.0, 0.0, 0.8)
    arrives = np.array([np.cos(0.5 * deviation), np.sin(0.5 * deviation), 0.0])
    leaves = arrives * (1.0, -1.0, 1.0)
    across = np.array([-arrives[1], arrives[0], 0.0])
    up = np.array([0.0, 0.0, 1.0])
    entry = np.array([-SIDE / 3.0, 0.0, 0.0])  # half way up the faces, so that the light passes along the base
    far, near = entry - 16.0 * arrives, entry - 1.2 * arrives
    lamp("Lamp", [far + i * 0.15 * across + k * up for i, k in ((-1, 0.0), (1, 0.0), (1, 4.0), (-1, 4.0))], 10.0)
    black = matt("Black", 0.02)
    for side in (-1.0, 1.0):
        jaw = mesh_object("Jaw of the slit", *box(0.04, 6.0, 3.0), black)
        jaw.location = near + side * (3.0 + 0.06) * across + 1.5 * up
        jaw.rotation_euler = (0.0, 0.0, 0.5 * deviation)
    screen = mesh_object("Screen", *box(0.05, 3.4, 2.4), screen_of_gain(-entry))
    screen.location = 6.0 * leaves - entry + 1.2 * up
    screen.rotation_euler = (0.0, 0.0, -0.5 * deviation)
    mesh_object("Table", [(-40, -40, 0), (40, -40, 0), (40, 40, 0), (-40, 40, 0)], [(0, 1, 2, 3)], matt("Table", 0.12))
    set_sky(scene, (0.10, 0.11, 0.13), (0.04, 0.04, 0.05), (0.01, 0.01, 0.01))
    add_softbox(scene, (3.0, 4.5, 6.0), (0.0, 0.0, 0.8), (2.0, 2.0), 0.8)
    add_camera(scene, (0.2, 6.0, 3.4), (1.95, -0.9, 0.8), 38.0)
    job.write(job.render(scene, "spectrum"), "spectrum.jpg")
    job.save_scene("spectrum")


FIGURES = (Figure("spectrum", "The spectrum of a prism on a screen", 240.0, spectrum),)
