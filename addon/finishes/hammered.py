"""Hammered: shallow dimples side by side, with soft ridges between them."""

from ..models.parameters import Slider, add_inputs
from ..operands import clip, exp, log, maximum
from .place import COORDINATES, NORMAL, ROUGHNESS, depth, noise, place, scale

__all__ = ["DRIVES", "TABLE", "build"]

DRIVES = ("Roughness", "Normal")
TABLE = (
    ROUGHNESS, scale(7.0, "Hammer marks"), depth(0.35, "How deep the marks are"),
    Slider(name="soft", socket="Softness", default=0.7, low=0.0, high=1.0, subtype="FACTOR",
           tip="0: sharp ridges between the marks; 1: rounded ones, as of a finished bowl"),
    Slider(name="irregular", socket="Randomness", default=0.85, low=0.0, high=1.0, subtype="FACTOR",
           tip="0: marks in a grid; 1: wherever the hammer fell"),
    *COORDINATES, NORMAL)


def build(builder):
    """Build the group."""
    s = add_inputs(builder, TABLE)
    at = place(builder, s)
    with builder.frame("Marks"):
        first, second = (builder.node("ShaderNodeTexVoronoi", {
            "Vector": at, "Scale": s.scale, "Randomness": s.irregular}, "Distance", voronoi_dimensions="3D",
            feature=feature) for feature in ("F1", "F2"))
        sharp = 40.0 - 34.0 * s.soft
        height = log(exp(sharp * (first * first) * -1.0) + exp(sharp * (second * second) * -1.0)) * (-1.0 / sharp)
    with builder.frame("Surface"):
        grain = noise(builder, at, 3.0 * s.scale, 3.0)
        normal = builder.node("ShaderNodeBump", {
            "Height": height + 0.03 * grain, "Distance": s.depth / s.scale, "Strength": 1.0,
            "Normal": builder.normal(s.normal)})
        rough = clip(s.roughness * (0.85 + 0.3 * grain), 0.0, 1.0)
    builder.output("Roughness", rough, description="Roughness, a little uneven")
    builder.output("Normal", normal, description="Normal of the dimples")
    builder.output("Mask", clip(maximum(height, 0.0), 0.0, 1.0), description="Height: 0 in the dimples, 1 on ridges")
