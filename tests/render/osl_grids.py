"""Arguments for the functions of the OSL scripts: in double precision, of values that single precision has too."""

import itertools
from types import SimpleNamespace

import numpy as np


def single(*values):
    """The values as single precision rounds them; of a SimpleNamespace, its members."""
    rounded = [_single(value) for value in values]
    return rounded[0] if len(rounded) == 1 else rounded


def _single(value):
    if isinstance(value, SimpleNamespace):
        return SimpleNamespace(**{name: _single(member) for name, member in vars(value).items()})
    return np.asarray(value, np.float32).astype(float)


def grid(*axes):
    """Every combination of the axes' values, as one array an axis, (cases,)."""
    return [single(values) for values in zip(*itertools.product(*axes))]


def spread(count, *ranges):
    """Points spread evenly over the ranges (low, high), one array a range, (count,).

    The fractions of the multiples of powers of 1/g, g the root of g^(n + 1) = g + 1 for n ranges
    (M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018).
    """
    g = 1.5
    for _ in range(60):
        g = (1.0 + g) ** (1.0 / (len(ranges) + 1.0))
    steps = g ** -np.arange(1.0, len(ranges) + 1.0)
    points = (0.5 + np.arange(count)[:, None] * steps) % 1.0
    return [single(low + (high - low) * column) for (low, high), column in zip(ranges, points.T)]


def about(axis, cosine, azimuth):
    """Unit directions at the angle of this cosine from the axes, (cases, 3)."""
    tangent = np.cross(axis, [0.36, 0.48, 0.8])
    tangent = tangent / np.linalg.norm(tangent, axis=-1, keepdims=True)
    sine = np.sqrt(1.0 - cosine * cosine)[:, None]
    around = np.cos(azimuth)[:, None] * tangent + np.sin(azimuth)[:, None] * np.cross(axis, tangent)
    return single(cosine[:, None] * axis + sine * around)


def tangent_in_the_scripts(axis):
    """The unit tangent, at right angles to X or Z, from which both scripts count azimuths; (cases, 3)."""
    beside = np.where(np.abs(axis[:, :1]) < 0.7, [1.0, 0.0, 0.0], [0.0, 0.0, 1.0])
    tangent = np.cross(axis, beside)
    return tangent / np.linalg.norm(tangent, axis=-1, keepdims=True)


def column(values):
    """Numbers as colours of one channel: (cases,) to (cases, 1)."""
    return np.asarray(values)[:, None]


def joined(result):
    """A formula's result, or tuple of results, as one table (cases, numbers)."""
    parts = result if isinstance(result, (tuple, list)) else [result]
    return np.concatenate([np.reshape(part, (len(part), -1)) for part in parts], axis=1)
