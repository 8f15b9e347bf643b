"""Times one thing in a Blender that has just started, and prints milliseconds as JSON: {"first": …, "later": …}.

    BLENDER_USER_RESOURCES=PROFILE python session_of_interface.py enable | draw | preset | search

Started by bench_interface.py, with the extension installed in the profile.
"""

import gc
import json
import statistics
import sys
import time
from importlib import import_module
from pathlib import Path
from types import SimpleNamespace

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import addon_utils  # noqa: E402  (a module of Blender's)
from drawn import Layout, drawn, properties_editor  # noqa: E402  (no tests package here: the extension is the installed one)

MODULE = "bl_ext.user_default.facet_film"
PRESETS = ("copper", "gold", "silver", "diamond", "vinyl", "main/Cu/Babar", "silver", "crown_glass")
TYPED = ("gold babar", "titanium oxide", "stainless steel", "tungstn", "schott n-bk7")


def timed(work):
    """Milliseconds that one waits for a call: of the processor, or passed where that is less, as with
    several threads.  Python tidies up before, not within it: when it would is chance, and takes as long as a draw.
    """
    clocks = (time.process_time, time.perf_counter)
    gc.collect()
    gc.disable()
    starts = [clock() for clock in clocks]
    work()
    took = min(clock() - start for clock, start in zip(clocks, starts)) * 1e3
    gc.enable()
    return took


def enable():
    """Enabling, which can only be the first time."""
    took = timed(lambda: addon_utils.enable(MODULE))
    return {"first": took, "later": took}


def panels_drawn():
    """A function that draws every panel of the Properties editor, opened, and says how many are shown."""
    registration = import_module(f"{MODULE}.addon.blender.registration")
    panels = [cls for cls in registration.CLASSES
              if issubclass(cls, bpy.types.Panel) and getattr(cls, "bl_context", "") == "material"]

    card = import_module(f"{MODULE}.addon.blender.panels.card")

    def all_panels():
        card.draw_first(SimpleNamespace(layout=Layout()), properties_editor())
        return sum(drawn(panel, properties_editor()) is not None for panel in panels)
    return all_panels


def draw():
    """Drawing, with the card above the slots: first without a material of ours, later on one."""
    all_panels = panels_drawn()
    first = timed(all_panels)
    bpy.ops.facet_film.bake_preset(preset="copper")
    assert all_panels() >= 6
    return {"first": first, "later": statistics.median(timed(all_panels) for _ in range(50))}


def preset():
    """Presets put on the cube as by clicks on their pictures, one after the other; of the later ones the slowest."""
    panels_drawn()()  # there is nothing to click before
    # As a window does then, idle before the first click.
    import_module(f"{MODULE}.addon.blender.panels.load_ahead").load()
    first, *later = (timed(lambda: bpy.ops.facet_film.apply(preset=name)) for name in PRESETS)
    return {"first": first, "later": max(later)}


def search():
    """Letters typed into the panel's field, of the later ones the slowest; a list for each letter, as Blender asks."""
    panels_drawn()()
    settings = import_module(f"{MODULE}.addon.blender.settings")
    texts = [text[:end] for text in TYPED for end in range(1, len(text) + 1)]
    first, *later = (timed(lambda: settings.search_presets(None, None, text)) for text in texts)
    return {"first": first, "later": max(later)}


def main(what):
    """Enable, then what is asked."""
    if what != "enable":
        addon_utils.enable(MODULE)
    print("took", json.dumps({"enable": enable, "draw": draw, "preset": preset, "search": search}[what]()))


if __name__ == "__main__":
    main(sys.argv[1])
