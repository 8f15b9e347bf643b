"""What a newcomer does in a Blender window, with the mouse: started by run.py with --enable-event-simulate.

In its folder lie facet_film.zip and, when it is through, report.json and the pictures. Each step is a
generator that yields seconds to wait for Blender to draw.
"""

import contextlib
import io
import json
import subprocess
import time
import traceback
from pathlib import Path

import bpy

FOLDER = Path(__file__).resolve().parent
MODULE = "bl_ext.user_default.facet_film"
SETTLE = 0.4
report = {"steps": [], "failure": "", "said": "", "ms": {}, "clicks": 0}


def window():
    """The only window."""
    return bpy.context.window_manager.windows[0]


def area_of(kind):
    """The first area of this kind."""
    return next(area for area in window().screen.areas if area.type == kind)


def region_of(area, kind="WINDOW"):
    return next(region for region in area.regions if region.type == kind)


def within(area, **more):
    """Context of an area, as if the mouse were in it."""
    return bpy.context.temp_override(window=window(), area=area, region=region_of(area), **more)


def picture(name):
    """What is on the screen."""
    subprocess.run(["import", "-window", "root", str(FOLDER / f"{name}.png")], check=False)


def button_under_mouse(area):
    """The Python command of the button that the mouse is over, or an empty text."""
    bpy.context.window_manager.clipboard = ""
    with within(area):
        if bpy.ops.ui.copy_python_command_button.poll():
            with contextlib.suppress(RuntimeError):
                bpy.ops.ui.copy_python_command_button()
    return bpy.context.window_manager.clipboard


def click(x, y):
    """The left button, down and up."""
    window().event_simulate("LEFTMOUSE", "PRESS", x=x, y=y)
    window().event_simulate("LEFTMOUSE", "RELEASE", x=x, y=y)
    report["clicks"] += 1


def click_button(area, command):
    """Find a button by what it runs, moving the mouse down the area, and click it."""
    region = region_of(area)
    x = region.x + int(region.width * 0.6)
    for y in range(region.y + region.height - 6, region.y + 4, -9):
        window().event_simulate("MOUSEMOVE", "NOTHING", x=x, y=y)
        yield 0.06
        if command in button_under_mouse(area):
            click(x, y)
            yield SETTLE
            return
    raise AssertionError(f"No button runs {command}")


def step(name):
    report["steps"].append(name)


def preset_of_cube():
    """What the cube is made of, by its material's record."""
    material = bpy.data.objects["Cube"].active_material
    return json.loads(material.get("facet_film", "{}")).get("name") if material else None


def group_of_cube():
    tree = bpy.data.objects["Cube"].active_material.node_tree
    return next(node.node_tree.name for node in tree.nodes if node.bl_idname == "ShaderNodeGroup")


def timed_draws(panel):
    """Make a panel time its own drawing."""
    drawn, draw = [], panel.draw

    def timed(self, context):
        start = time.perf_counter()
        draw(self, context)
        drawn.append(1000.0 * (time.perf_counter() - start))
    panel.draw = timed
    return drawn, lambda: setattr(panel, "draw", draw)


