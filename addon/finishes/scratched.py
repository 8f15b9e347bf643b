"""Scratched: deep scratches and many hairlines between them, on a surface that is else smooth."""

import math
from types import SimpleNamespace

from ..models.parameters import Slider, add_inputs
from ..operands import absolute, clip, cross, dot, less, maximum, normalize, part, sqrt, vector, x_of, y_of, z_of
from .place import (
    COORDINATES,
    DIFFUSE,
    NORMAL,
    ROUGHNESS,
    band,
    between,
    depth,
    noise,
    place,
    scale,
    tilted,
    to_object,
    to_world,
    whitened,
    whitening,
)

__all__ = ["DRIVES", "TABLE", "build"]

DRIVES = ("Roughness", "Normal", "Diffuse Color")
TABLE = (
    ROUGHNESS, DIFFUSE, scale(3.0, "Deep scratches that could be side by side"),
    depth(0.8, "How far the scratches tilt the surface"),
    Slider(name="amount", socket="Amount", default=0.75, low=0.0, high=1.0, subtype="FACTOR",
           tip="How many of them there are"),
    Slider(name="width", socket="Width", default=0.05, low=0.0001, high=1.0, never_zero=True,
           tip="Width of the widest scratches, as a share of the distance to where the next could be"),
    Slider(name="scuffed", socket="Scratch Roughness", default=0.6, low=0.0, high=1.0, subtype="FACTOR",
           tip="Roughness in the scratches"),
    whitening(0.35), *COORDINATES, NORMAL)

SETS = 5
"""Sets of parallel sheets in space; where a sheet meets the surface there is a scratch."""
FINER, THINNER, SHALLOWER = 4.0, 0.7, 0.8
"""The hairlines: how much closer they lie than the deep scratches, and their width and depth next to those'."""
BEND = 0.16
"""How far the sheets bend, of the distance between them."""


def sheet_normals(count=SETS, turned=0.0):
    """Unit normals of the sets, spread evenly over half a sphere: ``[(x, y, z), …]``.

    By the golden angle, as of Vogel's sunflower; turned about z by so many radians.

    >>> [round(x, 3) for x in sheet_normals(2)[0]]
    [0.661, 0.0, 0.75]
    """
    found = []
    for j in range(count):
        z = 1.0 - (j + 0.5) / count
        angle, r = turned + j * math.pi * (3.0 - math.sqrt(5.0)), math.sqrt(1.0 - z * z)
        found.append((r * math.cos(angle), r * math.sin(angle), z))
    return found


def build(builder):
    """Build the group."""
    s = add_inputs(builder, TABLE)
    n, at = builder.normal(s.normal), place(builder, s)
    facing = to_object(builder, n)
    handled = s.amount * _handled(builder, at, s.scale)
    deep = SimpleNamespace(scale=s.scale, width=s.width, depth=s.depth, amount=handled)
    fine = SimpleNamespace(scale=FINER * s.scale, width=THINNER * s.width, depth=SHALLOWER * s.depth, amount=handled)
    grooves, steep = part("Deep Scratches", "line", "slope")(_layer)(builder, deep, at, facing, _deep_sheets)
    hairs, faint = part("Hairlines", "line", "slope")(_layer)(builder, fine, at, facing, _fine_sheets)
    with builder.frame("Surface"):
        normal = part("Scratched Normal")(tilted)(n, (steep + faint, 1.0))
        mask = maximum(grooves, 0.8 * hairs)
        rough = s.roughness + (s.scuffed - s.roughness) * mask
        pale = whitened(s.diffuse, s.whitening * mask)
    builder.output("Roughness", clip(rough, 0.0, 1.0), description="Roughness, that of the scratches in them")
    builder.output("Normal", normal, description="Normal that the scratches tilt")
    builder.output("Diffuse Color", pale, "COLOR", description="Diffuse colour, paler in the scratches")
    builder.output("Mask", mask, description="1 in the scratches")


@part("Handled")
def _handled(builder, at, scale):
    """Where the surface is touched most, and scratched most: between 0.35 and 1."""
    return 0.35 + 0.65 * band(noise(builder, at, 0.45 * scale, 2.0), 0.38, 0.6)


def _deep_sheets():
    """(normal, a direction in the sheets, seed) of each set of the deep scratches."""
    return _sheets(0.0, 1.0)


def _fine_sheets():
    """Those of the hairlines."""
    return _sheets(1.0, 11.0)


def _sheets(turned, seed):
    return [(across, tuple(float(x) for x in normalize(cross(across, (across[1], across[2], across[0])))), seed + j)
            for j, across in enumerate(sheet_normals(SETS, turned))]


def _layer(builder, s, at, facing, sheets):
    """(1 in the scratches of one size, the slope of the surface in them, ``(..., 3)``)."""
    bent = at + (_bend(builder, at, s.scale) - (0.5, 0.5, 0.5)) * (BEND / s.scale)
    mask, slope = 0.0, 0.0
    for number, (across, aside, seed) in enumerate(sheets()):
        line, rise, direction = _set(builder, s, bent, facing, across, aside, seed)
        mask = maximum(mask, line)
        slope = slope + direction * rise if number else direction * rise
    return mask, slope


def _bend(builder, at, scale):
    """What keeps the sheets from being quite even."""
    return builder.node("ShaderNodeTexNoise", {"Vector": at, "Scale": 0.3 * scale, "Detail": 1.0}, "Color",
                        noise_dimensions="3D")


@part("Set of Scratches", "line", "rise", "direction")
def _set(builder, s, at, facing, across, aside, seed):
    """(1 in the scratches of one set, how far they tilt the surface, and in which direction).

    across, aside  normal of its sheets, and a direction in them, in the axes of the coordinates

    A few are wide and deep, most thin and shallow; each is pointed at both ends.
    """
    x, along = dot(at, across) * s.scale, dot(at, aside) * (0.3 * s.scale)
    cell, drawn, along = _piece(builder, x, along, seed)
    tilt = dot(facing, across)
    steep = sqrt(maximum(1.0 - tilt * tilt, 0.0))
    bold = _boldness(y_of(drawn), s.amount, _ends(along, z_of(drawn)))
    away = (x - cell - (0.1 + 0.8 * x_of(drawn))) / (s.width * maximum(bold * steep, 0.02))
    line, rise = _groove(away, less(y_of(drawn), s.amount) * between(steep, 0.2, 0.4), bold, s.depth)
    return line, rise, to_world(builder, across)


@part("Boldness")
def _boldness(drawn, amount, ends):
    """Width of a scratch next to the widest: most are thin, and all taper to their ends."""
    left = clip(1.0 - drawn / maximum(amount, 0.001), 0.0, 1.0)
    return (0.3 + 0.7 * left * left) * ends


@part("Groove", "line", "rise")
def _groove(away, there, bold, depth):
    """(1 in the groove, how far it tilts the surface) at this distance from its middle, in half its width."""
    line = clip(1.4 - 1.4 * absolute(away), 0.0, 1.0) * there * clip(4.0 * bold, 0.0, 1.0)
    return line, depth * (0.6 + 0.4 * bold) * line * clip(away, -1.0, 1.0)


@part("Ends of a Scratch")
def _ends(along, drawn):
    """How wide a piece is along it, 1 in its middle and 0 at its ends; its length is drawn."""
    share = along / (0.25 + 0.75 * drawn)
    return clip(6.0 * share * (1.0 - share), 0.0, 1.0)


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
