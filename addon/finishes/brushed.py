"""Brushed straight: streaks around the object, and straight ones on the faces square to the axis."""

from ..models.parameters import add_inputs
from ..operands import cross, dot, less, normalize, vector, where, x_of, y_of, z_of
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
    with builder.frame("Sides"):
        upright = where(less(0.5, s.uv), ACROSS_THE_MAP, axis)
        side = streak(builder, s, at, dot(at, upright), upright)
        _, v = on_map(builder, n)
        across = on_surface(n, where(less(0.5, s.uv), v, to_world(builder, axis)))
    with builder.frame("Ends"):
        aside = normalize(cross(axis, vector(z_of(axis), x_of(axis), y_of(axis))))
        end = streak(builder, s, at, dot(at, aside), aside)
        across_end = on_surface(n, to_world(builder, aside))
        share = ends(builder, n, axis) * less(s.uv, 0.5)
    output(builder, s, n, mixed(side, end, share), normalize(mixed(across, across_end, share)))
