"""Builds addon/spectra/data/films.table: size, errors and track of the tables of film presets, in the usual light.

    python tools/build_film_facts.py [OUTPUT_FOLDER]

They take a second a preset, and a click takes them from there.  To be run whenever a film's preset changes
or what is calculated of it.
"""

import dataclasses
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from addon.bake.film_errors import realisation_errors  # noqa: E402
from addon.catalogue import presets  # noqa: E402
from addon.catalogue.resolving import resolve  # noqa: E402
from addon.models.film import known, tables  # noqa: E402
from addon.models.film.baking import COUNT, LEAST_SLOPE  # noqa: E402
from addon.models.film.formulas import slope  # noqa: E402
from addon.models.film.parameters import Film  # noqa: E402
from addon.spectra import tables as packed  # noqa: E402

__all__ = ["build", "found"]

DIGITS = 4


def found(fitted=None):
    """{"tables": [(stack, size, steps, errors)], "errors": [(stack, slope, {realisation: errors})],
    "tracks": [(stack, (first, last thickness), knots, slopes from which it is closer)]}.

    fitted  {stack: FilmTrack} that are there already; by default they are fitted
    """
    of_stacks, of_slopes, tracks = {}, {}, {} if fitted is None else dict(fitted)
    for name in presets.of_model("film"):
        parameters = Film(**resolve(name).preset.parameters)
        m = round(max(float(slope(parameters.roughness)), LEAST_SLOPE), 6)
        table = _table(parameters.stack)
        if (table.text, m) in of_slopes:
            continue
        if hasattr(table, "steps"):
            errors = table.delta_e_2000_max, table.delta_e_2000_mean
            of_stacks[table.text] = table.text, list(table.size), table.steps and list(table.steps), _short(errors)
        of_slopes[table.text, m] = table.text, m, {
            which: _short(values) for which, values in realisation_errors(table, m, COUNT, _track(parameters, tracks)
                                                                          ).items()}
    return {"tables": list(of_stacks.values()), "errors": list(of_slopes.values()), "tracks": [
        (stack, track.thicknesses_nm[[0, -1]].tolist(), [_short(knot) for knot in track.knots],
         _short(track.from_slope)) for stack, track in tracks.items()]}


def _track(parameters, tracks):
    """The FilmTrack of a material that is not seen through, as it is kept: rounded; of each stack once."""
    if parameters.see_through > 0.0:
        return None
    if parameters.stack not in tracks:
        held, known.tracks = known.tracks, dict
        try:
            track = tables.track_of(parameters.stack, {})
        finally:
            known.tracks = held
        if track is None:
            return None
        tracks[parameters.stack] = dataclasses.replace(track, knots=np.round(track.knots, DIGITS),
                                                       from_slope=np.round(track.from_slope, DIGITS))
    return tracks[parameters.stack]


def _table(stack):
    """As it is worked out where nothing is known."""
    held, known.tables = known.tables, dict
    try:
        return tables.table_of(stack, {})
    finally:
        known.tables = held


def _short(values):
    return [round(float(value), DIGITS) for value in values]


def build(folder):
    """Write the table; how many stacks and slopes it holds."""
    held = found()
    about = {"title": "Sizes, errors and tracks of the tables of films' presets",
             "source": "presets.json, refractiveindex.table", "version": packed.about("refractiveindex")["version"],
             "licence": "CC0-1.0", "tool": "tools/build_film_facts.py"}
    packed.pack(folder / f"{known.NAME}.table", about, {name: {"rows": rows} for name, rows in held.items()})
    return len(held["tables"]), len(held["errors"])


if __name__ == "__main__":
    print("{} stacks, {} slopes".format(*build(Path(*sys.argv[1:]) if sys.argv[1:] else packed.DIRECTORY)))
