"""Brings the colours of films into [0, 1] so that a gradient of thickness stays smooth, and says what that changed.

Films leave Rec.709 often and wide spaces hardly ever.  Desaturating each
colour by itself until it is inside makes kinks where a gradient meets the
border: the amount is a maximum over channels and 1.  Here it is a smooth one.
"""

from typing import NamedTuple

import numpy as np

from .colour import SPACES, delta_e_2000, lab, rgb_to_xyz
from .gamut import TOLERANCE, map_colours

__all__ = ["FilmGamutReport", "map_film_colours", "desaturate_smoothly", "P"]

P = 12
"""Exponent of the norm that stands for a maximum; higher is closer to one, and kinkier."""

FARTHEST = 1000.0
"""Distance that is held to, so that its twelfth power is a number in single precision."""

SMOOTHED = ("desaturate", "nearest")
"""Ways of a Viewing that are the smooth desaturation for films."""


class FilmGamutReport(NamedTuple):
    """What was outside, and what was done.

    outside                share of colours outside [0, 1] by more than 0.0002
    method                 "desaturate", smoothly; "scale", "clip" or "leave"
    delta_e_2000_mean      CIEDE2000 of the change, over all colours
    delta_e_2000_max       the largest
    largest_change         of any channel
    outside_elsewhere      ((space, share of the same colours that is outside of that one), …)
    """

    outside: float
    method: str
    delta_e_2000_mean: float
    delta_e_2000_max: float
    largest_change: float
    outside_elsewhere: tuple


def map_film_colours(rgb, viewing):
    """(colours in [0, 1] of rgb's shape, FilmGamutReport) for the colours of one film, ``(…, 3)``.

    viewing  whose gamut "desaturate" is :func:`desaturate_smoothly` here, and
             "nearest" too, as each colour's own nearest makes kinks over a gradient;
             whose others are as :func:`addon.bake.gamut.map_colours` has them;
             "leave" leaves what is above 1, but what is below 0 becomes 0

    >>> from .reflected import Viewing
    >>> mapped, report = map_film_colours(np.array([[0.5, 0.4, 0.3], [-0.023, 0.103, 0.37]]), Viewing())
    >>> mapped.round(3).tolist(), report.outside
    ([[0.5, 0.4, 0.3], [0.001, 0.102, 0.315]], 0.5)
    """
    smooth = viewing.gamut in SMOOTHED
    if smooth:
        mapped = desaturate_smoothly(rgb, rgb_to_xyz(viewing.space)[1])
    else:
        mapped = np.maximum(map_colours(rgb, viewing.gamut, viewing.space)[0], 0.0)
    seen, shown = (np.asarray(colours, float).reshape(-1, 3)[::every_nth(rgb)] for colours in (rgb, mapped))
    change = delta_e_2000(lab(seen, viewing.space), lab(shown, viewing.space))
    elsewhere = tuple((space, _outside(rgb @ _between(viewing.space, space).T))
                      for space in SPACES if space != viewing.space)
    method = "desaturate" if smooth else viewing.gamut
    return mapped, FilmGamutReport(_outside(rgb), method, float(change.mean()), float(change.max()),
                                   float(np.abs(mapped - rgb).max()), elsewhere)


def desaturate_smoothly(rgb, luminance_weights):
    """Each colour towards the neutral of its luminance, so at constant dominant wavelength, a little before it has to.

    With d the channels' distances from the neutral as shares of what is to the
    border, s = (1 + Σ d^p)^(−1/p), p = 12, keeps of the colour what a gradient
    bears: next to 1 where max d < 0.7, next to 1/max d outside, no kink.

    >>> desaturate_smoothly(np.array([0.5, 0.4, 0.3]), np.array([0.2126, 0.7152, 0.0722])).round(6).tolist()
    [0.5, 0.4, 0.3]
    """
    neutral = np.clip(rgb @ luminance_weights.astype(rgb.dtype), 1e-6, 1.0 - 1e-6)[..., None]
    away = rgb - neutral
    distance = np.minimum(np.maximum(-away / neutral, away / (1.0 - neutral)), FARTHEST)
    distance *= distance
    distance *= distance  # d⁴: repeated squares are what P = 12 takes
    keep = (1.0 + (distance * distance * distance).sum(axis=-1, keepdims=True)) ** (-1.0 / P)
    return np.clip(neutral + keep * away, 0.0, 1.0)


def every_nth(rgb):
    """Of how many colours one is compared: 4,096 tell enough."""
    return max(1, rgb.size // 3 // 4096)


def _outside(rgb):
    return float(np.mean(np.any((rgb < -TOLERANCE) | (rgb > 1.0 + TOLERANCE), axis=-1)))


def _between(space, other):
    return np.linalg.solve(rgb_to_xyz(other), rgb_to_xyz(space))
