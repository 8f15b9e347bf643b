"""Scratched: fine straight lines of some length in many directions, on a surface that is else smooth."""

import math

from ..models.parameters import Slider, add_inputs
from ..operands import absolute, clip, cross, dot, less, maximum, normalize, part, sqrt, vector, x_of, y_of, z_of
from .place import COORDINATES, NORMAL, ROUGHNESS, between, depth, place, scale, tilted, to_object, to_world

__all__ = ["DRIVES", "TABLE", "build"]

DRIVES = ("Roughness", "Normal")
TABLE = (
    ROUGHNESS, scale(4.0, "Scratches that could be side by side"),
    depth(0.8, "How far the scratches tilt the surface"),
    Slider(name="amount", socket="Amount", default=0.8, low=0.0, high=1.0, subtype="FACTOR",
           tip="How many of them there are"),
    Slider(name="width", socket="Width", default=0.03, low=0.0001, high=1.0, never_zero=True,
           tip="Width of a scratch, as a share of the distance to where the next could be"),
    Slider(name="scuffed", socket="Scratch Roughness", default=0.6, low=0.0, high=1.0, subtype="FACTOR",
           tip="Roughness in the scratches"),
    *COORDINATES, NORMAL)

SETS = 6
"""Sets of parallel sheets in space; where a sheet meets the surface there is a scratch."""
BEND = 0.25


def sheet_normals(count=SETS):
    """Unit normals of the sets, spread evenly over half a sphere: ``[(x, y, z), …]``.

    By the golden angle, as of Vogel's sunflower.

    >>> [round(x, 3) for x in sheet_normals(2)[0]]
    [0.661, 0.0, 0.75]
    """
    found = []
    for j in range(count):
        z = 1.0 - (j + 0.5) / count
        angle, r = j * math.pi * (3.0 - math.sqrt(5.0)), math.sqrt(1.0 - z * z)
        found.append((r * math.cos(angle), r * math.sin(angle), z))
    return found


def build(builder):
    """Build the group."""
    s = add_inputs(builder, TABLE)
    n, at = builder.normal(s.normal), place(builder, s)
    facing = to_object(builder, n)
    bent = at + (_bend(builder, at, s) - (0.5, 0.5, 0.5)) * (BEND / s.scale)
    mask, slopes = 0.0, []
    for j, across in enumerate(sheet_normals(), 1):
        aside = tuple(float(x) for x in normalize(cross(across, (across[1], across[2], across[0]))))
        line, rise, direction = _set(builder, s, bent, facing, across, aside, float(j))
        mask = maximum(mask, line)
        slopes.append((direction, rise))
    with builder.frame("Surface"):
        normal = part("Scratched Normal")(tilted)(n, *slopes)
        rough = s.roughness + (s.scuffed - s.roughness) * mask
    builder.output("Roughness", clip(rough, 0.0, 1.0), description="Roughness, that of the scratches in them")
    builder.output("Normal", normal, description="Normal that the scratches tilt")
    builder.output("Mask", mask, description="1 in the scratches")


def _bend(builder, at, s):
    """What keeps the sheets from being quite even."""
    return builder.node("ShaderNodeTexNoise", {"Vector": at, "Scale": 0.35 * s.scale, "Detail": 1.0}, "Color",
                        noise_dimensions="3D")


@part("Set of Scratches", "line", "rise", "direction")
def _set(builder, s, at, facing, across, aside, seed):
    """(1 in the scratches of one set, how far they tilt the surface, and in which direction).

    across, aside  normal of its sheets, and a direction in them, in the axes of the coordinates
    """
    x, along = dot(at, across) * s.scale, dot(at, aside) * (0.35 * s.scale)
    cell, drawn, along = _piece(builder, x, along, seed)
    tilt = dot(facing, across)
    steep = sqrt(maximum(1.0 - tilt * tilt, 0.0))
    away = (x - cell - (0.1 + 0.8 * x_of(drawn))) / (s.width * maximum(steep, 0.05))
    there = less(y_of(drawn), s.amount) * between(steep, 0.2, 0.4)
    line = clip(1.0 - absolute(away), 0.0, 1.0) * there * _ends(along, z_of(drawn))
    return line, s.depth * line * clip(away, -1.0, 1.0), to_world(builder, across)


@part("Ends of a Scratch")
def _ends(along, drawn):
    """1 between the ends of a piece, whose length is drawn."""
    return clip(8.0 * along, 0.0, 1.0) * clip(8.0 * (0.3 + 0.7 * drawn - along), 0.0, 1.0)


@part("Piece of a Scratch", "sheet", "drawn", "along")
def _piece(builder, x, along, seed):
    """(the sheet, three numbers drawn for the piece of it, how far along the piece from 0 to 1)."""
    cell = builder.node("ShaderNodeMath", {"Value": x}, operation="FLOOR")
    start = builder.node("ShaderNodeTexWhiteNoise", {"Vector": vector(cell, seed, 0.0)}, "Value",
                         noise_dimensions="3D")
    along = along + 7.0 * start
    piece = builder.node("ShaderNodeMath", {"Value": along}, operation="FLOOR")
    drawn = builder.node("ShaderNodeTexWhiteNoise", {"Vector": vector(cell, piece, seed)}, "Color",
                         noise_dimensions="3D")
    return cell, drawn, along - piece
