"""Brings colours into [0, 1], and says what that changed."""

from typing import NamedTuple

import numpy as np

from ..errors import choice
from .colour import lab, rgb_to_xyz
from .fit import colour_metric

__all__ = ["DEFAULT", "METHODS", "GamutReport", "map_colours"]

DEFAULT = "nearest"
TOLERANCE = 2e-4
"""How far outside [0, 1] is no more than the rounding of a white to four digits."""
ROUNDS, SWEEPS = 3, 60
"""Of taking the metric anew, and of going through the channels: at most."""
SETTLED = 1e-9
"""What no channel moves by any more."""


class GamutReport(NamedTuple):
    """What was outside, and what was done.

    outside         whether any colour was outside [0, 1] by more than 0.0002
    method          "nearest", "desaturate", "scale", "clip" or "leave"
    largest_change  largest change of any channel of any colour
    """

    outside: bool
    method: str
    largest_change: float


def map_colours(rgb, method=DEFAULT, space="Rec.709"):
    """(colours in [0, 1] of rgb's shape, GamutReport) for colours of one material, ``(…, 3)``.

    "nearest"     the colour inside that looks most alike, by CIEDE2000
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
    mapped = METHODS[choice("gamut", method, METHODS)](rgb, space)
    outside = bool(rgb.min() < -TOLERANCE or rgb.max() > 1.0 + TOLERANCE)
    return mapped, GamutReport(outside, method, float(np.abs(mapped - rgb).max()))


def nearest(rgb, space):
    """Each colour as the one inside with the least CIEDE2000 from it; what is inside stays.

    Near a colour CIEDE2000² is a quadratic form in changes of RGB.  Its least value within the box is found a channel
    at a time, with the form taken half-way to what was found before.

    >>> nearest(np.array([1.059, 0.773, 0.307]), "Rec.709").round(3).tolist()
    [1.0, 0.742, 0.295]
    """
    colours = np.array(rgb, float).reshape(-1, 3)
    found = np.clip(colours, 0.0, 1.0)
    outside = np.abs(colours - found).max(axis=-1) > TOLERANCE
    target = colours[outside]
    for _ in range(ROUNDS if outside.any() else 0):
        place = 0.5 * (target + found[outside])
        found[outside] = _least_in_the_box(target, colour_metric(place, lab(place, space), space))
    return found.reshape(np.shape(rgb))


def _least_in_the_box(target, metric):
    """The x in [0, 1]³ with the least (x − target)·metric·(x − target), ``(A, 3)`` of ``(A, 3)`` and ``(A, 3, 3)``."""
    x = np.clip(target, 0.0, 1.0)
    for _ in range(SWEEPS):
        before = x.copy()
        for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
            others = metric[:, i, j] * (x[:, j] - target[:, j]) + metric[:, i, k] * (x[:, k] - target[:, k])
            x[:, i] = (target[:, i] - others / metric[:, i, i]).clip(0.0, 1.0)
        if np.abs(x - before).max() < SETTLED:
            break
    return x


def desaturate(rgb, space):
    """Each colour towards its neutral, as far as it has to go."""
    neutral = np.clip(rgb @ rgb_to_xyz(space)[1], 0.0, 1.0)[..., None]
    away = rgb - neutral
    room = np.where(away > 0.0, 1.0 - neutral, neutral)
    size = np.maximum(np.abs(away), 1e-30)
    keep = np.minimum(np.min(room / size, axis=-1, keepdims=True), 1.0)
    return np.clip(neutral + keep * away, 0.0, 1.0)


def scale(rgb, space):
    """All colours by one factor; then what is below 0 towards its neutral."""
    return desaturate(rgb / max(rgb.max(), 1.0), space)


METHODS = {
    "nearest": nearest,
    "desaturate": desaturate,
    "scale": scale,
    "clip": lambda rgb, space: np.clip(rgb, 0.0, 1.0),
    "leave": lambda rgb, space: rgb,
}
