"""A material's colours as a strip: a picture, a table, JSON."""

import numpy as np

from ..bake.colour import rgb_to_xyz
from ..bake.srgb import bytes_of, hex_of
from .png import png

__all__ = ["swatch_hex", "swatch_png"]

COLUMNS, HEIGHT = 512, 96


def swatch_png(swatch, space="Rec.709"):
    """The bytes of a PNG file of an addon.models.model.Swatch, its rows from the top, as sRGB, HEIGHT high.

    space  what its colours are linear in
    """
    rows = np.linspace(0, len(swatch.rgb) - 1e-9, HEIGHT).astype(int)
    return png(bytes_of(_rec709(swatch.rgb, space))[rows])


def swatch_hex(swatch, space="Rec.709"):
    """Its colours seen face on as #rrggbb in sRGB, a text a column."""
    return [hex_of(rgb) for rgb in _rec709(swatch.rgb[0], space)]


def _rec709(rgb, space):
    if space == "Rec.709":
        return rgb
    return rgb @ np.linalg.solve(rgb_to_xyz("Rec.709"), rgb_to_xyz(space)).T
