"""What a fit makes small: the samples' square roots, or the colours of a displayed ball."""

import numpy as np

from ..bake.colour import lab
from ..bake.fit import colour_metric
from ..models.fitted import Guess
from .ball import LUMINANCE, displayed, exposure_of
from .lights import FITTED

__all__ = ["ImageProblem", "SampleProblem", "guess_of"]

DARKEST = 0.004
"""Displayed colours below count as this in the metric."""


class _Problem:
    """Residuals of a Form: coordinates ``(M, 3)``, channel by channel of f, weighed to ``(3 M,)``; and its bends.

    stiffness  what the form's bends count
    """

    def __init__(self, form, v, l):
        self.form, self.v, self.l = form, v, l
        self.low, self.high = form.low, form.high
        self.stiffness = 0.0

    def coordinates(self, p):
        """Of the fitted BRDF, ``(M, 3)``."""
        return self._coordinates(self.form.evaluate(p, self.v, self.l))

    def residuals(self, p):
        """``(3 M + B,)``."""
        return np.r_[self._weighed(self.coordinates(p) - self.reference), self.stiffness * self.form.bends(p)]

    def jacobian(self, p, steps):
        """``(3 M + B, P)`` by differences; a colour's three numbers are moved at once, as each changes its channel
        alone.
        """
        here, columns = self.coordinates(p), np.zeros((3 * len(self.reference), len(p)))
        for group in self.form.groups:
            moved = p.copy()
            moved[list(group)] += steps[list(group)]
            change = self.coordinates(moved) - here
            for channel, i in enumerate(group):
                one = change if len(group) == 1 else np.where(np.arange(3) == channel, change, 0.0)
                columns[:, i] = self._weighed(one) / steps[i]
        bends = [(self.form.bends(p + step) - self.form.bends(p)) / step.sum() for step in np.diag(steps)]
        return np.concatenate([columns, self.stiffness * np.transpose(bends)])


class SampleProblem(_Problem):
    """√(f cos θl) of the samples, weighed by solid angle: between absolute and relative error.

    whole  the squares' sum of the samples themselves
    """

    def __init__(self, form, samples):
        super().__init__(form, samples.v, samples.l)
        self._cosine = samples.l[:, 2:]
        self._root_weight = np.sqrt(samples.weight)[:, None]
        self.reference = self._coordinates(samples.f)
        self.whole = float(np.sum(self._weighed(self.reference) ** 2))

    def _coordinates(self, f):
        return np.sqrt(np.maximum(f * self._cosine, 0.0))

    def _weighed(self, difference):
        return (self._root_weight * difference).ravel()


class ImageProblem(_Problem):
    """Displayed colours of a ball under the lights that are fitted to, in the quadratic form of CIEDE2000."""

    def __init__(self, form, ball, f):
        super().__init__(form, ball.v, ball.l)
        self._ball = ball
        images = {light: ball.image(light, f) for light in FITTED}
        self._exposures = {light: exposure_of(ball, image) for light, image in images.items()}
        self.reference = self._coordinates(f)
        seen = np.maximum(self.reference, DARKEST)
        self._roots = np.linalg.cholesky(colour_metric(seen, lab(seen)))
        self._root_area = np.sqrt(np.tile(ball.area.ravel(), len(FITTED)) / len(FITTED))[:, None]

    def difference(self, f):
        """Mean colour difference of a BRDF of v and l, ``(N, 3)``: the root of the residuals' squares."""
        return float(np.sum(self._weighed(self._coordinates(f) - self.reference) ** 2)) ** 0.5

    def _coordinates(self, f):
        return np.concatenate([displayed(self._ball.image(light, f), exposure).reshape(-1, 3)
                               for light, exposure in self._exposures.items()])

    def _weighed(self, difference):
        return (self._root_area * (difference[:, None, :] @ self._roots)[:, 0]).ravel()


def guess_of(samples):
    """The Guess of Samples: where f falls to 1/e of its top, the facets' slope is tan θh."""
    v, l, f, _ = samples
    h = v + l
    h = h / np.linalg.norm(h, axis=-1, keepdims=True)
    tilt = np.arccos(np.clip(h[:, 2], -1.0, 1.0))
    off = (tilt > np.radians(35.0)) & (np.minimum(v[:, 2], l[:, 2]) > 0.3)
    diffuse = np.clip(np.percentile(f[off] if off.any() else f, 25, axis=0) * np.pi, 0.0, 0.95)
    near = np.sum(v * h, axis=-1) > np.cos(np.radians(40.0))
    near = near if near.sum() >= 8 else np.ones(len(f), bool)
    order = np.argsort(tilt[near])
    bins = np.array_split(order, min(32, max(4, len(order) // 12)))
    profile = np.array([f[near][part].mean(axis=0) for part in bins]) - diffuse / np.pi
    angles = np.array([tilt[near][part].mean() for part in bins])
    bright = profile @ LUMINANCE
    peak = max(bright[:3].max(), 1e-4)
    below = np.flatnonzero(bright < peak / np.e)
    m = float(np.clip(np.tan(angles[below[0]]) if len(below) else 0.5, 0.006, 0.6))
    top = np.clip(profile[:3].max(axis=0) * 4.0 * np.pi * m * m, 1e-4, 2.0)
    shares = (0.95, 0.4) if top.mean() > 0.1 else (float(np.clip(top.mean() / 0.045, 0.02, 0.9)), 0.9)
    return Guess(diffuse, top, m, shares)
