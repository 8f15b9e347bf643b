"""A film on facets: Cook and Torrance's formula with the film's reflectance for F."""

import numpy as np

from ...operands import dot, maximum, rotate
from ...reflectance.directions import PI, around_z, frame_along, half_vector
from ...reflectance.masking import v_cavity
from ...reflectance.slopes import along_across, beckmann, elliptic_beckmann
from .tables import table_of

__all__ = ["SMOOTHEST", "evaluate", "slope"]

SMOOTHEST = 1e-3
"""Rms slope that stands in for 0."""


def slope(roughness):
    """Rms slope m of the facets, ``(...)``.

    >>> slope(0.3)
    0.09
    """
    return maximum(roughness * roughness, SMOOTHEST)


def evaluate(parameters, n, v, l, tangent=None):
    """R = s F D G/(4 N·V N·L) + (1 − s) Rd in 1/sr, ``(..., 3)``, F of the table at V·H; without what is seen through.

    tangent  what anisotropy is along before it is rotated, ``(..., 3)``; by default around the z axis, as on a ball

    >>> from .parameters import Film
    >>> from ...reflectance.directions import direction
    >>> up = direction(0.0, 0.0)
    >>> evaluate(Film(thickness=40, roughness=0.5), up, up, up).round(2).tolist()       # blue
    [0.0, 0.13, 0.4]
    """
    p = parameters
    h = half_vector(v, l)
    n_h, n_v, n_l, v_h = (np.sum(a * b, axis=-1) for a, b in ((n, h), (n, v), (n, l), (v, h)))
    above = (n_v > 0.0) & (n_l > 0.0)
    n_v, n_l, n_h, v_h = (np.where(above, x, 1.0) for x in (n_v, n_l, n_h, v_h))
    film = table_of(p.stack, {}, own=p.own_layers).at(v_h, p.thickness)
    facets = _distribution(p, n, h, n_h, tangent) / np.pi * v_cavity(n_h, n_v, n_l, v_h) / (4.0 * n_v * n_l)
    diffuse = (1.0 - p.specular) * (1.0 - p.see_through) * np.array(p.diffuse) / np.pi
    return np.where(above[..., None], np.array(p.tint) * (p.specular * film * facets[..., None] + diffuse), 0.0)


def _distribution(p, n, h, n_h, tangent):
    """D at H, stretched along the tangent where there is anisotropy."""
    m = slope(p.roughness)
    if p.anisotropy == 0.0:
        return beckmann(n_h, m)
    turned = rotate(around_z(n) if tangent is None else tangent, n, 2.0 * PI * p.rotation)
    t, b = frame_along(n, turned)
    return elliptic_beckmann(dot(h, t), dot(h, b), n_h, *along_across(m, p.anisotropy))
