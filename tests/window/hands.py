"""Hands and eyes in a Blender window: move, click, type, wait until something holds, take a picture.

A session is a generator that yields the seconds to let Blender draw; play() drives it from a timer and quits
Blender at its end. All files lie in this module's folder: log.txt, the pictures, and report.json.
"""

import faulthandler
import json
import shutil
import subprocess
import time
import traceback
from pathlib import Path

import bpy

FOLDER = Path(__file__).resolve().parent
MODULE = "bl_ext.user_default.facet_film"
ZIP = str(FOLDER / "facet_film.zip")
HANGS_AFTER = 140
LOOK = 0.04
KEYS = {" ": "SPACE", "-": "MINUS", ".": "PERIOD", **dict(zip("0123456789", (
    "ZERO", "ONE", "TWO", "THREE", "FOUR", "FIVE", "SIX", "SEVEN", "EIGHT", "NINE"), strict=True))}
started = time.perf_counter()
report = {"steps": [], "skipped": [], "failure": "", "clicks": 0}
log_file = (FOLDER / "log.txt").open("a", encoding="utf-8")


def log(text):
    """Note where we are, so that a hang shows it."""
    print(f"{time.perf_counter() - started:6.1f} s  {text}", file=log_file, flush=True)


def step(name):
    """Begin a step; a failure names the last one."""
    report["steps"].append(name)
    log(name)


def window():
    """The only window."""
    return bpy.context.window_manager.windows[0]


def area_of(kind):
    """The first area of a kind."""
    return next(area for area in window().screen.areas if area.type == kind)


def region_of(area, kind="WINDOW"):
    """The first region of a kind."""
    return next(region for region in area.regions if region.type == kind)


def within(area, kind="WINDOW"):
    """Context of an area, as if the mouse were in it."""
    return bpy.context.temp_override(window=window(), area=area, region=region_of(area, kind))


def middle_of(area, kind="WINDOW"):
    """Where to point to be in the middle of a region."""
    region = region_of(area, kind)
    return region.x + region.width // 2, region.y + region.height // 2


def picture(name):
    """What is on the screen; Blender's own screenshot where ImageMagick is missing."""
    file = str(FOLDER / f"{name}.png")
    if shutil.which("import"):
        subprocess.run(["import", "-window", "root", file], check=False, timeout=20)
    else:
        with bpy.context.temp_override(window=window()):
            bpy.ops.screen.screenshot(filepath=file)


def move(x, y):
    """The mouse, without a button."""
    window().event_simulate("MOUSEMOVE", "NOTHING", x=int(x), y=int(y))


def click(x, y):
    """Move there, press and release the left button."""
    move(x, y)
    yield LOOK
    window().event_simulate("LEFTMOUSE", "PRESS", x=int(x), y=int(y))
    yield LOOK
    window().event_simulate("LEFTMOUSE", "RELEASE", x=int(x), y=int(y))
    report["clicks"] += 1
    yield 0.2


def drag(start, end, moves=12):
    """Press at the start, move in small steps, release at the end."""
    move(*start)
    yield 0.3
    window().event_simulate("LEFTMOUSE", "PRESS", x=int(start[0]), y=int(start[1]))
    for nudge in range(0, 20, 3):  # a drag begins over what was pressed
        yield 0.1
        move(start[0] - nudge, start[1])
    for number in range(1, moves + 1):
        yield 0.1
        part = number / moves
        move(*(a + part * (b - a) for a, b in zip(start, end, strict=True)))
    yield 0.5
    window().event_simulate("LEFTMOUSE", "RELEASE", x=int(end[0]), y=int(end[1]))
    yield 0.3


def key(name, at, **modifiers):
    """Press and release a key with the mouse at a place."""
    x, y = map(int, at)
    for value in ("PRESS", "RELEASE"):
        window().event_simulate(name, value, x=x, y=y, **modifiers)
    yield 0.2


