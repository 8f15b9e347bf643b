"""From a stack in words to a film's parameters and what is to be said of it, and what it looks like at a glance."""

import functools

import numpy as np

from ...bake.film_errors import realisation_errors
from ...bake.reflected import Viewing
from ..model import Baked, Look
from . import known
from .formulas import slope
from .parameters import Film
from .tables import colour_of, table_of, track_of

__all__ = ["COUNT", "LEAST_SLOPE", "bake_for", "facts_of", "look", "no_longer"]

COUNT = 3
"""Thicknesses that the realisations' errors are worked out at."""
NATIVE = "exact"
"""The formula of renderers whose Metallic BSDF has a thin film of its own."""
LEAST_SLOPE = 0.01
"""That errors are worked out at; below it films are mirrors."""


def bake_for(resolved, viewing, renderer):
    """The Baked of a preset or a stack, for viewing options and a Renderer.

    Where the preset says nothing else the thickness is the middle of what
    varies, and a film with air on both sides is seen through.
    """
    preset = resolved.preset
    stated = dict(preset.parameters)
    stated.setdefault("own_layers", "")
    table = table_of(stated["stack"], viewing, own=stated["own_layers"])
    low, high = table.thickness_range_nm
    if "thickness_range" not in stated:
        stated.setdefault("thickness", 0.5 * (low + high))
    stated.setdefault("see_through", float(table.is_pane))
    parameters = Film(**stated)
    native = renderer.formula == NATIVE and parameters.see_through == 0.0
    track = track_of(parameters.stack, viewing, own=parameters.own_layers) if native else None
    return Baked(stated, facts_of(preset, parameters, table, track))


def facts_of(preset, parameters, table, track=None):
    """All that was baked, ready for JSON.

    track  a FilmTrack where the renderer has a native film that follows it
    """
    m = float(slope(parameters.roughness))
    errors = {name: errors._asdict() for name, errors in _errors_of(table, max(m, LEAST_SLOPE), track).items()}
    return {"name": preset.name, "title": preset.title, "kind": preset.kind,
            "note": " ".join(filter(None, (preset.note, preset.estimated))) or table.said(),
            **table.to_dict(), "slope": m, "realisations": errors}


@functools.lru_cache(maxsize=16)
def _errors_of(table, m, track):
    """The realisations' errors of a table and a track, which are the same objects for the same stack while kept."""
    of_presets = known.errors().get((table.text, round(m, 6))) if table.viewing == Viewing() else None
    if of_presets is None:
        return realisation_errors(table, m, COUNT, track)
    return of_presets if track is not None or "lobes" not in of_presets else \
        {"standard": of_presets["lobes"], "reference": of_presets["reference"]}


def no_longer(parameters, baked):
    """{name: value} of thicknesses that the stack of a Baked does not have: those that it is made with, in their place.

    >>> from .parameters import Film as Held
    >>> no_longer(Held(thickness=60.0), Baked({"thickness": 350.0}, {"table": {"thickness_range_nm": (300.0, 400.0)}}))
    {'thickness': 350.0}
    """
    low, high = baked.facts["table"].get("thickness_range_nm", (0.0, 0.0))
    ends = parameters.thickness_range or (parameters.thickness, parameters.thickness)
    if low <= ends[0] and ends[1] <= high:
        return {}
    return {"thickness": baked.parameters.get("thickness", 0.5 * (low + high))}


def look(parameters, place=None):
    """The Look of a Film: its colour face on, or on a ball from end to end of the range.

    place  None, or x, y, z on the ball, ``(...)`` each
    """
    p = parameters
    least, greatest = p.thickness_range or (p.thickness, p.thickness)
    share, cosine = 0.5, 1.0
    if place is not None:
        x, y, z = place
        noise = 0.5 + 0.5 * np.sin(4.0 * x + 2.0 * np.sin(3.0 * y) + 2.0 * z)
        share, cosine = noise + p.gradient * (0.5 - 0.5 * y - noise), np.clip(z, 0.0, 1.0)
    thickness = least + (greatest - least) * share
    colour = colour_of(p.stack, thickness, p.own_layers) if place is None else \
        table_of(p.stack, {}, own=p.own_layers).at(cosine, thickness)
    colour, diffuse = colour * np.array(p.tint), (1.0 - p.specular) * np.array(p.tint) * np.array(p.diffuse)
    return Look(p.specular * colour + diffuse, colour, p.specular, float(slope(p.roughness)), diffuse)
