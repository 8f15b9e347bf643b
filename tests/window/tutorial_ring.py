"""The tutorial of the anodised ring, step by step: a torus, the search, the thickness, volts."""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))

import hands  # noqa: E402
from hands import area_of, click, drag, find, key, middle_of, picture, region_of, step, until, within, write  # noqa: E402

ROW, ARROW = 26, 21
"""Pixels from one row of the panel Surface to the next, and from its left to the arrows that show what feeds a row."""


def session():
    """Everything, in order."""
    hands.installed()
    properties, view = area_of("PROPERTIES"), area_of("VIEW_3D")
    yield 1.0

    step("delete the cube, add a torus")
    middle = middle_of(view)
    yield from key("DEL", middle)
    yield from until(lambda: "Cube" not in bpy.context.scene.objects, "no cube")
    yield from key("A", middle, shift=True)
    yield 0.5
    yield from write("torus", middle)
    yield 0.5
    yield from key("RET", middle)
    yield from until(lambda: "Torus" in bpy.context.scene.objects, "a torus")
    for letter in ("R", "X"):
        yield from key(letter, middle)
    yield from write("90", middle)
    yield from key("RET", middle)
    assert abs(bpy.data.objects["Torus"].rotation_euler.x - 1.5708) < 1e-3
    with within(view):
        bpy.ops.object.transform_apply(location=False, rotation=True, scale=False)
        bpy.ops.object.shade_smooth()
        bpy.ops.view3d.view_selected()
    properties.spaces.active.context = "MATERIAL"
    bpy.ops.ed.undo_push(message="Torus")
    yield 1.5
    picture("torus")

    step("search for anodised titanium")
    button = yield from find(properties, "facet_film.search", across=(0.85,))
    yield from click(*button)
    yield 1.0
    yield from write("anodised titanium", button)
    yield 0.7
    picture("search")
    yield from key("RET", button)
    yield from until(lambda: name() == "anodised_titanium", "the ring is anodised titanium")
    yield 3.0
    picture("ring")

    step("open the thickness, and make its greatest less")
    specular = yield from find(properties, "inputs[2].default_value", across=(0.65,))
    yield from click(region_of(properties).x + ARROW, specular[1] + 2 * ROW)
    yield 1.0
    slider = yield from find(properties, greatest().path_from_id("default_value"), across=(0.75,))
    yield from drag(slider, (slider[0] - 60, slider[1]))
    yield from until(lambda: greatest().default_value < 175.0, "the thickest is thinner")
    yield 4.0
    picture("thickness")


def greatest():
    """The socket of the greatest thickness."""
    nodes = bpy.data.objects["Torus"].active_material.node_tree.nodes
    return next(socket for node in nodes for socket in node.inputs if socket.name == "Greatest Thickness")


def name():
    """The preset on the ring."""
    from bl_ext.user_default.facet_film.addon import api
    material = bpy.data.objects["Torus"].active_material
    return api.record_of(material).baked.get("name") if material else None


hands.play(session)
