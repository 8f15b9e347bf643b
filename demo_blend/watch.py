"""Cook and Torrance 1982, figure 8: a watch with an outer band of gold, an inner one of stainless steel, and LEDs.

The links of the outer band are rough inside a smooth border; one lamp lights the watch, beside the ambient term.
"""

import math

import bpy
import numpy as np
from mathutils import Matrix, Vector

from .interiors import show_scene
from .job import Figure
from .pictures import labelled
from .shapes import polygon, rounded_box, seven_segments
from .studio import add_camera, add_cove, add_softbox, set_sky
from .turned import turned_object

RADIUS = 1.32
"""Of the band's loop; everything else is measured by it."""

LINKS = 17
LINK_HEIGHT = 0.15
FLAT, SOFT = 0.90, 0.06
"""The loop stands on links that lie flat: no part of it is lower than FLAT of the radius, rounded by SOFT of it."""
CASE_HALF_ANGLE = math.radians(37.0)
TILT = math.radians(52.0)
LED_NM = 640.0
SMOOTH, ROUGH, ROUGHEST = 0.08, 0.28, 0.5


def gold_with_pattern():
    """Gold, smooth along the border of each link and rough inside, in fine stripes of two slopes."""
    from addon import api
    from addon.blender.datablocks.groups import socket_named
    from addon.blender.datablocks.materials import our_node
    material = api.create_material(preset="gold", name="Gold, patterned")
    tree, ours = material.node_tree, our_node(material)

    def math_node(operation, *inputs, x):
        node = tree.nodes.new("ShaderNodeMath")
        node.operation = operation
        node.location = (x, -200)
        for socket, given in zip(node.inputs, inputs):
            if isinstance(given, (int, float)):
                socket.default_value = given
            else:
                tree.links.new(given, socket)
        return node.outputs[0]
    place = tree.nodes.new("ShaderNodeTexCoord")
    split = tree.nodes.new("ShaderNodeSeparateXYZ")
    place.location, split.location = (-1300, -200), (-1100, -200)
    tree.links.new(place.outputs["Generated"], split.inputs[0])
    x, y = split.outputs["X"], split.outputs["Y"]
    from_edge = [math_node("SUBTRACT", 0.5, math_node("ABSOLUTE", math_node("SUBTRACT", at, 0.5, x=-900), x=-800),
                           x=-700) for at in (x, y)]
    inside = math_node("MULTIPLY", math_node("GREATER_THAN", from_edge[0], 0.2, x=-600),
                       math_node("GREATER_THAN", from_edge[1], 0.2, x=-600), x=-500)
    wave = math_node("SINE", math_node("MULTIPLY", math_node("ADD", x, y, x=-900), 20.0, x=-800), x=-700)
    striped = math_node("MULTIPLY_ADD", math_node("GREATER_THAN", wave, 0.0, x=-600), ROUGHEST - ROUGH, ROUGH, x=-500)
    slope = math_node("MULTIPLY_ADD", inside, math_node("SUBTRACT", striped, SMOOTH, x=-400), SMOOTH, x=-300)
    tree.links.new(math_node("SQRT", slope, x=-200), socket_named(ours, "Roughness"))
    return material


def led_colour():
    """Linear Rec.709 of a light of 640 nm, desaturated at constant dominant wavelength, its largest channel 1."""
    from addon.bake.colour import rgb_to_xyz
    from addon.bake.gamut import map_colours
    from addon.spectra import observers
    matching = observers.colour_matching_functions("1931")
    xyz = [np.interp(LED_NM, observers.WAVELENGTH_NM, matching[:, j]) for j in range(3)]
    rgb = np.linalg.solve(rgb_to_xyz("Rec.709"), xyz)
    inside, _ = map_colours(rgb[None] / rgb.max(), "desaturate")
    return inside[0] / inside[0].max()