def write(text, at):
    """Type letters, digits and the like."""
    x, y = map(int, at)
    for letter in text:
        name = KEYS.get(letter, letter.upper())
        window().event_simulate(name, "PRESS", unicode=letter, x=x, y=y)
        window().event_simulate(name, "RELEASE", x=x, y=y)
        yield 0.05


def until(holds, what, seconds=15.0):
    """Wait until something holds, and say what was awaited where it never does."""
    end = time.perf_counter() + seconds
    while not holds():
        if time.perf_counter() > end:
            raise AssertionError(f"Waited {seconds:.0f} s in vain: {what}")
        yield 0.1


def under_mouse(area, kind="WINDOW"):
    """What the button under the mouse runs or sets, as Blender tells it: an operator's call, or a property's path."""
    bpy.context.window_manager.clipboard = ""
    with within(area, kind):
        if found := bpy.context.property:
            return f"{type(found[0]).__name__} {found[1]}"
        try:
            bpy.ops.ui.copy_python_command_button()
        except RuntimeError:
            return ""
    return bpy.context.window_manager.clipboard


def find(area, wanted, kind="WINDOW", across=(0.8,), every=12):
    """Where the button is that runs or sets `wanted`: the mouse passes down (or along) the region until it is over it.

    Blender tells where areas and regions are, but not where buttons are; it does tell which is under the mouse.
    """
    region = region_of(area, kind)
    places = [(region.x + int(region.width * part), y)
              for part in across for y in range(region.y + region.height - 5, region.y + 3, -every)]
    if kind == "HEADER":
        places = [(x, region.y + region.height // 2) for x in range(region.x + region.width - 8, region.x, -12)]
    seen = set()
    for x, y in places:
        move(x, y)
        yield LOOK
        told = under_mouse(area, kind)
        seen.add(told.split("(")[0])
        if wanted in told:
            return x, y
    raise AssertionError(f"No button for {wanted} in {area.type}; there were {sorted(seen)}")


def undo(at):
    """Control and Z."""
    yield from key("Z", at, ctrl=True)


def redo(at):
    """Shift, Control and Z."""
    yield from key("Z", at, ctrl=True, shift=True)


def record():
    """What was baked into the cube's material."""
    material = bpy.data.objects["Cube"].active_material
    return json.loads(material.get("facet_film", "{}")).get("baked", {}) if material else {}


def preset():
    """The preset on the cube, or None."""
    return record().get("name")


def group():
    """Name of the group on the cube."""
    nodes = bpy.data.objects["Cube"].active_material.node_tree.nodes
    return next((node.node_tree.name for node in nodes if node.bl_idname == "ShaderNodeGroup"), "")


def play(session, samples=4):
    """Drive a session, write the report, quit. The viewport renders `samples`: it no longer takes a number
    set later.
    """
    faulthandler.dump_traceback_later(HANGS_AFTER, file=log_file)
    bpy.context.preferences.view.show_splash = False
    bpy.context.scene.render.engine = "CYCLES"  # EEVEE's shaders take a minute to compile without a graphics card
    bpy.context.scene.cycles.preview_samples = samples
    bpy.context.scene.cycles.use_preview_adaptive_sampling = False
    bpy.context.preferences.edit.use_enter_edit_mode = False
    running = session()

    def tick():
        try:
            return next(running)
        except StopIteration:
            pass
        except Exception:
            report["failure"] = traceback.format_exc()
            log(report["failure"])
            picture("failure")
        (FOLDER / "report.json").write_text(json.dumps(report, indent=1), encoding="utf-8")
        bpy.ops.wm.quit_blender()
        return None

    bpy.app.timers.register(tick, first_interval=1.0)


def installed():
    """Install the zip without asking, for sessions that are about something else."""
    bpy.ops.extensions.package_install_files(filepath=ZIP, repo="user_default", enable_on_install=True)
    assert MODULE in bpy.context.preferences.addons
