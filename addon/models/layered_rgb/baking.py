"""What a preset of the layered RGB model sets, and what its materials look like at a glance.  Nothing is measured."""

import numpy as np

from ..model import Baked, Feed, Look
from ..parameters import read, written
from .formulas import rho_d_eq16
from .parameters import THICKNESS_GROUP, LayeredRGB
from .spacing import bake_in

__all__ = ["bake_for", "feeds", "look", "read_feed"]

SPECULAR_SEEN = 0.6
"""Share of the specular weight that a small picture shows."""


def bake_for(resolved, space):
    """The Baked of a preset: its own parameters, as they are in a scene-linear space, and what is said about it."""
    preset = resolved.preset
    parameters, apart = bake_in(space, dict(preset.parameters), LayeredRGB())
    facts = {"name": preset.name, "title": preset.title, "kind": preset.kind, "note": preset.note}
    return Baked(parameters, facts if space == "Rec.709" else {**facts, "delta_e_2000_of_space": apart})


def look(parameters, place=None):
    """The Look of a LayeredRGB: the diffuse albedo at the middle thickness, or on a ball from end to end of the range.

    place  None, or x, y, z on the ball, ``(...)`` each
    """
    p = parameters
    least, greatest = p.thickness_range or (p.thickness, p.thickness)
    if place is None:
        d = 0.5 * (least + greatest)
    else:
        x, y, z = place
        d = least + (greatest - least) * (0.5 + 0.5 * np.sin(4.0 * x + 2.0 * np.sin(3.0 * y) + 2.0 * z))
    tint = np.clip(rho_d_eq16(np.array(p.ior), d, np.array(p.wavelengths)), 0.0, 1.0)
    return Look(tint, tint, SPECULAR_SEEN * p.specular, (2.0 / (p.exponent_r + 2.0)) ** 0.5, tint * p.diffuse)


def feeds(parameters):
    """The thickness field before the node, where the thickness varies."""
    if parameters.thickness_range is None:
        return ()
    links = {"Thickness": "Thickness"}
    if parameters.correlated:
        links["Lower Normal"] = "Lower Normal"
    values = {**written(parameters, THICKNESS_GROUP), "Deviation": parameters.deviation}
    return (Feed(THICKNESS_GROUP, values, links),)


def read_feed(table, fed):
    """{parameter's name: value} that the thickness field holds; a constant thickness where there is none."""
    if THICKNESS_GROUP not in fed:
        return {}
    values, linked = fed[THICKNESS_GROUP]
    return {**read(table, values, THICKNESS_GROUP), "thickness": None, "correlated": "Lower Normal" in linked}
