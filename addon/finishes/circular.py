"""Brushed in circles: streaks around the object as on a lathe, and circles on the faces square to the axis."""

from ..models.parameters import add_inputs
from ..operands import dot, length, less, normalize, part, where, x_of, y_of
from .place import on_map, place, to_world
from .streaks import DRIVES, ends, mixed, on_surface, output, streak, table, unit_axis

__all__ = ["DRIVES", "TABLE", "build"]

MIDDLE_OF_THE_MAP = (0.5, 0.5, 0.0)

TABLE = table("The streaks run around this axis of the object, as on a lathe, in circles on the faces square to it. In "
              "a UV map they run around its middle")


def build(builder):
    """Build the group."""
    s = add_inputs(builder, TABLE)
    n, at, axis = builder.normal(s.normal), place(builder, s), unit_axis(s)
    with builder.frame("Sides"):
        side = streak(builder, s, at, dot(at, axis), axis)
        across = on_surface(n, to_world(builder, axis))
    end, across_end, share = _ends(builder, s, n, at, axis)
    output(builder, s, n, mixed(side, end, share), normalize(mixed(across, across_end, share)))


@part("Circular Ends", "streaks", "across", "share")
def _ends(builder, s, n, at, axis):
    """(circles on the faces square to the axis, the direction across them, 1 on those faces)."""
    middle = at - where(less(0.5, s.uv), MIDDLE_OF_THE_MAP, (0.0, 0.0, 0.0))
    outward = middle - axis * dot(middle, axis)
    u, v = on_map(builder, n)
    mapped = u * x_of(outward) + v * y_of(outward)
    across = on_surface(n, where(less(0.5, s.uv), mapped, to_world(builder, outward)))
    share = where(less(0.5, s.uv), 1.0, ends(builder, n, axis))
    return streak(builder, s, normalize(outward), length(outward), axis), across, share
