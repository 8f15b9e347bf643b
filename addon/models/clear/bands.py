"""Which wavelength stands for which random number, and its colour: non-negative bands of red, green and blue."""

import functools

import numpy as np

from ...bake.colour import spectral_weights
from ...operands import lookup, lookup_three
from ...reflectance.transmission import LAMBDA_D
from ...spectra import observers

__all__ = ["colour_of", "place_for", "inverse_square_at", "wavelength_of", "wavelength_of_channel"]

KNOTS = np.concatenate([[0.0, 0.002, 0.01, 0.03], np.linspace(0.06, 0.94, 23), [0.97, 0.99, 0.998, 1.0]])
"""Random numbers between which the wavelength is a straight line."""

MARGIN = 0.04
"""Of a turn, at both ends."""

COLOUR_KNOTS = np.array([0, 4, 8, 12, 14, *range(16, 23), 24, 25, 26, 27, 28, 32, 36, 37, *range(38, 58, 2), 64]) / 64.0
"""Close where the colour turns: at a color ramp's 31 stops it is within 0.007 rms of what 400 would show."""


@functools.lru_cache(maxsize=1)
def _tables():
    """(each channel's density over the wavelengths ``(421, 3)``, that of all ``(421,)``): responses, clipped at 0."""
    positive = np.maximum(spectral_weights(), 0.0)
    density = positive / positive.sum(axis=0)
    return density, density.mean(axis=1)


def _inverse(density, numbers):
    """Wavelengths in µm at which a density's integral is these numbers, from where it begins to where it ends."""
    first, *_, last = np.flatnonzero(density)
    begins = observers.WAVELENGTH_NM[first:last + 1] - 0.5
    integral = np.append(0.0, np.cumsum(density[first:last + 1]))
    return np.interp(numbers, integral / integral[-1], np.append(begins, begins[-1] + 1.0)) / 1e3


def wavelength_of(u):
    """λ in µm, drawn as densely as the three channels together respond; u evenly in [0, 1).

    >>> round(float(wavelength_of(0.5)), 2)
    0.54
    """
    return lookup(u, KNOTS, _inverse(_tables()[1], KNOTS))


def wavelength_of_channel(u, channel):
    """λ in µm of one channel's band, drawn as densely as it responds.

    >>> [round(float(wavelength_of_channel(0.5, channel)), 2) for channel in range(3)]
    [0.61, 0.54, 0.45]
    >>> [round(float(wavelength_of_channel(1.0, channel)), 2) for channel in range(3)]
    [0.78, 0.61, 0.51]
    """
    return lookup(u, KNOTS, _inverse(_tables()[0][:, channel], KNOTS))


def colour_of(u):
    """Linear RGB of the wavelength drawn for u, response over density: white on average.

    >>> [round(float(x), 2) for x in colour_of((np.arange(1000) + 0.5) / 1000).mean(axis=0)]
    [1.0, 1.0, 1.0]
    """
    density, of_all = _tables()
    at = 1e3 * _inverse(of_all, COLOUR_KNOTS)
    shares = density / np.maximum(density.sum(axis=1, keepdims=True), 1e-30)
    colours = [3.0 * np.interp(at, observers.WAVELENGTH_NM, shares[:, channel]) for channel in range(3)]
    return lookup_three(u, COLOUR_KNOTS, np.transpose(colours))


def place_for(u):
    """The place in a turn that stands for a random number: not beside the turn's ends, which are neighbours.

    >>> place_for(0.0), place_for(0.5)
    (0.04, 0.5)
    """
    return MARGIN + (1.0 - 2.0 * MARGIN) * u


def inverse_square_at(place):
    """1/λ² in 1/µm² of the wavelength of a place, less that of the d line.

    >>> round(float(inverse_square_at(0.5)), 2)
    0.59
    """
    return lookup(place, place_for(KNOTS), _inverse(_tables()[1], KNOTS) ** -2 - LAMBDA_D**-2)
