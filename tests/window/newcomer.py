"""A newcomer drops the zip into the window; three clicks give a copper cube, which Control-Z undoes."""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))

import hands  # noqa: E402
from hands import area_of, click, find, key, middle_of, picture, preset, step, under_mouse, until, within  # noqa: E402


def material_tab(area):
    """The icon of the Material tab: the lowest of the column of tabs that sets the context to MATERIAL."""
    region = hands.region_of(area, "NAVIGATION_BAR")
    x = region.x + region.width // 2
    for y in range(region.y + 4, region.y + region.height, 8):
        hands.move(x, y)
        yield hands.LOOK
        if "context" in under_mouse(area, "NAVIGATION_BAR"):
            yield from click(x, y)
            if area.spaces.active.context == "MATERIAL":
                return x, y
            hands.report["clicks"] -= 1  # a tab below it
    raise AssertionError("No Material tab among the tabs of the Properties editor")


BAKING = f"{hands.MODULE}.addon.bake.baking"


def session():
    """Everything, in order."""
    step("drop the zip into the window and confirm")
    view = area_of("VIEW_3D")
    with within(view):
        bpy.ops.extensions.package_install_files("INVOKE_DEFAULT", url=hands.ZIP)
    yield 1.0
    picture("install")
    yield from key("RET", middle_of(view))
    yield from until(lambda: hands.MODULE in bpy.context.preferences.addons, "the extension is enabled", 30)
    bpy.ops.ed.undo_push(message="Installed")
    assert BAKING not in sys.modules  # nothing at start-up but classes and menus

    step("click the Material tab")
    hands.report["clicks"] = 0
    properties = area_of("PROPERTIES")
    yield from material_tab(properties)
    yield from until(lambda: BAKING in sys.modules, "what the first preset needs is loaded")
    yield 0.5
    picture("click_1")

    step("click Apply: copper")
    apply = yield from find(properties, "facet_film.bake_preset")
    yield from click(*apply)
    yield from until(lambda: preset() == "copper", "the cube is copper")
    yield 0.5
    picture("click_2")

    # The default lamp stands behind what the default view sees, so that Rendered is lit here as Material Preview is.
    view.spaces.active.shading.use_scene_lights_render = view.spaces.active.shading.use_scene_world_render = False
    step("click Rendered in the viewport")
    rendered = yield from find(view, "shading.type", "HEADER")
    yield from click(*rendered)
    yield from until(lambda: view.spaces.active.shading.type == "RENDERED", "the viewport renders")
    yield 30.0  # two cores and no graphics card; a graphics card shows this at once
    picture("click_3")
    assert hands.report["clicks"] == 3, hands.report["clicks"]
    view.spaces.active.shading.type = "SOLID"

    step("undo the copper by Control-Z and redo it")
    yield from hands.undo(middle_of(view))
    yield from until(lambda: preset() is None, "no copper after undo")
    yield from hands.redo(middle_of(view))
    yield from until(lambda: preset() == "copper", "copper after redo")


hands.play(session, samples=2000)
