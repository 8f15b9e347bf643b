"""Surroundings that balls are shown in: two that are fitted to and one that is not.

Functions of unit directions ``(..., 3)``, y up and z to the viewer, to
radiance ``(...)``, without colour.
"""

import numpy as np

__all__ = ["FITTED", "HELD_OUT", "LIGHTS"]


def _lamp(d, towards, degrees, edge):
    """A round lamp of an angular radius, with a soft edge; both in degrees."""
    return 1.0 / (1.0 + np.exp(np.minimum((_angle(d, towards) - degrees) / edge, 60.0)))


def _sun(d, towards, degrees):
    """A bell of an angular width."""
    return np.exp(-0.5 * (_angle(d, towards) / degrees) ** 2)


def _angle(d, towards):
    towards = np.asarray(towards, d.dtype)
    return np.degrees(np.arccos(np.clip(d @ (towards / np.linalg.norm(towards)), -1.0, 1.0)))


def studio(d):
    """A large lamp at the left, a small one at the right, one behind, and a ceiling."""
    lamps = 14.0 * _lamp(d, (-0.6, 0.55, 0.6), 16.0, 1.5) + 4.0 * _lamp(d, (0.85, 0.15, 0.35), 14.0, 1.5)
    return lamps + 6.0 * _lamp(d, (0.3, 0.5, -0.8), 20.0, 3.0) + 0.15 + 0.35 / (1.0 + np.exp(-6.0 * d[..., 1]))


def sun(d):
    """A small sun and a little sky."""
    return 130.0 * _sun(d, (-0.5, 0.6, 0.62), 4.0) + 0.12


def window(d):
    """A window at the right, a lamp from above, one behind."""
    lamps = 10.0 * _lamp(d, (0.75, 0.1, 0.65), 14.0, 1.5) + 3.0 * _lamp(d, (-0.4, -0.1, -0.9), 25.0, 4.0)
    return lamps + 40.0 * _sun(d, (-0.2, 0.9, 0.38), 5.0) + 0.1 + 0.2 * (d[..., 1] > 0.0)


LIGHTS = {"studio": studio, "sun": sun, "window": window}
FITTED = ("studio", "sun")
"""Those that the image step compares under."""
HELD_OUT = "window"
"""The one that the report is under."""
