"""A track over thickness: what Blender's native film is set to, so that its colours over the angle come closest.

The native film has one index, a metal of n and k a channel, and white light of
equal energy: fed with what is on a film's label it is off by CIEDE2000 1 to 20.
Fed with eight numbers that are fitted to the spectrum's colours it follows
them, and is evaluated at the V·H of every facet.  Knots are even in
thickness, with straight lines between them; the fit sees the middles of these
too, and keeps neighbours alike, so that a gradient shows no step.
"""

import dataclasses
import functools

import numpy as np

from ..columns import columns
from ..reflectance.native_film import NativeFilm, native_film, sensitivity_table
from ..spectra.observers import WAVELENGTH_NM, colour_matching_functions
from .colour import lab, rgb_to_xyz

__all__ = ["FilmTrack", "KNOTS", "NUMBERS", "film_at", "native_colours", "native_knots"]

KNOTS = 41
NUMBERS = 8
"""Of a knot: the film's index, its thickness as a multiple of the stack's, n of each channel, k of each."""
DEGREES = (0.0, 10.0, 20.0, 30.0, 40.0, 48.0, 56.0, 63.0, 69.0, 74.0, 78.0, 81.0, 84.0)
COS_THETA = np.cos(np.radians(DEGREES))
WEIGHTS = np.minimum(1.0, COS_THETA / np.cos(np.radians(60.0)))
"""Grazing facets are seen small."""
SCALES = np.array([0.3, 0.2, *(0.5,) * 6])
"""Steps of the eight numbers that count alike."""
LOW, HIGH = np.array([1.02, 0.3, *(0.03,) * 3, *(0.0,) * 3]), np.array([4.5, 3.0, *(9.0,) * 6])
STIFFNESS = (10.0, 3.0, 1.0, 0.3, 0.1)
"""How alike neighbours are kept, one after the other: a stiff track finds the way, a soft one the colours."""
TRIES = 12
"""Steps of the search for each."""
ENOUGH = 1e-3
"""Share of the cost that a step has to gain for another one."""
STEP, COLOUR_STEP = 1e-4, 1e-5
EASIER, HARDER, LEAST_DAMPING, MOST_DAMPING = 0.25, 4.0, 1e-9, 1e6
SINGULAR = 1e-6
LEAST_K = 0.02
GROUPS = (slice(0, 1), slice(1, 2), slice(2, 5), slice(5, 8))
"""What is moved together for the slopes of the fit: a channel has n and k of its own."""


@dataclasses.dataclass(frozen=True, eq=False)
class FilmTrack:
    """Eight numbers for each of some thicknesses.

    thicknesses_nm  ``(K,)``, even
    knots           ``(K, 8)``: see NUMBERS
    from_slope      rms slope from which it is closer than the tilted lobes, ``(K,)``

    >>> knots = np.array([[2.0] + 7 * [1.0], [3.0] + 7 * [1.0]])
    >>> track = FilmTrack(np.array([0.0, 100.0]), knots, np.array([0.1, 0.2]))
    >>> float(track.at(50.0).index), round(float(track.from_slope_at(50.0)), 6)
    (2.5, 0.15)
    """

    thicknesses_nm: np.ndarray
    knots: np.ndarray
    from_slope: np.ndarray

    def at(self, thickness_nm):
        """The NativeFilm at thicknesses ``(...)``, the ends held."""
        numbers = [np.interp(thickness_nm, self.thicknesses_nm, column) for column in self.knots.T]
        within = np.clip(thickness_nm, self.thicknesses_nm[0], self.thicknesses_nm[-1])
        return film_at(np.stack(numbers, axis=-1), within)

    def from_slope_at(self, thickness_nm):
        """The slope from which it is closer, at thicknesses ``(...)``."""
        return np.interp(thickness_nm, self.thicknesses_nm, self.from_slope)


def film_at(numbers, thickness_nm):
    """The NativeFilm of eight numbers ``(..., 8)`` at thicknesses ``(...)``.

    >>> film_at(np.array([2.5, 0.9, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0]), np.array(100.0)).thickness_nm
    90.0
    """
    return NativeFilm(numbers[..., 0], numbers[..., 1] * thickness_nm, numbers[..., 2:5], numbers[..., 5:8])


