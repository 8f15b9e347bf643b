"""The colour of a stack at every angle of a grid and every thickness of an even range, fast.

What is between the films that vary does not depend on the thickness: it is one
matrix a wavelength and angle.  Along the thickness each varying film's z is a
power of one number, so a table takes multiplications only: a recurrence in
single precision, for numbers of which no larger one is subtracted.
"""

import numpy as np

from ..reflectance import stack as optics
from ..spectra.observers import WAVELENGTH_NM
from .colour import delta_e_2000, lab

__all__ = ["colours", "exact_colours", "stepped_colours", "step_for", "coarse_weights"]

BLOCK = 16
"""Thicknesses calculated at once: the numbers of a block stay in a processor's cache."""
STEPS = (6, 4, 2)
"""Wavelength steps in nm that may do; else it is 1."""
STEP_TOLERANCE = 0.05
"""CIEDE2000 from spectra at every nm that a wider step may have."""
TRIED = 8, 33
"""Angles and thicknesses that it is tried at."""
GRAZING = 0.07
"""cos θ below which steps are chosen apart: both faces of a film reflect so much there that its spectra have sharp lines."""
LEAST_COS_THETA = np.cos(np.radians(89.0))
"""Beyond 89° no colours are compared."""


def stepped_colours(stack, viewing, cos_theta, count):
    """:func:`colours` with the wavelength steps that the stack needs, grazing angles and the others apart."""
    grazing = cos_theta < GRAZING
    found = np.empty((len(cos_theta), count, 3), np.float32)
    for band in (grazing, ~grazing):
        if band.any():
            found[band] = colours(stack, viewing, cos_theta[band], count, step=step_for(stack, viewing, cos_theta[band]))
    return found


def step_for(stack, viewing, cos_theta):
    """The widest wavelength step in nm, 6, 4, 2 or 1, that keeps colours to 0.05 CIEDE2000 where it is tried.

    cos_theta  ``(A,)``, of which 8 are tried, up to 89°

    The phase turns with 4π n d/λ, so the thicker the films the narrower: with
    cubics between, 6 nm do for oxides on metal or silicon to 1 µm, 2 nm to
    3 µm, 1 nm for mirrors of many layers.
    """
    angles, thicknesses = TRIED
    low, high = np.maximum([cos_theta.min(), cos_theta.max()], LEAST_COS_THETA)
    tried = np.linspace(np.sqrt(low), np.sqrt(high), angles) ** 2
    fine, *others = (lab(colours(stack, viewing, tried, thicknesses, step=step).astype(float), viewing.space)
                     for step in (1, *STEPS))
    close = (step for step, other in zip(STEPS, others) if delta_e_2000(fine, other).max() <= STEP_TOLERANCE)
    return next(close, 1)


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


def exact_colours(stack, viewing, cos_theta, thickness_nm):
    """Linear RGB before gamut mapping, at every nm in double precision, ``(..., 3)``: the slow way, for single looks.

    cos_theta, thickness_nm  that broadcast to ``(...)``
    """
    spectrum = (slice(None),) + (None,) * np.broadcast(cos_theta, thickness_nm).ndim
    indices = [index[spectrum] for index in stack.indices(WAVELENGTH_NM)]
    reflected = optics.reflectance(indices, stack.thicknesses(thickness_nm), cos_theta, WAVELENGTH_NM[spectrum])
    return np.moveaxis(np.tensordot(viewing.weights, reflected, axes=(0, 0)), 0, -1)


