"""The χ² test of drawn directions against a density, as renderers do it for their BSDFs."""

import numpy as np
from scipy import stats

__all__ = ["bin_centres", "direction_p_value"]

BINS, FINE = 48, 8
FEWEST = 10.0


def bin_centres():
    """Directions of the upper hemisphere at which to give a density, ``(n, n, 3)``.

    Even in solid angle: on Lambert's equal-area map of the hemisphere, a disc
    in a square, where r² = 1 − cos θ.
    """
    at = 2.0 * (np.arange(BINS * FINE) + 0.5) / (BINS * FINE) - 1.0
    x, y = np.meshgrid(at, at, indexing="ij")
    z = 1.0 - np.minimum(x * x + y * y, 1.0)
    stretch = np.sqrt(1.0 + z)
    directions = np.stack([x * stretch, y * stretch, z], axis=-1)
    return directions / np.linalg.norm(directions, axis=-1, keepdims=True)


def direction_p_value(directions, density, count=None):
    """The chance of so bad a fit of directions ``(n, 3)`` to a density per steradian at bin_centres().

    count  of all draws, those included that are in no bin of the hemisphere

    Bins with few expected are taken together.  Those that the horizon cuts are
    one bin more, with all that lies below it.
    """
    count = count or len(directions)
    above = directions[directions[:, 2] > 0.0]
    on_map = above[:, :2] / np.sqrt(1.0 + above[:, 2:])
    column = np.clip(((on_map + 1.0) * (0.5 * BINS)).astype(int), 0, BINS - 1)
    edges = np.abs(2.0 * np.arange(BINS + 1) / BINS - 1.0)
    far = np.maximum(edges[1:], edges[:-1]) ** 2
    whole = (far[:, None] + far[None, :] < 1.0).ravel()
    found = np.bincount(column[:, 0] * BINS + column[:, 1], minlength=BINS * BINS)[whole]
    solid_angle = 2.0 * (2.0 / (BINS * FINE)) ** 2
    expected = density.reshape(BINS, FINE, BINS, FINE).sum(axis=(1, 3)).ravel()[whole] * solid_angle * count
    found, expected = np.append(found, count - found.sum()), np.append(expected, count - expected.sum())
    many = expected >= FEWEST
    found, expected = np.append(found[many], found[~many].sum()), np.append(expected[many], expected[~many].sum())
    chi2 = np.sum((found - expected) ** 2 / np.maximum(expected, 1.0))
    return float(stats.chi2.sf(chi2, len(found) - 1))
