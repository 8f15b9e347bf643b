"""A film for other programs: what its node holds now, in the light that it was baked in."""

import numpy as np

from ...export import json_text
from .tables import table_of

__all__ = ["principled", "write_form"]

ANGLES = 91


def write_form(form, record):
    """The text of a form: "json", or "csv" of the exact curve over angle at the material's thickness."""
    if form == "json":
        return json_text(record.to_dict())
    cosines, rgb = _curve(record)
    rows = [f"{c:.6f}," + ",".join(f"{x:.6f}" for x in colour) for c, colour in zip(cosines, rgb)]
    return "\n".join(["cos_theta,r,g,b", *rows]) + "\n"


def principled(record):
    """The settings of a Principled BSDF with the film's colour face on and at 82°, or None for what is seen through."""
    p = record.parameters
    if p.see_through > 0.0:
        return None
    table = table_of(p.stack, record.viewing)
    face_on, grazing = (table.at(c, _thickness(p)) for c in (1.0, 1.0 / 7.0))
    schlick = face_on + (1.0 - face_on) * (6.0 / 7.0) ** 5
    tint = np.clip(grazing / np.maximum(schlick, 1e-6), 0.0, 1.0)
    return {"Metallic": 1.0, "Base Color": (*map(float, face_on), 1.0), "Specular Tint": (*map(float, tint), 1.0),
            "Roughness": p.roughness}


def _curve(record):
    cosines = np.cos(np.radians(np.linspace(90.0, 0.0, ANGLES)))
    return cosines, table_of(record.parameters.stack, record.viewing).at(cosines, _thickness(record.parameters))


def _thickness(parameters):
    """The middle of what varies."""
    return parameters.thickness if parameters.thickness_range is None else sum(parameters.thickness_range) / 2.0
