"""Fit Measured BRDF: from the file browser, stopped by Esc, and to its end, with the preset that it saves."""

import importlib
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))

import hands  # noqa: E402
from hands import area_of, key, middle_of, picture, record, step, until, within  # noqa: E402

COUNT = 4000


def session():
    """Everything, in order."""
    hands.installed()
    file = hands.FOLDER / "paint.txt"
    file.write_text(points(), encoding="utf-8")
    properties, view = area_of("PROPERTIES"), area_of("VIEW_3D")
    properties.spaces.active.context = "MATERIAL"
    bpy.ops.ed.undo_push(message="Start")
    yield 0.7

    step("a fit tells how far it is, and Esc stops it")
    fit(view, chosen=True, filepath=str(file))
    yield from until(lambda: fitting() is not None, "the operator runs")
    yield 0.3
    picture("fitting")
    yield from key("ESC", middle_of(view))
    yield from until(lambda: fitting() is None, "it has stopped")
    assert not (bpy.context.object.active_material or {}).get("facet_film"), "nothing was made"

    step("the file browser asks for the file, and the fit becomes the cube's material")
    fit(view)
    yield from until(lambda: browser() is not None, "a file browser is open")
    yield 0.7
    with bpy.context.temp_override(window=browser()[0], area=browser()[1]):
        browser()[1].spaces.active.params.directory = str(file.parent).encode()
        browser()[1].spaces.active.params.filename = file.name
        bpy.ops.file.execute("INVOKE_DEFAULT")
    yield from until(lambda: record().get("fitted", {}).get("file") == "paint.txt", "the cube is the paint", 60.0)
    saved = list((hands.FOLDER / "profile").rglob("presets/facet_film/*.py"))
    assert len(saved) == 1, saved
    yield 0.5
    picture("fitted")

    step("undo takes the material away, redo brings it back")
    yield from hands.undo(middle_of(view))
    yield from until(lambda: not record().get("fitted"), "no paint after undo")
    yield from hands.redo(middle_of(view))
    yield from until(lambda: record().get("fitted"), "the paint again after redo")


def fit(area, **given):
    """Press the button."""
    with within(area):
        bpy.ops.facet_film.fit_brdf("INVOKE_DEFAULT", **given)


def fitting():
    """The running operator, or None."""
    return next((one for one in hands.window().modal_operators if "fit_brdf" in one.bl_idname.lower()), None)


def browser():
    """(window, area) of an open file browser, or None."""
    return next(((window, area) for window in bpy.context.window_manager.windows for area in window.screen.areas
                 if area.type == "FILE_BROWSER"), None)


def points():
    """A text of points of a paint."""
    model = importlib.import_module(hands.MODULE + ".addon.models").named("cook_torrance")
    paint = model.parameters(n=(1.5,) * 3, k=(0.0,) * 3, specular=0.5, diffuse=(0.7, 0.2, 0.1), slopes=((0.2, 1.0),))
    rng = np.random.default_rng(1)
    theta, phi = rng.uniform(0.0, np.radians(75.0), (2, COUNT)), rng.uniform(-np.pi, np.pi, (2, COUNT))
    theta[1, ::2], phi[1, ::2] = theta[0, ::2], phi[0, ::2] + np.pi + rng.normal(0.0, 0.2, COUNT // 2)
    l, v = (np.stack([np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t)], axis=-1) for t, p in zip(theta, phi))
    f = model.evaluate(paint, np.array([0.0, 0.0, 1.0]), v, l)
    rows = np.column_stack([theta[0], phi[0], theta[1], phi[1], f])
    lines = ["theta_i_rad phi_i_rad theta_o_rad phi_o_rad R G B"]
    return "\n".join(lines + [" ".join(f"{x:.9g}" for x in row) for row in rows]) + "\n"


hands.play(session)
