"""Cast: the coarse skin that a mould of sand leaves, a little wavy, with pits."""

from ..models.parameters import Slider, add_inputs
from .grain import DRIVES, output, uneven
from .place import COORDINATES, NORMAL, ROUGHNESS, band, depth, noise, place, scale

__all__ = ["DRIVES", "TABLE", "build"]

TABLE = (
    ROUGHNESS, scale(22.0, "Bumps"), depth(0.4, "How rough the sand of the mould was"),
    Slider(name="pits", socket="Pits", default=0.4, low=0.0, high=1.0, subtype="FACTOR",
           tip="How deep the small holes are"),
    uneven(0.35, "How much the roughness varies from place to place"),
    *COORDINATES, NORMAL)


def build(builder):
    """Build the group."""
    s = add_inputs(builder, TABLE)
    at = place(builder, s)
    with builder.frame("Grain"):
        skin = noise(builder, at, s.scale, 3.0, 0.45)
        wave = noise(builder, at, 0.12 * s.scale, 2.0)
        hole = builder.node("ShaderNodeTexVoronoi", {"Vector": at, "Scale": 0.6 * s.scale, "Randomness": 1.0},
                            "Distance", voronoi_dimensions="3D", feature="F1")
        height = skin + 2.0 * wave - 0.8 * s.pits * band(hole, 0.3, 0.12)
    output(builder, s, at, height, skin, 0.7)
