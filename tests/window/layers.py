"""In the panel of layers, by mouse: the list of a film that is there, another layer, a thickness typed, Bake."""

import json
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))

import hands  # noqa: E402
from hands import area_of, click, find, key, middle_of, picture, step, until, within, write  # noqa: E402


def session():
    """Everything, in order."""
    hands.installed()
    properties, view = area_of("PROPERTIES"), area_of("VIEW_3D")
    properties.spaces.active.context = "MATERIAL"
    with within(view):
        bpy.ops.facet_film.apply(preset="anodised_titanium")
    bpy.ops.ed.undo_push(message="Start")
    yield 1.0

    step("the list and the text are those of the material that is shown")
    yield from until(lambda: settings().layers_text == "TiO2 0-200 nm / Ti", "the panel shows what the material is of")
    with within(properties):
        for _ in range(12):
            bpy.ops.view2d.scroll_down(page=True)
    yield 1.0
    picture("layers")

    step("add a layer by its button, and type what it is of")
    button = yield from find(properties, "facet_film.change_layers(what='ADD')", across=(0.93, 0.96))
    yield from click(*button)
    yield from until(lambda: len(settings().layers) == 2, "there are two layers")
    yield 0.5
    picture("layers_added")
    fields = yield from places(properties, "FacetFilmLayer material", across=0.2)
    yield from click(*fields[-1])
    yield from key("A", fields[-1], ctrl=True)
    yield from write("sio2", fields[-1])
    yield 0.5
    picture("layers_search")
    yield from key("DOWN_ARROW", fields[-1])
    yield from key("RET", fields[-1])
    yield from until(lambda: settings().layers_text == "TiO2 0-200 nm / SiO2 100 nm / Ti",
                     "the text has the layer that was chosen from the list")

    step("bake")
    button = yield from find(properties, "facet_film.bake_layers", across=(0.5,))
    yield from click(*button)
    yield from until(lambda: stack() == "TiO2 0-200 nm / SiO2 100 nm / Ti", "the material is made of both layers")
    yield 1.0
    picture("layers_baked")
    yield from hands.undo(middle_of(view))
    yield from until(lambda: stack() == "TiO2 0-200 nm / Ti" == settings().layers_text,
                     "undone, and the panel shows what the material is of again")

    step("what cannot be read is told beneath the text")
    settings().layers_text = "TiO2 0-200 nm / Unobtainium 5 nm / Ti"
    properties.tag_redraw()
    yield 1.0
    picture("layers_trouble")


def places(area, wanted, across):
    """Every place down a region where the button is `wanted`, from the top, one a button."""
    region = hands.region_of(area)
    found, before = [], ""
    x = region.x + int(region.width * across)
    for y in range(region.y + region.height - 5, region.y + 3, -6):
        hands.move(x, y)
        yield hands.LOOK
        told = hands.under_mouse(area)
        if told.startswith(wanted) and (not found or not before.startswith(wanted)):
            found.append((x, y - 4))
        before = told
    assert found, f"No button for {wanted}"
    return found


def settings():
    """What the panel edits."""
    return bpy.context.window_manager.facet_film


def stack():
    """What the cube is made of."""
    material = bpy.data.objects["Cube"].active_material
    return json.loads(material["facet_film"])["parameters"]["stack"]


hands.play(session)
