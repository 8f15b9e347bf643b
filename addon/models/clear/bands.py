"""Which wavelength stands for which random number, and its colour: non-negative bands of red, green and blue."""

import functools

import numpy as np

from ...bake.colour import spectral_weights
from ...operands import lookup, vector
from ...spectra import observers

__all__ = ["colour_of", "wavelength_of", "wavelength_of_channel"]

KNOTS = np.concatenate([[0.0, 0.002, 0.01, 0.03], np.linspace(0.06, 0.94, 23), [0.97, 0.99, 0.998, 1.0]])
"""Random numbers between which the wavelength is a straight line."""

COLOUR_KNOTS = np.linspace(0.0, 1.0, 65)


@functools.lru_cache(maxsize=1)
def _tables():
    """(each channel's density over the wavelengths ``(421, 3)``, that of all ``(421,)``): responses, clipped at 0."""
    positive = np.maximum(spectral_weights(), 0.0)
    density = positive / positive.sum(axis=0)
    return density, density.mean(axis=1)


def _inverse(density, numbers):
    """Wavelengths in µm at which a density's integral is these numbers."""
    edges = np.append(observers.WAVELENGTH_NM - 0.5, observers.WAVELENGTH_NM[-1] + 0.5)
    return np.interp(numbers, np.append(0.0, np.cumsum(density)), edges) / 1e3


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
    return vector(*(lookup(u, COLOUR_KNOTS, 3.0 * np.interp(at, observers.WAVELENGTH_NM, shares[:, channel]))
                    for channel in range(3)))