def newcomer():
    """Everything, in order."""
    with within(area_of("VIEW_3D")):
        start = time.perf_counter()
        bpy.ops.extensions.package_install_files(filepath=str(FOLDER / "facet_film.zip"), repo="user_default",
                                                 enable_on_install=True)
        report["ms"]["install and enable"] = 1000.0 * (time.perf_counter() - start)
    assert MODULE in bpy.context.preferences.addons
    step("installed by the interface's operator")
    cube = bpy.data.objects["Cube"]
    bpy.context.view_layer.objects.active = cube
    bpy.ops.ed.undo_push(message="Start of the test")
    properties = area_of("PROPERTIES")
    properties.spaces.active.context = "MATERIAL"
    with within(properties):
        bpy.ops.screen.screen_full_area()
    yield SETTLE
    properties = area_of("PROPERTIES")
    for _ in range(2):
        properties.tag_redraw()
        yield SETTLE
    picture("1 panel")
    step("opened the panel")

    bpy.context.window_manager.facet_film.preset = "copper"
    yield from click_button(properties, "facet_film.bake_preset")
    assert preset_of_cube() == "copper", preset_of_cube()
    picture("2 copper applied by a click")
    step("applied copper by a click")

    drawn, restore = timed_draws(bpy.types.FACET_FILM_PT_material)
    for _ in range(8):
        properties.tag_redraw()
        yield 0.1
    restore()
    report["ms"]["panel draw"] = sorted(drawn)[len(drawn) // 2]

    search_timings()
    with within(properties):
        start = time.perf_counter()
        bpy.ops.facet_film.bake_preset(preset="gold")
        report["ms"]["change of preset"] = 1000.0 * (time.perf_counter() - start)
        bpy.ops.facet_film.bake_preset(preset="copper")
        bpy.ops.ed.undo_push(message="Copper")
        bpy.ops.facet_film.switch_realisation(realisation="exact")
        bpy.ops.ed.undo_push(message="Exact")
    assert group_of_cube() == "Cook-Torrance Exact"
    yield SETTLE
    picture("3 exact")
    step("switched to Exact")
    with within(properties):
        bpy.ops.ed.undo()
    assert group_of_cube() == "Cook-Torrance Fast", group_of_cube()
    with within(area_of("PROPERTIES")):
        bpy.ops.ed.redo()
    assert group_of_cube() == "Cook-Torrance Exact", group_of_cube()
    step("undone and redone")

    with within(area_of("PROPERTIES")):
        bpy.ops.facet_film.add_asset_library()
        bpy.ops.screen.back_to_previous()
    yield SETTLE
    yield from asset_browser()
    yield from viewport()
    bpy.ops.preferences.addon_disable(module=MODULE)
    assert not [library for library in bpy.context.preferences.filepaths.asset_libraries
                if library.name == "Facet & Film"]
    yield SETTLE
    step("disabled: the library is off the preferences, the material stays")
    assert group_of_cube() == "Cook-Torrance Exact"


def search_timings():
    """A query typed letter by letter, over the whole database."""
    from importlib import import_module
    search = import_module(f"{MODULE}.addon.spectra.search").search
    search("a", limit=40)
    took = []
    for query in ("copper", "Babar", "titanium ni", "SiO2"):
        for length in range(1, len(query) + 1):
            start = time.perf_counter()
            search(query[:length], limit=40)
            took.append(1000.0 * (time.perf_counter() - start))
    report["ms"]["a keystroke in the search, at most"] = max(took)


def asset_browser():
    """The timeline becomes an Asset Browser with our library."""
    area = next(a for a in window().screen.areas if a.type in ("DOPESHEET_EDITOR", "TIMELINE"))
    with within(area_of("VIEW_3D")):
        pass
    area.type = "FILE_BROWSER"
    area.ui_type = "ASSETS"
    yield SETTLE
    with within(area):
        bpy.ops.screen.screen_full_area()
    yield 1.0
    area = area_of("FILE_BROWSER")
    area.spaces.active.params.asset_library_reference = "Facet & Film"
    with within(area):
        bpy.ops.asset.library_refresh()
    yield 6.0
    picture("4 asset browser")
    step("the library is in the Asset Browser")
    with within(area):
        bpy.ops.screen.back_to_previous()
    yield SETTLE


def viewport():
    """Copper in the viewport, rendered by Cycles."""
    bpy.context.scene.render.engine = "CYCLES"
    bpy.context.scene.cycles.preview_samples = 8
    area = area_of("VIEW_3D")
    area.spaces.active.shading.type = "RENDERED"
    yield 8.0
    picture("5 viewport")
    area.spaces.active.shading.type = "SOLID"
    yield SETTLE
    step("rendered in the viewport")


def finish():
    """Write the report and leave."""
    (FOLDER / "report.json").write_text(json.dumps(report, indent=1), encoding="utf-8")
    bpy.ops.wm.quit_blender()


def run():
    """Drive the generator from a timer; its exceptions are the report's failure."""
    session = newcomer()

    def tick():
        said = io.StringIO()
        try:
            with contextlib.redirect_stdout(said):
                wait = next(session)
        except StopIteration:
            wait = None
        except Exception:
            report["failure"] = traceback.format_exc()
            picture("failure")
            wait = None
        report["said"] += said.getvalue()
        if wait is None:
            finish()
        return wait
    bpy.app.timers.register(tick, first_interval=2.0)


bpy.context.preferences.view.show_splash = False
run()
