"""Brushed straight: streaks around the object, and straight ones on the faces square to the axis."""

from ..models.parameters import add_inputs
from ..operands import cross, dot, less, normalize, part, vector, where, x_of, y_of, z_of
from .place import on_map, place, to_world
from .streaks import DRIVES, ends, mixed, on_surface, output, streak, table, unit_axis

__all__ = ["DRIVES", "TABLE", "build"]

ACROSS_THE_MAP = (0.0, 1.0, 0.0)

TABLE = table("The streaks run around this axis of the object; faces square to it are brushed straight. In a UV map "
              "they run along U")


def build(builder):
    """Build the group."""
    s = add_inputs(builder, TABLE)
    n, at, axis = builder.normal(s.normal), place(builder, s), unit_axis(s)
    side, across = _sides(builder, s, n, at, axis)
    end, across_end, share = _ends(builder, s, n, at, axis)
    output(builder, s, n, mixed(side, end, share), normalize(mixed(across, across_end, share)))


@part("Brushed Sides", "streaks", "across")
def _sides(builder, s, n, at, axis):
    """(streaks around the axis, the direction across them)."""
    upright = where(less(0.5, s.uv), ACROSS_THE_MAP, axis)
    _, v = on_map(builder, n)
    across = on_surface(n, where(less(0.5, s.uv), v, to_world(builder, axis)))
    return streak(builder, s, at, dot(at, upright), upright), across


@part("Brushed Ends", "streaks", "across", "share")
def _ends(builder, s, n, at, axis):
    """(straight streaks on the faces square to the axis, the direction across them, 1 on those faces)."""
    aside = normalize(cross(axis, vector(z_of(axis), x_of(axis), y_of(axis))))
    share = ends(builder, n, axis) * less(s.uv, 0.5)
    return streak(builder, s, at, dot(at, aside), aside), on_surface(n, to_world(builder, aside)), share
