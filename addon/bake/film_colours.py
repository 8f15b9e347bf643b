"""The colour of a stack at every angle of a grid and every thickness of an even range, fast."""

import numpy as np

from ..reflectance import stack as optics
from ..spectra.observers import WAVELENGTH_NM
from .colour import delta_e_2000, lab
from .film_recurrence import BLOCK, Recurrence

__all__ = ["colours", "exact_colours", "stepped_colours", "step_for", "steps_for", "coarse_weights"]

STEPS = (6, 4, 2)
"""Wavelength steps in nm that may do; else it is 1."""
STEP_TOLERANCE = 0.05
"""CIEDE2000 from spectra at every nm that a wider step may have."""
TRIED = 8, 33
"""Angles and thicknesses that it is tried at."""
GRAZING = 0.07
"""cos θ below which steps are chosen apart: faces reflect so much there that a film's spectra have sharp lines."""
LEAST_COS_THETA = np.cos(np.radians(89.0))
"""Beyond 89° no colours are compared."""


def stepped_colours(stack, viewing, cos_theta, count, low=None, high=None, steps=None, of="reflected", progress=None):
    """:func:`colours` with the wavelength steps that the stack needs, grazing angles and the others apart.

    steps     (of grazing angles, of others), as :func:`steps_for` finds them, by default for these angles
    progress  function that is told the share that is done
    """
    grazing = cos_theta < GRAZING
    found, done = np.empty((len(cos_theta), count, 3), np.float32), 0.0
    for band, step in zip((grazing, ~grazing), steps or (None, None)):
        if not band.any():
            continue
        step, share = step or step_for(stack, viewing, cos_theta[band], of), float(band.mean())
        found[band] = colours(stack, viewing, cos_theta[band], count, low, high, step, of,
                              _part_of(progress, done, share))
        done += share
    return found


def steps_for(stack, viewing, of="reflected"):
    """(wavelength step in nm at grazing angles, at others) that a stack needs; see :func:`step_for`."""
    return tuple(step_for(stack, viewing, np.array(ends) ** 2, of)
                 for ends in ((0.0, GRAZING**0.5), (GRAZING**0.5, 1.0)))


def _part_of(progress, done, share):
    """What tells progress of a part of the work, which is a share of it after what is done."""
    return progress and (lambda part: progress(done + share * part))


def step_for(stack, viewing, cos_theta, of="reflected"):
    """The widest wavelength step in nm, 6, 4, 2 or 1, that keeps colours to 0.05 CIEDE2000 where it is tried.

    cos_theta  ``(A,)``, of which 8 are tried, up to 89°

    The phase turns with 4π n d/λ, so the thicker the films the narrower: with
    cubics between, 6 nm do for oxides on metal or silicon to 1 µm, 2 nm to
    3 µm, 1 nm for mirrors of many layers.
    """
    angles, thicknesses = TRIED
    low, high = np.maximum([cos_theta.min(), cos_theta.max()], LEAST_COS_THETA)
    tried = np.linspace(np.sqrt(low), np.sqrt(high), angles) ** 2

    def at(step):
        return lab(colours(stack, viewing, tried, thicknesses, step=step, of=of).astype(float), viewing.space)
    fine = at(1)
    return next((step for step in STEPS if delta_e_2000(fine, at(step)).max() <= STEP_TOLERANCE), 1)


def coarse_weights(weights, step):
    """(wavelengths ``(V,)``, weights ``(V, 3)``) for spectra at every step-th nm, with a cubic through four between.

    weights  what each nm adds to linear RGB, ``(421, 3)``
    step     in nm, a divisor of 420

    >>> wavelength, coarse = coarse_weights(np.ones((421, 3)), 4)
    >>> wavelength.size, [round(float(x), 6) for x in (coarse.T @ np.ones(106))]
    (106, [421.0, 421.0, 421.0])
    """
    if step == 1:
        return WAVELENGTH_NM, weights
    wavelength = WAVELENGTH_NM[::step]
    at = (WAVELENGTH_NM - wavelength[0]) / step
    first = np.clip(np.floor(at).astype(int) - 1, 0, wavelength.size - 4)
    x = at - first
    shares = np.stack([(1.0 - x) * (2.0 - x) * (3.0 - x) / 6.0, x * (2.0 - x) * (3.0 - x) / 2.0,
                       x * (x - 1.0) * (3.0 - x) / 2.0, x * (x - 1.0) * (x - 2.0) / 6.0])
    coarse = np.zeros((wavelength.size, weights.shape[1]))
    for place, share in enumerate(shares):
        np.add.at(coarse, first + place, share[:, None] * weights)
    return wavelength, coarse


def exact_colours(stack, viewing, cos_theta, thickness_nm, of="reflected"):
    """Linear RGB before gamut mapping, at every nm in double precision, ``(..., 3)``: the slow way, for single looks.

    cos_theta, thickness_nm  that broadcast to ``(...)``
    of                       "reflected" or "transmitted"
    """
    spectrum = (slice(None),) + (None,) * np.broadcast(cos_theta, thickness_nm).ndim
    indices = [index[spectrum] for index in stack.indices(WAVELENGTH_NM)]
    powers = optics.powers(indices, stack.thicknesses(thickness_nm), cos_theta, WAVELENGTH_NM[spectrum])
    return np.moveaxis(np.tensordot(viewing.weights, getattr(powers, of), axes=(0, 0)), 0, -1)


def colours(stack, viewing, cos_theta, count, low=None, high=None, step=1, of="reflected",
            progress=None):
    """Linear RGB before gamut mapping, ``(A, D, 3)`` in single precision.

    stack      a Stack with a film that varies
    viewing    a Viewing
    cos_theta  ``(A,)``
    count      D even thicknesses from low to high, the ends of the stack's range where not given
    step       of the wavelength in nm
    of         "reflected" or "transmitted"
    progress   function that is told the share that is done
    """
    low, high = (end if given is None else given for given, end in zip((low, high), stack.thickness_range_nm))
    wavelength, weights = coarse_weights(viewing.weights, step)
    recurrence = Recurrence(stack, cos_theta, wavelength, np.linspace(low, high, count))
    weights = np.ascontiguousarray(weights.T, np.float32)
    found = np.empty((count, 3, len(cos_theta)), np.float32)
    for start in range(0, count, BLOCK):
        found[start:start + BLOCK] = (weights @ recurrence.block(of))[:count - start]
        if progress:
            progress(min(1.0, (start + BLOCK) / count))
    return found.transpose(2, 0, 1)
