"""Absorption through a body as three numbers: σ for red, green and blue, fitted over the depths at which it is seen."""

from typing import NamedTuple

import numpy as np

from ..spectra import observers
from .colour import delta_e_2000, lab
from .gamut import map_colours

__all__ = ["Attenuation", "alpha_of", "attenuation_of"]

DEPTHS = np.geomspace(0.1, 3.0, 25)
"""Over which σ is fitted, as shares of the depth of half transmission."""

NOTHING = 1e-9
"""1/m: what absorbs less is clear over any depth that is rendered."""

FARTHEST = 1e4
"""m: what lets half the light through from farther away is clear."""

ROUNDS, FIRST_STEPS, STEPS = 6, 30, 12
"""Of weighing up what is farthest off, and of the least squares in the first round and in each later one."""

POWERS, STEPS_A_POWER = (8, 16, 32, 64, 128, 256), 20
"""Whose sums are made least one after the other: the higher, the more it is the largest alone that counts."""

FARTHEST_OFF = 10.0
"""Errors over the largest at hand, in those powers: what is farther off is a step that is not taken."""

NUDGES = 1e-4 * np.concatenate([np.zeros((1, 3)), np.eye(3)])
"""Of ln σ, ``(4, 3)``: none, and one a channel, for the slopes."""


class Attenuation(NamedTuple):
    """What was found.

    sigma            σ a channel in 1/m
    colour           linear RGB after `distance` of it
    distance         the depth of half transmission in m, or None for what is clear
    delta_e          largest CIEDE2000 from the spectrum over DEPTHS
    """

    sigma: tuple
    colour: tuple
    distance: float | None
    delta_e: float


CLEAR = Attenuation((0.0,) * 3, (1.0,) * 3, None, 0.0)


def alpha_of(constants):
    """Absorption coefficient α = 4πk/λ of every nm, ``(421,)`` in 1/m.

    >>> from addon.spectra.optical_constants import load
    >>> float(alpha_of(load("glass/soda-lime/Rubin-clear"))[190].round(1))
    5.0
    """
    return 4.0 * np.pi * constants.at(observers.WAVELENGTH_NM)[1] / (observers.WAVELENGTH_NM * 1e-9)


def attenuation_of(alpha, viewing):
    """The Attenuation of an absorption spectrum as :func:`alpha_of` gives it.

    alpha    ``(421,)`` in 1/m
    viewing  an addon.bake.reflected.Viewing

    Colours are relative to the light that enters, and brought into the gamut at constant dominant wavelength, which is
    continuous over depths.  σ has the least largest CIEDE2000: least squares, with what is farthest off weighed up
    round by round (Lawson 1961), which comes past the kinks of CIEDE2000; then least sums of ever higher powers
    (Pólya 1913), which end in the same place whatever the last bits were.
    """
    if alpha.max() < NOTHING:
        return CLEAR
    def through(d):
        light = np.exp(-np.outer(d, alpha)) @ viewing.weights
        return map_colours(light / viewing.weights.sum(axis=0), "desaturate", viewing.space)[0]
    half = _half(lambda d: through(np.array([d]))[0] @ (0.2126, 0.7152, 0.0722))
    if half > FARTHEST:
        return CLEAR
    depths = half * DEPTHS
    target = lab(through(depths), viewing.space)
    start = -np.log(np.clip(through(np.array([half]))[0], 1e-6, 1.0 - 1e-6)) / half
    def difference(log_sigma):
        through_body = np.exp(-depths[:, None] * np.exp(log_sigma)[..., None, :])
        return delta_e_2000(target, lab(through_body, viewing.space))
    sigma, error = _least_largest(difference, np.log(np.maximum(start, NOTHING)))
    return Attenuation(tuple(sigma.tolist()), tuple(np.exp(-sigma * half).tolist()), float(half), error)


def _half(luminance):
    """The depth at which the luminance is a half, by bisection of its logarithm."""
    low, high = -9.0, 12.0
    for _ in range(50):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if luminance(10.0**middle) > 0.5 else (low, middle)
    return 10.0**low


def _least_largest(difference, start):
    """(σ, largest difference) of the fit whose largest difference is least.

    difference  of ln σ ``(..., 3)``: ``(..., depths)``
    """
    fit = best = _Fit(difference, start)
    weights = np.full(len(DEPTHS), 1.0 / len(DEPTHS))
    for turn in range(ROUNDS):
        fit = _least_squares(fit, _weighted(np.sqrt(weights)), STEPS if turn else FIRST_STEPS)
        best = min(best, fit, key=_Fit.largest)
        weights = weights * (fit.errors + 1e-6)
        weights /= weights.sum()
    fit = best
    for power in POWERS:
        fit = _least_squares(fit, _half_power(power, fit.largest()), STEPS_A_POWER)
        best = min(best, fit, key=_Fit.largest)
    return np.exp(best.at), best.largest()


def _weighted(weights):
    """The errors times weights; as :func:`_half_power`."""
    return lambda errors: (weights * errors, weights)


def _half_power(power, scale):
    """A function of errors ``(D,)``: (what is to be squared, its slopes), the errors over a scale to half a power."""
    def shape(errors):
        shares = np.minimum(errors / scale, FARTHEST_OFF)
        root = shares ** (0.5 * power - 1.0)
        return root * shares, 0.5 * power / scale * root
    return shape


class _Fit:
    """Where a fit stands: ln σ, the difference at every depth ``(D,)``, and its slopes ``(D, 3)``."""

    def __init__(self, difference, at):
        found = difference(at + NUDGES)
        self.difference, self.at, self.errors = difference, at, found[0]
        self.slopes = (found[1:] - found[0]).T / NUDGES.max()

    def largest(self):
        """The largest difference."""
        return float(self.errors.max())


def _least_squares(fit, shape, steps):
    """The _Fit of least squares of the shape of its errors: Levenberg and Marquardt on three unknowns."""
    damping = 1e-2
    for _ in range(steps):
        found, steep = shape(fit.errors)
        slope = steep[:, None] * fit.slopes
        normal = slope.T @ slope
        step = np.linalg.solve(normal + damping * np.diag(np.diag(normal) + 1e-9), slope.T @ found)
        new = _Fit(fit.difference, fit.at - np.clip(step, -1.0, 1.0))
        gain = found @ found - np.sum(shape(new.errors)[0] ** 2)
        if gain > 0.0:
            fit, damping = new, max(0.25 * damping, 1e-6)
            if gain < 1e-4 * (found @ found):
                break
        else:
            damping *= 4.0
            if damping > 1e6:
                break
    return fit
