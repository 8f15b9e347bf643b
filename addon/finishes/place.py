"""Where a finish's marks are, and along which direction: what all groups of finishes share."""

from ..models.parameters import Colour, Direction, Number, Slider
from ..operands import clip, cross, dot, length, less, normalize, part, vector, where, widen

__all__ = ["COORDINATES", "DIFFUSE", "NORMAL", "ROUGHNESS", "band", "between", "depth", "eased", "noise", "on_map",
           "place", "scale", "tilted", "to_object", "to_world", "whitened", "whitening"]

NOTHING = 1e-12
WHITE = (0.8, 0.8, 0.8)
"""Albedo of what is broken into fine pieces."""

ROUGHNESS = Number(
    name="roughness", socket="Roughness", default=0.3, low=0.0, high=1.0, subtype="FACTOR",
    tip="Mean roughness of the surface, which the marks vary; its square is the rms slope m of the facets")
DIFFUSE = Colour(
    name="diffuse", socket="Diffuse Color", default=(0.8, 0.8, 0.8), low=0.0, high=1.0,
    tip="Colour beneath the surface of plastic and stone, which the marks make paler; a metal has none")
NORMAL = Direction(
    name="normal", symbol="N", socket="Normal", tip="Shading normal; the surface's own where nothing is plugged in")
COORDINATES = (
    Slider(name="uv", socket="UV", default=0.0, low=0.0, high=1.0, subtype="FACTOR",
           tip="0: marks in the object's own axes, in scene units whatever its scale, without seams; 1: in its UV map"),
    Direction(name="coordinates", socket="Vector",
              tip="Coordinates of the marks, a Mapping node's for instance; the object's or its UV map's where nothing "
                  "is plugged in"),
)


def scale(default, what):
    """The row of how fine the marks are."""
    return Slider(name="scale", socket="Scale", default=default, low=0.001, high=100000.0, never_zero=True,
                  tip=f"{what} per scene unit, or per width of the UV map: higher is finer")


def depth(default, what):
    """The row of how strong they are."""
    return Slider(name="depth", socket="Depth", default=default, low=0.0, high=1.0, subtype="FACTOR", tip=what)


def whitening(default):
    """The row of how pale they are on plastic and stone, which scatter light where they are broken or greasy."""
    return Slider(name="whitening", socket="Whitening", default=default, low=0.0, high=1.0, subtype="FACTOR",
                  tip="How much paler the marks make plastic and stone; metals stay as they are")


# --- Coordinates ---

def place(builder, sockets):
    """The coordinates of the marks under the sockets' settings."""
    return _coordinates(builder, sockets.uv, sockets.coordinates)


@part("Coordinates")
def _coordinates(builder, uv, given):
    """Those of the object or of its UV map, where none are given."""
    own = builder.node("ShaderNodeTexCoord", output="Object") * _size(builder)
    own = where(less(0.5, uv), builder.node("ShaderNodeTexCoord", output="UV"), own)
    return where(less(dot(given, given), NOTHING), own, given)


def _size(builder):
    """Scene units a unit of the object's axes: what an object's scale stretches is not stretched."""
    return vector(*(length(to_world(builder, axis)) for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))))


def to_world(builder, direction):
    """A vector of the object's axes in the world's."""
    return builder.node("ShaderNodeVectorTransform", {"Vector": direction}, vector_type="VECTOR",
                        convert_from="OBJECT", convert_to="WORLD")


def to_object(builder, direction):
    """A normal of the world in the object's axes."""
    return normalize(builder.node("ShaderNodeVectorTransform", {"Vector": direction}, vector_type="NORMAL",
                                  convert_from="WORLD", convert_to="OBJECT"))


def on_map(builder, normal):
    """(direction of U, direction of V) of the UV map on the surface, unit vectors in the world."""
    u = builder.node("ShaderNodeTangent", direction_type="UV_MAP")
    v = normalize(cross(normal, u))
    return cross(v, normal), v


# --- Patterns ---

def noise(builder, at, scale=1.0, detail=2.0, roughness=0.5, w=None):
    """Perlin noise about 0.5, ``(...)``; with w in four dimensions."""
    inputs = {"Vector": at, "Scale": scale, "Detail": detail, "Roughness": roughness}
    if w is None:
        return builder.node("ShaderNodeTexNoise", inputs, "Fac", noise_dimensions="3D")
    return builder.node("ShaderNodeTexNoise", {**inputs, "W": w}, "Fac", noise_dimensions="4D")


def between(x, low, high):
    """0 where x is low or below, 1 where it is high or above, straight between."""
    return clip((x - low) / (high - low), 0.0, 1.0)


def eased(x):
    """x from 0 to 1 with level ends: x²(3 − 2x)."""
    return x * x * (3.0 - 2.0 * x)


@part("Band")
def band(x, low, high):
    """The same with level ends."""
    return eased(between(x, low, high))


def whitened(colour, share):
    """A diffuse colour, and by this share white that scatters before light gets to what is coloured.

    >>> import numpy as np
    >>> whitened(np.array([0.0, 0.2, 0.8]), 0.5).round(3)
    array([0.4, 0.5, 0.8])
    """
    return colour + (colour * -1.0 + WHITE) * widen(share)


def tilted(normal, *slopes):
    """The normal of a surface that rises along unit directions: (direction, rise) pairs."""
    found = normal
    for direction, rise in slopes:
        found = found - direction * rise
    return normalize(found)
