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
    field = yield from find(properties, "layers[1].material", across=(0.6,), every=8)
    yield from click(*field)
    yield from key("A", field, ctrl=True)
    yield from write("mgf", field)
    yield 0.5
    picture("layers_search")
    yield from key("DOWN_ARROW", field)
    yield from key("RET", field)
    yield from until(lambda: settings().layers_text == "TiO2 0-200 nm / MgF2 100 nm / Ti",
                     "the text has the layer that was chosen from the list")

    step("bake")
    button = yield from find(properties, "facet_film.bake_layers", across=(0.5,))
    yield from click(*button)
    yield from until(lambda: stack() == "TiO2 0-200 nm / MgF2 100 nm / Ti", "the material is made of both layers")
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


def settings():
    """What the panel edits."""
    return bpy.context.window_manager.facet_film


def stack():
    """What the cube is made of."""
    material = bpy.data.objects["Cube"].active_material
    return json.loads(material["facet_film"])["parameters"]["stack"]


hands.play(session)
