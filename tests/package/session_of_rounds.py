"""Enables, uses and disables the extension over and over, and notes what stays behind.

    BLENDER_USER_RESOURCES=EMPTY_FOLDER python session_of_rounds.py ZIP REPORT ROUNDS

Started by test_rounds.py; REPORT is written as JSON.
"""

import json
import os
import resource
import sys
import traceback
from pathlib import Path

import bpy
from traces import datablocks, timers_of, traces

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from drawn import drawn, properties_editor  # noqa: E402  (no tests package here: the extension is the installed one)

MODULE = "bl_ext.user_default.facet_film"
ZIP, REPORT, ROUNDS = sys.argv[1:]


def modules(name):
    """A module of the installed extension."""
    return sys.modules[f"{MODULE}.addon.blender.{name}"]


def panels():
    """Its panels in the Material properties."""
    return [cls for cls in modules("registration").CLASSES
            if issubclass(cls, bpy.types.Panel) and getattr(cls, "bl_context", "") == "material"]


def use(round_number):
    """A bit of everything, and the user's own clearing away of it."""
    target = bpy.context.active_object
    realisation = ("fast", "exact")[round_number % 2]
    bpy.ops.facet_film.bake_preset(preset=("copper", "gold", "vinyl")[round_number % 3], realisation=realisation)
    bpy.ops.facet_film.switch_realisation(realisation="fast")
    bpy.ops.facet_film.check(against="copper", kind="material", material="gold")
    bpy.ops.facet_film.add_asset_library()
    settings = bpy.context.window_manager.facet_film
    settings.illuminant, settings.preset = "A", "gold"
    modules("settings").search_presets(None, None, "gold")
    assert sum(drawn(panel, properties_editor()) is not None for panel in panels()) >= 6
    bpy.ops.facet_film.rebake()
    bpy.ops.facet_film.rebake_all()
    bpy.ops.facet_film.save_user_preset(name="Mine")
    bpy.ops.facet_film.save_user_preset(name="Mine", remove_name=True)
    bpy.ops.facet_film.bake_preset(preset="nacre")
    material = target.active_material
    target.data.materials.clear()
    bpy.data.materials.remove(material)


def left_after(before):
    """What was not there before the first round."""
    bpy.ops.outliner.orphans_purge(do_local_ids=True, do_recursive=True)
    found, counts = traces(), datablocks()
    return {"traces": sorted(found ^ before["traces"]),
            "datablocks": {name: count for name, count in counts.items() if count != before["counts"][name]},
            "timers": timers_of(MODULE), "memory_mb": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024}


def go_through(report):
    """Every round, a look after the tenth and the last."""
    bpy.ops.extensions.package_install_files(filepath=ZIP, repo="user_default", enable_on_install=False)
    bpy.context.active_object.data.materials.clear()
    bpy.ops.outliner.orphans_purge(do_local_ids=True, do_recursive=True)
    before = {"traces": traces(), "counts": datablocks()}
    for number in range(int(ROUNDS)):
        bpy.ops.preferences.addon_enable(module=MODULE)
        use(number)
        bpy.ops.preferences.addon_disable(module=MODULE)
        if number + 1 in (10, int(ROUNDS)):
            report[str(number + 1)] = left_after(before)
    report["rounds"] = number + 1


def main():
    report = {"failure": ""}
    try:
        go_through(report)
    except Exception:
        report["failure"] = traceback.format_exc()
    Path(REPORT).write_text(json.dumps(report), encoding="utf-8")
    os._exit(0)


main()
