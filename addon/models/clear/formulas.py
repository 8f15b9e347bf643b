"""A clear body's own formulas, over the operands of addon.operands."""

import numpy as np

from ...operands import absolute, dot, log, maximum, normalize, part, term, where, widen
from ...reflectance.fresnel import dielectric
from ...reflectance.masking import smith_beckmann
from ...reflectance.slopes import beckmann

__all__ = ["evaluate", "reflectance", "relative_index", "sigma_of"]

DARKEST = 1e-6
SMOOTHEST = 1e-4


@part("Absorption σ")
def sigma_of(absorption, depth_colour, depth, concentration, scene_scale):
    """Absorption a scene unit: concentration · (σ − ln(colour)/depth) · scale.

    absorption    σ in 1/m, ``(..., 3)``
    depth_colour  linear RGB after `depth` metres of what comes on top, ``(..., 3)``
    depth, concentration, scene_scale  ``(...)``; the last in metres a unit

    >>> sigma_of(np.zeros(3), np.array([1.0, 0.5, 0.25]), 0.01, 1.0, 1.0).round(1).tolist()
    [0.0, 69.3, 138.6]
    """
    added = log(maximum(depth_colour, DARKEST)) / widen(depth)
    return maximum(absorption - added, 0.0) * widen(concentration * scene_scale)


@term("n/n0")
def relative_index(n, outside):
    """Index inside over that outside.

    >>> float(relative_index(1.5, 1.0))
    1.5
    """
    return n / outside


@part("F of both sides")
def reflectance(cos_theta, n, back):
    """Fresnel reflectance of a face of relative index n, seen from outside or, back = 1.0, from within.

    >>> round(float(reflectance(1.0, 1.5, 0.0)), 4), round(float(reflectance(1.0, 1.5, 1.0)), 4)
    (0.04, 0.04)
    >>> float(reflectance(0.2, 1.5, 1.0))
    1.0
    """
    return dielectric(cos_theta, where(back, 1.0 / n, n))


def evaluate(parameters, n, v, l):
    """The reflection of the outer face in 1/sr, ``(..., 3)``: F D G / (4 N·V N·L), Beckmann and Smith.

    What passes through is no function of two directions at one place, and is not in it.  Of a polished surface it is 0
    everywhere: its mirror has no width.

    >>> from .parameters import Clear
    >>> up = np.array([0.0, 0.0, 1.0])
    >>> evaluate(Clear(roughness=0.5), up, up, up).round(4).tolist()
    [0.0509, 0.0509, 0.0509]
    """
    p, m = parameters, parameters.roughness**2
    cosines = dot(n, v), dot(n, l)
    if m < SMOOTHEST:
        return np.zeros((*np.shape(cosines[0]), 3))
    n_v, n_l = (np.maximum(cosine, 1e-6) for cosine in cosines)
    h = normalize(v + l)
    shape = beckmann(absolute(dot(n, h)), m) * smith_beckmann(n_v, n_l, m) / (4.0 * np.pi * n_v * n_l)
    found = shape * dielectric(absolute(dot(v, h)), p.ior / p.outside)
    return np.where((np.minimum(*cosines) > 0.0)[..., None], found[..., None] * np.array(p.tint), 0.0)
