"""The tutorial of brushed copper, step by step: a click on the picture, the finish, the roughness, the marks."""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))

import hands  # noqa: E402
import tiles  # noqa: E402
from hands import area_of, click, drag, find, key, middle_of, picture, preset, step, until  # noqa: E402

ROW, ENTRY = 20, 23
"""Pixels from one button of the panel to the next, and from one entry of a menu to the next."""


def session():
    """Everything, in order."""
    hands.installed()
    properties, view = area_of("PROPERTIES"), area_of("VIEW_3D")
    properties.spaces.active.context = "MATERIAL"
    bpy.ops.ed.undo_push(message="Start")
    yield 1.0

    step("the ball in the header, and copper")
    button = yield from find(view, "facet_film.choose", "HEADER")
    yield from click(*button)
    yield 6.0
    yield from click(*tiles.place_of("copper"))
    yield from until(lambda: preset() == "copper", "the cube is copper")
    yield from key("ESC", middle_of(view))
    yield 2.0

    step("Finish: Brushed")
    slider = yield from find(properties, "default_value", across=(0.5,))
    button = slider[0], slider[1] + ROW  # Blender does not tell what a menu's button runs
    yield from click(*button)
    yield 0.5
    entry = button[0], button[1] - ENTRY * place_in_menu("brushed")
    hands.move(*entry)
    yield 0.5
    picture("finishes")
    yield from click(*entry)
    yield from until(lambda: finish() == "brushed", "the finish is brushed")
    yield 8.0
    picture("brushed")

    step("move the slider of the roughness")
    slider = yield from find(properties, "default_value", across=(0.5,))
    before = roughness()
    yield from drag(slider, (slider[0] + 25, slider[1]))
    yield from until(lambda: roughness() != before, "the roughness is another")
    yield 8.0
    picture("rougher")


def finish():
    """The finish on the cube."""
    from bl_ext.user_default.facet_film.addon import api
    return api.record_of(bpy.data.objects["Cube"].active_material).finish


def place_in_menu(name):
    """How far down the menu of finishes one stands."""
    from bl_ext.user_default.facet_film.addon.finishes import all_finishes
    return 2 + [one.name for one in all_finishes()].index(name)


def roughness():
    """The roughness that the finish varies."""
    nodes = bpy.data.objects["Cube"].active_material.node_tree.nodes
    return [node.inputs["Roughness"].default_value for node in nodes if "Roughness" in node.inputs]


hands.play(session)