def glowing(name, colour, radiance):
    """A material that shines."""
    from addon.blender.compat import enable_nodes
    material = bpy.data.materials.new(name)
    enable_nodes(material)
    tree = material.node_tree
    tree.nodes.clear()
    emission = tree.nodes.new("ShaderNodeEmission")
    emission.inputs["Color"].default_value = (*colour, 1.0)
    emission.inputs["Strength"].default_value = radiance
    tree.links.new(emission.outputs[0], tree.nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    return material


def build_watch():
    """The watch, its loop about the origin in the plane of y and z, its face leaning back; all parts in a list."""
    from addon import api
    gold = api.create_material(preset="gold", name="Gold, polished", slopes=[(SMOOTH, 0.8), (0.2, 0.2)])
    satin = api.create_material(preset="gold", name="Gold, satin", slopes=[(0.25, 1.0)])
    steel = api.create_material(preset="stainless_steel", name="Stainless steel", slopes=[(0.12, 0.7), (0.25, 0.3)])
    glass = api.create_material(preset="obsidian", name="Dark glass", slopes=[(0.03, 1.0)], specular=0.35)
    head = [*_case(gold, satin, steel, glass), *_digits("10:58", glowing("LED, 640 nm", led_colour(), 0.95))]
    bpy.context.view_layer.update()
    for part in head:
        part.matrix_world = Matrix.Rotation(TILT, 4, "X") @ part.matrix_world
    return [*head, *_band(gold_with_pattern(), steel)]


def loop():
    """The band's middle: (y and z, (N, 2)), from one end of the case round to the other."""
    turn = np.linspace(TILT + CASE_HALF_ANGLE, TILT + 2.0 * math.pi - CASE_HALF_ANGLE, 4001)
    above = (np.cos(turn) + FLAT) / SOFT
    return RADIUS * np.stack([-np.sin(turn), SOFT * np.logaddexp(0.0, above) - FLAT], axis=1)


def _band(patterned, steel):
    """Links at equal distances along the loop."""
    path = loop()
    way = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(path, axis=0).T))])
    step = way[-1] / LINKS
    parts = []
    for at in step * (np.arange(LINKS) + 0.5):
        (y, z), before, after = ([np.interp(d, way, path[:, j]) for j in (0, 1)] for d in (at, at - 0.1, at + 0.1))
        turn = Matrix.Rotation(math.atan2(before[1] - after[1], before[0] - after[0]), 4, "X")
        for x, width, height, material in ((-0.43, 0.40, LINK_HEIGHT, patterned), (0.0, 0.44, 0.12, steel),
                                           (0.43, 0.40, LINK_HEIGHT, patterned)):
            link = rounded_box("Link", (width, 0.92 * step, height), 0.035, material, segments=4)
            link.matrix_world = Matrix.Translation((x, y, z)) @ turn
            parts.append(link)
    return parts


def _case(gold, satin, steel, glass):
    """Body, bezel, window and crown, at the top of the loop."""
    parts = []
    for name, size, radius, height, material in (
            ("Case", (1.62, 1.66, 0.30), 0.12, 0.02, satin), ("Bezel", (1.42, 1.24, 0.14), 0.06, 0.19, gold),
            ("Window", (1.16, 0.80, 0.06), 0.025, 0.245, glass)):
        part = rounded_box(name, size, radius, material, segments=6)
        part.location = (0.0, 0.0, RADIUS + height)
        parts.append(part)
    crown = turned_object("Crown", ((0, 0), (0.13, 0), (0.15, 0.02), (0.15, 0.10), (0.13, 0.13), (0, 0.14)), steel,
                          segments=48)
    crown.matrix_world = Matrix.Translation((0.80, 0.0, RADIUS + 0.02)) @ Matrix.Rotation(math.pi / 2, 4, "Y")
    return [*parts, crown]


def _digits(text, material):
    parts, x = [], -0.42
    top = RADIUS + 0.2755
    for character in text:
        if character == ":":
            dots = [polygon("Dot", [(x + 0.025 + 0.024 * math.cos(a), y + 0.024 * math.sin(a))
                                    for a in np.linspace(0.0, 2.0 * math.pi, 12, endpoint=False)], 0.004, material)
                    for y in (-0.06, 0.07)]
            x += 0.12
        else:
            dots = seven_segments(character, 0.27, 0.125, material, thickness=0.004)
            for part in dots:
                part.location.x, part.location.y = x, -0.135
            x += 0.205
        for part in dots:
            part.location.z = top
        parts += dots
    return parts


def figure_8(job):
    """The watch, standing on its band."""
    scene = show_scene(job, 20, size=(1200, 960))
    add_cove(scene, (0.085, 0.088, 0.096))
    lift = 0.5 * LINK_HEIGHT - loop()[:, 1].min()
    whole = Matrix.Translation((0.0, 0.0, lift)) @ Matrix.Rotation(math.radians(-30.0), 4, "Z")
    for part in build_watch():
        part.matrix_world = whole @ part.matrix_world
    add_softbox(scene, Vector((-3.2, -3.6, 6.4)), (0.0, 0.0, 1.4), (4.5, 3.2), 3.0)
    add_softbox(scene, Vector((5.5, -4.0, 2.6)), (0.0, 0.0, 1.2), (0.8, 4.0), 2.5)
    set_sky(scene, 0.9, 0.40, 0.10)
    add_camera(scene, (1.4, -9.4, 4.6), (0.05, 0.0, 1.22), 84.0)
    picture = job.render(scene, "figure 8, the watch")
    job.write(labelled(picture, "8  watch: gold, stainless steel, LEDs of 640 nm"), "watch.jpg")
    job.save_scene("watch")


FIGURES = (Figure("watch", "Cook and Torrance, figure 8: the watch", 90.0, figure_8),)
