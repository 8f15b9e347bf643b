"""Fits the closed forms of addon/reflectance/film_facets.py: mean and spread of V·H over the facets V sees.

    python tools/fit_film_facets.py

prints the constants and how far off they are at each slope.  Needs scipy.
"""

import sys
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from addon.reflectance.masking import smith_beckmann  # noqa: E402

SLOPES = np.array([0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6])
N_V = np.cos(np.radians([0, 10, 20, 30, 40, 50, 55, 60, 65, 70, 75, 78, 80, 82, 84, 86, 88]))
STARTS = {"mean": (0.68, -0.67, 0.98, -0.66, 0.58, 0.0, 0.16, 0.24, -0.55),
          "spread": (0.9, 0.37, 0.39, 0.16, 0.55, 0.21)}


def moments(n_v, m, count=600, turns=192):
    """(mean, standard deviation) of V·H where a facet counts by D G V·H/(N·V)."""
    tan_alpha = m * np.sqrt(-np.log((np.arange(count) + 0.5) / count))[:, None]
    phi = (np.arange(turns) + 0.5) / turns * np.pi
    n_h = 1.0 / np.sqrt(1.0 + tan_alpha**2)
    v_h = np.sqrt(1.0 - n_v**2) * tan_alpha * n_h * np.cos(phi) + n_v * n_h
    n_l = 2.0 * v_h * n_h - n_v
    seen = (v_h > 0.0) & (n_l > 0.0)
    weight = np.where(seen, smith_beckmann(n_v, np.maximum(n_l, 1e-6), m) * v_h / (n_v * n_h), 0.0)
    weight /= weight.sum()
    mean = (weight * v_h).sum()
    return mean, np.sqrt((weight * (v_h - mean) ** 2).sum())


def mean(p, n_v, m):
    """:func:`addon.reflectance.film_facets.mean_v_h` with free constants."""
    sine = np.sqrt(1.0 - n_v**2)
    leaning = m * (p[2] + p[3] * m) * np.exp(-n_v / m * (p[4] + p[5] * m)) + m**2 * (p[6] + p[7] * n_v + p[8] * n_v**2)
    return n_v - n_v * m**2 * (p[0] + p[1] * m) + sine * leaning


def spread(p, n_v, m):
    """:func:`addon.reflectance.film_facets.spread_v_h` with free constants; 0.242 is p0 p1, 0.3226 is p0 p2."""
    across = np.sqrt(1.0 - n_v**2) * m * p[0] * (1.0 - (p[1] + p[2] * m) * np.exp(-n_v / m * p[3])) / (1.0 + p[4] * m)
    return np.hypot(across, p[5] * m**2 * n_v)


def main():
    m, n_v = np.meshgrid(SLOPES, N_V, indexing="ij")
    wanted = np.array([[moments(c, slope) for c in N_V] for slope in SLOPES])
    for form, target in ((mean, wanted[..., 0]), (spread, wanted[..., 1])):
        found = least_squares(lambda p: ((form(p, n_v, m) - target) / (0.02 + 0.3 * m)).ravel(),
                              STARTS[form.__name__], max_nfev=4000)
        error = np.abs(form(found.x, n_v, m) - target).max(axis=1)
        print(form.__name__, found.x.round(4).tolist())
        print("  off by at most", ", ".join(f"{e:.4f} at m {slope:g}" for slope, e in zip(SLOPES, error)))


if __name__ == "__main__":
    main()
