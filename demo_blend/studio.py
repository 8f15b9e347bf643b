"""Sets to photograph in: backdrops, lights, skies made by nodes, a camera."""

import bpy
import numpy as np
from mathutils import Vector

from addon.blender.compat import enable_nodes

__all__ = ["new_scene", "add_sun_of_solid_angle", "add_softbox", "add_lamp", "add_cove", "add_camera", "set_ambient",
           "set_sky", "matt"]


def new_scene(resolution, samples, *, look="Standard", exposure=0.0, denoise=False, noise=0.01):
    """An empty scene for Cycles.

    look      view transform: "Standard" shows colours as they are, "Khronos PBR Neutral" too, but rolls off highlights
    exposure  in stops
    denoise   by Open Image Denoise; never where pictures are compared
    noise     at which a pixel is done, as Cycles' adaptive sampling has it
    """
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y = resolution
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "PNG"
    scene.view_settings.view_transform = look
    scene.view_settings.exposure = exposure
    scene.cycles.samples = samples
    scene.cycles.use_adaptive_sampling = True
    scene.cycles.adaptive_threshold = noise
    scene.cycles.use_denoising = denoise
    scene.cycles.max_bounces = 6
    return scene


def add_sun_of_solid_angle(scene, solid_angle, irradiance, towards):
    """A neutral (D65) light that fills a solid angle of so many sr, shining from the direction `towards`.

    irradiance is what a surface facing the light receives.
    """
    light = bpy.data.lights.new("Light", "SUN")
    light.energy = irradiance
    light.angle = 2.0 * float(np.arcsin(np.sqrt(solid_angle / np.pi)))
    sun = bpy.data.objects.new("Light", light)
    sun.rotation_euler = Vector(towards).to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(sun)
    return sun


def set_ambient(scene, radiance):
    """Even light of this radiance from all around."""
    world = bpy.data.worlds.new("Ambient")
    scene.world = world
    enable_nodes(world)
    tree = world.node_tree
    tree.nodes.clear()
    background = tree.nodes.new("ShaderNodeBackground")
    background.inputs["Color"].default_value = (radiance, radiance, radiance, 1.0)
    output = tree.nodes.new("ShaderNodeOutputWorld")
    output.location = (250, 0)
    tree.links.new(background.outputs["Background"], output.inputs["Surface"])


def set_sky(scene, zenith, horizon, ground):
    """A sky of three greys or colours that blend over the elevation, by nodes."""
    world = bpy.data.worlds.new("Sky")
    scene.world = world
    enable_nodes(world)
    tree = world.node_tree
    tree.nodes.clear()

    def node(kind, x):
        made = tree.nodes.new(kind)
        made.location = (x, 0)
        return made
    place, split = node("ShaderNodeTexCoord", -800), node("ShaderNodeSeparateXYZ", -600)
    ramp, background = node("ShaderNodeValToRGB", -360), node("ShaderNodeBackground", 0)
    half = node("ShaderNodeMath", -480)
    half.operation = "MULTIPLY_ADD"
    half.inputs[1].default_value = half.inputs[2].default_value = 0.5
    stops = ramp.color_ramp
    stops.elements[0].position, stops.elements[1].position = 0.42, 1.0
    middle = stops.elements.new(0.52)
    for element, colour in zip((stops.elements[0], middle, stops.elements[-1]), (ground, horizon, zenith)):
        element.color = (*np.broadcast_to(colour, 3), 1.0)
    tree.links.new(place.outputs["Generated"], split.inputs[0])
    tree.links.new(split.outputs["Z"], half.inputs[0])
    tree.links.new(half.outputs[0], ramp.inputs[0])
    tree.links.new(ramp.outputs["Color"], background.inputs["Color"])
    tree.links.new(background.outputs[0], node("ShaderNodeOutputWorld", 220).inputs["Surface"])


def add_softbox(scene, place, target, size, radiance, *, seen=True):
    """A rectangular lamp at `place` facing `target`, as bright as `radiance` from everywhere.

    seen  whether mirrors and glossy surfaces show it; cameras never do
    """
    light = bpy.data.lights.new("Softbox", "AREA")
    light.shape = "RECTANGLE"
    light.size, light.size_y = np.broadcast_to(size, 2).tolist()
    light.energy = radiance * np.pi * light.size * light.size_y
    return _aimed(scene, light, place, target, seen)


def add_lamp(scene, place, radius, radiance):
    """A luminous ball, as bright as `radiance` from everywhere."""
    light = bpy.data.lights.new("Lamp", "POINT")
    light.shadow_soft_size = radius
    light.energy = 4.0 * np.pi ** 2 * radius ** 2 * radiance
    return _aimed(scene, light, place, (0.0, 0.0, 0.0), True)


def _aimed(scene, light, place, target, seen):
    lamp = bpy.data.objects.new(light.name, light)
    lamp.location = place
    lamp.rotation_euler = (Vector(place) - Vector(target)).to_track_quat("Z", "Y").to_euler()
    lamp.visible_camera = False
    lamp.visible_glossy = seen
    scene.collection.objects.link(lamp)
    return lamp


def matt(name, colour):
    """A material that scatters evenly, of this grey or colour."""
    material = bpy.data.materials.new(name)
    enable_nodes(material)
    tree = material.node_tree
    tree.nodes.clear()
    diffuse = tree.nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (*np.broadcast_to(colour, 3), 1.0)
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    output.location = (250, 0)
    tree.links.new(diffuse.outputs["BSDF"], output.inputs["Surface"])
    return material


def add_cove(scene, colour=0.18, *, width=60.0, front=-30.0, back=8.0, bend=5.0, height=30.0):
    """A matt floor that bends up into a wall: no horizon behind the objects."""
    turn = np.linspace(0.0, 0.5 * np.pi, 33)
    y = np.concatenate([[front], back + bend * np.sin(turn), [back + bend]])
    z = np.concatenate([[0.0], bend - bend * np.cos(turn), [height]])
    vertices = [(x, b, c) for b, c in zip(y, z) for x in (-0.5 * width, 0.5 * width)]
    faces = [(2 * j, 2 * j + 1, 2 * j + 3, 2 * j + 2) for j in range(len(y) - 1)]
    mesh = bpy.data.meshes.new("Cove")
    mesh.from_pydata(vertices, [], faces)
    mesh.polygons.foreach_set("use_smooth", np.ones(len(faces), bool))
    mesh.materials.append(matt("Cove", colour))
    cove = bpy.data.objects.new("Cove", mesh)
    scene.collection.objects.link(cove)
    return cove


def add_camera(scene, eye, target, focal_length=85.0):
    """A camera at `eye` looking at `target`."""
    camera = bpy.data.cameras.new("Camera")
    camera.lens = focal_length
    viewer = bpy.data.objects.new("Camera", camera)
    viewer.location = eye
    viewer.rotation_euler = (Vector(eye) - Vector(target)).to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(viewer)
    scene.camera = viewer
    return viewer
