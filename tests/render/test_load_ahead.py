"""What a window loads while it is idle changes nothing, and nothing is loaded where there is no window."""

from types import SimpleNamespace

import bpy

from addon.blender.datablocks import groups
from addon.blender.panels import load_ahead
from addon.models.making import made


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
