"""A still life of metals: a hammered copper pot, a brass candlestick, a shaker of brushed steel, gold.

    python -m demo_blend.figures show_metals

Everything is turned, bent or bevelled here; preset and finish are all that the materials are given.
"""

import math

import bpy
import numpy as np
from mathutils import Vector

from .interiors import add_board, add_table, add_wall, focus, set_room, show_scene
from .job import Figure
from .studio import add_camera, add_softbox
from .turned import bent_rod, turned_object

POT = (
    (0.00, 0.00), (0.60, 0.00), (0.78, 0.02), (0.88, 0.08), (0.93, 0.18), (0.95, 0.40), (0.96, 0.70), (0.97, 0.98),
    (1.00, 1.03), (1.03, 1.05), (1.03, 1.08), (1.00, 1.09), (0.96, 1.07), (0.94, 1.00), (0.93, 0.70), (0.92, 0.40),
    (0.90, 0.20), (0.85, 0.11), (0.75, 0.06), (0.00, 0.05),
)
CANDLESTICK = (
    (0.00, 0.00), (0.46, 0.00), (0.50, 0.03), (0.50, 0.07), (0.44, 0.10), (0.42, 0.15), (0.30, 0.19), (0.16, 0.24),
    (0.11, 0.32), (0.11, 0.42), (0.17, 0.47), (0.19, 0.51), (0.17, 0.55), (0.10, 0.60), (0.08, 0.74), (0.10, 0.94),
    (0.15, 1.10), (0.19, 1.18), (0.15, 1.25), (0.09, 1.30), (0.08, 1.38), (0.12, 1.44), (0.27, 1.50), (0.31, 1.53),
    (0.31, 1.56), (0.27, 1.575), (0.17, 1.56), (0.145, 1.60), (0.15, 1.80), (0.165, 1.83), (0.15, 1.85), (0.13, 1.83),
    (0.12, 1.66), (0.00, 1.64),
)
CANDLE = ((0.00, 0.00), (0.118, 0.00), (0.12, 0.02), (0.115, 0.45), (0.11, 0.49), (0.09, 0.50), (0.04, 0.475),
          (0.00, 0.47))
SHAKER = (
    (0.00, 0.00), (0.36, 0.00), (0.40, 0.02), (0.41, 0.06), (0.44, 0.60), (0.47, 1.10), (0.475, 1.13), (0.47, 1.15),
    (0.475, 1.17), (0.46, 1.28), (0.40, 1.40), (0.30, 1.49), (0.235, 1.53), (0.225, 1.56), (0.235, 1.58), (0.235, 1.74),
    (0.22, 1.79), (0.16, 1.82), (0.00, 1.83),
)
CUP = (
    (0.00, 0.00), (0.26, 0.00), (0.285, 0.015), (0.285, 0.035), (0.24, 0.06), (0.10, 0.10), (0.06, 0.16), (0.06, 0.22),
    (0.085, 0.26), (0.085, 0.29), (0.07, 0.32), (0.16, 0.37), (0.27, 0.46), (0.325, 0.60), (0.335, 0.75), (0.345, 0.80),
    (0.345, 0.815), (0.33, 0.815), (0.315, 0.75), (0.30, 0.60), (0.25, 0.48), (0.15, 0.41), (0.00, 0.39),
)


def metal(preset, finish, name, **controls):
    """A metal of the catalogue with a finish, and the controls of its marks that are not as they come."""
    from addon import api
    from addon.blender.datablocks.groups import socket_named
    from addon.blender.datablocks.materials import our_node
    material = api.create_material(preset=preset, finish=finish, name=name)
    if controls:
        marks = socket_named(our_node(material), "Roughness").links[0].from_node
        for control, value in controls.items():
            socket_named(marks, control.capitalize()).default_value = value
    return material


def copper_pot(place):
    """The pot with two brass handles."""
    copper = metal("copper", "hammered", "Copper, hammered", scale=8.5, depth=0.3, randomness=0.6)
    turned_object("Pot", POT, copper, points_between=10).location = place
    brass = metal("brass", "satin", "Brass, satin")
    for side in (-1.0, 1.0):
        arc = [(side * (0.97 + 0.26 * math.sin(a)), 0.27 * math.cos(a), 0.80 + 0.05 * math.sin(a))
               for a in np.linspace(0.0, math.pi, 17)]
        ends = [(side * 0.93, 0.27, 0.80), *arc, (side * 0.93, -0.27, 0.80)]
        bent_rod("Handle", [Vector(point) + Vector(place) for point in ends], 0.045, brass)


def candlestick(place):
    """Polished brass, and a candle that is not lit."""
    from .studio import matt
    turned_object("Candlestick", CANDLESTICK, metal("brass", "polished", "Brass, polished"),
                  points_between=8).location = place
    turned_object("Candle", CANDLE, matt("Wax", (0.78, 0.72, 0.58)), segments=64).location = (
        Vector(place) + Vector((0.0, 0.0, 1.66)))


def rings(place):
    """Two wedding rings, one leaning on the other."""
    gold = metal("gold", "polished", "Gold, polished")
    for offset, turn, lean in (((0.0, 0.0, 0.045), 0.0, 0.0), ((0.17, 0.08, 0.135), 0.5, 0.52)):
        bpy.ops.mesh.primitive_torus_add(major_radius=0.17, minor_radius=0.035, major_segments=128, minor_segments=32,
                                         location=Vector(place) + Vector(offset), rotation=(0.0, -lean, turn))
        ring = bpy.context.object
        ring.name = "Ring"
        ring.scale.z = 1.3
        ring.data.polygons.foreach_set("use_smooth", np.ones(len(ring.data.polygons), bool))
        ring.data.materials.append(gold)


def metals(job):
    """The whole table."""
    scene = show_scene(job, 56)
    set_room(scene, "interior.exr", strength=0.5, turn=2.2)
    add_table()
    add_wall(3.6)
    add_board((-0.72, 0.12, 0.0))
    copper_pot((-0.72, 0.22, 0.09))
    candlestick((1.38, 0.72, 0.0))
    turned_object("Shaker", SHAKER, metal("stainless_steel", "brushed_circular", "Stainless steel, brushed"),
                  points_between=8).location = (0.62, 1.12, 0.0)
    turned_object("Cup", CUP, metal("gold", "satin", "Gold, satin"), points_between=8).location = (0.92, -0.32, 0.0)
    rings((1.52, -0.62, 0.0))
    add_softbox(scene, (-4.6, -1.2, 3.6), (0.0, 0.3, 0.5), (2.6, 3.6), 6.0)
    add_softbox(scene, (3.8, -2.4, 2.6), (0.2, 0.3, 0.6), (0.8, 3.0), 2.4)
    add_softbox(scene, (1.8, 2.4, 4.6), (0.2, 0.3, 0.8), (3.2, 0.9), 2.6)
    add_softbox(scene, (-3.4, 2.0, 3.4), (-0.4, 3.6, 1.3), (0.8, 0.5), 18.0, seen=False)
    camera = add_camera(scene, (0.2, -8.6, 2.75), (0.1, 0.3, 0.93), 68.0)
    focus(camera, (0.1, 0.0, 0.7), 5.6)
    job.write(job.render(scene, "metals and finishes"), "show_metals.jpg")
    job.save_scene("show_metals")


FIGURES = (Figure("show_metals", "Metals and finishes on a table", 300.0, metals),)
