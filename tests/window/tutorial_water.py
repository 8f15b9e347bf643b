"""The tutorial of a glass of water: its snippet, as it stands there; then by hand, with what the wall is against."""

import re
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))

import hands  # noqa: E402
from hands import area_of, click, find, key, middle_of, picture, step, until, within, write  # noqa: E402

BY_HAND = (("Glass", "low iron"), ("Surface", "water"), ("Wall", "water"))

ROW = 26
"""Pixels from a button to the one below."""
MADE = {"Glass": "Clear glass, low iron", "Surface": "Water", "Wall": "Water"}


def session():
    """Everything, in order."""
    hands.installed()
    properties, view = area_of("PROPERTIES"), area_of("VIEW_3D")
    bpy.data.objects.remove(bpy.data.objects["Cube"])

    step("the snippet makes the three meshes, with their materials")
    text = (hands.FOLDER / "glass_of_water.md").read_text(encoding="utf-8")
    exec(re.search(r"```python\n(.*?)```", text, re.S).group(1), {})
    assert is_near(outside_of("Wall"), ior_of("Glass")) and is_near(outside_of("Glass"), 1.0)
    for name, _ in BY_HAND:
        bpy.data.objects[name].data.materials.clear()
    with within(view):
        bpy.ops.object.select_all(action="SELECT")
        bpy.ops.view3d.view_selected()
    choose("Glass")
    properties.spaces.active.context = "MATERIAL"
    bpy.ops.ed.undo_push(message="Meshes")
    yield 1.5

    for name, words in BY_HAND:
        step(f"{name}: search for {words}")
        hands.move(*middle_of(view))
        choose(name)
        yield 2.0
        button = yield from find(properties, "facet_film.search", across=(0.85,))
        hands.move(*middle_of(view))  # a button that has been clicked is to be left before it is clicked again
        yield 0.5
        yield from click(*button)
        yield 2.0
        yield from write(words, button)
        yield 1.5
        picture(f"search_{name}")
        yield from key("RET", button)
        yield from until(lambda name=name: bpy.data.objects[name].active_material, f"{name} has a material")
        assert bpy.data.objects[name].active_material.name.startswith(MADE[name])
        yield 1.0
    assert len({bpy.data.objects[name].active_material for name, _ in BY_HAND}) == 3

    step("choose what the wall is against")
    with within(properties):
        bpy.ops.view2d.scroll_down(page=True)
    yield 1.0
    x, y = yield from find(properties, "facet_film.switch_realisation", across=(0.6,))
    field = x, y - ROW  # of a menu Blender does not tell whose it is
    picture("wall_before")
    yield from click(*field)
    yield 1.0
    picture("wall_menu")
    for _ in range(2):
        yield from key("DOWN_ARROW", field)
    yield from key("RET", field)
    yield from until(lambda: is_near(outside_of("Wall"), ior_of("Glass")), "outside the wall there is glass")
    yield 4.0
    picture("wall")


def choose(name):
    """Make an object the active and only selected one, as a click in the outliner does."""
    for one in bpy.context.scene.objects:
        one.select_set(one.name == name)
    bpy.context.view_layer.objects.active = bpy.data.objects[name]


def is_near(value, wanted):
    """Whether a socket has this value, which it holds in single precision."""
    return abs(value - wanted) < 1e-5


def parameters_of(name):
    """Of an object's material."""
    from bl_ext.user_default.facet_film.addon import api
    return api.record_of(bpy.data.objects[name].active_material).parameters


def outside_of(name):
    """Outside IOR of an object's material."""
    return parameters_of(name).outside


def ior_of(name):
    """IOR of an object's material."""
    return parameters_of(name).ior


hands.play(session)
