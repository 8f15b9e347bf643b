"""In the Shader Editor: our groups from the Add menu, by clicks and by typing; undone and redone."""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))

import hands  # noqa: E402
from hands import click, key, middle_of, picture, step, until, write  # noqa: E402

opened = []


def groups():
    """Names of the groups in the cube's material."""
    nodes = bpy.data.objects["Cube"].active_material.node_tree.nodes
    return sorted(node.node_tree.name for node in nodes if node.bl_idname == "ShaderNodeGroup")


def note_opened(_menu, _context):
    """Drawn at the end of our menu: so we know that it is open."""
    opened.append(True)


def session():
    """Both ways."""
    hands.installed()
    area = hands.area_of("VIEW_3D")
    area.ui_type = "ShaderNodeTree"
    yield 1.0
    region = hands.region_of(area)
    # The menu opens at the mouse with its first entry under it; ours is the last.
    at = region.x + region.width // 3, region.y + region.height - 60
    bpy.ops.ed.undo_push(message="Start")

    step("add a group by typing in the Add menu, and Return")
    yield from key("A", at, shift=True)
    yield 0.5
    picture("add_menu")
    yield from write("layered rgb standard", at)
    yield 0.7
    picture("add_typed")
    yield from key("RET", at)
    yield 0.3
    yield from click(*middle_of(area))  # puts down what hangs on the mouse
    yield from until(lambda: groups() == ["Layered RGB Standard"], "the group is there")
    yield from undone(area, 0)
    yield from hands.redo(middle_of(area))
    yield from until(lambda: groups() == ["Layered RGB Standard"], "there again after redo")

    step("add a group from the Add menu by clicks")
    bpy.types.FACET_FILM_MT_add.append(note_opened)
    yield from key("A", at, shift=True)
    yield 0.5
    entry = yield from our_entry(at, region)
    picture("add_sub_menu")
    yield from click(entry[0] + int(220 * bpy.context.preferences.system.ui_scale), entry[1])
    yield from click(*middle_of(area))
    yield from until(lambda: len(groups()) == 2, "a group more")
    picture("added")
    yield from undone(area, 1)


def undone(area, left):
    """Control-Z takes the placing back and then the adding, as for Blender's own nodes."""
    for _ in range(3):
        yield from hands.undo(middle_of(area))
        yield 0.3
        if len(groups()) == left:
            return
    raise AssertionError(f"After undo there are {groups()}")


def our_entry(at, region):
    """Move down the open menu until ours opens beside it; Blender opens one when the mouse has rested on its entry."""
    opened.clear()
    for y in range(at[1] - 120, max(region.y, at[1] - 500), -10):
        hands.move(at[0] - 20, y)
        yield 0.4
        if opened:
            return at[0] - 20, y
    raise AssertionError("No entry Facet & Film opened in the Add menu")


hands.play(session)
