"""At Blender's start what is registered is loaded, and no more; what a window loads while it is idle changes nothing,
and nothing is loaded where there is no window.
"""

import ast
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import bpy

from addon.blender.datablocks import groups
from addon.blender.panels import load_ahead
from addon.models.making import made

ROOT = Path(__file__).parents[2]
ENABLE = """
import os, sys
import bpy
before = set(sys.modules)
import addon
addon.register()
print("loaded", *sorted(set(sys.modules) - before), flush=True)
os._exit(0)
"""
LISTS = {"addon", "addon.errors", "addon.finishes", "addon.finishes.finish", "addon.models",
         "addon.models.realisations"}
"""What enumerations are made of."""


def loaded_by_enabling():
    done = subprocess.run([sys.executable, "-c", ENABLE], cwd=ROOT, capture_output=True, text=True, check=True)
    return done.stdout.split("loaded ")[1].split()


def imported_at_the_top(source):
    found = set()
    for node in ast.parse(source).body:
        found |= {alias.name.split(".")[0] for alias in node.names} if isinstance(node, ast.Import) else set()
        found |= {node.module.split(".")[0]} if isinstance(node, ast.ImportFrom) and not node.level else set()
    return found


def test_what_stands_at_the_top_is_seen():
    source = "import numpy.linalg\nfrom json import loads\nfrom . import zipfile\ndef f():\n    import hashlib"
    assert imported_at_the_top(source) == {"numpy", "json"}


def test_enabling_loads_what_is_registered_and_no_more():
    """The formulas, the file's datablocks and numpy wait for a redraw or a click: enabling is a part of each start."""
    loaded = loaded_by_enabling()
    rooms = {name for name in loaded if name.startswith("addon.blender")}
    assert set(loaded) - rooms == LISTS
    assert not [name for name in rooms if name.startswith(("addon.blender.datablocks.", "addon.blender.exporters."))]
    files = [ROOT / name.replace(".", "/") for name in loaded]
    sources = {file: (file / "__init__.py" if file.is_dir() else file.with_suffix(".py")) for file in files}
    slow = {"numpy", "json", "zipfile", "dataclasses", "re", "hashlib", "subprocess"}
    assert not [name for name in sources.values() if slow & imported_at_the_top(name.read_text(encoding="utf-8"))]


def datablocks():
    return {name: len(getattr(bpy.data, name)) for name in ("materials", "node_groups", "images", "libraries", "texts")}


def test_it_bakes_a_preset_and_reads_its_group_and_leaves_the_file_alone(monkeypatch):
    baked, read, appended = [], [], groups._appended
    monkeypatch.setattr("addon.models.making.made", lambda preset: baked.append(preset) or made(preset=preset))
    monkeypatch.setattr(groups, "_appended", lambda data, *what: read.append(appended(data, *what).name))
    before = datablocks()
    load_ahead.load()
    assert baked == ["copper"] and read == ["Cook-Torrance Standard"]
    assert datablocks() == before


def test_nothing_waits_for_a_window_that_never_opens():
    load_ahead.when_idle()
    assert not bpy.app.timers.is_registered(load_ahead.load)
    load_ahead.forget()


def test_disabling_before_the_window_was_idle_takes_it_back():
    bpy.app.timers.register(load_ahead.load, persistent=True)
    load_ahead.forget()
    assert not bpy.app.timers.is_registered(load_ahead.load)


def test_the_button_that_needs_it_asks_once(monkeypatch):
    """In a window; here the timers are looked at in its stead."""
    waiting = []
    timers = SimpleNamespace(register=lambda function, persistent: waiting.append(function),
                             is_registered=waiting.__contains__, unregister=waiting.remove)
    app = SimpleNamespace(background=False, timers=timers)
    monkeypatch.setattr(load_ahead, "bpy", SimpleNamespace(app=app))
    load_ahead.when_idle()
    load_ahead.when_idle()
    assert waiting == [load_ahead.load]
    load_ahead.forget()
    assert waiting == []
