"""The scene in which the vases stand: Cook and Torrance's two small lights and ambient light, a table, a camera."""

import bpy
import numpy as np

__all__ = ["new_scene", "add_sun_of_solid_angle", "add_table", "add_camera", "set_ambient"]


def new_scene(resolution, samples):
    """An empty scene for Cycles, showing colours as they are (no film look)."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y = resolution
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "PNG"
    scene.view_settings.view_transform = "Standard"
    scene.cycles.samples = samples
    scene.cycles.use_adaptive_sampling = True
    scene.cycles.adaptive_threshold = 0.01
    scene.cycles.use_denoising = False
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
    from mathutils import Vector
    sun.rotation_euler = Vector(towards).to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(sun)
    return sun


def set_ambient(scene, radiance):
    """Even light of this radiance from all around."""
    world = bpy.data.worlds.new("Ambient")
    scene.world = world
    if world.node_tree is None:
        world.use_nodes = True
    tree = world.node_tree
    tree.nodes.clear()
    background = tree.nodes.new("ShaderNodeBackground")
    background.inputs["Color"].default_value = (radiance, radiance, radiance, 1.0)
    output = tree.nodes.new("ShaderNodeOutputWorld")
    output.location = (250, 0)
    tree.links.new(background.outputs["Background"], output.inputs["Surface"])


def add_table(scene, albedo=0.18, radius=14.0):
    """A matt grey plane to stand on, wide enough to fill the view."""
    material = bpy.data.materials.new("Table")
    if material.node_tree is None:
        material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    diffuse = tree.nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (albedo, albedo, albedo, 1.0)
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    output.location = (250, 0)
    tree.links.new(diffuse.outputs["BSDF"], output.inputs["Surface"])
    mesh = bpy.data.meshes.new("Table")
    corners = [(-radius, -radius, 0), (radius, -radius, 0), (radius, radius, 0), (-radius, radius, 0)]
    mesh.from_pydata(corners, [], [(0, 1, 2, 3)])
    mesh.materials.append(material)
    table = bpy.data.objects.new("Table", mesh)
    scene.collection.objects.link(table)
    return table


def add_camera(scene, eye, target, focal_length=85.0):
    """A camera at `eye` looking at `target`."""
    from mathutils import Vector
    camera = bpy.data.cameras.new("Camera")
    camera.lens = focal_length
    viewer = bpy.data.objects.new("Camera", camera)
    viewer.location = eye
    viewer.rotation_euler = (Vector(eye) - Vector(target)).to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(viewer)
    scene.camera = viewer
    return viewer
