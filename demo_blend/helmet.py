"""A full-face helmet: one fine mesh whose radius is a formula, with a visor, pivots, vents and a rubber trim."""

import bpy
import numpy as np
from mathutils import Vector

from .studio import matt
from .turned import bent_rod

__all__ = ["helmet"]

HALF_WIDTH, HALF_LENGTH, HALF_HEIGHT = 0.86, 1.02, 0.98
POWER = 2.2
"""Of the superellipsoid that the shell begins as."""
RIM = -0.86
"""Height of its lower edge."""
AROUND, DOWN = 900, 560
SHELL, RUBBER, VISOR = range(3)
GROOVE = 0.011
GAP = 1.1 * GROOVE
"""Half the width of the gap round the visor, and of what is black in it."""
VENT_EDGE = -0.012


def helmet(name, shell, visor, *, detail=1.0):
    """An empty that carries the helmet, its lower edge at z = 0, its face towards -Y.

    shell, visor  materials
    detail        of the mesh; 1 is what a large picture needs
    """
    columns, rows = round(AROUND * detail), round(DOWN * detail)
    around = 2.0 * np.pi * np.arange(columns) / columns
    share = np.linspace(0.0, 1.0, rows)[:, None]
    lowest = _lowest(around)
    up = 0.5 * np.pi + share * (lowest - 0.5 * np.pi)
    around = np.broadcast_to(around, up.shape)
    for distance, edge in ((_port, GAP), (_port, -GAP), (_chin_vent, VENT_EDGE)):
        up = _with_rows_on(distance, edge, around, up)
    place = shaped(around, up)[0]
    place[..., 2] -= RIM
    following = around + 2.0 * np.pi / columns
    part = shaped(0.5 * (around + following)[:-1], _middle(up))[1]
    ring, step = np.meshgrid(np.arange(rows - 1), np.arange(columns), indexing="ij")
    after = (step + 1) % columns
    faces = np.stack([ring * columns + step, (ring + 1) * columns + step, (ring + 1) * columns + after,
                      ring * columns + after], axis=-1).reshape(-1, 4)
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(place.reshape(-1, 3).tolist(), [], faces.tolist())
    for material in (shell, matt("Rubber", 0.018), visor):
        mesh.materials.append(material)
    mesh.polygons.foreach_set("material_index", part.ravel().astype(np.int32))
    mesh.polygons.foreach_set("use_smooth", np.ones(len(faces), bool))
    made = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(made)
    for added in (_trim(place[-1, ::max(1, columns // 90)], mesh.materials[RUBBER]), _lining(mesh.materials[RUBBER])):
        added.parent = made
    return made


def shaped(around, up):
    """Where the surface is, (..., 3), and which part it belongs to, by direction.

    around  radians about the vertical, 0 at the face
    up      radians above the horizon
    """
    direction = np.stack([np.sin(around) * np.cos(up), -np.cos(around) * np.cos(up), np.sin(up)], axis=-1)
    axes = np.array([HALF_WIDTH, HALF_LENGTH, HALF_HEIGHT])
    radius = np.sum(np.abs(direction / axes) ** POWER, axis=-1) ** (-1.0 / POWER)
    face, behind = np.maximum(np.cos(around), 0.0), np.maximum(-np.cos(around), 0.0)
    radius += 0.15 * face ** 2 * _bell(up, -0.62, 0.36)  # the chin bar
    radius += 0.07 * behind ** 3 * _bell(up, 0.30, 0.25) - 0.05 * behind ** 2 * _bell(up, -0.60, 0.35)  # the tail
    side = radius * np.abs(direction[..., 0])
    along = radius * direction[..., 1]
    crest = _step((radius * direction[..., 2] - 0.55) / 0.25) * _step((along + 0.70) / 0.3)
    radius += 0.022 * crest * _bell(side, 0.30 - 0.08 * along, 0.055)  # two ridges over the crown
    flank = _step((np.abs(around) - 0.9) / 0.5) * _step((2.75 - np.abs(around)) / 0.5)
    radius += 0.020 * flank * _bell(up, -0.20 + 0.16 * (np.abs(around) - 1.6), 0.06)  # and one along each flank
    return _details(direction, radius, around, up)


def _middle(corners):
    """Means over the four corners of each face; the last column meets the first."""
    across = 0.5 * (corners + np.roll(corners, -1, axis=1))
    return 0.5 * (across[:-1] + across[1:])


def _with_rows_on(from_edge, level, around, up):
    """The heights, those next to where function(around, up) has this level moved onto it: faces end where parts do."""
    distance = from_edge(_wrapped(around), up) - level
    row, column = np.nonzero(np.signbit(distance[:-1]) != np.signbit(distance[1:]))
    above, below = distance[row, column], distance[row + 1, column]
    share = above / (above - below)
    moved = up.copy()
    crossing = up[row, column] + share * (up[row + 1, column] - up[row, column])
    moved[row + (share > 0.5), column] = crossing
    return moved


def _wrapped(around):
    """Between -pi and pi."""
    return (around + np.pi) % (2.0 * np.pi) - np.pi


def _port(around, up):
    """About the distance from the edge of the opening for the eyes, negative inside."""
    return _superellipse(around, up - 0.15 + 0.05 * (around / 1.3) ** 2, 1.32, 0.36, 3.4)


def _chin_vent(around, up):
    """About the distance from the edge of the vent below."""
    return _superellipse(around, up + 0.66, 0.25, 0.062, 3.0)


def _details(direction, radius, around, up):
    """The gap round the visor, the pivots and the vents, and the part that each point belongs to."""
    around = _wrapped(around)
    part = np.full(around.shape, SHELL)
    port = _port(around, up)
    radius = radius + 0.012 * _step(-port / 0.02) - 0.034 * np.exp(-(port / GROOVE) ** 2)
    part[port < 0.0] = VISOR
    part[np.abs(port) < GAP] = RUBBER
    for turn in (-1.0, 1.0):
        away = np.hypot((around - turn * 1.36) * np.cos(0.12), up - 0.12) - 0.15
        radius = radius + 0.030 * _step(-away / 0.02) - 0.014 * np.exp(-((away + 0.055) / 0.008) ** 2)
        part[away < 0.004] = RUBBER
    vents = [_chin_vent(around, up)]
    vents += [_superellipse(around - turn * 0.33, up - 0.80 + turn * 0.25 * (around - turn * 0.33), 0.13, 0.035, 3.0)
              for turn in (-1.0, 1.0)]
    for vent in vents:
        radius = radius - 0.055 * _step(-vent / 0.022) + 0.008 * np.exp(-((vent - 0.014) / 0.012) ** 2)
        part[vent < VENT_EDGE] = RUBBER
    return direction * radius[..., None], part


def _superellipse(x, y, half_width, half_height, power):
    """About the distance from a superellipse, negative inside, in the unit of x and y."""
    norm = (np.abs(x / half_width) ** power + np.abs(y / half_height) ** power) ** (1.0 / power)
    steepness = np.hypot(
        np.abs(x / half_width) ** (power - 1.0) / half_width, np.abs(y / half_height) ** (power - 1.0) / half_height)
    near = (norm - 1.0) * norm ** (power - 1.0) / np.maximum(steepness, 1e-9)
    return np.where(norm > 0.3, near, -0.7 * half_height)  # about the middle no direction leads out


def _bell(x, middle, width):
    return np.exp(-((x - middle) / width) ** 2)


def _step(x):
    """From 0 to 1 as x goes there, smoothly."""
    x = np.clip(x, 0.0, 1.0)
    return x * x * (3.0 - 2.0 * x)


def _lowest(around):
    """The angle below the horizon at which the surface comes to the rim, by bisection."""
    low, high = np.full(around.shape, -1.45), np.full(around.shape, -0.2)
    for _ in range(40):
        middle = 0.5 * (low + high)
        below = shaped(around, middle)[0][..., 2] < RIM
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return 0.5 * (low + high)


def _trim(edge, rubber):
    """A rubber bead along the lower edge."""
    points = [Vector(point) + Vector((0.0, 0.0, 0.03)) for point in np.concatenate([edge, edge[:1]]).tolist()]
    return bent_rod("Trim", points, 0.03, rubber)


def _lining(black):
    """What is dark inside."""
    bpy.ops.mesh.primitive_uv_sphere_add(segments=64, ring_count=32, radius=1.0, location=(0.0, 0.02, 0.82))
    made = bpy.context.object
    made.name = "Lining"
    made.scale = (0.74, 0.86, 0.80)
    made.data.polygons.foreach_set("use_smooth", np.ones(len(made.data.polygons), bool))
    made.data.materials.append(black)
    return made
