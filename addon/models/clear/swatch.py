"""The colours of a clear body over its depth."""

import numpy as np

from ..model import Swatch
from .formulas import sigma_of

__all__ = ["swatch"]

DARKEST = 0.02
"""Of its clearest channel, what is left where the strip ends."""
DEEPEST = 10.0
"""Metres that the strip ends at at the latest."""


def swatch(record, columns):
    """The Swatch of a Record: what is left of white light, on a scale of depth that ends where it is dark.

    >>> from ..making import made
    >>> found = swatch(made(preset="water"), 3)
    >>> found.over, found.unit, found.places.round(1).tolist()
    ('depth', 'm', [0.0, 5.0, 10.0])
    """
    p = record.parameters
    sigma = sigma_of(np.array(p.absorption), np.array(p.depth_colour), p.depth, p.concentration, 1.0)
    depth = np.linspace(0.0, min(-np.log(DARKEST) / max(float(sigma.min()), 1e-9), DEEPEST), columns)
    return Swatch("depth", "m", depth, (np.array(p.tint) * np.exp(-depth[:, None] * sigma))[None])
