"""What a window loads while it is idle changes nothing, and nothing is loaded where there is no window."""

import sys

import bpy

from addon.blender import load_ahead


def datablocks():
    return {name: len(getattr(bpy.data, name)) for name in ("materials", "node_groups", "images", "libraries", "texts")}


def test_it_loads_the_baking_and_leaves_the_file_alone():
    before = datablocks()
    load_ahead.load()
    assert "addon.bake.baking" in sys.modules
    assert datablocks() == before


def test_nothing_waits_for_a_window_that_never_opens():
    load_ahead.attach()
    assert not bpy.app.timers.is_registered(load_ahead.load)
    load_ahead.detach()


def test_disabling_before_the_window_was_idle_takes_it_back():
    bpy.app.timers.register(load_ahead.load, persistent=True)
    load_ahead.detach()
    assert not bpy.app.timers.is_registered(load_ahead.load)
