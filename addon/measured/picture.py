"""A picture of a fit: the ball as measured at the left, as fitted at the right."""

import numpy as np

from ..bake.srgb import bytes_of
from ..export.png import png
from .ball import LAST, displayed

__all__ = ["picture", "picture_pixels", "seen_at"]

GAP = 8
FILLED = 0.98
"""Share of the width that the ball has."""


def picture(fit, size=256):
    """The bytes of a PNG file of a Fit, balls of `size` pixels."""
    return png(bytes_of(picture_pixels(fit, size)))


def picture_pixels(fit, size):
    """Displayed linear RGB, ``(size, 2 size + 8, 3)``, rows from the top."""
    measured, fitted = (_round(displayed(image, 1.0), size) for image in fit.images)
    return np.concatenate([measured, np.zeros((size, GAP, 3)), fitted], axis=1)


def seen_at(polar, x, y):
    """Colours of a ball's rings ``(rings, around, 3)`` at places ``(...)`` from −1 to 1, y up: ``(..., 3)``."""
    rings, around = polar.shape[:2]
    ring = np.clip(np.arcsin(np.minimum(np.hypot(x, y), 1.0)) / LAST * rings - 0.5, 0.0, rings - 1.0)
    turn = (np.arctan2(y, x) / (2.0 * np.pi) * around - 0.5) % around
    i, j = np.minimum(ring.astype(int), rings - 2), turn.astype(int) % around
    u, v = (ring - i)[..., None], (turn - np.floor(turn))[..., None]
    after = (j + 1) % around
    inner = polar[i, j] * (1.0 - v) + polar[i, after] * v
    outer = polar[i + 1, j] * (1.0 - v) + polar[i + 1, after] * v
    return inner * (1.0 - u) + outer * u


def _round(polar, size):
    """A ball's rings as a square picture, black around, ``(size, size, 3)``; its edge is half-way covered."""
    across = ((np.arange(size) + 0.5) / size * 2.0 - 1.0) / FILLED
    x, y = np.meshgrid(across, -across)
    covered = np.clip((1.0 - np.hypot(x, y)) * size * FILLED / 2.0 + 0.5, 0.0, 1.0)[..., None]
    return seen_at(polar, x, y) * covered
