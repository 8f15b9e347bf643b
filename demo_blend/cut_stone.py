"""Faceted solids as corners and faces: the round brilliant, a prism, a box."""

import numpy as np

__all__ = ["box", "brilliant", "prism"]

MAINS = 8
"""Mains of the crown, and of the pavilion."""


def brilliant(*, table=0.57, crown=34.5, pavilion=40.75, star=0.45, lower=0.8, girdle=0.03):
    """(corners ``(N, 3)``, faces) of a round brilliant of radius 1, its table up; 57 facets and a girdle.

    table            radius of the table's corners
    crown, pavilion  slopes of their mains in degrees; Tolkowsky's of 1919 are 34.5 and 40.75
    star, lower      how far the stars reach from the table, and the lower halves from the girdle, as shares
    girdle           its height
    """
    up, down = np.tan(np.radians(crown)), np.tan(np.radians(pavilion))
    top = 0.5 * girdle + (1.0 - table) * up
    foot, well = table + star * (1.0 - table), 1.0 - lower
    rings = {  # name: (distance from the axis, height, half steps of turn)
        "table": (table, top, 0), "star": (foot / np.cos(np.pi / MAINS), top - (foot - table) * up, 1),
        "rim": (1.0, 0.5 * girdle, 0), "rim half": (1.0, 0.5 * girdle, 1),
        "edge": (1.0, -0.5 * girdle, 0), "edge half": (1.0, -0.5 * girdle, 1),
        "lower": (well / np.cos(np.pi / MAINS), -0.5 * girdle - lower * down, 1)}
    first = {name: MAINS * number for number, name in enumerate(rings)}
    corners = np.concatenate([_ring(*ring) for ring in rings.values()] + [[[0.0, 0.0, -0.5 * girdle - down]]])

    def at(name, k):
        return first[name] + k % MAINS
    tip, faces = len(corners) - 1, [tuple(range(MAINS))]
    for k in range(MAINS):
        faces += [
            (at("table", k), at("star", k - 1), at("rim", k), at("star", k)),
            (at("table", k), at("star", k), at("table", k + 1)),
            (at("star", k), at("rim", k), at("rim half", k)),
            (at("star", k), at("rim half", k), at("rim", k + 1)),
            (at("rim", k), at("edge", k), at("edge half", k), at("rim half", k)),
            (at("rim half", k), at("edge half", k), at("edge", k + 1), at("rim", k + 1)),
            (tip, at("lower", k), at("edge", k), at("lower", k - 1)),
            (at("lower", k), at("edge half", k), at("edge", k)),
            (at("lower", k), at("edge", k + 1), at("edge half", k))]
    return corners, faces


def _ring(radius, height, half_steps):
    angle = 2.0 * np.pi * (np.arange(MAINS) + 0.5 * half_steps) / MAINS
    return np.stack([radius * np.cos(angle), radius * np.sin(angle), np.full(MAINS, height)], axis=1)


def prism(side=1.0, length=3.0):
    """(corners, faces) of a prism, its section in x, y a triangle of equal sides about the origin, a corner at +y."""
    angle = np.radians([90.0, 210.0, 330.0])
    section = side / np.sqrt(3.0) * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    corners = np.array([(*corner, z) for z in (-0.5 * length, 0.5 * length) for corner in section])
    return corners, [(2, 1, 0), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)]


def box(x, y, z):
    """(corners, faces) of a box about the origin."""
    corners = 0.5 * np.array([(i * x, j * y, k * z) for k in (-1, 1) for j in (-1, 1) for i in (-1, 1)])
    return corners, [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
