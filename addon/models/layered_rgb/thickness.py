"""Fields of the layer's thickness, Perlin noise or a texture, and the lower normal tilted along them."""

from ...operands import clip, dot, less, tan, where
from ..parameters import add_inputs
from .parameters import TABLE, THICKNESS_GROUP

__all__ = ["build"]

NOTHING = 1e-12
SPREAD = 1.6
"""Noise keeps to the middle of [0, 1]: spread by this much it reaches both thicknesses."""


def build(builder):
    """Build the group."""
    sockets = add_inputs(builder, TABLE, group=THICKNESS_GROUP)
    least, greatest, scale = sockets.least, sockets.greatest, sockets.noise_scale
    with builder.frame("Field"):
        own = builder.node("ShaderNodeTexCoord", output="Object")
        at = where(less(dot(sockets.coordinates, sockets.coordinates), NOTHING), own, sockets.coordinates)
        noise = builder.node("ShaderNodeTexNoise", {
            "Vector": at, "Scale": scale, "Detail": sockets.noise_detail}, "Fac")
        noise = clip(0.5 + SPREAD * (noise - 0.5), 0.0, 1.0)
        field = noise + sockets.texture_share * (sockets.texture - noise)
    with builder.frame("Lower normal"):
        tilted = builder.node("ShaderNodeBump", {
            "Height": field, "Distance": tan(sockets.field_deviation) / scale, "Strength": 1.0,
            "Normal": builder.normal(sockets.field_normal)})
    builder.output("Thickness", least + (greatest - least) * field, description="Thickness in nanometres")
    builder.output("Field", field, description="The field between 0 and 1")
    builder.output("Lower Normal", tilted,
                   description="Normal n1 of the lower boundary, tilted along the gradient")
