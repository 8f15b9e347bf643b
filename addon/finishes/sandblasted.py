"""Sandblasted: an even, fine grain."""

from ..models.parameters import add_inputs
from . import grain
from .place import COORDINATES, DIFFUSE, NORMAL, ROUGHNESS, band, depth, noise, place, scale, whitened, whitening

__all__ = ["DRIVES", "TABLE", "build"]

DRIVES = (*grain.DRIVES, "Diffuse Color")
TABLE = (
    ROUGHNESS, DIFFUSE, scale(80.0, "Grains"), depth(0.5, "How deep the grain is"),
    grain.uneven(0.3, "How much the roughness varies from place to place, as where the jet went over twice"),
    whitening(0.15), *COORDINATES, NORMAL)


def build(builder):
    """Build the group."""
    s = add_inputs(builder, TABLE)
    at = place(builder, s)
    with builder.frame("Grain"):
        height = noise(builder, at, s.scale, 3.0, 0.6)
    grain.output(builder, s, at, height, height, 0.8)
    pale = whitened(s.diffuse, s.whitening * band(height, 0.3, 0.7))
    builder.output("Diffuse Color", pale, "COLOR", description="Diffuse colour, paler on the grains")
