"""From a stack in words to a film's parameters and what is to be said of it, and what it looks like at a glance."""

import functools

import numpy as np

from ...bake.film_errors import realisation_errors
from ..model import Baked, Look
from .formulas import slope
from .parameters import Film
from .tables import table_of

__all__ = ["bake_for", "facts_of", "look"]

COUNT = 3
"""Thicknesses that the realisations' errors are worked out at."""
CLEAR = 1e-3
"""Extinction up to which what is below a stack is clear."""
OF_REALISATIONS = {"fast": "standard", "exact": "reference"}


def bake_for(resolved, viewing):
    """The Baked of a preset or a stack, for viewing options.

    Where the preset says nothing else the thickness is the middle of what
    varies, and a film with air on both sides is seen through.
    """
    preset = resolved.preset
    stated = dict(preset.parameters)
    table = table_of(stated["stack"], viewing)
    low, high = table.thickness_range_nm
    if "thickness_range" not in stated:
        stated.setdefault("thickness", 0.5 * (low + high))
    stated.setdefault("see_through", float(table.is_pane))
    return Baked(stated, facts_of(preset, Film(**stated), table))


def facts_of(preset, parameters, table):
    """All that was baked, ready for JSON."""
    m = float(slope(parameters.roughness))
    errors = {name: errors._asdict() for name, errors in _errors_of(table, max(m, 0.01)).items()}
    return {"name": preset.name, "title": preset.title, "kind": preset.kind,
            "note": " ".join(filter(None, (preset.note, preset.estimated))) or table.said(),
            **table.to_dict(), "slope": m, "realisations": errors}


@functools.lru_cache(maxsize=16)
def _errors_of(table, m):
    """The realisations' errors of a table, which is the same object for the same stack while it is kept."""
    return realisation_errors(table, m, COUNT)


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
    colour = table_of(p.stack, {}).at(cosine, least + (greatest - least) * share)
    diffuse = (1.0 - p.specular) * np.array(p.diffuse)
    return Look(p.specular * colour + diffuse, colour, p.specular, float(slope(p.roughness)), diffuse)
