"""Specks in pictures of few samples: pixels that shine out of their surroundings."""

import numpy as np

__all__ = ["MOST", "salt"]

MOST = 8.0
"""Local standard deviations by which a pixel may exceed what it converges to."""


def salt(pictures, mask):
    """By how many local standard deviations each pixel exceeds the mean of the other pictures, ``(seeds, pixels)``.

    pictures  of independent seeds, ``(seeds, height, width)``
    mask      the pixels that count, ``(height, width)``

    The local deviation is that of a pixel and its eight neighbours over all pictures but the one in question.
    """
    found = []
    for number, picture in enumerate(pictures):
        others = np.delete(pictures, number, axis=0)
        variance = np.pad(others.var(axis=0, ddof=1), 1, mode="edge")
        height, width = picture.shape
        local = np.mean([variance[i:i + height, j:j + width] for i in range(3) for j in range(3)], axis=0)
        found.append(((picture - others.mean(axis=0)) / np.sqrt(np.maximum(local, 1e-12)))[mask])
    return np.array(found)
