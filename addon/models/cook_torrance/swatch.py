"""The colours of a surface over the angle at which it is seen."""

import numpy as np

from ...reflectance import fresnel
from ..model import Swatch
from .formulas import dyed

__all__ = ["swatch"]

GRAZING = 89.0
"""Degrees that the strip ends at: at 90 everything is white."""


def swatch(record, columns):
    """The Swatch s F(θ) + d Rd π of a Record, from 0° to GRAZING.

    >>> from ..making import made
    >>> found = swatch(made(preset="copper"), 3)
    >>> found.places.tolist(), found.rgb.shape, found.rgb[0, 0].round(2).tolist()
    ([0.0, 44.5, 89.0], (1, 3, 3), [0.93, 0.62, 0.52])
    >>> swatch(made(preset="copper", tint=(0.5, 0.5, 0.5)), 3).rgb[0, 0].round(2).tolist()
    [0.46, 0.31, 0.26]
    """
    p = record.parameters
    degrees = np.linspace(0.0, GRAZING, columns)
    n, k, normal_reflectance = dyed(p)
    mirror = fresnel.conductor(np.cos(np.radians(degrees))[:, None], n, k)
    rgb = p.specular * mirror + (1.0 - p.specular) * normal_reflectance
    return Swatch("angle", "°", degrees, rgb[None])
