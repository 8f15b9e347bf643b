"""Worn edges: where a dull, tarnished surface is rubbed bright, at its edges and in patches."""

from ..models.parameters import Colour, Slider, add_inputs
from ..operands import clip, maximum, part
from .place import COORDINATES, NORMAL, ROUGHNESS, band, noise, place, scale

__all__ = ["DRIVES", "TABLE", "build"]

DRIVES = ("Roughness", "Tint")
TABLE = (
    ROUGHNESS,
    Colour(name="tint", socket="Tint", default=(1.0, 1.0, 1.0), low=0.0, high=1.0,
           tip="Colour that dyes the surface where it is rubbed bright; elsewhere it is darker"),
    scale(5.0, "Patches"),
    Slider(name="edge", socket="Edge Width", default=0.2, low=0.0, high=1000.0,
           tip="How far from an edge the surface is rubbed, in scene units"),
    Slider(name="bright", socket="Edge Roughness", default=0.4, low=0.0, high=1.0, subtype="FACTOR",
           tip="Roughness where the surface is rubbed bright"),
    Slider(name="tarnish", socket="Tarnish", default=0.8, low=0.0, high=1.0, subtype="FACTOR",
           tip="How much darker the surface is where it is not rubbed"),
    Slider(name="wear", socket="Wear", default=0.5, low=0.0, high=1.0, subtype="FACTOR",
           tip="How much of the surface is rubbed bright: 0 the edges alone"),
    Slider(name="broken", socket="Unevenness", default=0.5, low=0.0, high=1.0, subtype="FACTOR",
           tip="How ragged the rubbed edges are"),
    *COORDINATES, NORMAL)
SAMPLES = 8
"""Rays that look for the other side of an edge."""
RUBBED = (0.04, 0.16)
"""Share of the rays that find it where rubbing begins and is complete; on an edge of 90° it is a half."""


def build(builder):
    """Build the group."""
    s = add_inputs(builder, TABLE)
    at, n = place(builder, s), builder.normal(s.normal)
    coarse = noise(builder, at, s.scale, 5.0, 0.65)
    fine = noise(builder, at, 7.0 * s.scale, 4.0, 0.65)
    edge = _edges(builder, s.edge, s.broken * (0.6 * coarse + 0.6 * fine - 0.6), n)
    with builder.frame("Patches"):
        least = 0.68 - 0.16 * s.wear
        patch = s.wear * band(coarse + 0.3 * (fine - 0.5), least, least + 0.1)
    with builder.frame("Surface"):
        mask = maximum(edge * (0.7 + 0.3 * fine), patch)
        dull = s.roughness * (0.85 + 0.3 * fine)
        rough = clip(dull + (s.bright - dull) * mask, 0.0, 1.0)
        tint = s.tint * (1.0 - s.tarnish * (1.0 - mask))
    builder.output("Roughness", rough, description="Roughness, low where the surface is rubbed")
    builder.output("Tint", tint, "COLOR", description="Tint, dark where the surface is not rubbed")
    builder.output("Mask", mask, description="1 where the surface is rubbed bright")


@part("Rubbed Edges")
def _edges(builder, width, ragged, n):
    """1 at edges."""
    behind = builder.node("ShaderNodeAmbientOcclusion", {"Distance": width, "Normal": n}, "AO",
                          samples=SAMPLES, inside=True, only_local=True)
    return band(1.0 - behind + ragged, *RUBBED)
