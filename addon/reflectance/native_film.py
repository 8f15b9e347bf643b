"""The thin film of Blender's own Metallic BSDF, from 5.0: one film of a constant index on n + ik of each channel.

L. Belcour and P. Barla, "A Practical Extension to Microfacet Theory for the
Modeling of Varying Iridescence", ACM Transactions on Graphics 36(4), 2017: the
reflectance is a series over the orders in which light crosses the film, and
the colour of each order the Fourier transform of a channel's sensitivity at
its path difference.  Cycles takes three orders, draws the transforms from a
table with straight lines between its entries, and has white light of equal
energy, each channel scaled to 1 for white.
"""

from typing import NamedTuple

import numpy as np

__all__ = ["NativeFilm", "native_film", "sensitivity_table"]

ORDERS = 3
ENTRIES, ENTRIES_NM = 512, 60000.0 / (2.0 * np.pi)
"""Of the table, and the path difference of its last entry."""
SAMPLES = 1022
"""Of each sensitivity over frequency, π/60 per µm apart, before its transform."""
LEAST_NM = 1.0
"""Thickness below which the film's index fades to that of air."""
TINY = 1e-12


class NativeFilm(NamedTuple):
    """What the Metallic BSDF's sockets hold: index ``(...)``, thickness ``(...)`` in nm, n and k ``(..., 3)``.

    >>> NativeFilm(2.5, 60.0, (1.7, 1.9, 2.1), (1.9, 2.1, 2.3)).index
    2.5
    """

    index: np.ndarray
    thickness_nm: np.ndarray
    n: np.ndarray
    k: np.ndarray


def native_film(cos_theta, film, sensitivities):
    """Reflectance of a NativeFilm in air, ``(..., A, 3)`` in [0, 1].

    cos_theta      ``(A,)``, above 0
    film           a NativeFilm of ``(...)``
    sensitivities  of the file's scene-linear space, by :func:`sensitivity_table`

    >>> from addon.spectra.observers import WAVELENGTH_NM, colour_matching_functions
    >>> table = sensitivity_table(WAVELENGTH_NM, colour_matching_functions())
    >>> bare = NativeFilm(np.array(1.5), np.array(0.0), np.full(3, 1.5), np.zeros(3))
    >>> native_film(np.ones(1), bare, table).round(6).tolist()
    [[0.04, 0.04, 0.04]]
    """
    t = np.clip(film.thickness_nm / LEAST_NM, 0.0, 1.0)
    index = 1.0 + (film.index - 1.0) * t * t * (3.0 - 2.0 * t)
    index, thickness = index[..., None], np.asarray(film.thickness_nm)[..., None]
    inside = np.sqrt(np.maximum(1.0 - (1.0 - cos_theta * cos_theta) / (index * index), TINY))
    path = _places(2.0 * index * thickness * inside)
    # Fresnel's amplitudes, of light that comes from above and, at the metal, from within the film.
    above = ((cos_theta - index * inside) / (cos_theta + index * inside),
             (index * cos_theta - inside) / (index * cos_theta + inside))
    metal = (film.n + 1j * film.k)[..., None, :]
    index, inside = index[..., None], inside[..., None]
    within = np.sqrt(metal * metal - index * index * (1.0 - inside * inside))
    below = ((index * inside - within) / (index * inside + within),
             (metal * metal * inside - index * within) / (metal * metal * inside + index * within))
    waves = [_looked_up(sensitivities, order * path) for order in range(1, ORDERS + 1)]
    both = sum(_summed(r12[..., None], r23, waves) for r12, r23 in zip(above, below))
    return np.clip(0.5 * both, 0.0, 1.0)


def _summed(r12, r23, waves):
    """(10) of the paper for one polarisation: the mean over all orders, and what the first of them swing by."""
    passed = 1.0 - r12 * r12
    size = np.abs(r23)
    phase = -np.sign(r12) * r23 / np.maximum(size, TINY)
    once = np.abs(r12) * size
    mean = passed * passed * size * size / (1.0 - once * once)
    total, swing, turned = r12 * r12 + mean, mean - passed, 1.0
    for wave in waves:
        swing, turned = swing * once, turned * phase
        total = total + 2.0 * swing * (turned * wave).real
    return total


def _places(path_nm):
    return path_nm * ((ENTRIES - 1) / ENTRIES_NM)


def _looked_up(table, place):
    """The table's entries at places between them, its last held."""
    place = np.minimum(place, ENTRIES - 1.0)
    low = np.minimum(place.astype(int), ENTRIES - 2)
    share = (place - low)[..., None]
    return table[low] + share * (table[low + 1] - table[low])


def sensitivity_table(wavelengths, sensitivities):
    """Fourier transforms of each channel's sensitivity, ``(512, 3)`` complex, over path differences to 9549 nm.

    wavelengths    in nm, ``(W,)``
    sensitivities  what light of each adds to linear RGB, ``(W, 3)``

    >>> flat = sensitivity_table(np.arange(400.0, 701.0), np.ones((301, 3)))
    >>> flat.shape, round(float(flat[0, 0].real), 6)
    ((512, 3), 1.0)
    """
    frequency = np.arange(1, SAMPLES) * (np.pi / 60.0)
    at = 1000.0 / frequency
    seen = (at >= wavelengths[0]) & (at <= wavelengths[-1])
    frequency, at = frequency[seen], at[seen]
    sampled = np.stack([np.interp(at, wavelengths, channel) for channel in np.transpose(sensitivities)], axis=-1)
    sampled /= (frequency * frequency)[:, None]
    entries = np.arange(ENTRIES)[:, None] * (ENTRIES_NM / (ENTRIES - 1)) / 1000.0
    table = np.exp(2j * np.pi * entries * frequency) @ sampled
    return table / table[0].real
