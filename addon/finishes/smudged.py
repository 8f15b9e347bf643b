"""Smudged: fingerprints and the marks of wiping on a surface that is else smooth."""

from ..models.parameters import Slider, add_inputs
from ..operands import clip, dot, length, less, maximum, normalize, part, sin, vector, x_of, y_of, z_of
from .place import COORDINATES, DIFFUSE, NORMAL, ROUGHNESS, band, noise, place, scale, whitened, whitening

__all__ = ["DRIVES", "TABLE", "build"]

DRIVES = ("Roughness", "Diffuse Color")
TABLE = (
    ROUGHNESS, DIFFUSE, scale(2.2, "Fingerprints"),
    Slider(name="greasy", socket="Smudge Roughness", default=0.55, low=0.0, high=1.0, subtype="FACTOR",
           tip="Roughness where the surface is smudged"),
    Slider(name="prints", socket="Fingerprints", default=0.6, low=0.0, high=1.0, subtype="FACTOR",
           tip="How many fingerprints there are"),
    Slider(name="wiped", socket="Wipe Marks", default=0.6, low=0.0, high=1.0, subtype="FACTOR",
           tip="How much was wiped over"),
    whitening(0.12), *COORDINATES, NORMAL)

RIDGES = 190.0
"""Of a fingerprint, in radians of their wave over the width of its cell."""


def build(builder):
    """Build the group."""
    s = add_inputs(builder, TABLE)
    at = place(builder, s)
    marks = maximum(_prints(builder, s, at), _wiped(builder, s, at))
    with builder.frame("Surface"):
        film = 0.3 * band(noise(builder, at, 0.7 * s.scale, 5.0, 0.6), 0.42, 0.7)
        mask = clip(maximum(marks, film), 0.0, 1.0)
        rough = s.roughness + (s.greasy - s.roughness) * mask
        pale = whitened(s.diffuse, s.whitening * mask)
    builder.output("Roughness", clip(rough, 0.0, 1.0), description="Roughness, that of the smudges in them")
    builder.output("Diffuse Color", pale, "COLOR", description="Diffuse colour, paler where the surface is smudged")
    builder.output("Mask", mask, description="1 where the surface is smudged")


@part("Fingerprints")
def _prints(builder, s, at):
    """Fingerprints: ovals of ridges that curve about points beside them."""
    def cell(output):
        return builder.node("ShaderNodeTexVoronoi", {"Vector": at, "Scale": s.scale, "Randomness": 0.9}, output,
                            voronoi_dimensions="3D", feature="F1")
    drawn = cell("Color")
    local = (at - cell("Position")) * s.scale
    finger = normalize(drawn - (0.5, 0.5, 0.5))
    bent = builder.node("ShaderNodeTexNoise", {"Vector": at, "Scale": 1.6 * s.scale, "Detail": 1.0}, "Color",
                        noise_dimensions="3D") - (0.5, 0.5, 0.5)
    core = local + finger * 0.36 + bent * 0.26
    ridges = band(sin(length(core - finger * (0.35 * dot(core, finger))) * RIDGES), -0.7, 0.7)
    oval = length(local - finger * (0.4 * dot(local, finger)) + bent * 0.08)
    pressed = band(noise(builder, at, 3.0 * s.scale, 3.0, 0.6), 0.25, 0.55) * band(oval, 0.3, 0.2)
    return less(x_of(drawn), s.prints) * pressed * (0.4 + 0.6 * ridges)


@part("Wipe Marks")
def _wiped(builder, s, at):
    """Wipe marks: broad curved smears with fine streaks in them."""
    turn = builder.node("ShaderNodeTexNoise", {"Vector": at, "Scale": 0.22 * s.scale, "Detail": 0.0}, "Color",
                        noise_dimensions="3D")
    bent = at * s.scale + (turn - (0.5, 0.5, 0.5)) * 6.0
    drawn = vector(x_of(bent), y_of(bent) - 0.9 * x_of(bent), z_of(bent))
    streak = noise(builder, vector(0.05 * x_of(drawn), 3.5 * y_of(drawn), 3.5 * z_of(drawn)), 1.6, 4.0, 0.65)
    least = 0.62 - 0.24 * s.wiped
    smear = band(noise(builder, vector(0.25 * x_of(drawn), y_of(drawn), z_of(drawn)), 0.5, 2.0), least, least + 0.15)
    return smear * (0.15 + 0.85 * band(streak, 0.36, 0.66)) * 0.75
