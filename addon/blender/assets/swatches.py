"""The strips of materials' colours that a panel shows: drawn once for an image, while the window is idle."""

import functools
from typing import NamedTuple

import bpy

__all__ = ["Shown", "clear", "draw", "swatch_icon"]

ACROSS = 64
_held, _asked = {}, []


class Shown(NamedTuple):
    """A strip: its icon's number; what it is over, from where to where, in which unit; whether angles go down it."""

    icon: int
    over: str
    first: float
    last: float
    unit: str
    has_angles: bool


def swatch_icon(material, key):
    """The Shown of a material whose colours are told by a key; None until it is drawn, and where there is none."""
    if key not in _held and not _asked and not bpy.app.background:
        _asked.append(key)
        bpy.app.timers.register(functools.partial(_draw_asked, material.name_full, key))
    return _held.get(key)


def draw(material, key):
    """Draw the strip of a material and keep it by the key."""
    from ...errors import FacetFilmError
    from ...models import named
    from ..datablocks.materials import record_of
    from .pictures import of_swatch
    from .thumbnails import drawn_icon
    try:
        record = record_of(material)
        swatch = named(record.model).swatch(record, ACROSS)
    except FacetFilmError:
        swatch = None
    if swatch is None:
        _held[key] = None
        return
    icon = drawn_icon(f"swatch {key}", lambda: of_swatch(swatch.rgb, record.viewing.get("space", "Rec.709")))
    _held[key] = Shown(icon, swatch.over, float(swatch.places[0]), float(swatch.places[-1]), swatch.unit,
                       len(swatch.rgb) > 1)


def clear():
    """Keep none."""
    _held.clear()
    _asked.clear()


def _draw_asked(name, key):
    from ..layers import redraw
    _asked.clear()
    material = next((one for one in bpy.data.materials if one.name_full == name), None)
    if material is not None:
        draw(material, key)
        redraw()