def colours(stack, viewing, cos_theta, count, low=None, high=None, step=1):
    """Linear RGB before gamut mapping, ``(A, D, 3)`` in single precision.

    stack      a Stack with a film that varies
    viewing    a Viewing
    cos_theta  ``(A,)``
    count      D even thicknesses from low to high, the ends of the stack's range where not given
    step       of the wavelength in nm
    """
    low, high = (end if given is None else given for given, end in zip((low, high), stack.thickness_range_nm))
    wavelength, weights = coarse_weights(viewing.weights, step)
    indices = [index[:, None] for index in stack.indices(wavelength)]
    q = optics.optical_cosine(indices, cos_theta[None])
    trips = _round_trips(stack, q, wavelength[:, None], np.linspace(low, high, count))
    chains = [_chain(optics.boundaries(q, indices, p), trips) for p in (False, True)]
    weights = np.ascontiguousarray(0.5 * weights.T, np.float32)
    found = np.empty((3, len(cos_theta), count), np.float32)
    for start in range(0, count, BLOCK):
        blocks = {trip: trip.block() for trip in {*filter(_varies, trips)}}
        reflected = sum(_reflected(chain, blocks) for chain in chains)
        block = (weights @ reflected.reshape(wavelength.size, -1)).reshape(3, len(cos_theta), BLOCK)
        found[:, :, start:start + BLOCK] = block[:, :, :count - start]
    return np.moveaxis(found, 0, -1)


class _Trip:
    """z of a film that varies, a block of thicknesses at a time: each block is the last one times one number."""

    def __init__(self, first, step):
        """first: exponent ``(W, A)`` at the first thickness; step: what each further one adds."""
        self.now = np.exp(first)
        self.powers = np.exp(step[..., None] * np.arange(BLOCK)).astype(np.complex64)
        self.leap = np.exp(BLOCK * step)

    def block(self):
        """``(W, A, BLOCK)``, the next thicknesses."""
        found = self.now.astype(np.complex64)[..., None] * self.powers
        self.now = self.now * self.leap
        return found


def _varies(z):
    return isinstance(z, _Trip)


def _round_trips(stack, q, wavelength, thicknesses):
    """z of every film from the outside in: numbers ``(W, A)`` where it stays, a _Trip where it varies, films that are alike share one."""
    ends = zip(stack.thicknesses(thicknesses[0]), stack.thicknesses(thicknesses[-1]))
    kept, found = {}, []
    for film, inside, (first, last) in zip(stack.films, q[1:], ends):
        key = (id(film.constants), first, last)
        if key not in kept and film.varies:
            per_nm = (4j * np.pi) * inside / wavelength
            kept[key] = _Trip(per_nm * first, per_nm * ((last - first) / max(len(thicknesses) - 1, 1)))
        elif key not in kept:
            kept[key] = optics.round_trip(inside, first, wavelength)
        found.append(kept[key])
    return found


def _chain(f, trips):
    """What the amplitudes go through from the substrate up: (numerator, denominator), then (_Trip, matrix) for each.

    r is a fraction; a film that stays multiplies its numerator by z, and a
    boundary takes (a, b) to (a + f b, f a + b).
    """
    matrix, steps, trip = (f[-1], np.ones_like(f[-1])), [], None
    for boundary, z in zip(f[-2::-1], trips[::-1]):
        if _varies(z):
            steps.append((trip, _single(matrix)))
            trip, matrix = z, (1.0, 0.0, 0.0, 1.0)
            z = 1.0
        half = len(matrix) // 2
        top, bottom = [z * x for x in matrix[:half]], matrix[half:]
        matrix = (*(a + boundary * b for a, b in zip(top, bottom)), *(boundary * a + b for a, b in zip(top, bottom)))
    return [*steps, (trip, _single(matrix))]


def _single(matrix):
    """In single precision, all of it scaled alike so that the largest is 1; ``(W, A, 1)`` each."""
    size = np.max(np.abs(np.stack(matrix)), axis=0)
    return tuple((x / size).astype(np.complex64)[..., None] for x in matrix)


def _reflected(chain, blocks):
    """|r|² of one polarisation, ``(W, A, BLOCK)``."""
    (_, (top, bottom)), *steps = chain
    for trip, (a, b, c, d) in steps:
        top = top * blocks[trip]
        top, bottom = a * top + b * bottom, c * top + d * bottom
    return _squared(top) / _squared(bottom)


def _squared(amplitude):
    return amplitude.real ** 2 + amplitude.imag ** 2
