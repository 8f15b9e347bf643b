"""Directions about a surface: half vectors, mirrored directions and the frame that a direction is given in.

Unit vectors ``(..., 3)``: N surface normal, V to the viewer, L to the light,
H = (V + L)/|V + L|.
"""

from types import SimpleNamespace

from ..operands import (
    cos,
    cross,
    dot,
    less,
    maximum,
    normalize,
    sin,
    term,
    vector,
    where,
    widen,
    x_of,
    y_of,
    z_of,
)

__all__ = ["PI", "direction", "half_vector", "mirrored", "cosines", "facing", "tangent_of", "around_z", "frame_along",
           "frame_about", "in_frame"]

PI = 3.141592653589793

LEAST_N_V = 0.01
"""Of :func:`facing`."""

NOBODYS_NORMAL = (0.7531, 0.0, 0.6579)
"""A direction along which no flat surface is likely to lie."""


def direction(theta, phi):
    """The direction at the angle theta from the z axis and phi about it, both in radians; ``(..., 3)``.

    >>> direction(0.0, 0.0).tolist()
    [0.0, 0.0, 1.0]
    """
    return vector(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta))


def half_vector(v, l):
    """H, half-way between V and L: the normal of the facet that mirrors one to the other.

    >>> half_vector(direction(0.3, 0.0), direction(0.5, 0.0)).round(6).tolist() \\
    ...     == direction(0.4, 0.0).round(6).tolist()
    True
    """
    return normalize(v + l)


def mirrored(v, h):
    """L = 2 (V·H) H − V, the direction that the facet with normal H mirrors V to.

    >>> mirrored(direction(0.3, 0.0), direction(0.4, 0.0)).round(6).tolist() \\
    ...     == direction(0.5, 0.0).round(6).tolist()
    True
    """
    return widen(2.0 * dot(v, h)) * h - v


def cosines(n, v, l):
    """N·V, N·L, N·H and V·H by name (n_v, n_l, n_h, v_h), each ``(...)``.

    >>> c = cosines(direction(0.0, 0.0), direction(0.3, 0.0), direction(0.3, PI))
    >>> round(float(c.n_h), 6), round(float(c.v_h - c.n_v), 6)
    (1.0, 0.0)
    """
    h = half_vector(v, l)
    return SimpleNamespace(n_v=dot(n, v), n_l=dot(n, l), n_h=dot(n, h), v_h=dot(v, h))


@term("N")
def facing(n, v):
    """N, turned towards V where N·V is below 0.01, as of a smoothed or bumped surface at its outline; ``(..., 3)``.

    The formulas are made for surfaces that the viewer sees: seen from below, densities of what is drawn lose their
    sign.

    >>> up = direction(0.0, 0.0)
    >>> turned = facing(up, direction(1.8, 0.0))
    >>> facing(up, direction(1.5, 0.0)).tolist(), round(float(dot(turned, direction(1.8, 0.0))), 3)
    ([0.0, 0.0, 1.0], 0.01)
    """
    return normalize(n + widen(maximum(LEAST_N_V - dot(n, v), 0.0)) * v)


@term("Frame")
def tangent_of(n):
    """A unit tangent of the surface with normal N, ``(..., 3)``; 0 at one odd normal.

    >>> tangent_of(direction(0.0, 0.0)).tolist()
    [0.0, 1.0, 0.0]
    """
    return normalize(cross(n, NOBODYS_NORMAL))


def around_z(n):
    """The unit tangent around the z axis, ``(..., 3)``: what Blender gives a ball as its own; x at the poles.

    >>> (around_z(direction(0.5, 0.0)).round(6) + 0.0).tolist()
    [0.0, 1.0, 0.0]
    """
    flat = vector(-y_of(n), x_of(n), 0.0 * z_of(n))
    return normalize(where(widen(less(dot(flat, flat), 1e-12)), (1.0, 0.0, 0.0), flat))


@term("Frame")
def frame_along(n, tangent):
    """Two unit tangents (t, b) that make a right-handed frame (t, b, N) with the normal, t next to `tangent`.

    n, tangent  ``(..., 3)``; the tangent of any length, not along N

    >>> t, b = frame_along(direction(0.0, 0.0), direction(1.0, 0.0))
    >>> t.round(6).tolist(), b.round(6).tolist()
    ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0])
    """
    b = normalize(cross(n, tangent))
    return cross(b, n), b


@term("Frame")
def frame_about(n):
    """Two unit tangents that make a right-handed frame (t, b, N) with the normal, t as :func:`tangent_of`.

    >>> t, b = frame_about(direction(0.0, 0.0))
    >>> (t.tolist(), b.tolist())
    ([0.0, 1.0, 0.0], [-1.0, 0.0, 0.0])
    """
    t = tangent_of(n)
    return t, cross(n, t)


def in_frame(x, y, z, t, b, n):
    """The direction with components x, y, z ``(...)`` along the frame (t, b, N).

    >>> in_frame(0.0, 0.0, 1.0, *frame_about(direction(0.4, 0.0)), direction(0.4, 0.0)).round(6).tolist() \\
    ...     == direction(0.4, 0.0).round(6).tolist()
    True
    """
    return widen(x) * t + widen(y) * b + widen(z) * n
