"""Coordinates apart, each in a row of its own in memory.

Where a strided array lies next to what a function writes, numpy takes it for
one that overlaps and goes by another way, which differs in the last bit.  A
fit's steps let such a bit grow, and a file would give other numbers each time.
"""

import numpy as np

__all__ = ["columns"]


def columns(x):
    """The last axis's parts of ``(..., C)``, as contiguous arrays ``(C, ...)``.

    >>> columns(np.array([[1.0, 2.0], [3.0, 4.0]])).tolist()
    [[1.0, 3.0], [2.0, 4.0]]
    """
    x = np.asarray(x, float)
    return np.ascontiguousarray(x.transpose(-1, *range(x.ndim - 1)))
