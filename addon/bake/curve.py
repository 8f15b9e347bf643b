"""A curve by as few straight pieces as keep it within a tolerance."""

import functools

import numpy as np

__all__ = ["knots"]


def knots(x, y, tolerance=1e-3):
    """Which samples to keep, ``(K,)`` indices, first and last among them.

    x  ascending, ``(N,)``
    y  ``(N, C)``: C curves that share their knots
    tolerance  above 1e-5, as slopes are compared in single precision

    Straight lines between the kept samples are within the tolerance of all
    samples, and no smaller choice of samples is.

    >>> knots(np.array([0.0, 1.0, 2.0, 3.0]), np.array([[0.0], [1.0], [2.0], [1.0]])).tolist()
    [0, 2, 3]
    """
    reach = _reachable(x, y, tolerance)
    last = len(x) - 1
    before = np.full(len(x), -1)
    frontier = np.zeros(len(x), bool)
    frontier[0] = True
    seen = frontier.copy()
    while not seen[last]:  # breadth first: as many steps as there are pieces
        sources = np.flatnonzero(frontier)
        found = reach[sources]
        new = found.any(axis=0) & ~seen
        before[new] = sources[found[:, new].argmax(axis=0)]
        seen |= new
        frontier = new
    path = [last]
    while path[-1] != 0:
        path.append(before[path[-1]])
    return np.array(path[::-1])


def _reachable(x, y, tolerance):
    """``(N, N)``: whether the straight line from sample i to sample j > i stays within the tolerance.

    Every sample between i and j leaves the line from i a range of slopes; the
    slope to j has to be in the ranges of all of them.
    """
    per_run, later = _per_run(tuple(x))
    y = np.ascontiguousarray(y.T, np.float32)
    slope = (y[:, None, :] - y[:, :, None]) * per_run
    slack = np.where(later, tolerance * per_run, np.inf)
    inside = ((slope >= np.maximum.accumulate(slope - slack, axis=2))
              & (slope <= np.minimum.accumulate(slope + slack, axis=2)))
    return inside.all(axis=0) & later


@functools.lru_cache(maxsize=4)
def _per_run(x):
    """1/(xj − xi) and whether j > i, ``(N, N)`` each; 0 where it is not."""
    run = np.subtract.outer(x, x).T
    later = run > 0.0
    return np.where(later, 1.0 / np.where(later, run, 1.0), 0.0).astype(np.float32), later
