"""A film on facets: Cook and Torrance's formula with the film's reflectance for F."""

from types import SimpleNamespace

import numpy as np

from ...operands import clip, dot, maximum, rotate
from ...reflectance.directions import PI, around_z, frame_along, half_vector
from ...reflectance.film_facets import tilted_lobes
from ...reflectance.masking import smith_beckmann, v_cavity
from ...reflectance.slopes import along_across, beckmann, elliptic_beckmann
from .tables import table_of

__all__ = ["SMOOTHEST", "evaluate", "second_slope", "slope", "slopes_of", "standard"]

SMOOTHEST = 1e-3
"""Rms slope that stands in for 0."""
LEAST_COSINE = 1e-3


def slope(roughness):
    """Rms slope m of the facets, ``(...)``.

    >>> slope(0.3)
    0.09
    """
    return maximum(roughness * roughness, SMOOTHEST)


def second_slope(m, ratio):
    """Rms slope of the second slope, ``(...)``: a multiple of the first's, at most 1.

    >>> float(second_slope(0.25, 2.0)), float(second_slope(0.5, 3.0))
    (0.5, 1.0)
    """
    return clip(m * ratio, SMOOTHEST, 1.0)


def slopes_of(parameters):
    """The (m, w) pairs of a Film: one, or two whose shares sum to 1.

    >>> from .parameters import Film
    >>> slopes_of(Film(roughness=0.5)), slopes_of(Film(roughness=0.5, second_weight=0.25, second_ratio=2.0))
    (((0.25, 1.0),), ((0.25, 0.75), (0.5, 0.25)))
    """
    m, w = float(slope(parameters.roughness)), parameters.second_weight
    return ((m, 1.0),) if w == 0.0 else ((m, 1.0 - w), (float(second_slope(m, parameters.second_ratio)), w))


def evaluate(parameters, n, v, l, tangent=None):
    """R = s F D G/(4 N·V N·L) + (1 − s) Rd in 1/sr, ``(..., 3)``, F of the table at V·H; without what is seen through.

    tangent  what anisotropy is along before it is rotated, ``(..., 3)``; by default around the z axis, as on a ball

    >>> from .parameters import Film
    >>> from ...reflectance.directions import direction
    >>> up = direction(0.0, 0.0)
    >>> evaluate(Film(thickness=40, roughness=0.5), up, up, up).round(2).tolist()       # blue
    [0.0, 0.13, 0.4]
    """
    def facets(c, look):
        d = _distribution(parameters, c.n, c.h, c.n_h, tangent)
        return look(c.v_h) * (d / np.pi * v_cavity(c.n_h, c.n_v, c.n_l, c.v_h) / (4.0 * c.n_v * c.n_l))[..., None]
    return _with_diffuse(parameters, n, v, l, facets)


def standard(parameters, n, v, l):
    """What Standard renders in place of :func:`evaluate` where facets are round: tilted lobes of one colour, Smith's G.

    See addon.reflectance.film_facets; arguments as for :func:`evaluate`.

    >>> from .parameters import Film
    >>> from ...reflectance.directions import direction
    >>> up = direction(0.0, 0.0)
    >>> standard(Film(thickness=40, roughness=0.5), up, up, up).round(2).tolist()
    [0.0, 0.13, 0.4]
    """
    def facets(c, look):
        return sum(w * colour * _native(normal, c, m)[..., None] for m, w in slopes_of(parameters)
                   for colour, normal in tilted_lobes(c.n, c.v, m, look))
    return _with_diffuse(parameters, n, v, l, facets)


def _with_diffuse(parameters, n, v, l, facets):
    """Tint times s times facets(cosines, look) and the diffuse part; 0 where a direction is below the surface."""
    p = parameters
    n, v, l = np.broadcast_arrays(n, v, l)
    h = half_vector(v, l)
    n_h, n_v, n_l, v_h = (np.sum(a * b, axis=-1) for a, b in ((n, h), (n, v), (n, l), (v, h)))
    above = (n_v > 0.0) & (n_l > 0.0)
    n_v, n_l, n_h, v_h = (np.where(above, x, 1.0) for x in (n_v, n_l, n_h, v_h))
    seen = SimpleNamespace(n=n, v=v, l=l, h=h, n_h=n_h, n_v=n_v, n_l=n_l, v_h=v_h)
    film = facets(seen, lambda c: table_of(p.stack, {}, own=p.own_layers).at(c, p.thickness))
    diffuse = (1.0 - p.specular) * (1.0 - p.see_through) * np.array(p.diffuse) / np.pi
    return np.where(above[..., None], np.array(p.tint) * (p.specular * film + diffuse), 0.0)


def _native(normal, c, m):
    """D G/(4 N·V N·L) of a Beckmann closure about a normal that is not the surface's."""
    t_h, t_v, t_l = (np.sum(normal * x, axis=-1) for x in (c.h, c.v, c.l))
    t_v = np.maximum(t_v, LEAST_COSINE)
    lit = beckmann(t_h, m) / np.pi * smith_beckmann(t_v, np.maximum(t_l, 0.0), m) / (4.0 * t_v * c.n_l)
    return np.where(t_l > 0.0, lit, 0.0)


def _distribution(p, n, h, n_h, tangent):
    """D at H of both slopes, stretched along the tangent where there is anisotropy."""
    if p.anisotropy == 0.0:
        return sum(w * beckmann(n_h, m) for m, w in slopes_of(p))
    turned = rotate(around_z(n) if tangent is None else tangent, n, 2.0 * PI * p.rotation)
    t, b = frame_along(n, turned)
    h_t, h_b = dot(h, t), dot(h, b)
    return sum(w * elliptic_beckmann(h_t, h_b, n_h, *along_across(m, p.anisotropy)) for m, w in slopes_of(p))
