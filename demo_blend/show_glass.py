"""Glass, water and gems on a window sill, the sun behind them.

    python -m demo_blend.figures show_glass

Ten centimetres are a unit.  The sun's light passes straight through what is clear, in the colours that are left of it.
"""

import bpy
import numpy as np
from mathutils import Euler, Matrix, Vector

from addon.blender.compat import enable_nodes

from .clear import BOTTLE_PROFILE, BOUNCES, TUMBLER_INSIDE, TUMBLER_LIP, TUMBLER_OUTSIDE, mesh_object
from .cut_stone import brilliant
from .interiors import focus, set_room, show_scene
from .job import Figure
from .shapes import rounded_box
from .studio import add_camera, add_softbox, add_sun_of_solid_angle, matt
from .turned import bent_rod, turned_object

UNIT = 0.1
"""Metres."""

GOBLET_OUTSIDE = (
    (0.00, 0.00), (0.30, 0.00), (0.36, 0.008), (0.375, 0.02), (0.36, 0.032), (0.24, 0.05), (0.09, 0.09), (0.045, 0.16),
    (0.04, 0.45), (0.042, 0.75), (0.07, 0.86), (0.20, 0.95), (0.34, 1.08), (0.43, 1.27), (0.46, 1.50), (0.44, 1.75),
    (0.395, 2.00),
)
GOBLET_LIP = ((0.388, 2.012), (0.380, 2.00))
WINE = 1.38
"""Level of the wine."""
GOBLET_INSIDE = ((0.436, WINE), (0.405, 1.25), (0.32, 1.09), (0.19, 0.975), (0.08, 0.925), (0.00, 0.915))
"""From the wine's edge down."""
GOBLET_ABOVE = ((0.425, 1.75), (0.444, 1.50))
"""Its inner wall from the lip to the wine's edge."""

STONES = (  # preset, where on the sill, radius, how it is turned about the vertical from facing the camera
    ("amethyst", (-1.62, -0.95), 0.27, -0.5), ("ruby", (-0.86, -1.38), 0.24, 0.3),
    ("diamond", (-0.14, -1.62), 0.20, -0.2), ("blue_sapphire", (0.62, -1.40), 0.25, 0.5),
    ("citrine", (1.06, -0.80), 0.20, -0.4), ("emerald", (1.78, -1.05), 0.26, 0.2),
)
STONE_UNIT = 0.02
"""Metres a unit in the stones: five times smaller ones, whose colour is not too deep to shine."""


def clear(preset, *, unit=UNIT, **parameters):
    """A clear material of the catalogue, at this scene's scale."""
    from addon import api
    return api.create_material(preset=preset, scene_scale=unit, **parameters)


def ior(material):
    """The index of one of our materials, for what touches it."""
    from addon import api
    return api.record_of(material).parameters.ior


def filled(name, dry, inside, glass, liquid, surface, place, **parameters):
    """A glass with a liquid in it: three faces, the common one once."""
    wet = clear(liquid, name=f"{liquid} in {name}", outside=ior(glass), **parameters)
    top = inside[0]
    for part, profile, material in (
            ("glass against air", dry, glass), ("liquid against glass", inside[::-1], wet),
            ("liquid against air", ((top[0], top[1]), (0.96 * top[0], top[1] - 0.02), (0.88 * top[0], top[1] - surface),
                                    (0.0, top[1] - surface)), clear(liquid, **parameters))):
        turned_object(f"{name}, {part}", profile, material).location = place


def tumbler(place):
    """A glass of water with a long spoon of silver in it."""
    from addon import api
    filled("Tumbler", (*TUMBLER_OUTSIDE, *TUMBLER_LIP, TUMBLER_INSIDE[0]), TUMBLER_INSIDE, clear("low_iron_glass"),
           "water", 0.028, place)
    silver = api.create_material(preset="sterling_silver", finish="polished")
    stem = bent_rod("Spoon", [Vector(place) + Vector(point) for point in (
        (-0.50, 0.10, 0.36), (-0.28, 0.09, 0.85), (0.30, 0.05, 1.75), (0.88, 0.0, 2.55), (1.02, 0.0, 2.70))],
        0.04, silver)
    stem.name = "Spoon"
    bpy.ops.mesh.primitive_uv_sphere_add(segments=64, ring_count=32, radius=1.0)
    bowl = bpy.context.object
    bowl.name = "Spoon's bowl"
    bowl.matrix_world = (Matrix.Translation(Vector(place) + Vector((-0.47, 0.10, 0.46)))
                         @ Matrix.Rotation(0.42, 4, "Y") @ Matrix.Diagonal((0.045, 0.13, 0.2, 1.0)))
    bowl.data.polygons.foreach_set("use_smooth", np.ones(len(bowl.data.polygons), bool))
    bowl.data.materials.append(silver)


def stone(preset, place, radius, turn):
    """A brilliant that lies on its pavilion."""
    corners, faces = brilliant()
    made = mesh_object(preset, corners, faces, clear(preset, unit=STONE_UNIT))
    whole = Euler((0.0, np.radians(40.75), turn - 0.5 * np.pi), "XYZ").to_matrix().to_4x4()
    low = min((whole @ Vector(corner)).z for corner in corners.tolist())
    made.matrix_world = Matrix.Translation((*place, -low * radius)) @ whole @ Matrix.Scale(radius, 4)


