"""From which slope on Blender's native film is closer to a film than the tilted lobes, thickness by thickness."""

import dataclasses

import numpy as np

from .colour import delta_e_2000, lab
from .film_errors import SUNS, tilted_means
from .film_track import FilmTrack, native_colours, native_knots

__all__ = ["NEVER", "film_track", "slopes_where_closer"]

SLOPES = (0.05, 0.1, 0.15, 0.2, 0.3, 0.45, 0.6, 0.8, 1.0)
"""At which both are compared."""
NEVER = 2.0
"""Above every slope."""


def film_track(table):
    """The FilmTrack of a FilmTable whose stack has one film.

    >>> from .film_table import smallest_table
    >>> from .stack_notation import parse
    >>> from ..spectra.optical_constants import load
    >>> track = film_track(smallest_table(parse("main/TiO2/Jolivet-anatase 120 nm / main/Ti/Palm", load)))
    >>> track.knots.shape, bool(0.05 < track.from_slope[0] < 0.15)
    ((1, 8), True)
    """
    thicknesses, knots = native_knots(table)
    track = FilmTrack(thicknesses, knots, np.full(len(knots), NEVER))
    return dataclasses.replace(track, from_slope=slopes_where_closer(table, track))


def slopes_where_closer(table, track):
    """The slope at each knot, ``(K,)``: the last at which the lobes are closer; NEVER where they are at all.

    Both by the mean over a sphere of the worse of two suns.  The native film's is the same at every slope, as under a
    sun all facets that are seen have one V·H.
    """
    cosines = np.cos(np.radians(np.array(SUNS) / 2.0))
    thicknesses, space = track.thicknesses_nm, table.viewing.space
    shown = native_colours(track.at(thicknesses), cosines, space)
    exact = table.at(cosines, thicknesses[:, None]).astype(float)
    native = delta_e_2000(lab(exact, space), lab(shown, space)).max(axis=-1)
    ahead = np.stack([tilted_means(table, m, thicknesses) for m in SLOPES], axis=-1) - native[:, None]
    return np.array([_last_crossing(row) for row in ahead])


def _last_crossing(ahead):
    """The slope from which on a row of differences at SLOPES stays above 0."""
    behind = np.flatnonzero(ahead <= 0.0)
    if not behind.size:
        return SLOPES[0]
    last = behind[-1]
    if last == len(SLOPES) - 1:
        return NEVER
    share = -ahead[last] / (ahead[last + 1] - ahead[last])
    return SLOPES[last] + share * (SLOPES[last + 1] - SLOPES[last])
