"""Small pictures of a material, drawn with numpy: a lit ball, and its colours over the angle.

They stand in the picker where no rendered thumbnail has been shipped, and show what was baked.
"""

import functools

import numpy as np

from ...bake.colour import rgb_to_xyz
from ...bake.srgb import encoded
from ...models import named
from ...models.making import made

__all__ = ["SIZE", "ball", "of_swatch", "plain", "strip"]

SIZE = 64
KEY, FILL = (-0.45, 0.65, 0.61), (0.75, 0.1, 0.65)
BALL = 0.94
"""Radius of the ball in a picture that reaches from −1 to 1."""


def ball(what):
    """A ball of a material, lit by two soft lamps under a bright sky.

    what  what :func:`addon.catalogue.resolving.resolve` understands

    Returns sRGB times alpha, and alpha, ``(SIZE, SIZE, 4)``, bottom row first.  Raises FacetFilmError for an unknown
    name.
    """
    record = made(preset=what)
    x, y, z, cover = _geometry()
    look = named(record.model).look(record.parameters, (x, y, z))
    seen, arriving = _light(round(float(look.slope), 2))
    fresnel = look.mirror + (1.0 - look.mirror) * ((1.0 - z) ** 5)[..., None]
    colour = look.specular * fresnel * seen[..., None] + look.diffuse * arriving[..., None]
    return np.concatenate([_shown(colour) * cover[..., None], cover[..., None]], axis=-1).astype(np.float32)


def strip(cos_theta, rgb, space="Rec.709"):
    """The colours from 0° on the left to 90° on the right, ``(SIZE, SIZE, 4)``.

    cos_theta  ascending, ``(K,)``
    rgb        linear in the space, ``(K, 3)``
    """
    c = np.cos(np.radians(np.linspace(0.0, 90.0, SIZE)))
    row = np.stack([np.interp(c, cos_theta, channel) for channel in np.transpose(rgb)], axis=-1)
    return _with_alpha(np.broadcast_to(_shown(row, space), (SIZE, SIZE, 3)))


def of_swatch(rgb, space="Rec.709"):
    """The colours of an addon.models.model.Swatch, its first row at the top, ``(SIZE, SIZE, 4)``."""
    rows, columns = (np.linspace(0, size - 1, SIZE).round().astype(int) for size in rgb.shape[:2])
    return _with_alpha(_shown(rgb[rows[::-1, None], columns], space))


def plain(rgb, space="Rec.709"):
    """One colour, ``(SIZE, SIZE, 4)``; rgb ``(3,)`` is linear in the space."""
    return _with_alpha(np.broadcast_to(_shown(np.array(rgb), space), (SIZE, SIZE, 3)))


@functools.lru_cache(maxsize=1)
def _geometry():
    """The ball's normal x, y, z, and how much of each pixel it covers, ``(SIZE, SIZE)`` each."""
    across = (np.arange(SIZE) + 0.5) / SIZE * 2.0 - 1.0
    x, y = np.meshgrid(across / BALL, across / BALL)
    r = np.hypot(x, y)
    inside = np.minimum(1.0, 0.999 / np.maximum(r, 1e-6))
    x, y = x * inside, y * inside
    z = np.sqrt(1.0 - x * x - y * y)
    return x, y, z, np.clip((1.0 - r) * BALL * SIZE / 2.0 + 0.5, 0.0, 1.0)


@functools.lru_cache(maxsize=64)
def _light(rough):
    """(what a mirror of this roughness sees, what a diffuse surface gets), ``(SIZE, SIZE)`` each."""
    x, y, z, _ = _geometry()
    mirrored = (2.0 * z * x, 2.0 * z * y, 2.0 * z * z - 1.0)
    width = 0.12 + rough
    seen = 0.12 + 0.5 / (1.0 + np.exp(-mirrored[1] / (0.1 + rough)))
    arriving = 0.25 + 0.15 * y
    for (lx, ly, lz), power in ((KEY, 1.0), (FILL, 0.35)):
        lobe = np.exp((mirrored[0] * lx + mirrored[1] * ly + mirrored[2] * lz - 1.0) / width ** 2)
        seen = seen + power * lobe * (0.6 + 0.5 / (1.0 + 8.0 * rough))
        arriving = arriving + power * 0.7 * np.maximum(x * lx + y * ly + z * lz, 0.0)
    return seen, arriving


def _shown(rgb, space="Rec.709"):
    """Linear RGB as the screen's sRGB, brought into [0, 1]."""
    if space != "Rec.709":
        rgb = rgb @ np.linalg.solve(rgb_to_xyz("Rec.709"), rgb_to_xyz(space)).T
    return encoded(rgb)


def _with_alpha(rgb):
    return np.concatenate([rgb, np.ones((SIZE, SIZE, 1))], axis=-1).astype(np.float32)
