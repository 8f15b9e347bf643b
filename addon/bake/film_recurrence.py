"""Reflectance and transmittance of a stack along its thickness, by multiplications only.

What lies between the films that vary does not depend on the thickness: it is
one matrix a wavelength and angle, made once in double precision.  Along even
thicknesses the z of a film that varies is a power of one number.  So each
thickness takes a few products in single precision, and as |z| ≤ 1 none of them
is the small difference of large ones.
"""

import itertools
import math

import numpy as np

from ..reflectance import stack as optics

__all__ = ["Recurrence", "BLOCK"]

BLOCK = 16
"""Thicknesses calculated at once: the numbers of a block stay in a processor's cache."""


class Recurrence:
    """A stack over a grid of wavelengths and angles, a block of thicknesses at a time.

    Thickness is the first axis: what does not depend on it is broadcast over whole grids, which numpy does fast.

    >>> from .stack_notation import parse
    >>> from ..spectra.optical_constants import load
    >>> coat = Recurrence(parse("1.38 0-100 nm / 1.52", load), np.ones(1), np.array([550.0]), np.array([0.0, 100.0]))
    >>> [round(float(share), 4) for share in coat.block("reflected")[:2, 0, 0]]
    [0.0426, 0.0126]
    """

    def __init__(self, stack, cos_theta, wavelength_nm, thicknesses_nm):
        """cos_theta ``(A,)``, wavelength_nm ``(W,)``, thicknesses_nm ``(D,)`` at even distances."""
        indices = [index[:, None] for index in stack.indices(wavelength_nm)]
        q = optics.optical_cosine(indices, cos_theta[None])
        trips = _round_trips(stack, q, wavelength_nm[:, None], thicknesses_nm)
        into = q[-1].real / q[0].real, (q[-1] / indices[-1] ** 2).real / (q[0].real / indices[0] ** 2)
        self.chains = [_Chain(optics.boundaries(q, indices, p), trips, into[p]) for p in (False, True)]
        self.trips = {*filter(_varies, trips)}
        self.is_of_one = len(self.chains[0].steps) == 2

    def block(self, of):
        """Shares of unpolarised light at the next BLOCK thicknesses, ``(BLOCK, W, A)``.

        of  "reflected" or "transmitted"
        """
        if of == "reflected" and self.is_of_one:
            trip, = self.trips
            parts = trip.parts()
            return 0.5 * sum(chain.reflected_by_one(*parts) for chain in self.chains)
        z = {trip: trip.block() for trip in self.trips}
        return 0.5 * sum(getattr(chain, of)(z) for chain in self.chains)


class _Trip:
    """z of a film that varies, a block of thicknesses at a time: each block is the last one times one number."""

    def __init__(self, first, step):
        """first: exponent ``(W, A)`` at the first thickness; step: what each further one adds."""
        self.now = np.exp(first)
        once = np.exp(step)
        powers = list(itertools.accumulate([np.ones_like(once), *[once] * BLOCK], np.multiply))
        self.powers, self.leap = np.stack(powers[:BLOCK]).astype(np.complex64), powers[BLOCK]

    def block(self):
        """``(BLOCK, W, A)``, the next thicknesses."""
        found = self.now.astype(np.complex64) * self.powers
        self.now = self.now * self.leap
        return found

    def parts(self):
        """Its real part, its imaginary part and its square |z|², ``(BLOCK, W, A)`` each."""
        found = self.block()
        real, imaginary = (np.ascontiguousarray(part) for part in (found.real, found.imag))
        return real, imaginary, real * real + imaginary * imaginary


class _Chain:
    """What the amplitudes of one polarisation go through from the substrate up.

    r is a fraction; a film multiplies its numerator by z, and a boundary takes
    (a, b) to (a + f b, f a + b).  t is what all films and boundaries let
    through, Π (1 + f) √z, over the last denominator.

    steps   (numerator, denominator) below the lowest film that varies, then a matrix above each, with its _Trip
    let     Π of what does not vary, as power
    """

    def __init__(self, f, trips, into):
        """f of the boundaries and trips of the films from the outside in; into: power in the substrate for |t|²."""
        matrix, trip, self.steps = (f[-1], np.ones_like(f[-1])), None, []
        self.let = into * math.prod(_squared(1.0 + boundary) for boundary in f)
        for boundary, z in zip(f[-2::-1], trips[::-1]):
            if _varies(z):
                self._keep(trip, matrix)
                matrix, trip, z = (1.0, 0.0, 0.0, 1.0), z, 1.0
            half = len(matrix) // 2
            top, bottom = [z * x for x in matrix[:half]], matrix[half:]
            matrix = (*(a + boundary * b for a, b in zip(top, bottom)),
                      *(boundary * a + b for a, b in zip(top, bottom)))
            self.let = self.let * np.abs(z)
        self._keep(trip, matrix)

    def _keep(self, trip, matrix):
        """In single precision, scaled so that the largest is 1; ``(W, A)`` each."""
        size = np.max(np.abs(np.stack(matrix)), axis=0)
        self.steps.append((trip, tuple((x / size).astype(np.complex64) for x in matrix)))
        self.let = self.let / (size * size)

    def _fraction(self, z):
        (_, (top, bottom)), *steps = self.steps
        for trip, (a, b, c, d) in steps:
            top = top * z[trip]
            below = c * top
            below += d * bottom
            top *= a
            top += b * bottom
            bottom = below
        return top, bottom

    def reflected(self, z):
        """|r|², ``(BLOCK, W, A)``."""
        top, bottom = self._fraction(z)
        return _squared(top) / _squared(bottom)

    def reflected_by_one(self, real, imaginary, both):
        """The same where one film varies, of its :meth:`_Trip.parts`: |a z + b|² = |a z|² + |b|² + 2 Re(a b̄ z)."""
        (_, (top, bottom)), (_, (a, b, c, d)) = self.steps
        above, below = (_squared_sum(*pair, real, imaginary, both)
                        for pair in ((a * top, b * bottom), (c * top, d * bottom)))
        return np.maximum(above, 0.0, out=above) / below

    def transmitted(self, z):
        """The power that enters the substrate, ``(BLOCK, W, A)``."""
        let = self.let.astype(np.float32) / _squared(self._fraction(z)[1])
        for trip, _ in self.steps[1:]:
            let = let * np.abs(z[trip])
        return let


def _varies(z):
    return isinstance(z, _Trip)


def _round_trips(stack, q, wavelength, thicknesses):
    """z of every film from the outside in: numbers ``(W, A)`` where it stays, else a _Trip, shared by films alike."""
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


def _squared_sum(a, b, real, imaginary, both):
    """|a z + b|² in real numbers, which is a sixth of the work."""
    product = 2.0 * a * b.conj()
    found = _squared(a) * both
    found += _squared(b)
    found += product.real * real
    found -= product.imag * imaginary
    return found


def _squared(amplitude):
    return amplitude.real ** 2 + amplitude.imag ** 2