def native_colours(film, cos_theta, space):
    """Linear RGB of a NativeFilm as Cycles draws it in a scene-linear space, ``(..., A, 3)``.

    >>> label = NativeFilm(np.array(2.5), np.array(60.0), np.array([1.7, 1.9, 2.1]), np.array([1.9, 2.1, 2.3]))
    >>> native_colours(label, np.ones(1), "Rec.709").round(2).tolist()
    [[0.32, 0.41, 0.52]]
    """
    return native_film(cos_theta, film, _sensitivities(space))


def native_knots(table):
    """(thicknesses ``(K,)``, eight numbers of each ``(K, 8)``) of a FilmTable whose stack has one film.

    Least squares by Levenberg and Marquardt of what CIEDE2000 makes of the differences, over all knots at once.

    >>> from .film_table import smallest_table
    >>> from .stack_notation import parse
    >>> from ..spectra.optical_constants import load
    >>> _, knots = native_knots(smallest_table(parse("main/TiO2/Jolivet-anatase 60 nm / main/Ti/Palm", load)))
    >>> knots.shape, bool(2.0 < knots[0, 0] < 3.2)
    ((1, 8), True)
    """
    low, high = table.thickness_range_nm
    thicknesses = np.linspace(low, high, KNOTS if high > low else 1)
    fit = _Fit(table, thicknesses, np.linspace(low, high, 2 * len(thicknesses) - 1))
    knots = np.tile(_label(table), (len(thicknesses), 1))
    for stiffness in STIFFNESS:
        knots = fit.closer(knots, stiffness)
    return thicknesses, knots


class _Fit:
    """The search for the numbers of knots whose colours at the thicknesses seen are those of a table."""

    def __init__(self, table, knots, seen):
        self.space, self.seen = table.viewing.space, seen
        self.wanted = lab(table.at(COS_THETA, seen[:, None]).astype(float), self.space)
        self.metric = _metric(self.wanted) * WEIGHTS[:, None, None]
        self.between = np.stack([np.interp(seen, knots, row) for row in np.eye(len(knots))], axis=-1)
        self.pairs = (self.between[:, :, None] * self.between[:, None, :]).reshape(len(seen), -1).T
        apart = np.diff(np.eye(len(knots)), axis=0)
        self.alike = apart.T @ apart

    def closer(self, numbers, stiffness):
        """The numbers ``(K, 8)`` after a few steps."""
        damping, (colours, off) = 1e-3, self._off(numbers)
        cost = self._cost(numbers, off, stiffness)
        for _ in range(TRIES):
            tried = self._stepped(numbers, colours, off, stiffness, damping)
            found, left = self._off(tried)
            reached = self._cost(tried, left, stiffness)
            if reached >= cost:
                damping = min(damping * HARDER, MOST_DAMPING)
                continue
            gained, numbers, colours, off, cost = 1.0 - reached / cost, tried, found, left, reached
            damping = max(damping * EASIER, LEAST_DAMPING)
            if gained < ENOUGH:
                break
        return numbers

    def _colours(self, numbers):
        return native_colours(film_at(numbers, self.seen), COS_THETA, self.space)

    def _off(self, numbers):
        """(colours, what they differ by ``(M, A, 3)``)."""
        colours = self._colours(self.between @ numbers)
        return colours, _applied(self.metric, lab(colours, self.space) - self.wanted)

    def _cost(self, numbers, off, stiffness):
        scaled = numbers / SCALES
        return float(np.sum(off * off) + stiffness**2 * np.sum(scaled * (self.alike @ scaled)))

    def _stepped(self, numbers, colours, off, stiffness, damping):
        """The numbers a damped step on."""
        slopes = self._slopes(self.between @ numbers, colours).reshape(len(self.seen), -1, NUMBERS) * SCALES
        towards = -np.einsum("mri,mr->mi", slopes, off.reshape(len(self.seen), -1))
        bent = slopes.transpose(0, 2, 1) @ slopes
        count = len(numbers)
        matrix = (self.pairs @ bent.reshape(len(self.seen), -1)).reshape(count, count, NUMBERS, NUMBERS)
        matrix = matrix.transpose(0, 2, 1, 3)
        matrix = matrix + stiffness**2 * self.alike[:, None, :, None] * np.eye(NUMBERS)[:, None, :]
        matrix = matrix.reshape(count * NUMBERS, -1)
        wanted = self.between.T @ towards - stiffness**2 * self.alike @ (numbers / SCALES)
        matrix[np.diag_indices(len(matrix))] += damping * (np.diag(matrix) + SINGULAR) + SINGULAR
        step = np.linalg.solve(matrix, wanted.ravel()).reshape(count, NUMBERS)
        return np.clip(numbers + step * SCALES, LOW, HIGH)

    def _slopes(self, numbers, colours):
        """What the differences change by with each number, ``(M, A, 3, 8)``."""
        moved = []
        for group in GROUPS:
            there = numbers.copy()
            there[:, group] += STEP
            moved.append((self._colours(there) - colours) / STEP)
        base = lab(colours, self.space)
        by_channel = np.stack([(lab(colours + COLOUR_STEP * axis, self.space) - base) / COLOUR_STEP
                               for axis in np.eye(3)], axis=-1)
        by_channel = self.metric @ by_channel
        shared = [_applied(by_channel, slope)[..., None] for slope in moved[:2]]
        own = [by_channel * slope[..., None, :] for slope in moved[2:]]
        return np.concatenate([*shared, *own], axis=-1)


