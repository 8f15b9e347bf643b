"""Reflectance and transmittance of a stack of films: ambient / films / substrate, with interference.

A stack has L films between two half-spaces, so L + 2 complex indices n + ik,
from the outside in.  The ambient's is real; time goes as exp(−iωt), so k ≥ 0
absorbs.  q = n cos θ inside a layer follows from Snell's law,
q² = n² − n₀² sin² θ₀ with Im q ≥ 0; a film's round trip multiplies by
z = exp(2i·2π q d/λ), |z| ≤ 1; a boundary reflects f = (y − y′)/(y + y′) with
y = q for s and q/n² for p.  From the substrate up

    r ← (f + r z)/(1 + f r z),   t ← (1 + f) √z t/(1 + f r z),

which, other than a product of transfer matrices, holds nothing that grows:
P. Rouard, Ann. Phys. 7, 291 (1937); L. G. Parratt, Phys. Rev. 95, 359 (1954),
equations 4 and 5; M. Born and E. Wolf, Principles of Optics, 7th ed., section
1.6.

Every argument broadcasts: indices over wavelength ``(W, 1, 1)``, cos θ
``(A, 1)`` and one thickness ``(D,)`` give ``(W, A, D)``.
"""

from typing import NamedTuple

import numpy as np

from ..errors import FacetFilmError

__all__ = ["Powers", "reflectance", "powers", "check_layers", "optical_cosine", "round_trip", "boundaries"]

SMALLEST = 1e-9
"""|q| is held above: exactly at a critical angle a boundary's f would be 0/0."""


class Powers(NamedTuple):
    """Shares of the arriving power, of one shape: reflected and transmitted, s and p polarised.

    >>> Powers(0.2, 0.1, 0.7, 0.9).reflected
    0.15000000000000002
    """

    r_s: np.ndarray
    r_p: np.ndarray
    t_s: np.ndarray
    t_p: np.ndarray

    @property
    def reflected(self):
        """Of unpolarised light."""
        return 0.5 * (self.r_s + self.r_p)

    @property
    def transmitted(self):
        """Of unpolarised light."""
        return 0.5 * (self.t_s + self.t_p)


def reflectance(indices, thicknesses_nm, cos_theta, wavelength_nm):
    """Share of unpolarised light that the stack reflects, [0, 1]; shapes and errors as :func:`powers`.

    100 nm of n = 1.38 on glass, the usual coat of a lens:

    >>> round(float(reflectance([1.0, 1.38, 1.52], [100.0], 1.0, 550.0)), 4)
    0.0126
    """
    return powers(indices, thicknesses_nm, cos_theta, wavelength_nm).reflected


def powers(indices, thicknesses_nm, cos_theta, wavelength_nm):
    """The :class:`Powers` of a stack.

    indices         of ambient, films and substrate, L + 2 arrays, real or complex
    thicknesses_nm  of the films, L arrays, 0 or more; none for a bare surface
    cos_theta       cosine between the direction in the ambient and the normal, [0, 1]
    wavelength_nm   in vacuum, above 0

    Transmitted is what enters the substrate: at its surface, where that absorbs.
    Raises FacetFilmError as :func:`check_layers` does.

    >>> bare = powers([1.0, 1.5], [], 1.0, 550.0)
    >>> round(float(bare.reflected), 6), round(float(bare.transmitted), 6)
    (0.04, 0.96)
    """
    check_layers(indices, thicknesses_nm)
    indices = [np.asarray(index) for index in indices]
    q = optical_cosine(indices, cos_theta)
    half_trips = [round_trip(q_film, 0.5 * np.asarray(d), wavelength_nm)
                  for q_film, d in zip(q[1:-1], thicknesses_nm)]
    amplitudes = [_amplitudes(boundaries(q, indices, p), half_trips) for p in (False, True)]
    (r_s, t_s), (r_p, t_p) = amplitudes
    into_s, into_p = q[-1].real / q[0].real, (q[-1] / indices[-1] ** 2).real / (q[0].real / indices[0].real ** 2)
    return Powers(_squared(r_s), _squared(r_p), into_s * _squared(t_s), into_p * _squared(t_p))


