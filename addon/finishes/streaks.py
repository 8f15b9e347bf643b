"""What brushed finishes share: streaks, and the direction across which they scatter light.

Streaks lie where slices across an axis meet the surface: so they are as long on a ball as on a box.  The faces square
to the axis, which a slice would only graze, are brushed by themselves.
"""

from ..models.parameters import Direction, Slider, Triple
from ..operands import absolute, clip, dot, less, normalize, part, where
from .place import (
    COORDINATES,
    DIFFUSE,
    NORMAL,
    NOTHING,
    ROUGHNESS,
    band,
    depth,
    noise,
    scale,
    tilted,
    to_object,
    whitened,
    whitening,
)

__all__ = ["DRIVES", "ends", "mixed", "on_surface", "output", "paler", "streak", "table", "unit_axis"]

DRIVES = ("Roughness", "Normal", "Tangent", "Diffuse Color")
ENDS = (0.72, 0.88)
"""Cosines to the axis between which a face becomes an end."""
SPREAD, OCTAVES, FINENESS = 4.0, 4.0, 0.75
"""Noise keeps to the middle of [0, 1]: spread by this much it reaches both ends; its octaves, and their strength."""
STEEPEST = 0.4
"""Rise of a streak at the full depth."""


def table(axis_tip):
    """The rows of a group of streaks about an axis."""
    return (
        ROUGHNESS, DIFFUSE, scale(50.0, "Streaks"), depth(0.5, "How far the streaks tilt the surface"),
        Slider(name="uneven", socket="Unevenness", default=0.3, low=0.0, high=1.0, subtype="FACTOR",
               tip="How much the roughness varies from streak to streak"),
        Slider(name="stretch", socket="Length", default=60.0, low=1.0, high=10000.0, never_zero=True,
               tip="Length of the streaks, in their widths"),
        Triple(name="axis", socket="Axis", default=(0.0, 0.0, 1.0), low=-1.0, high=1.0, tip=axis_tip),
        whitening(0.3), *COORDINATES, NORMAL,
        Direction(name="tangent", symbol="T", socket="Tangent",
                  tip="Direction across the streaks, in which they scatter light; their own where nothing is plugged "
                      "in"))


@part("Axis")
def unit_axis(s):
    """The axis under the sockets' settings; in a UV map square to it."""
    return where(less(0.5, s.uv), (0.0, 0.0, 1.0), normalize(s.axis))


def ends(builder, n, axis):
    """1 on the faces square to the axis."""
    return band(absolute(dot(to_object(builder, n), axis)), *ENDS)


def on_surface(n, direction):
    """The unit direction on the surface that is nearest to a direction."""
    return normalize(direction - n * dot(n, direction))


def mixed(a, b, share):
    """a where the share is 0, b where it is 1."""
    return a + (b - a) * share


@part("Streaks")
def streak(builder, s, at, height, axis):
    """Streaks over a height above slices, about -1 to 1, which change slowly along the slices.

    at    place along the slices, ``(..., 3)``
    axis  along which the height is, or a direction in which nothing else varies
    """
    slow = (at - axis * dot(at, axis)) * (s.scale / s.stretch)
    return clip(SPREAD * (noise(builder, slow + axis * (height * s.scale), 1.0, OCTAVES, FINENESS) - 0.5), -1.0, 1.0)


@part("Paler Streaks")
def paler(diffuse, most, mask):
    """The diffuse colour, paler on the crests of the streaks."""
    return whitened(diffuse, most * mask * mask)


def output(builder, s, n, streaks, across):
    """What the streaks drive."""
    with builder.frame("Surface"):
        across = where(less(dot(s.tangent, s.tangent), NOTHING), across, s.tangent)
        rough = clip(s.roughness * (1.0 + s.uneven * streaks), 0.0, 1.0)
        tilt = tilted(n, (across, STEEPEST * s.depth * streaks))
        mask = 0.5 + 0.5 * streaks
        pale = paler(s.diffuse, s.whitening, mask)
    builder.output("Roughness", rough, description="Roughness that varies from streak to streak")
    builder.output("Normal", tilt, description="Normal that the streaks tilt")
    builder.output("Tangent", across, description="Direction across the streaks, in which they scatter light")
    builder.output("Diffuse Color", pale, "COLOR", description="Diffuse colour, paler in the streaks")
    builder.output("Mask", mask, description="The streaks, between 0 and 1")
