"""The picker: from picture to picture, the search, a drag from the shelf, and a material made by hand; all undone."""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))

import hands  # noqa: E402
import tiles  # noqa: E402
from hands import (  # noqa: E402
    area_of,
    click,
    drag,
    find,
    key,
    middle_of,
    picture,
    preset,
    region_of,
    step,
    until,
    within,
    write,
)

OPEN_S = 2.0


def session():
    """Everything, in order."""
    hands.installed()
    properties, view = area_of("PROPERTIES"), area_of("VIEW_3D")
    properties.spaces.active.context = "MATERIAL"
    bpy.ops.ed.undo_push(message="Start")
    yield 1.0
    picture("card_before")
    yield from from_picture_to_picture(properties, view)
    yield from by_hand(view)
    yield from by_search(properties, view)
    yield from from_the_shelf(properties, view)


def from_picture_to_picture(properties, view):
    """The popover stays open; every click is a step of its own to undo, and one slot holds one material."""
    step("from picture to picture")
    button = yield from find(properties, "facet_film.choose", across=(0.5,))
    yield from click(*button)
    yield OPEN_S
    for name in ("copper", "chromium", "brass"):
        yield from click(*tiles.place_of(name))
        yield from until(lambda name=name: preset() == name, f"the cube is {name}")
        picture(f"picked_{name}")
    assert names() == ["Brass"], names()
    yield from key("ESC", middle_of(view))
    yield 1.5
    picture("card_after")
    for name in ("chromium", "copper", None):
        yield from hands.undo(middle_of(view))
        yield from until(lambda name=name: preset() == name, f"{name} again after undo")


def by_hand(view):
    """A material that two objects share stays on the other one as it was."""
    step("a material made by hand and shared survives")
    made = bpy.data.materials.new("By Hand")
    made.node_tree.nodes.new("ShaderNodeTexNoise")
    other = bpy.data.objects.new("Other", bpy.data.objects["Cube"].data.copy())
    bpy.context.scene.collection.objects.link(other)
    bpy.data.objects["Cube"].active_material = other.active_material = made
    bpy.ops.ed.undo_push(message="By hand")
    yield 0.5
    button = yield from find(view, "facet_film.choose", "HEADER")
    yield from click(*button)
    yield OPEN_S
    yield from click(*tiles.place_of("gold"))
    yield from until(lambda: preset() == "gold", "the cube is gold")
    assert names() == ["Gold"] and bpy.data.objects["Other"].active_material.name == "By Hand"
    assert len(bpy.data.materials["By Hand"].node_tree.nodes) == 3
    yield from key("ESC", middle_of(view))
    yield 0.5
    yield from hands.undo(middle_of(view))
    yield from until(lambda: names() == ["By Hand"], "the material by hand is on the cube again after undo")


def by_search(properties, view):
    """Any name for it, as Americans spell it."""
    step("by search to anodised titanium")
    button = yield from find(properties, "facet_film.search", across=(0.85,))
    yield from click(*button)
    yield 1.0
    yield from write("anodized titanium rain", button)
    yield 0.7
    picture("search")
    yield from key("RET", button)
    yield from until(lambda: preset() == "anodised_titanium", "the cube is anodised titanium")
    yield 2.0
    picture("searched")
    yield from hands.undo(middle_of(view))
    yield from until(lambda: names() == ["By Hand"], "undone")


def from_the_shelf(properties, view):
    """Dragged onto the cube, which fills the view's middle, whatever is selected."""
    step("drag a picture from the shelf onto the cube")
    bpy.data.objects["Other"].hide_set(True)
    with within(view):
        bpy.ops.view3d.view_selected()
    bpy.data.objects["Cube"].select_set(False)
    bpy.ops.ed.undo_push(message="Nothing selected")
    yield 1.0
    button = yield from find(properties, "facet_film.shelf", across=(0.85,))
    yield from click(*button)
    yield from until(lambda: region_of(view, "ASSET_SHELF").height > 20, "the shelf is open")
    yield 3.0
    shelf = region_of(view, "ASSET_SHELF")
    picture("shelf")
    yield from drag((shelf.x + 60, shelf.y + shelf.height // 2), middle_of(view))
    yield from until(lambda: preset() is not None, "what was dragged is on the cube")
    picture("shelf_dropped")
    yield from hands.undo(middle_of(view))
    yield from until(lambda: names() == ["By Hand"], "undone")


def names():
    """Names of the materials in the cube's slots."""
    return [slot.material.name for slot in bpy.data.objects["Cube"].material_slots]


hands.play(session)