def check_layers(indices, thicknesses_nm):
    """Raise FacetFilmError unless these can be a stack: real ambient, n > 0, k ≥ 0, films of 0 nm or more.

    >>> check_layers([1.0, 1.4, 1.5], [-3.0])
    Traceback (most recent call last):
    ...
    addon.errors.FacetFilmError: The thickness of a film must be at least 0 nm; that of layer 1 is -3.
    """
    if len(indices) != len(thicknesses_nm) + 2:
        raise FacetFilmError("A stack of {films} films has {indices} indices: outside, films and substrate; {given} "
                             "were given.", films=len(thicknesses_nm), indices=len(thicknesses_nm) + 2,
                             given=len(indices))
    absorbed = float(np.max(np.abs(np.imag(indices[0]))))
    if absorbed > 0.0:
        raise FacetFilmError("What is outside a stack must not absorb, and this has k up to {k:.2g}; name something "
                             "clear, such as air or water.", k=absorbed)
    for place, index in enumerate(indices):
        if not (np.all(np.isfinite(index)) and np.min(np.real(index)) > 0.0 and np.min(np.imag(index)) >= 0.0):
            raise FacetFilmError("Layer {place} of a stack needs n above 0 and k of at least 0 at every wavelength.",
                                 place=place)
    for place, thickness in enumerate(thicknesses_nm, 1):
        if not (np.all(np.isfinite(thickness)) and np.min(thickness) >= 0.0):
            raise FacetFilmError("The thickness of a film must be at least 0 nm; that of layer {place} is "
                                 "{thickness:g}.", place=place, thickness=float(np.min(thickness)))


def optical_cosine(indices, cos_theta):
    """q = n cos θ in every layer, a list of complex arrays; Im q ≥ 0 picks the wave that dies out inwards.

    indices    L + 2 arrays, the ambient's first
    cos_theta  in the ambient

    >>> [complex(q.round(4)) for q in optical_cosine([1.5, 1.0], 0.5)]
    [(0.75+0j), 0.8292j]
    """
    n_0, c = np.real(indices[0]), np.asarray(cos_theta, float)
    sine_2 = n_0 * n_0 * (1.0 - c * c)
    q = [n_0 * c + 0j, *(np.sqrt(np.asarray(index) ** 2 - sine_2 + 0j) for index in indices[1:])]
    q = [np.where(layer.imag < 0.0, -layer, layer) for layer in q]
    return [np.where(np.abs(layer) < SMALLEST, SMALLEST, layer) for layer in q]


def round_trip(q, thickness_nm, wavelength_nm):
    """z = exp(2i·2π q d/λ): what a wave is multiplied by on its way through a film and back.

    >>> complex(np.round(round_trip(1.38, 550.0 / 4 / 1.38, 550.0), 12))
    (-1+0j)
    """
    return np.exp((4j * np.pi) * q * thickness_nm / wavelength_nm)


def boundaries(q, indices, p):
    """Amplitude f that each of the L + 1 boundaries reflects, of the electric field for s, the magnetic for p.

    q     of :func:`optical_cosine`
    p     whether p polarised

    >>> f, = boundaries(optical_cosine([1.0, 1.5], 1.0), [1.0, 1.5], False)
    >>> float(f.real)
    -0.2
    """
    y = [layer / np.asarray(index) ** 2 for layer, index in zip(q, indices)] if p else q
    return [(above - below) / (above + below) for above, below in zip(y, y[1:])]


def _amplitudes(f, half_trips):
    """(r, t) of the stack, from its boundaries' f and √z of its films, by the recursion from the substrate up."""
    r, t = f[-1], 1.0 + f[-1]
    for boundary, half in zip(f[-2::-1], half_trips[::-1]):
        below = r * half * half
        through = 1.0 + boundary * below
        r, t = (boundary + below) / through, (1.0 + boundary) * half * t / through
    return r, t


def _squared(amplitude):
    return amplitude.real ** 2 + amplitude.imag ** 2
