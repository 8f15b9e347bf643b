"""A number that a ray hands on in its direction, from face to face of a body.

Cycles hands no number on along a path.  A direction, though, has digits that no eye sees: its place is the fraction of
TURNS · a·D, D the direction back to where the ray came from.  Each face reads the place of the ray that arrives, and
turns its facet by some 1e-4 rad, so that the ray that leaves into the body has the place that is wanted.
"""

import numpy as np

from ...operands import dot, fraction, part, widen

__all__ = ["place_of", "steered"]

TURNS = 4096.0
"""Turns of the place over a cosine: single precision keeps a place to about 1e-3, and facets turn by 1e-4 rad."""
AXIS = np.array([0.36, 0.80, 0.48])
NEAREST = 0.001
"""Added to sin² of the angle with the axis: beside it a ray would have to turn far, and keeps no place."""


@part("Place of a Ray")
def place_of(incoming):
    """The place of the ray that comes from a unit direction, in [0, 1); ``(..., 3)`` to ``(...)``.

    >>> round(float(place_of(np.array([0.0, 0.0, 1.0]))), 3)
    0.08
    """
    return fraction(dot(incoming, TURNS * AXIS))


@part("Steered Facet")
def steered(v, normal, along_v, along_n, place):
    """The normal, of nearly unit length, of the facet by which the ray that leaves has a place.

    v, normal         unit directions, to where the ray came from, and of the surface, ``(..., 3)``
    along_v, along_n  of the direction D back along the ray that leaves, D = along_v · V + along_n · N, ``(...)``
    place             as wanted, [0, 1], ``(...)``

    By Snell's law and the mirror's N is along D − along_v · V; D turned by η a⊥, a⊥ = a − (a·D) D, so asks for
    N + (η / along_n) a⊥, of which what is along N is left out.

    >>> up, v = np.array([0.0, 0.0, 1.0]), np.array([0.6, 0.0, 0.8])
    >>> n = steered(v, up, 1.0, -1.6, 0.3)
    >>> n = n / np.linalg.norm(n)
    >>> bool(n @ up > 1.0 - 1e-7), round(float(place_of(v - 2.0 * (n @ v) * n)), 2)
    (True, 0.3)
    """
    turns = along_v * dot(v, TURNS * AXIS) + along_n * dot(normal, TURNS * AXIS)
    off = fraction(place + 0.5 - turns) - 0.5
    turn = off / (along_n * (TURNS * (1.0 + NEAREST) - turns * turns / TURNS))
    return normal + widen(turn) * (AXIS - widen(turns * along_v / TURNS) * v)
