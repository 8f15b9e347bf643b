"""The look-up in the table's image: colour over cos θ and thickness, and above it what is absorbed.

Each step comes first as what a material without a body below leaves of it, so that Cycles folds the rest away.
"""

from types import SimpleNamespace

from ...operands import clip, less, maximum, part, sqrt, vector, where, widen
from ..clear.surfaces import FROSTED, began_inside

__all__ = ["absorbed", "body_below", "is_blended", "look", "place_in_table"]

BLACK, WHITE = (0.0, 0.0, 0.0), (1.0, 1.0, 1.0)


@part("Body Below")
def body_below(builder, ior_below, roughness):
    """Of the clear body that a film coats, by name.

    refracts  1 where light is bent: not on its straight way to a lamp, nor where all that is seen is its sheet.  A
              frosted body bends, and so stops, shadow rays that begin in it: what it scatters inwards finds its lamps
              by the faces that it leaves through, and so has none twice
    is_below  1 where there is a body
    index2    square of the index that light comes from, which is 1 outside
    """
    shadow, diffuse = (builder.node("ShaderNodeLightPath", output=f"Is {kind} Ray") for kind in ("Shadow", "Diffuse"))
    back = builder.node("ShaderNodeNewGeometry", output="Backfacing")
    straight = maximum(shadow * (1.0 - less(FROSTED, roughness) * began_inside(builder, back)), diffuse)
    is_below = less(1.0, ior_below)
    refracts = is_below * (1.0 - straight)
    return SimpleNamespace(refracts=refracts, is_below=is_below,
                           index2=where(refracts * back, ior_below * ior_below, 1.0))


@part("Place in the Table")
def place_in_table(builder, d, first, last, columns, rows, height):
    """Where the image holds the thickness d, and which of its rows hold what, by name; across and up it are [0, 1].

    across     of the thickness
    per_row    by the root of cos θ
    reflected  of cos θ = 0
    absorbed   of the same in the upper half, which holds what is absorbed

    The middles of columns are even in thickness, those of rows in the root.
    """
    step = (columns - 1.0) / ((last - first) * columns)
    across = builder.apply("multiply_add", (d, step, 0.5 / columns - first * step))
    return SimpleNamespace(across=across, per_row=(rows - 1.0) / height, reflected=0.5 / height,
                           absorbed=(rows + 0.5) / height)


def look(builder, c, table):
    """Colour of the film at cos θ; from within a body that refracts at the angle outside, or all of the light.

    c      [0, 1]
    table  of :func:`place_in_table` and :func:`body_below`; or with columns and height, where each look blends four
           pixels itself, for renderers that blur images where the place that is looked up changes from pixel to pixel,
           as EEVEE does
    """
    if is_blended(table):
        return _blended(builder, table.across, _up(c, table, table.reflected), table.columns, table.height)
    return _look(builder, c, table)


def absorbed(builder, c, table):
    """The share that it absorbs, as :func:`look` has it."""
    if is_blended(table):
        return _blended(builder, table.across, _up(c, table, table.absorbed), table.columns, table.height)
    return _absorbed(builder, c, table)


def is_blended(table):
    """Whether each look in a table blends four pixels itself."""
    return hasattr(table, "columns")


@part("Film's Colour")
def _look(builder, c, table):
    squared = _squared_outside(builder, c, table.index2)
    seen = _pictured(builder, table.across, _up(sqrt(squared), table, table.reflected))
    return where(table.is_below * less(squared, 0.0), WHITE, seen)


@part("Film's Absorption")
def _absorbed(builder, c, table):
    squared = _squared_outside(builder, c, table.index2)
    taken = _pictured(builder, table.across, _up(sqrt(squared), table, table.absorbed))
    return where(table.is_below * less(squared, 0.0), BLACK, taken)


def _up(c, table, lowest):
    """How far up the image a cosine stands."""
    return sqrt(c) * table.per_row + lowest


@part("Outside")
def _squared_outside(builder, c, index2):
    """cos² of the angle outside by Snell's law, 1 - n² + n² cos² θ; below 0 where the body reflects all."""
    # No product and sum in one node, which Cycles would keep where n is 1.
    return builder.node("ShaderNodeMath", {"Value": 1.0 - index2, "Value_001": (c * c) * index2}, operation="ADD")


@part("Film's Table")
def _pictured(builder, across, up):
    """What the image holds, squared: it holds roots."""
    root = _pixel(builder, across, up, "Linear")
    return root * root


@part("Film's Table, Blended")
def _blended(builder, across, up, columns, height):
    """The same, bilinear of the four pixels around."""
    column, row = clip(across * columns - 0.5, 0.0, columns - 1.0), up * height - 0.5
    i, j = _floor(builder, row), _floor(builder, column)
    u, v = widen(row - i), widen(column - j)
    a, b, c, d = (_middle(builder, j + dj, i + di, columns, height) for di in (0.0, 1.0) for dj in (0.0, 1.0))
    lower, upper = a + v * (b - a), c + v * (d - c)
    root = lower + u * (upper - lower)
    return root * root


def _floor(builder, x):
    return builder.node("ShaderNodeMath", {"Value": x}, operation="FLOOR")


@part("Pixel")
def _middle(builder, column, row, columns, height):
    """The pixel of a column and row, which are whole numbers."""
    return _pixel(builder, (column + 0.5) / columns, (row + 0.5) / height, "Closest")


def _pixel(builder, across, up, interpolation):
    return builder.node("ShaderNodeTexImage", {"Vector": vector(across, up, 0.0)}, "Color",
                        interpolation=interpolation, extension="EXTEND")
