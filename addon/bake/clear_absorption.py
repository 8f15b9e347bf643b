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

ROUNDS, PATIENCE = 50, 20
"""Of weighing up what is farthest off: at most, and how many that better nothing end it."""

FIRST_STEPS, STEPS = 30, 12
"""Of the least squares, in the first round and in each later one, which starts near its end."""

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
    continuous over depths.  σ has the least largest CIEDE2000: least squares, with what is
    farthest off weighed up round by round (Lawson 1961).
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
    fit = _Fit(difference, start)
    weights, best, since = np.full(len(DEPTHS), 1.0 / len(DEPTHS)), (np.inf, start), 0
    for turn in range(ROUNDS):
        fit = _least_squares(fit, np.sqrt(weights), STEPS if turn else FIRST_STEPS)
        largest = float(fit.errors.max())
        since = 0 if largest < best[0] - 1e-3 else since + 1
        best = min(best, (largest, fit.at), key=lambda pair: pair[0])
        if since > PATIENCE:
            break
        weights = weights * (fit.errors + 1e-6)
        weights /= weights.sum()
    return np.exp(best[1]), best[0]


class _Fit:
    """Where a fit stands: ln σ, the difference at every depth ``(D,)``, and its slopes ``(D, 3)``."""

    def __init__(self, difference, at):
        found = difference(at + NUDGES)
        self.difference, self.at, self.errors = difference, at, found[0]
        self.slopes = (found[1:] - found[0]).T / NUDGES.max()


def _least_squares(fit, weights, steps):
    """The _Fit of least weighted squares: Levenberg and Marquardt on three unknowns."""
    damping = 1e-2
    for _ in range(steps):
        slope, found = weights[:, None] * fit.slopes, weights * fit.errors
        normal = slope.T @ slope
        step = np.linalg.solve(normal + damping * np.diag(np.diag(normal) + 1e-9), slope.T @ found)
        new = _Fit(fit.difference, fit.at - np.clip(step, -1.0, 1.0))
        gain = found @ found - np.sum((weights * new.errors) ** 2)
        if gain > 0.0:
            fit, damping = new, max(0.25 * damping, 1e-6)
            if gain < 1e-4 * (found @ found):
                break
        else:
            damping *= 4.0
            if damping > 1e6:
                break
    return fit
