"""A curve by as few straight pieces as keep it within a tolerance."""

import numpy as np

__all__ = ["knots"]


def knots(x, y, tolerance=1e-3):
    """Which samples to keep, ``(K,)`` indices, first and last among them.

    x  ascending, ``(N,)``
    y  ``(N, C)``: C curves that share their knots

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
        found = reach & frontier[:, None]
        new = found.any(axis=0) & ~seen
        before[new] = found[:, new].argmax(axis=0)
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
    x, y = x[:, None, None], y[:, None, :]
    run = np.swapaxes(x, 0, 1) - x
    later = run > 0.0
    run = np.where(later, run, 1.0)
    rise = np.swapaxes(y, 0, 1) - y
    lowest = np.where(later, (rise - tolerance) / run, -np.inf)
    highest = np.where(later, (rise + tolerance) / run, np.inf)
    slope = rise / run
    inside = ((slope >= np.maximum.accumulate(lowest, axis=1))
              & (slope <= np.minimum.accumulate(highest, axis=1)))
    return inside.all(axis=2) & later[..., 0]
