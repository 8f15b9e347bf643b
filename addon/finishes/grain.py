"""What finishes with a grain share: pits and bumps without a direction."""

from ..models.parameters import Slider
from ..operands import clip
from .place import noise

__all__ = ["DRIVES", "output", "uneven"]

DRIVES = ("Roughness", "Normal")


def uneven(default, tip):
    """The row of how much the roughness varies."""
    return Slider(name="patches", socket="Unevenness", default=default, low=0.0, high=1.0, subtype="FACTOR", tip=tip)


def output(builder, s, at, height, fine, share):
    """What the grain drives.

    height  of the surface, in grains; fine: the part of it that varies the roughness, about 0.5
    share   of the height that the full depth has
    """
    with builder.frame("Surface"):
        patch = noise(builder, at, 0.05 * s.scale, 3.0)
        rough = clip(s.roughness * (1.0 + s.patches * (2.0 * (patch - 0.5) + 1.2 * (fine - 0.5))), 0.0, 1.0)
        normal = builder.node("ShaderNodeBump", {
            "Height": height, "Distance": share * s.depth / s.scale, "Strength": 1.0,
            "Normal": builder.normal(s.normal)})
    builder.output("Roughness", rough, description="Roughness that varies from place to place")
    builder.output("Normal", normal, description="Normal of the grain")
    builder.output("Mask", clip(height, 0.0, 1.0), description="Height of the grain")
