"""A newcomer drops the zip into the window; two clicks give a copper cube, which Control-Z undoes."""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))

import hands  # noqa: E402
import tiles  # noqa: E402
from hands import area_of, click, find, key, middle_of, picture, preset, step, until, within  # noqa: E402

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
    assert not libraries()  # and nothing written into the preferences

    step("click the button in the header: all materials, and the library is in the preferences")
    button = yield from find(view, "facet_film.choose", "HEADER")
    hands.report["clicks"] = 0
    yield from click(*button)
    yield from until(libraries, "the library is in the preferences")
    yield 8.0  # Blender reads the pictures one after the other
    picture("click_1")

    step("click on the picture of copper")
    yield from click(*tiles.place_of("copper"))
    yield from until(lambda: preset() == "copper", "the cube is copper")
    assert hands.report["clicks"] == 2, hands.report["clicks"]
    yield 0.5
    picture("click_2")
    yield from key("ESC", middle_of(view))
    yield 0.5

    # The default lamp stands behind what the default view sees, so that Rendered is lit here as Material Preview is.
    view.spaces.active.shading.use_scene_lights_render = view.spaces.active.shading.use_scene_world_render = False
    step("click Rendered in the viewport")
    rendered = yield from find(view, "shading.type", "HEADER")
    yield from click(*rendered)
    yield from until(lambda: view.spaces.active.shading.type == "RENDERED", "the viewport renders")
    yield 20.0  # two cores and no graphics card; a graphics card shows this at once
    picture("click_3")
    view.spaces.active.shading.type = "SOLID"

    step("undo the copper by Control-Z and redo it")
    yield from hands.undo(middle_of(view))
    yield from until(lambda: preset() is None, "no copper after undo")
    assert bpy.data.objects["Cube"].active_material.name == "Material"
    yield from hands.redo(middle_of(view))
    yield from until(lambda: preset() == "copper", "copper after redo")


def libraries():
    """The asset libraries of ours in the preferences."""
    found = bpy.context.preferences.filepaths.asset_libraries
    return [library.name for library in found if library.name == "Facet & Film"]


hands.play(session, samples=2000)
