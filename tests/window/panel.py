"""In the Material panel: search by typing, apply, another realisation, undo and redo; other languages."""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))

import hands  # noqa: E402
from hands import area_of, click, find, group, key, middle_of, picture, preset, step, until, within, write  # noqa: E402


def session():
    """Everything, in order."""
    hands.installed()
    properties, view = area_of("PROPERTIES"), area_of("VIEW_3D")
    properties.spaces.active.context = "MATERIAL"
    bpy.ops.ed.undo_push(message="Start")
    yield 0.7
    apply = yield from find(properties, "facet_film.bake_preset")

    step("search by typing, and take what is listed first")
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

    step("switch to Exact by the menu")
    scroll_to_end(properties)
    yield 0.5
    # Blender does not tell what a menu's button opens; this one is left of Re-bake.
    rebake = yield from find(properties, "facet_film.rebake(")
    button = hands.region_of(properties).x + int(0.3 * hands.region_of(properties).width), rebake[1]
    yield from click(*button)
    yield 0.4
    picture("realisations")
    yield from key("E", button)
    yield from until(lambda: "Exact" in group(), "the group is Exact")
    yield from hands.undo(middle_of(view))
    yield from until(lambda: "Fast" in group(), "Fast again after undo")
    yield from hands.redo(middle_of(view))
    yield from until(lambda: "Exact" in group(), "Exact again after redo")
    picture("panel")
    yield from languages(properties, apply)


def scroll_to_end(area):
    """The end of the Material tab, where our panel is."""
    with within(area):
        for _ in range(12):
            bpy.ops.view2d.scroll_down(page=True)


def languages(properties, apply):
    """Apply by a click in each language that we have and this Blender does."""
    step("apply in the interface's other languages")
    with within(properties):
        for _ in range(12):
            bpy.ops.view2d.scroll_up(page=True)
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
