"""The scene in which every preview is taken: a ball of radius 1 in neutral light, nothing behind it."""

import bpy
import numpy as np
from mathutils import Vector

__all__ = ["SIZE", "new_scene", "render"]

SIZE = 96
"""Of a preview in pixels, as large as the Asset Browser shows it by default."""

SAMPLES = 64
BOUNCES = 4
STRIPES, TILE = "Stripes", 1.6
SKY = ((0.0, 0.05), (0.42, 0.10), (0.5, 0.16), (0.56, 0.54), (0.75, 0.68), (1.0, 0.40))
"""Radiance of the surroundings from straight below (0) to straight above (1): a dark floor, a bright horizon."""
LIGHTS = (
    # name, power in W, width and height in m, where it stands
    ("Key", 270.0, (1.8, 1.8), (-3.6, -3.2, 4.4)),
    ("Strip", 95.0, (0.4, 3.6), (4.2, -0.6, 1.4)),
    ("Rim", 80.0, (3.0, 0.6), (-1.0, 4.2, 2.6)),
)


def new_scene():
    """An empty file with the lit ball in it; returns (scene, ball)."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    _set_render(scene)
    _add_surroundings(scene)
    for name, power, size, place in LIGHTS:
        _add_light(scene, name, power, size, place)
    _add_camera(scene)
    return scene, _add_ball(scene)


def render(scene, ball, material, path):
    """Take the picture of one material into a PNG file."""
    ball.data.materials.clear()
    ball.data.materials.append(material)
    _set_backdrop(scene, material.use_raytrace_refraction)
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)


def _set_backdrop(scene, seen_through):
    """Tiles behind the ball, seen only through it, where light passes through; and the bounces that it needs."""
    scene.cycles.max_bounces = 16 if seen_through else BOUNCES
    stripes = bpy.data.objects.get(STRIPES)
    if stripes is None and seen_through:
        stripes = _add_stripes(scene)
    if stripes is not None:
        stripes.hide_render = not seen_through


def _add_stripes(scene):
    """Light and dark tiles that shine, behind and below the ball."""
    mesh = bpy.data.meshes.new(STRIPES)
    side, vertices, faces = 6, [], []
    for column in range(side):
        for row in range(side):
            x, z = TILE * (column - 0.5 * side), TILE * (row - 0.5 * side)
            vertices += [(x, 3.0, z), (x + TILE, 3.0, z), (x + TILE, 3.0, z + TILE), (x, 3.0, z + TILE)]
            faces.append(range(len(vertices) - 4, len(vertices)))
    mesh.from_pydata(vertices, [], [tuple(face) for face in faces])
    for radiance in (0.22, 0.8):
        mesh.materials.append(_shining(radiance))
    for number, face in enumerate(mesh.polygons):
        face.material_index = (number // side + number % side) % 2
    stripes = bpy.data.objects.new(STRIPES, mesh)
    stripes.visible_camera = stripes.visible_glossy = stripes.visible_diffuse = False
    scene.collection.objects.link(stripes)
    return stripes


def _shining(radiance):
    material = bpy.data.materials.new(STRIPES)
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    emission = tree.nodes.new("ShaderNodeEmission")
    emission.inputs["Color"].default_value = (radiance, radiance, radiance, 1.0)
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(emission.outputs[0], output.inputs[0])
    return material


def _set_render(scene):
    scene.render.engine = "CYCLES"
    scene.render.resolution_x = scene.render.resolution_y = SIZE
    scene.render.resolution_percentage = 100
    scene.render.film_transparent = True
    scene.render.use_persistent_data = True
    scene.render.dither_intensity = 0.0
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGBA"
    scene.render.image_settings.compression = 100
    scene.view_settings.view_transform = "Standard"
    scene.cycles.samples = SAMPLES
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.use_denoising = True
    scene.cycles.max_bounces = BOUNCES
    scene.cycles.seed = 0


def _add_surroundings(scene):
    """Grey light from all around, by the height from which it comes."""
    world = bpy.data.worlds.new("Surroundings")
    scene.world = world
    if world.node_tree is None:
        world.use_nodes = True
    tree = world.node_tree
    tree.nodes.clear()
    direction = tree.nodes.new("ShaderNodeTexCoord")
    parts = tree.nodes.new("ShaderNodeSeparateXYZ")
    height = tree.nodes.new("ShaderNodeMapRange")
    height.inputs["From Min"].default_value = -1.0
    ramp = tree.nodes.new("ShaderNodeValToRGB")
    elements = ramp.color_ramp.elements
    while len(elements) < len(SKY):
        elements.new(0.5)
    for element, (position, radiance) in zip(elements, SKY):
        element.position = position
        element.color = (radiance, radiance, radiance, 1.0)
    background = tree.nodes.new("ShaderNodeBackground")
    output = tree.nodes.new("ShaderNodeOutputWorld")
    for source, target in ((direction.outputs["Generated"], parts.inputs[0]),
                           (parts.outputs["Z"], height.inputs["Value"]),
                           (height.outputs["Result"], ramp.inputs[0]), (ramp.outputs["Color"], background.inputs[0]),
                           (background.outputs[0], output.inputs[0])):
        tree.links.new(source, target)


def _add_light(scene, name, power, size, place):
    light = bpy.data.lights.new(name, "AREA")
    light.shape = "RECTANGLE"
    light.energy = power
    light.size, light.size_y = size
    lamp = bpy.data.objects.new(name, light)
    lamp.location = place
    lamp.rotation_euler = Vector(place).to_track_quat("Z", "Y").to_euler()
    lamp.visible_camera = False
    scene.collection.objects.link(lamp)


def _add_camera(scene):
    camera = bpy.data.cameras.new("Camera")
    camera.type = "ORTHO"
    camera.ortho_scale = 2.08
    viewer = bpy.data.objects.new("Camera", camera)
    viewer.location = (0.0, -6.0, 1.6)
    viewer.rotation_euler = Vector(viewer.location).to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(viewer)
    scene.camera = viewer


def _add_ball(scene):
    import bmesh
    mesh = bpy.data.meshes.new("Ball")
    made = bmesh.new()
    bmesh.ops.create_uvsphere(made, u_segments=96, v_segments=48, radius=1.0)
    made.to_mesh(mesh)
    made.free()
    mesh.polygons.foreach_set("use_smooth", np.ones(len(mesh.polygons), bool))
    ball = bpy.data.objects.new("Ball", mesh)
    scene.collection.objects.link(ball)
    return ball