def add_window():
    """A sill, the reveal at its sides, a frame with bars, and a garden out of focus behind it."""
    paint, stone_white = matt("White paint", (0.62, 0.60, 0.56)), matt("Sill", (0.56, 0.54, 0.50))
    rounded_box("Sill", (9.0, 4.4, 0.3), 0.04, stone_white).location = (0.0, -0.5, -0.15)
    for x in (-3.55, 3.55):
        rounded_box("Reveal", (0.5, 2.2, 9.0), 0.03, paint).location = (x, 0.75, 4.3)
    for x, width in ((-3.15, 0.3), (0.55, 0.2), (3.15, 0.3)):
        rounded_box("Frame", (width, 0.16, 8.0), 0.03, paint).location = (x, 1.62, 4.0)
    for z, height in ((0.13, 0.26), (3.1, 0.14)):
        rounded_box("Bar", (6.6, 0.15, height), 0.03, paint).location = (0.0, 1.62, z)
    garden = mesh_object("Garden", [(-16.0, 14.0, -5.0), (16.0, 14.0, -5.0), (16.0, 14.0, 14.0), (-16.0, 14.0, 14.0)],
                [(0, 1, 2, 3)], _garden())
    garden.visible_shadow = False


def _garden():
    """Trees before a bright sky, which shine: what is out of focus needs no more."""
    material = bpy.data.materials.new("Garden")
    enable_nodes(material)
    tree = material.node_tree
    tree.nodes.clear()

    def node(kind, x, links=(), **values):
        made = tree.nodes.new(kind)
        made.location = (x, 0.0)
        for name, value in values.items():
            setattr(made, name, value)
        for socket, given in links:
            if isinstance(given, bpy.types.NodeSocket):
                tree.links.new(given, made.inputs[socket])
            else:
                made.inputs[socket].default_value = given
        return made
    place = node("ShaderNodeTexCoord", -1200).outputs["Object"]
    leaves = node("ShaderNodeTexNoise", -1000, [("Vector", place), ("Scale", 0.42), ("Detail", 3.0)])
    height = node("ShaderNodeSeparateXYZ", -1000, [(0, place)]).outputs["Z"]
    up = node("ShaderNodeMath", -800, [(0, height), (1, 0.075), (2, -0.02)], operation="MULTIPLY_ADD")
    mixed = node("ShaderNodeMath", -600, [(0, leaves.outputs[0]), (1, 0.8), (2, up.outputs[0])],
                 operation="MULTIPLY_ADD")
    ramp = node("ShaderNodeValToRGB", -400, [(0, mixed.outputs[0])])
    stops = ((0.30, (0.060, 0.105, 0.035)), (0.46, (0.22, 0.33, 0.10)), (0.58, (0.62, 0.66, 0.34)),
             (0.74, (0.90, 0.92, 0.88)))
    while len(ramp.color_ramp.elements) < len(stops):
        ramp.color_ramp.elements.new(0.5)
    for element, (position, colour) in zip(ramp.color_ramp.elements, stops):
        element.position, element.color = position, (*colour, 1.0)
    shining = node("ShaderNodeEmission", -100, [("Color", ramp.outputs["Color"]), ("Strength", 1.5)])
    tree.links.new(shining.outputs[0], node("ShaderNodeOutputMaterial", 100).inputs["Surface"])
    return material


def glass(job):
    """The whole sill."""
    scene = show_scene(job, 16)
    cycles = scene.cycles
    cycles.max_bounces = cycles.transmission_bounces = cycles.glossy_bounces = BOUNCES
    cycles.transparent_max_bounces = BOUNCES
    cycles.caustics_reflective = cycles.caustics_refractive = False  # the shadows are straight
    set_room(scene, "interior.exr", strength=0.35, turn=0.8)
    add_window()
    for preset, place, size in (("bottle_green", (-2.15, 0.72, 0.0), 1.0), ("cobalt_glass", (-1.20, 1.00, 0.0), 0.62),
                                ("bottle_brown", (2.35, 0.85, 0.0), 0.78)):
        bottle = turned_object(preset, BOTTLE_PROFILE, clear(preset))
        bottle.location, bottle.scale = place, (size,) * 3
    tumbler((-0.38, 0.1, 0.0))
    filled("Goblet", (*GOBLET_OUTSIDE, *GOBLET_LIP, *GOBLET_ABOVE, GOBLET_INSIDE[0]), GOBLET_INSIDE,
           clear("crystal_glass", realisation="standard"), "red_wine", 0.02, (1.25, 0.3, 0.0), concentration=0.45)
    for preset, place, radius, turn in STONES:
        stone(preset, place, radius, turn)
    add_sun_of_solid_angle(scene, 7e-5, 5.0, (-0.42, 0.80, 0.58))
    add_softbox(scene, (-1.5, -8.0, 7.0), (0.0, -1.0, 0.2), (5.0, 3.0), 2.0)
    camera = add_camera(scene, (0.15, -9.6, 4.0), (0.06, 0.0, 1.22), 62.0)
    focus(camera, (0.1, -0.4, 0.6), 1.0)
    job.write(job.render(scene, "glass, water and gems"), "show_glass.jpg")
    job.save_scene("show_glass")


FIGURES = (Figure("show_glass", "Glass, water and gems on a window sill", 150.0, glass),)
