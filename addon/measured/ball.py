"""A ball under a surrounding, for any isotropic BRDF: rings of pixels, each an integral over half vectors.

The ball is seen from far away.  A ring holds the pixels that are seen at one
angle θv; over it only the surrounding turns, so that the BRDF is evaluated
once a ring, and light by light the pixels are one product of matrices.  Half
vectors are even in the root of their angle, so that sharp highlights have
many; those at one side of the plane of incidence stand for both.
"""

import functools

import numpy as np

from ..bake.colour import delta_e_2000, lab
from .lights import LIGHTS

__all__ = ["LUMINANCE", "Ball", "ball", "below", "displayed", "exposure_of"]

LAST = np.radians(84.0)
"""The outermost ring."""
LEAST_COSINE = 1e-3
MEAN_LUMINANCE = 0.3
"""Of a displayed ball."""
WHITE = 4.0
"""Exposed luminance that is displayed as white."""
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])


class Ball:
    """Directions and weights of a ball's pixels.

    v, l    of every ring's half vectors, one after the other, ``(N, 3)``
    area    what each pixel counts, seen from the front, ``(rings, around)``, sum 1
    """

    def __init__(self, rings, around, tilts, turns):
        self.theta = (np.arange(rings) + 0.5) / rings * LAST
        self.azimuth = (np.arange(around) + 0.5) / around * 2.0 * np.pi
        weight = np.sin(self.theta) * np.cos(self.theta)
        self.area = np.repeat((weight / weight.sum() / around)[:, None], around, axis=1)
        t = (np.arange(tilts) + 0.5) / tilts
        tilt, turn = (a.ravel() for a in np.meshgrid(t * t * np.pi / 2.0, (np.arange(turns) + 0.5) / turns * np.pi,
                                                     indexing="ij"))
        h = np.stack([np.sin(tilt) * np.cos(turn), np.sin(tilt) * np.sin(turn), np.cos(tilt)], axis=-1)
        solid = np.sin(tilt) * np.sqrt(tilt * np.pi / 2.0) * (2.0 / tilts) * (np.pi / turns)
        self._rings = [_ring(theta, h, solid) for theta in self.theta]
        self.v, self.l = (np.concatenate([getattr(ring, x) for ring in self._rings]) for x in "vl")
        self._starts = np.cumsum([0, *(len(ring.weight) for ring in self._rings)])
        self._light = {}

    def image(self, light, f):
        """Linear RGB of the pixels under a light of LIGHTS, ``(rings, around, 3)``.

        f  the BRDF of this ball's v and l, ``(N, 3)``
        """
        if light not in self._light:
            self._light[light] = [self._reaching(LIGHTS[light], ring, theta)
                                  for ring, theta in zip(self._rings, self.theta)]
        parts = zip(self._light[light], self._starts, self._starts[1:])
        return np.stack([reaching @ f[first:last] for reaching, first, last in parts])

    def of_brdf(self, brdf):
        """The BRDF of this ball's v and l, ``(N, 3)``, the mean of both sides of the plane of incidence."""
        return 0.5 * (brdf(self.v, self.l) + brdf(self.v, self.l * (1.0, -1.0, 1.0)))

    def mean(self, values):
        """The mean over what is seen, of ``(rings, around, …)``."""
        return np.tensordot(self.area, values, 2)

    def differences(self, measured, fitted, light):
        """CIEDE2000 of two BRDFs ``(N, 3)`` as displayed, ``(rings, around)``; exposed as the first one asks for."""
        first, second = self.image(light, measured), self.image(light, fitted)
        exposure = exposure_of(self, first)
        return delta_e_2000(lab(displayed(first, exposure)), lab(displayed(second, exposure)))

    def _reaching(self, light, ring, theta):
        """What of the light reaches each pixel of a ring by each half vector, ``(around, n)``."""
        normal = np.stack([np.sin(theta) * np.cos(self.azimuth), np.sin(theta) * np.sin(self.azimuth),
                           np.full_like(self.azimuth, np.cos(theta))], axis=-1)
        along = ((0.0, 0.0, 1.0) - np.cos(theta) * normal) / np.sin(theta)
        frame = np.stack([along, np.cross(normal, along), normal], axis=1).astype(np.float32)
        both = sum(light((ring.l * side).astype(np.float32) @ frame) for side in ((1, 1, 1), (1, -1, 1)))
        return both * ring.weight


class _Ring:
    """v and l ``(n, 3)`` of a ring's half vectors, and cos θl dωl of each."""

    def __init__(self, v, l, weight):
        self.v, self.l, self.weight = v, l, weight


def _ring(theta, h, solid):
    v = np.array([np.sin(theta), 0.0, np.cos(theta)])
    v_h = h @ v
    l = 2.0 * v_h[:, None] * h - v
    seen = (v_h > 0.0) & (l[:, 2] > LEAST_COSINE)
    l = l[seen]
    return _Ring(np.broadcast_to(v, l.shape), l, (4.0 * v_h * solid)[seen] * l[:, 2])


@functools.lru_cache(maxsize=4)
def ball(rings, around, tilts, turns):
    """The Ball of a size, made once.

    >>> from .half_difference import grid
    >>> white = ball(8, 8, 24, 24)
    >>> image = white.image("sun", np.full((len(white.v), 3), 1.0 / np.pi))
    >>> image.shape
    (8, 8, 3)
    """
    return Ball(rings, around, tilts, turns)


def below(values, area, share=0.95):
    """What a share of the area is below: values and what each counts, of one shape.

    >>> below(np.arange(100.0), np.full(100, 0.01))
    94.0
    """
    order = np.argsort(values, axis=None)
    place = np.searchsorted(np.cumsum(area.ravel()[order]), share)
    return float(values.ravel()[order][min(place, values.size - 1)])


def exposure_of(ball_, image):
    """The factor that makes an image's mean luminance MEAN_LUMINANCE."""
    return MEAN_LUMINANCE / max(float(ball_.mean(image) @ LUMINANCE), 1e-9)


def displayed(image, exposure):
    """Linear RGB as a display shows it, [0, 1]: highlights roll off to white (Reinhard et al. 2002, equation 4)."""
    x = np.maximum(image * exposure, 0.0)
    return np.clip(x * (1.0 + x / WHITE**2) / (1.0 + x), 0.0, 1.0)
