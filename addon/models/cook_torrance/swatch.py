"""The colours of a surface over the angle at which it is seen."""

import numpy as np

from ...reflectance import fresnel
from ..model import Swatch

__all__ = ["swatch"]

GRAZING = 89.0
"""Degrees that the strip ends at: at 90 everything is white."""


def swatch(record, columns):
    """The Swatch s F(θ) + d Rd π of a Record, from 0° to GRAZING.

    >>> from ..making import made
    >>> found = swatch(made(preset="copper"), 3)
    >>> found.places.tolist(), found.rgb.shape, found.rgb[0, 0].round(2).tolist()
    ([0.0, 44.5, 89.0], (1, 3, 3), [0.93, 0.62, 0.52])
    """
    p = record.parameters
    degrees = np.linspace(0.0, GRAZING, columns)
    mirror = fresnel.conductor(np.cos(np.radians(degrees))[:, None], np.array(p.n), np.array(p.k))
    rgb = p.specular * mirror + (1.0 - p.specular) * np.array(p.diffuse)
    return Swatch("angle", "°", degrees, rgb[None])
