"""A BRDF of scattered points everywhere: the fitted one, times what is between points of measured over fitted."""

import numpy as np

from .half_difference import angles_of

__all__ = ["Between"]

SIZE = (24, 10, 8)
"""Nodes over θh (even in its root), θd and φd."""
FAR = 0.3
"""Where the nearest point is this far off, in angles over π/2, the fit counts as much as the point."""
DARK = 0.01
"""Share of the mean that is added to both sides of a ratio, so that black over black is 1."""
MOST_POINTS = 5000
LARGEST = 4.0


class Between:
    """The BRDF near a fit.

    samples  the points
    fitted   function (v, l) -> f, ``(N, 3)``
    """

    def __init__(self, samples, fitted):
        self._fitted = fitted
        some = np.linspace(0, len(samples.v) - 1, min(len(samples.v), MOST_POINTS)).astype(int)
        v, l, f = samples.v[some], samples.l[some], samples.f[some]
        model = fitted(v, l)
        dark = DARK * f.mean(axis=0) + 1e-9
        ratio = np.log(np.clip((f + dark) / (model + dark), 1.0 / LARGEST, LARGEST))
        nodes = _place(*(a.ravel() for a in np.meshgrid(*_axes(), indexing="ij")))
        apart = np.sum((nodes[:, None] - _place(*angles_of(v, l))) ** 2, axis=-1)
        weight = 1.0 / (apart + 1e-5) ** 2
        self._ratio = np.exp(weight @ ratio / (weight.sum(axis=1) + FAR**-4)[:, None]).reshape(*SIZE, 3)

    def brdf(self, v, l):
        """f in 1/sr, ``(N, 3)``."""
        theta_h, theta_d, phi_d = angles_of(v, l)
        x = np.stack([np.sqrt(theta_h * (2.0 / np.pi)) * (SIZE[0] - 1), theta_d * (2.0 / np.pi) * (SIZE[1] - 1),
                      phi_d / np.pi * SIZE[2]], axis=-1)
        low = np.minimum(np.floor(np.maximum(x, 0.0)).astype(int), (SIZE[0] - 2, SIZE[1] - 2, SIZE[2] - 1))
        share, ratio = np.clip(x - low, 0.0, 1.0), 0.0
        for corner in np.ndindex(2, 2, 2):
            i, j, k = (low + corner).T
            weight = np.prod(np.where(corner, share, 1.0 - share), axis=-1)
            ratio = ratio + weight[:, None] * self._ratio[i, j, k % SIZE[2]]
        return ratio * self._fitted(v, l)


def _axes():
    return (np.linspace(0.0, 1.0, SIZE[0]) ** 2 * np.pi / 2.0, np.linspace(0.0, 1.0, SIZE[1]) * np.pi / 2.0,
            np.arange(SIZE[2]) / SIZE[2] * np.pi)


def _place(theta_h, theta_d, phi_d):
    """Where angles are in a space in which neighbours are alike, ``(N, 3)``; V and L may be exchanged."""
    r = theta_d * (2.0 / np.pi)
    return np.stack([np.sqrt(theta_h * (2.0 / np.pi)), r * np.cos(2.0 * phi_d), r * np.sin(2.0 * phi_d)], axis=-1)
