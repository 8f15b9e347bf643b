"""In the Material panel: another realisation, undone and redone; any dataset by typing; other languages."""

import sys
from importlib import import_module
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))

import hands  # noqa: E402
from hands import area_of, click, find, group, key, middle_of, picture, preset, step, until, within, write  # noqa: E402


def session():
    """Everything, in order."""
    hands.installed()
    open_measurement()
    properties, view = area_of("PROPERTIES"), area_of("VIEW_3D")
    properties.spaces.active.context = "MATERIAL"
    with within(view):
        bpy.ops.facet_film.apply(preset="copper")
    bpy.ops.ed.undo_push(message="Start")
    yield 0.7
    scroll_to_end(properties)
    yield 0.5
    picture("panel")

    step("switch to Reference by its button")
    button = yield from found_above(properties, "facet_film.switch_realisation(realisation='exact'")
    yield from click(*button)
    yield from until(lambda: "Reference" in group(), "the group is that of the Reference")
    yield from hands.undo(middle_of(view))
    yield from until(lambda: "Standard" in group(), "Standard again after undo")
    yield from hands.redo(middle_of(view))
    yield from until(lambda: "Reference" in group(), "the Reference again after redo")

    step("search the whole database by typing, and take what is listed first")
    scroll_to_end(properties)
    yield 0.5
    apply = yield from find(properties, "facet_film.bake_preset")
    field = yield from find(properties, "facet_film.preset", across=(0.3,))
    yield from click(*field)
    yield from key("A", field, ctrl=True)
    yield from write("single crystal", field)
    yield 0.5
    picture("search")
    yield from key("DOWN_ARROW", field)
    yield from key("RET", field)
    yield from until(lambda: bpy.context.window_manager.facet_film.preset == "gold_single_crystal",
                     "the name of the first in the list is in the field")
    yield from click(*apply)
    yield from until(lambda: preset() == "gold_single_crystal", "the cube is gold")
    yield from languages(properties, apply)


def found_above(area, wanted):
    """Where a button is, page by page upwards."""
    for _ in range(8):
        try:
            return (yield from find(area, wanted, across=(0.75,)))
        except AssertionError:
            with within(area):
                bpy.ops.view2d.scroll_up(page=True)
            yield 0.3
    raise AssertionError(f"No button for {wanted} on any page")


def open_measurement():
    """Have the panel Measurement open from the start: Blender tells nobody where a panel's header is to be clicked."""
    module = import_module(f"{hands.MODULE}.addon.blender.panels.measurement")
    for cls in reversed(module.CLASSES):
        bpy.utils.unregister_class(cls)
    module.FACET_FILM_PT_measurement.bl_options = set()
    for cls in module.CLASSES:
        bpy.utils.register_class(cls)


def scroll_to_end(area):
    """The end of the Material tab, where our panel is."""
    with within(area):
        for _ in range(12):
            bpy.ops.view2d.scroll_down(page=True)


def languages(properties, apply):
    """Apply by a click in each language that we have and this Blender does."""
    step("apply in the interface's other languages")
    has = [name for name in ("de_DE", "zh_HANS") if name in bpy.app.translations.locales]
    if not has:
        hands.report["skipped"].append("other languages: this Blender has no languages")
    for number, language in enumerate(has):
        bpy.context.preferences.view.language = language
        bpy.context.preferences.view.use_translate_interface = True
        chosen = bpy.context.window_manager.facet_film.preset = ("silver", "copper")[number]
        yield 1.0
        picture(f"panel_{language}")
        yield from click(*apply)
        yield from until(lambda chosen=chosen: preset() == chosen, f"{chosen} applied in {language}")


hands.play(session)
