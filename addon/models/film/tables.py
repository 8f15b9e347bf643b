"""The tables of a film's colours: baked once for a stack in words and a viewing, and made the image of groups."""

import dataclasses
import functools
import hashlib

import numpy as np

from ...bake.film_choice import film_track
from ...bake.film_curve import curve_table, is_curve
from ...bake.film_table import curve_over_angle, film_table, smallest_table
from ...bake.reflected import Viewing
from ...bake.stack_notation import parse
from ...catalogue.resolving import layers_in
from ..model import Picture
from . import known

__all__ = ["colour_of", "picture", "stack_of", "table_of", "track_of"]

VERSION = 2
"""Raised whenever what a table's image holds changes."""
OF_METALS, OF_DARK = 0.5, 1.0
"""CIEDE2000 that a table may be off by: on what absorbs, and where little is reflected."""
ABSORBING = 0.01
"""Extinction of what is below from which a film's colour is bright."""


_told = []
"""Who is told of the progress of a table that is being made, which is no part of what it is kept by."""


@functools.lru_cache(maxsize=32)
def stack_of(text, own=""):
    """The Stack of a text in the notation.  Raises FacetFilmError that begins with the place.

    own  the user's measurements that it names, as addon.catalogue.resolving.layers_in reads them
    """
    return parse(text, layers_in(own))


def table_of(text, viewing, of="reflected", own="", progress=None):
    """The FilmTable of a stack in words, or the CurveTable of a Fresnel curve.

    viewing   options of addon.bake.reflected.Viewing, {} for its defaults
    of        "reflected", of the smallest size that comes close enough; "transmitted", of the same size
    own       as :func:`stack_of` has it
    progress  function that is told the share that is done, where the table is not there yet
    """
    _told[:] = [progress] if progress else []
    try:
        return _table(text, Viewing(**viewing), of, own)
    finally:
        _told.clear()


@functools.lru_cache(maxsize=16)
def _table(text, light, of, own):
    if is_curve(text):
        return curve_table(text, light)
    stack = _in_medium(stack_of(text, own), light.medium, layers_in(own))
    if of == "transmitted":
        rows, columns = _table(text, light, "reflected", own).size
        return film_table(stack, light, rows=rows, columns=max(columns, 8), of=of)
    if text in known.tables() and light == Viewing() and not own:
        (rows, columns), steps, errors = known.tables()[text]
        return film_table(stack, light, rows=rows, columns=columns, steps=steps, errors=errors,
                          progress=next(iter(_told), None))
    bright = float(stack.below_constants.at(550.0)[1]) > ABSORBING
    return smallest_table(stack, light, OF_METALS if bright else OF_DARK, progress=next(iter(_told), None))


def track_of(text, viewing, own=""):
    """The FilmTrack of a stack in words of one film, as :func:`table_of` takes them; None for other stacks."""
    return _track(text, Viewing(**viewing), own)


@functools.lru_cache(maxsize=16)
def _track(text, light, own):
    if is_curve(text) or len(stack_of(text, own).films) != 1:
        return None
    table = _table(text, light, "reflected", own)
    if text in known.tracks() and light == Viewing() and not own:
        return known.tracks()[text]
    return film_track(table)


@functools.lru_cache(maxsize=64)
def colour_of(text, thickness_nm, own=""):
    """Linear Rec.709 of one thickness seen face on, ``(3,)``, without a table."""
    if is_curve(text):
        return curve_table(text).at(1.0)
    stack = stack_of(text, own)
    within = np.clip(thickness_nm, *stack.thickness_range_nm)
    return curve_over_angle(stack, Viewing(), float(within), np.ones(1))[0]


def _in_medium(stack, medium, find):
    """The stack in the medium of a viewing, where its own words leave it in air."""
    if stack.outside != "air" or medium == 1.0:
        return stack
    word = str(getattr(medium, "dataset", medium))
    outside = parse(f"{word} | {stack.below}", find).outside_constants
    return dataclasses.replace(stack, outside=word, outside_constants=outside)


def picture(parameters, viewing):
    """The Picture of a Film's table: √R; above it √A, the absorbed share, where it is seen through, else its track."""
    clear = parameters.see_through > 0.0
    words = parameters.stack, parameters.own_layers
    told = repr((VERSION, *filter(None, words), sorted(viewing.items()), clear))
    key = hashlib.sha256(told.encode()).hexdigest()[:16]
    return Picture(f"Film {key}", key, lambda: _made(*words, viewing, clear))


def _made(text, own, viewing, clear):
    table = table_of(text, viewing, own=own)
    pixels = table.pixels()
    if clear:
        absorbed = np.ones_like(pixels)
        absorbed[..., :3] = np.sqrt(_absorbed(text, own, viewing)) if table.absorbs else 0.0
        pixels = np.concatenate([pixels, absorbed])
    elif track_of(text, viewing, own) is not None:
        pixels = np.concatenate([pixels, _track_rows(track_of(text, viewing, own), table)])
    rows, columns = table.size
    low, high = table.thickness_range_nm
    values = {"stack": text, **({"own_layers": own} if own else {})}
    return pixels, values, {"First Thickness": low, "Last Thickness": high, "Columns": float(columns),
                            "Rows": float(rows), "Image Rows": float(len(pixels))}


def _track_rows(track, table):
    """Three rows of the image: (index, thickness, slope from which it is closer), n and k, ``(3, columns, 4)``."""
    thicknesses = np.linspace(*table.thickness_range_nm, table.size[1])
    film = track.at(thicknesses)
    found = np.ones((3, len(thicknesses), 4), np.float32)
    found[0, :, :3] = np.stack([film.index, film.thickness_nm, track.from_slope_at(thicknesses)], axis=-1)
    found[1, :, :3], found[2, :, :3] = film.n, film.k
    return found


def _absorbed(text, own, viewing):
    """1 − R − T, ``(rows, columns, 3)``."""
    reflected, transmitted = (table_of(text, viewing, of, own) for of in ("reflected", "transmitted"))
    return np.clip(1.0 - reflected.rgb - transmitted.rgb, 0.0, 1.0)
