"""The scene in which every preview is taken: a turned piece on a checked floor that runs up behind it, in a studio.

The piece has what a material is told by: a ball for highlights and colours over angle, a groove and a foot for edges.
The squares of the floor show how clear a mirror is, and are seen through what is clear.
"""

import bpy
import numpy as np
from mathutils import Vector

__all__ = ["SIZE", "new_scene", "render"]

SIZE = 256
"""Of a preview in pixels."""

SAMPLES, SAMPLES_OF_CLEAR, SAMPLES_OF_RAINBOWS = 8, 16, 48
BOUNCES, BOUNCES_OF_CLEAR = 4, 12
PIXEL_LIMIT = 6.0
"""Radiance up to which light that has been reflected counts: caustics would be dots."""
LIGHTS = (
    # name, power in W, width and height in m, where it stands
    ("Key", 420.0, (3.4, 3.4), (-4.2, -3.4, 5.2)),
    ("Strip", 120.0, (0.8, 4.4), (4.6, -1.6, 2.6)),
    ("Rim", 150.0, (4.6, 0.9), (1.2, 3.4, 4.6)),
)
SKY = ((0.0, 0.10), (0.5, 0.16), (0.62, 0.42), (0.8, 0.62), (1.0, 0.32))
"""Radiance of the surroundings from straight below (0) to straight above (1)."""
SQUARES = (0.40, 0.24)
"""What the floor's squares reflect."""
SQUARE, FLOOR = 0.55, 9.0
"""Their sides, and the floor's half width, in m."""

RADIUS, CENTRE = 1.0, 1.16
FOOT = ((0.0, 0.0), (0.74, 0.0), (0.79, 0.02), (0.81, 0.07), (0.81, 0.17), (0.79, 0.22), (0.74, 0.24), (0.5, 0.24))
"""Outline of the foot, (distance from the axis, height); the ball stands on it."""
GROOVE = (-0.30, -0.17, 0.055)
"""Where the groove begins and ends over the ball's middle, and how deep it is."""
AROUND = 128


