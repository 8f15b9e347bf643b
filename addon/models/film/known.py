"""What was found of the presets' stacks in the usual light, so that a click does not wait for it to be found again.

films.table is made by tools/build_film_facts.py; what is not in it is worked out.
"""

import functools

import numpy as np

from ...bake.film_errors import RealisationErrors
from ...bake.film_track import FilmTrack
from ...spectra import tables as packed

__all__ = ["NAME", "errors", "forget", "tables", "tracks"]

NAME = "films"


def _part(name):
    return packed.part(NAME, name)["rows"] if (packed.DIRECTORY / f"{NAME}.table").exists() else []


@functools.cache
def tables():
    """{stack in words: (size of its table, wavelength steps or None, (largest, mean) CIEDE2000 of it)}."""
    return {stack: (tuple(size), steps and tuple(steps), tuple(found)) for stack, size, steps, found in _part("tables")}


@functools.cache
def errors():
    """{(stack in words, slope): {realisation: its RealisationErrors}}."""
    return {(stack, m): {name: RealisationErrors(*values) for name, values in found.items()}
            for stack, m, found in _part("errors")}


@functools.cache
def tracks():
    """{stack in words: FilmTrack of it}."""
    return {stack: FilmTrack(np.linspace(*ends, len(knots)), np.array(knots), np.array(slopes))
            for stack, ends, knots, slopes in _part("tracks")}


def forget():
    """Read the table anew."""
    tables.cache_clear()
    errors.cache_clear()
    tracks.cache_clear()