def _label(table):
    """The eight numbers that a stack's own layers suggest, to begin with."""
    stack = table.stack
    share = np.maximum(_weights(table.viewing.space), 0.0)
    n, k = (np.asarray(x) @ (share / share.sum(axis=0)) for x in stack.below_constants.at(WAVELENGTH_NM))
    index = float(np.asarray(stack.films[0].constants.at(550.0)[0]).ravel()[0])
    return np.clip([index, 1.0, *n, *np.maximum(k, LEAST_K)], LOW, HIGH)


def _weights(space):
    """What light of each nm adds to linear RGB, of equal energy, ``(421, 3)``."""
    return colour_matching_functions() @ np.linalg.inv(rgb_to_xyz(space)).T


@functools.lru_cache(maxsize=8)
def _sensitivities(space):
    return sensitivity_table(WAVELENGTH_NM, _weights(space))


def _applied(matrices, vectors):
    """Matrices ``(..., 3, 3)`` times vectors ``(..., 3)``."""
    return (matrices @ vectors[..., None])[..., 0]


def _metric(wanted):
    """What makes small differences of L*a*b* those of CIEDE2000, ``(..., 3, 3)``, less its turn of blues.

    Sharma, Wu and Dalal 2005: (4), (5), (15) and (18) to (20), about the colours wanted.
    """
    l, a, b = columns(wanted)
    c7 = np.hypot(a, b) ** 7
    grown = 1.5 - 0.5 * np.sqrt(c7 / (c7 + 25.0**7))
    c = np.maximum(np.hypot(a * grown, b), 1e-6)
    h = np.arctan2(b, a * grown)
    t = (1.0 - 0.17 * np.cos(h - np.pi / 6) + 0.24 * np.cos(2.0 * h)
         + 0.32 * np.cos(3.0 * h + np.pi / 30) - 0.20 * np.cos(4.0 * h - 63.0 * np.pi / 180))
    s_l = 1.0 + 0.015 * (l - 50.0) ** 2 / np.sqrt(20.0 + (l - 50.0) ** 2)
    s_c, s_h = 1.0 + 0.045 * c, 1.0 + 0.015 * c * t
    along, across = a * grown / c, b / c
    found = np.zeros((*wanted.shape, 3))
    found[..., 0, 0] = 1.0 / s_l
    found[..., 1, 1], found[..., 1, 2] = along * grown / s_c, across / s_c
    found[..., 2, 1], found[..., 2, 2] = -across * grown / s_h, along / s_h
    return found
