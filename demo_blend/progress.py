"""Rendering with a progress line in place of Blender's own log."""

import os
import re
import sys
import time
from contextlib import contextmanager

import bpy

__all__ = ["render_with_progress", "blender_silent"]


def render_with_progress(scene, path, title, shown=True):
    """Render the scene to `path`, showing how far it is; returns the seconds it took.

    shown  whether the last line names the file
    """
    scene.render.filepath = str(path)
    begun = time.perf_counter()
    with blender_silent() as screen:
        def show(text, *_):
            found = re.search(r"Sample (\d+)/(\d+)", str(text))
            if found:
                done, total = map(int, found.groups())
                _line(screen, f"{title}: sample {done} of {total}, {time.perf_counter() - begun:.0f} s")
        bpy.app.handlers.render_stats.append(show)
        try:
            bpy.ops.render.render(write_still=True)
        finally:
            bpy.app.handlers.render_stats.remove(show)
        seconds = time.perf_counter() - begun
        _line(screen, f"{title}: {seconds:.0f} s" + (f", {path}" if shown else ""), end="\n")
    return seconds


def _line(screen, text, end=""):
    """Write over the current line; on a file or pipe only lines that are final."""
    if screen.isatty():
        screen.write(f"\r\x1b[K{text}{end}")
    elif end:
        screen.write(text + end)
    screen.flush()


@contextmanager
def blender_silent():
    """Blender writes its render log to the C library's stdout; send that to nowhere, and keep the screen."""
    sys.stdout.flush()
    saved = os.dup(1)
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    try:
        with os.fdopen(os.dup(saved), "w", encoding="utf-8", errors="replace") as screen:
            yield screen
    finally:
        os.dup2(saved, 1)
        os.close(saved)
        os.close(nowhere)