def new_scene():
    """An empty file with the lit piece in it; returns (scene, piece)."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    _set_render(scene)
    _add_surroundings(scene)
    for name, power, size, place in LIGHTS:
        _add_light(scene, name, power, size, place)
    _add_camera(scene)
    _add_floor(scene)
    return scene, _add_piece(scene)


def render(scene, piece, material, path, rainbows=False):
    """Take the picture of one material into a PNG file.

    rainbows  whether it parts light by its colours, which takes more samples
    """
    piece.data.materials.clear()
    piece.data.materials.append(material)
    clear = material.use_raytrace_refraction
    scene.cycles.samples = SAMPLES_OF_RAINBOWS if rainbows else SAMPLES_OF_CLEAR if clear else SAMPLES
    scene.cycles.max_bounces = BOUNCES_OF_CLEAR if clear else BOUNCES
    scene.cycles.diffuse_bounces = 0 if clear else 1  # the floor shows no caustics, which would be dots
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)


def _set_render(scene):
    scene.render.engine = "CYCLES"
    scene.render.resolution_x = scene.render.resolution_y = SIZE
    scene.render.resolution_percentage = 100
    scene.render.use_persistent_data = True
    scene.render.dither_intensity = 0.0
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.image_settings.compression = 0
    scene.view_settings.view_transform = "Standard"
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.use_denoising = True
    scene.cycles.denoising_prefilter = "FAST"
    scene.cycles.blur_glossy = 0.5
    scene.cycles.sample_clamp_indirect = PIXEL_LIMIT
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
    lamp.rotation_euler = (Vector(place) - Vector((0.0, 0.0, CENTRE))).to_track_quat("Z", "Y").to_euler()
    lamp.visible_camera = False
    scene.collection.objects.link(lamp)


def _add_camera(scene):
    camera = bpy.data.cameras.new("Camera")
    camera.lens = 100.0
    viewer = bpy.data.objects.new("Camera", camera)
    viewer.location = (0.0, -7.0, 2.9)
    aim = Vector(viewer.location) - Vector((0.0, 0.0, 1.05))
    viewer.rotation_euler = aim.to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(viewer)
    scene.camera = viewer


def _add_floor(scene):
    """A plane with squares, which runs up behind the piece."""
    outline = [(-FLOOR, 0.0), (2.2, 0.0)]
    turn = np.linspace(0.0, 0.5 * np.pi, 13)[1:]
    outline += [(2.2 + 2.0 * np.sin(angle), 2.0 - 2.0 * np.cos(angle)) for angle in turn] + [(4.2, FLOOR)]
    vertices = [(x, y, z) for y, z in outline for x in (-FLOOR, FLOOR)]
    faces = [(2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2) for i in range(len(outline) - 1)]
    mesh = bpy.data.meshes.new("Floor")
    mesh.from_pydata(vertices, [], faces)
    lengths = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(np.array(outline), axis=0).T))])
    layer = mesh.uv_layers.new(name="UVMap")
    for loop in mesh.loops:
        side, place = loop.vertex_index % 2, loop.vertex_index // 2
        layer.data[loop.index].uv = ((2.0 * side - 1.0) * FLOOR / SQUARE, lengths[place] / SQUARE)
    mesh.polygons.foreach_set("use_smooth", np.ones(len(faces), bool))
    mesh.materials.append(_squares())
    scene.collection.objects.link(bpy.data.objects.new("Floor", mesh))


def _squares():
    material = bpy.data.materials.new("Floor")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    place = tree.nodes.new("ShaderNodeUVMap")
    squares = tree.nodes.new("ShaderNodeTexChecker")
    squares.inputs["Scale"].default_value = 1.0
    for name, grey in zip(("Color1", "Color2"), SQUARES):
        squares.inputs[name].default_value = (grey, grey, grey, 1.0)
    diffuse = tree.nodes.new("ShaderNodeBsdfDiffuse")
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    for source, target in ((place.outputs[0], squares.inputs["Vector"]), (squares.outputs[0], diffuse.inputs["Color"]),
                           (diffuse.outputs[0], output.inputs[0])):
        tree.links.new(source, target)
    return material


def _outline():
    """Of the piece, (distance from the axis, height), from the foot's middle to the top, ``(K, 2)``."""
    low, high, deep = GROOVE
    start = np.arcsin((FOOT[-1][1] - CENTRE) / RADIUS)
    angles = np.linspace(start, 0.5 * np.pi, 97)
    radii = RADIUS - deep * np.clip(np.minimum(angles - low, high - angles) / 0.03, 0.0, 1.0)
    ball = np.stack([radii * np.cos(angles), CENTRE + radii * np.sin(angles)], axis=-1)
    return np.concatenate([np.array(FOOT[:-1]), ball[:-1], [[0.0, CENTRE + RADIUS]]])


def _add_piece(scene):
    """The outline turned about its axis: one closed surface, smooth but at its edges."""
    outline, turns = _outline(), np.linspace(0.0, 2.0 * np.pi, AROUND, endpoint=False)
    rings = [[(r * np.cos(a), r * np.sin(a), z) for a in turns] for r, z in outline[1:-1]]
    vertices = [(0.0, 0.0, outline[0][1]), *(point for ring in rings for point in ring), (0.0, 0.0, outline[-1][1])]
    faces = []
    for i in range(AROUND):
        j = (i + 1) % AROUND
        faces.append((0, 1 + j, 1 + i))
        for ring in range(len(rings) - 1):
            a = 1 + ring * AROUND
            faces.append((a + i, a + j, a + AROUND + j, a + AROUND + i))
        last = 1 + (len(rings) - 1) * AROUND
        faces.append((last + i, last + j, len(vertices) - 1))
    mesh = bpy.data.meshes.new("Piece")
    mesh.from_pydata(vertices, [], faces)
    mesh.polygons.foreach_set("use_smooth", np.ones(len(faces), bool))
    mesh.set_sharp_from_angle(angle=np.radians(32.0))
    piece = bpy.data.objects.new("Piece", mesh)
    scene.collection.objects.link(piece)
    return piece
