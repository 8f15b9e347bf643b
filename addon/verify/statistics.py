"""The statistics of comparing pictures of independent seeds with a formula; numpy only."""

import math
from dataclasses import dataclass

import numpy as np

__all__ = ["CHANCE", "ZTest", "z_test", "relative_rms", "student_t_tails", "student_t_limit"]


CHANCE = 1e-3
"""Probability with which a check of the verification fails by chance alone; there are some thirty in a report."""


@dataclass
class ZTest:
    """Outcome of comparing the mean of independent pictures with a reference.

    z              (measured − reference) / standard error, for each value compared
    largest        largest |z|
    limit          |z| that the largest of so many values passes by chance with probability `alpha`
    rms_relative   rms difference of the means over the reference's rms
    """

    z: np.ndarray
    largest: float
    limit: float
    rms_relative: float

    @property
    def passed(self):
        """Whether no value is farther off than chance explains."""
        return bool(self.largest <= self.limit)


def z_test(pictures, reference, mask=None, *, alpha=0.01, systematic=1e-5, tolerance=0.0):
    """Compare (seeds, …, channels) with (…, channels) value by value; a :class:`ZTest`.

    The limit is Student's t for seeds − 1 degrees of freedom with the Šidák
    correction for the number of values.  `systematic` is the relative error
    allowed to the reference itself (its quadrature, the sphere's facets), and
    `tolerance` one by which the means may differ from it: z counts from there.

    >>> pictures = np.array([[0.99, 2.02], [1.01, 1.98], [1.00, 2.00]])
    >>> z_test(pictures, np.array([1.0, 2.0])).passed, z_test(pictures, np.array([1.0, 3.0])).passed
    (True, False)
    """
    pictures = np.asarray(pictures, float)
    reference = np.asarray(reference, float)
    if mask is not None:
        pictures, reference = pictures[:, mask], reference[mask]
    seeds = len(pictures)
    mean = pictures.mean(axis=0)
    held = np.clip(mean, (1.0 - tolerance) * reference, (1.0 + tolerance) * reference) if tolerance else reference
    error = pictures.std(axis=0, ddof=1) / np.sqrt(seeds)
    error = np.hypot(error, systematic * np.abs(reference) + 1e-12)
    z = (mean - held) / error
    single = 1.0 - (1.0 - alpha) ** (1.0 / z.size)
    return ZTest(z, float(np.abs(z).max()), student_t_limit(single, seeds - 1), relative_rms(mean, reference))


def relative_rms(picture, reference, mask=None):
    """Rms difference over the reference's rms.

    >>> round(relative_rms(np.array([1.0, 1.1]), np.array([1.0, 1.0])), 4)
    0.0707
    """
    if mask is not None:
        picture, reference = picture[mask], reference[mask]
    return float(np.sqrt(np.mean((picture - reference) ** 2) / max(np.mean(reference ** 2), 1e-30)))


def student_t_tails(t, degrees):
    """Probability that |T| of Student's distribution exceeds t ≥ 0, for whole degrees of freedom.

    By the finite series for whole degrees: M. Abramowitz, I. A. Stegun,
    "Handbook of Mathematical Functions", 1964, 26.7.3 and 26.7.4.

    >>> round(student_t_tails(2.570582, 5), 6), round(student_t_tails(1.0, 1), 6)
    (0.05, 0.5)
    """
    angle = math.atan2(t, math.sqrt(degrees))
    cosine, factor, total = math.cos(angle), 1.0, 0.0
    first = degrees % 2  # the series' powers of the cosine are odd for odd degrees
    for power in range(first, degrees - 1, 2):
        total += factor * cosine ** power
        factor *= (power + 1) / (power + 2)
    within = math.sin(angle) * total
    if first:
        within = 2.0 / math.pi * (angle + within)
    return 1.0 - within


def student_t_limit(probability, degrees):
    """The t that |T| exceeds with this probability, from 1e-12 to 1.

    >>> round(student_t_limit(0.05, 5), 4), round(student_t_limit(0.01, 11), 4)
    (2.5706, 3.1058)
    """
    low, high = 0.0, 1.0
    while student_t_tails(high, degrees) > probability:
        high *= 2.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if student_t_tails(middle, degrees) > probability else (low, middle)
    return 0.5 * (low + high)
