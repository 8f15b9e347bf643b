"""The shader of base colour, metalness and index that comes closest to a material, by CIEDE2000 over the angle."""

from typing import NamedTuple

import numpy as np

from ..reflectance import fresnel
from .colour import delta_e_2000, lab
from .fit import colour_metric

__all__ = ["COS_THETA", "Fit", "fit_curve", "fit_dielectric", "fit_metal", "fit_mirror"]

COS_THETA = np.sqrt((np.arange(24) + 0.5) / 24.0)
"""Angles that a ball shows an even share of its disc at, ``(24,)``: a mean over them is a mean over the picture."""
STEPS, STEP = 30, 1e-5
LEAST_F0, LARGEST_F0 = 0.0, 0.6


class Fit(NamedTuple):
    """base colour ``(3,)``, one number or three beside it, and the mean and largest CIEDE2000 over COS_THETA."""

    base: tuple
    beside: tuple
    delta_e_mean: float
    delta_e_max: float


def fit_mirror(rgb, *, with_edge=True):
    """The Fit of a mirror's colours: F0, and F82 tint beside it; or Schlick's curve by F0 alone.

    rgb        linear Rec.709 at COS_THETA, ``(24, 3)``
    with_edge  whether the shader has an edge tint

    F82 tint: Kutz, Hašan, Edmondson 2021.

    >>> grey = fit_mirror(fresnel.f82(COS_THETA[:, None], np.full(3, 0.5), np.full(3, 0.9)))
    >>> np.round(grey.base, 3).tolist(), np.round(grey.beside, 3).tolist()
    ([0.5, 0.5, 0.5], [0.9, 0.9, 0.9])
    """
    c = COS_THETA[:, None]
    if with_edge:
        return _found(lambda x: fresnel.f82(c, x[:3], x[3:]), np.concatenate([rgb[-1], np.ones(3)]), rgb)
    return _found(lambda x: fresnel.schlick(c, x[:3]), rgb[-1], rgb)


def fit_dielectric(rgb, f0):
    """The Fit of a diffuse colour under a clear coat: base colour, and the coat's F0 beside it.

    rgb  linear Rec.709 at COS_THETA, ``(24, 3)``
    f0   where the search for F0 starts

    The coat reflects a dielectric's F, and the base what is left, (1 − F) · colour.
    """
    def curve(x):
        mirror = fresnel.dielectric_from_normal(COS_THETA[:, None], x[3:])
        return mirror + (1.0 - mirror) * x[:3]
    start = np.concatenate([np.clip((rgb[-1] - f0) / (1.0 - f0), 0.0, 1.0), [f0]])
    return _found(curve, start, rgb, high=np.array([1.0, 1.0, 1.0, LARGEST_F0]))


def fit_metal(rgb, metallic):
    """The Fit of a metal with a diffuse part of its own colour: base colour, and metalness beside it.

    rgb       linear Rec.709 at COS_THETA, ``(24, 3)``
    metallic  where the search for it starts
    """
    def curve(x):
        return x[3] * fresnel.schlick(COS_THETA[:, None], x[:3]) + (1.0 - x[3]) * x[:3]
    return _found(curve, np.concatenate([rgb[-1], [metallic]]), rgb)


def fit_curve(curve, start, rgb):
    """The Fit of any family of colours, whose first three parameters are `base`, all in [0, 1].

    curve  function of the parameters: linear Rec.709, ``(A, 3)``
    rgb    what it comes closest to, likewise
    """
    return _found(curve, start, rgb)


def _found(curve, start, rgb, high=1.0):
    """The Fit of a family of curves, whose first three parameters are the base colour, all in [0, high]."""
    target = lab(rgb)
    root = np.linalg.cholesky(colour_metric(rgb, target))

    def residuals(x):
        return np.einsum("ai,aij->aj", curve(x) - rgb, root).ravel()
    x, damping = np.clip(start, 0.0, high), 1e-3
    found = residuals(x)
    for _ in range(STEPS):
        slopes = np.stack([(residuals(x + STEP * axis) - found) / STEP for axis in np.eye(len(x))], axis=1)
        normal = slopes.T @ slopes
        new = x - np.linalg.solve(normal + damping * np.diag(np.diag(normal) + 1e-9), slopes.T @ found)
        new = np.clip(new, 0.0, high)
        error = residuals(new)
        if error @ error < found @ found:
            x, found, damping = new, error, max(0.1 * damping, 1e-9)
        else:
            damping *= 10.0
            if damping > 1e6:
                break
    apart = delta_e_2000(lab(curve(x)), target)
    return Fit(tuple(x[:3].tolist()), tuple(x[3:].tolist()), float(apart.mean()), float(apart.max()))
