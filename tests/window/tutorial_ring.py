"""The tutorial of the anodised ring, step by step: a torus, the search, the thickness, volts."""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))

import hands  # noqa: E402
from hands import area_of, click, drag, find, key, middle_of, picture, region_of, step, until, within, write  # noqa: E402

ROW, ARROW = 26, 21
"""Pixels from one row of the panel Surface to the next, and from its left to the arrows that show what feeds a row."""

FIRST_SOCKET, SOCKET, CHOICE = 35, 22, 26
"""From the top of a node to its first socket, from one to the next, and what the choice of the group takes between its
outputs and its inputs.
"""


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
    names = [socket.name for socket in node_of("Film Standard").inputs]
    specular = names.index("Specular")  # which the card above does not show as well
    _, y = yield from find(properties, f"inputs[{specular}].default_value", across=(0.65,))
    yield from click(region_of(properties).x + ARROW, y + ROW * (specular - names.index("Thickness")))
    yield 1.0
    slider = yield from find(properties, greatest().path_from_id("default_value"), across=(0.75,))
    yield from drag(slider, (slider[0] - 60, slider[1]))
    yield from until(lambda: greatest().default_value < 175.0, "the thickest is thinner")
    yield 4.0
    picture("thickness")
    yield from by_volts(view)


def by_volts(view):
    """In the Shader Editor: the group of volts, and a line from it to the film."""
    step("add Film Anodising, and draw a line from Titanium to Thickness")
    view.ui_type = "ShaderNodeTree"
    yield 1.5
    region = region_of(view)
    at = region.x + region.width // 4, region.y + region.height // 2
    yield from key("HOME", at)
    yield 1.0
    yield from key("A", at, shift=True)
    yield 1.0
    yield from write("film anodising", at)
    yield 1.5
    yield from key("RET", at)
    yield 0.5
    yield from click(region.x + 10, region.y + region.height // 4)
    yield from until(lambda: node_of("Film Anodising") is not None, "the group is there")
    yield 1.0
    volts, film = node_of("Film Anodising"), node_of("Film Standard")
    start = place_of(region, volts, volts.width, FIRST_SOCKET)
    end = place_of(region, film, 0.0, FIRST_SOCKET + SOCKET * len(film.outputs) + CHOICE)
    yield from drag(start, end)
    yield from until(lambda: feeds_thickness() == "Film Anodising", "volts feed the thickness")
    yield from key("HOME", at)
    yield 2.0
    picture("volts")


def place_of(region, node, right, below):
    """Where on the screen a place of a node is."""
    x, y = region.view2d.view_to_region(node.location_absolute.x + right, node.location_absolute.y - below, clip=False)
    return region.x + x, region.y + y


def node_of(group):
    """The node of a group on the ring, by the group's name."""
    nodes = bpy.data.objects["Torus"].active_material.node_tree.nodes
    return next((node for node in nodes if getattr(node, "node_tree", None)
                 and node.node_tree.name.startswith(group)), None)


def feeds_thickness():
    """The group that the film's thickness comes from."""
    links = next(socket.links for socket in node_of("Film Standard").inputs if socket.name == "Thickness")
    return links[0].from_node.node_tree.name if links else None


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
