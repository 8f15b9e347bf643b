"""Sandblasted: an even, fine grain."""

from ..models.parameters import add_inputs
from .grain import DRIVES, output, uneven
from .place import COORDINATES, NORMAL, ROUGHNESS, depth, noise, place, scale

__all__ = ["DRIVES", "TABLE", "build"]

TABLE = (
    ROUGHNESS, scale(45.0, "Grains"), depth(0.6, "How deep the grain is"),
    uneven(0.3, "How much the roughness varies from place to place, as where the jet went over twice"),
    *COORDINATES, NORMAL)


def build(builder):
    """Build the group."""
    s = add_inputs(builder, TABLE)
    at = place(builder, s)
    with builder.frame("Grain"):
        height = noise(builder, at, s.scale, 3.0, 0.6)
    output(builder, s, at, height, height, 0.8)
