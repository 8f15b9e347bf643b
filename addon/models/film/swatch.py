"""The colours of a film over its thickness and the angle at which it is seen."""

import numpy as np

from ..model import Swatch
from .tables import table_of

__all__ = ["swatch"]

ANGLES = tuple(np.linspace(0.0, 85.0, 24))
GRAZING = 89.0


def swatch(record, columns):
    """The Swatch of a Record: over thickness, a row for each of ANGLES; over the angle where the thickness is fixed.

    >>> from ..making import made
    >>> found = swatch(made(preset="anodised_titanium"), 5)
    >>> found.over, found.places.tolist(), found.rgb.shape
    ('thickness', [0.0, 50.0, 100.0, 150.0, 200.0], (24, 5, 3))
    """
    p = record.parameters
    table = table_of(p.stack, record.viewing, own=p.own_layers)
    low, high = table.thickness_range_nm
    if low == high:
        degrees = np.linspace(0.0, GRAZING, columns)
        return Swatch("angle", "°", degrees, table.at(np.cos(np.radians(degrees)), low)[None])
    thickness = np.linspace(low, high, columns)
    return Swatch("thickness", "nm", thickness, table.at(np.cos(np.radians(ANGLES))[:, None], thickness))
