"""Brings colours into [0, 1], and says what that changed."""

from typing import NamedTuple

import numpy as np

from ..errors import choice
from .colour import rgb_to_xyz

__all__ = ["METHODS", "GamutReport", "map_colours"]

TOLERANCE = 2e-4
"""How far outside [0, 1] is no more than the rounding of a white to four digits."""


class GamutReport(NamedTuple):
    """What was outside, and what was done.

    outside         whether any colour was outside [0, 1] by more than 0.0002
    method          "desaturate", "scale", "clip" or "leave"
    largest_change  largest change of any channel of any colour
    """

    outside: bool
    method: str
    largest_change: float


def map_colours(rgb, method="desaturate", space="Rec.709"):
    """(colours in [0, 1] of rgb's shape, GamutReport) for colours of one material, ``(…, 3)``.

    "desaturate"  towards the neutral of the same luminance, so at constant
                  dominant wavelength, until inside (Cook and Torrance 1982)
    "scale"       all alike, so that the largest channel is 1; then what is
                  below 0 is desaturated, as no scale can bring it in
    "clip"        per channel
    "leave"       as they are

    Raises FacetFilmError for another method.

    >>> map_colours(np.array([1.2, 0.5, 0.5]), "scale")[0].round(3).tolist()
    [1.0, 0.417, 0.417]
    """
    mapped = METHODS[choice("gamut", method, METHODS)](rgb, rgb_to_xyz(space)[1])
    outside = bool(rgb.min() < -TOLERANCE or rgb.max() > 1.0 + TOLERANCE)
    return mapped, GamutReport(outside, method, float(np.abs(mapped - rgb).max()))


def desaturate(rgb, luminance_weights):
    """Each colour towards its neutral, as far as it has to go."""
    neutral = np.clip(rgb @ luminance_weights, 0.0, 1.0)[..., None]
    away = rgb - neutral
    room = np.where(away > 0.0, 1.0 - neutral, neutral)
    size = np.maximum(np.abs(away), 1e-30)
    keep = np.minimum(np.min(room / size, axis=-1, keepdims=True), 1.0)
    return np.clip(neutral + keep * away, 0.0, 1.0)


def scale(rgb, luminance_weights):
    """All colours by one factor; then what is below 0 towards its neutral."""
    return desaturate(rgb / max(rgb.max(), 1.0), luminance_weights)


METHODS = {
    "desaturate": desaturate,
    "scale": scale,
    "clip": lambda rgb, luminance_weights: np.clip(rgb, 0.0, 1.0),
    "leave": lambda rgb, luminance_weights: rgb,
}
