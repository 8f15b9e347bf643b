"""Clear bodies before bright bars and lamps, as meshes that two renderers get alike."""

from typing import NamedTuple

import numpy as np

from demo_blend.cut_stone import box, brilliant, prism

__all__ = ["SCENES", "Body", "Lamp", "Scene", "ball", "triangles", "tube"]


class Body(NamedTuple):
    """A closed mesh of clear material; inside and outside name its media: "body", "inner" or "air"."""

    corners: np.ndarray
    faces: list
    inside: str = "body"
    outside: str = "air"


class Lamp(NamedTuple):
    """A rectangle that shines on both sides."""

    corners: np.ndarray
    radiance: float


class Scene(NamedTuple):
    """What both renderers get.

    material  preset whose index the bodies have
    eye, target, up, fov  of the camera; fov in degrees, across the picture
    sky       radiance all around
    height    rows over columns
    """

    material: str
    bodies: list
    lamps: list
    eye: tuple
    target: tuple
    up: tuple
    fov: float
    sky: float
    height: float = 1.0


def _bar(centre, towards, up, width, height, radiance=1.0):
    normal = np.array(towards, float) / np.linalg.norm(towards)
    across = np.cross(up, normal)
    across *= 0.5 * width / np.linalg.norm(across)
    along = 0.5 * height * np.cross(normal, across) / np.linalg.norm(across)
    return Lamp(np.array(centre, float) + [-across - along, across - along, across + along, along - across], radiance)


def _turned(corners, axis, degrees):
    """Corners turned about the axis x, y or z."""
    i, angle = "xyz".index(axis), np.radians(degrees)
    j, k = (i + 1) % 3, (i + 2) % 3
    turned = np.array(corners, float)
    turned[:, j] = np.cos(angle) * corners[:, j] - np.sin(angle) * corners[:, k]
    turned[:, k] = np.sin(angle) * corners[:, j] + np.cos(angle) * corners[:, k]
    return turned


def ball(segments=64, radius=1.0):
    """(corners, faces) of a ball of flat faces."""
    rings = segments // 2
    polar = np.pi * np.arange(1, rings) / rings
    turn = 2.0 * np.pi * np.arange(segments) / segments
    around = np.stack([np.cos(turn), np.sin(turn)], axis=1)
    corners = [[0.0, 0.0, 1.0], *([np.sin(t) * x, np.sin(t) * y, np.cos(t)] for t in polar for x, y in around),
               [0.0, 0.0, -1.0]]

    def at(ring, k):
        return 1 + (ring - 1) * segments + k % segments
    faces, last = [], len(corners) - 1
    for k in range(segments):
        faces += [(0, at(1, k), at(1, k + 1)), (last, at(rings - 1, k + 1), at(rings - 1, k))]
        faces += [(at(r, k), at(r + 1, k), at(r + 1, k + 1), at(r, k + 1)) for r in range(1, rings - 1)]
    return radius * np.array(corners), faces


def tube(radius, height, segments=96):
    """(corners, faces) of an upright cylinder of flat faces, closed."""
    turn = 2.0 * np.pi * np.arange(segments) / segments
    ring = radius * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    corners = np.array([(*p, z) for z in (-0.5 * height, 0.5 * height) for p in ring])
    sides = [(k, (k + 1) % segments, segments + (k + 1) % segments, segments + k) for k in range(segments)]
    return corners, [tuple(range(segments))[::-1], tuple(range(segments, 2 * segments)), *sides]


def triangles(faces):
    """Convex faces as triangles, ``(T, 3)``."""
    return np.array([(face[0], face[i], face[i + 1]) for face in faces for i in range(1, len(face) - 1)])


def _plate():
    corners, faces = box(6.0, 6.0, 1.0)
    bars = [_bar((0.8 * k, 0.0, -6.0), (0, 0, 1), (0, 1, 0), 0.4, 12.0) for k in range(-6, 7)]
    return Scene("flint_glass", [Body(_turned(corners, "y", 50.0), faces)], bars, (0, 0, 8), (0, 0, 0), (0, 1, 0),
                 22.0, 0.05)


def _prism():
    bars = [_bar((6.0, -5.6 + 1.9 * k, 0.0), (-1, 0.9, 0), (0, 0, 1), 0.95, 12.0) for k in range(-7, 8)]
    return Scene("flint_glass", [Body(*prism(1.155))], bars, (-4.0, -1.9, 0.0), (0.0, -0.02, 0.0), (0, 1, 0), 20.0,
                 0.05)


def _ball():
    bars = [_bar((1.2 * k, 0.0, -5.0), (0, 0, 1), (0, 1, 0), 0.5, 12.0) for k in range(-4, 5)]
    bars.append(_bar((6, 4, 5), (-6, -4, -5), (0, 1, 0), 3.0, 3.0, 4.0))
    return Scene("flint_glass", [Body(*ball())], bars, (0, 0, 6), (0, 0, 0), (0, 1, 0), 24.0, 0.1)


def _brilliant():
    corners, faces = brilliant()
    corners = _turned(_turned(corners, "x", -35.0), "z", 10.0)
    random = np.random.default_rng(4)
    lamps = []
    for _ in range(14):
        towards = random.normal(size=3)
        towards[2] = 0.7 * abs(towards[2]) + 0.15
        towards /= np.linalg.norm(towards)
        lamps.append(_bar(8.0 * towards, -towards, (0.1, 0.2, 1.0) if towards[2] < 0.9 else (1, 0, 0), 1.2, 1.2, 12.0))
    return Scene("diamond", [Body(corners, faces)], lamps, (0, -3.2, 4.2), (0, 0, -0.15), (0, 0, 1), 24.0, 0.25)


def _water_in_a_glass():
    bodies = [Body(*tube(1.0, 40.0)), Body(*tube(0.85, 40.0), "inner", "body")]
    bars = [_bar((0.8 * k, 5.0, 0.0), (0, -1, 0), (0, 0, 1), 0.4, 20.0) for k in range(-8, 9)]
    return Scene("window_glass", bodies, bars, (0, -8, 0), (0, 0, 0), (0, 0, 1), 18.0, 0.1, 0.25)


SCENES = {"plate": _plate, "prism": _prism, "ball": _ball, "brilliant": _brilliant,
          "water in a glass": _water_in_a_glass}
"""Name -> function that makes the Scene."""
