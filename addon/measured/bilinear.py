"""Tables over the unit square, one for each angle of incidence, and the warp that a table is as a density.

Dupuy and Jakob 2018, "An Adaptive Parameterization for Efficient Material
Acquisition and Rendering", ACM Transactions on Graphics 37(6), section 5.3:
tables are bilinear between their nodes, and linear between two angles of
incidence.
"""

import numpy as np

__all__ = ["Density", "Table"]


class Table:
    """Values over the unit square, ``(S, rows, columns)`` or with channels ``(S, rows, columns, C)``.

    values  rows over the second coordinate, columns over the first
    angles  of the S slices, ascending, ``(S,)``
    """

    def __init__(self, values, angles=(0.0,)):
        self.values = np.ascontiguousarray(values, float)
        self.angles = np.asarray(angles, float)
        self.rows, self.columns = self.values.shape[1:3]
        self._flat = self.values.reshape(-1, *self.values.shape[3:])

    def at(self, u, angle=0.0):
        """The values at places ``(N, 2)`` and angles ``(N,)``: ``(N,)`` or ``(N, C)``."""
        i, j, x, y = self._cell(u)
        return sum(self._widened(weight * (y if dj else 1.0 - y) * (x if di else 1.0 - x)) * self._node(part, j + dj,
                                                                                                         i + di)
                   for part, weight in self._slices(angle) for dj in (0, 1) for di in (0, 1))

    def _widened(self, weight):
        return weight[:, None] if self._flat.ndim == 2 else weight

    def _cell(self, u):
        """Column, row, and the shares of the way to the next."""
        x, y = np.clip(u, 0.0, 1.0).T * ((self.columns - 1,), (self.rows - 1,))
        i = np.minimum(x.astype(int), self.columns - 2)
        j = np.minimum(y.astype(int), self.rows - 2)
        return i, j, x - i, y - j

    def _slices(self, angle):
        """((slice, weight), …): the two that an angle lies between."""
        last = len(self.angles) - 1
        if not last:
            return ((0, np.ones(1)),)
        low = np.clip(np.searchsorted(self.angles, angle, side="right") - 1, 0, last - 1)
        share = np.clip((angle - self.angles[low]) / (self.angles[low + 1] - self.angles[low]), 0.0, 1.0)
        return ((low, 1.0 - share), (low + 1, share))

    def _node(self, part, row, column):
        return self._flat[(part * self.rows + row) * self.columns + column]


class Density(Table):
    """A table as the density of a warp: positive values, each slice scaled to the mean 1."""

    def __init__(self, values, angles=(0.0,)):
        values = np.asarray(values, float)
        rows, columns = values.shape[1:3]
        along = np.zeros_like(values)
        along[:, :, 1:] = np.cumsum(0.5 * (values[:, :, 1:] + values[:, :, :-1]), axis=2)
        across = np.zeros(values.shape[:2])
        across[:, 1:] = np.cumsum(0.5 * (along[:, 1:, -1] + along[:, :-1, -1]), axis=1)
        whole = across[:, -1]
        super().__init__(values / whole[:, None, None], angles)
        self._along = (along / whole[:, None, None]).ravel()
        self._across = (across / whole[:, None]).ravel()

    def inverted(self, u, angle):
        """The random numbers ``(N, 2)`` that the warp sends to places ``(N, 2)``: its cumulative distributions there.

        First that of the columns within the row, then that of the rows.
        """
        i, j, x, y = self._cell(u)
        slices = self._slices(angle)

        def blended(look):
            return sum(weight * look(part) for part, weight in slices)

        low = [blended(lambda part, dj=dj: self._node(part, j + dj, i)) for dj in (0, 1)]
        high = [blended(lambda part, dj=dj: self._node(part, j + dj, i + 1)) for dj in (0, 1)]
        before = [blended(lambda part, dj=dj: self._along_at(part, j + dj, i)) for dj in (0, 1)]
        whole = [blended(lambda part, dj=dj: self._along_at(part, j + dj, self.columns - 1)) for dj in (0, 1)]
        first, second = ((1.0 - y) * pair[0] + y * pair[1] for pair in (low, high))
        column = (1.0 - y) * before[0] + y * before[1] + x * (first + 0.5 * x * (second - first))
        column = column / ((1.0 - y) * whole[0] + y * whole[1])
        row = blended(lambda part: self._across[part * self.rows + j]) + y * (whole[0] + 0.5 * y * (whole[1]
                                                                                                  - whole[0]))
        return np.stack([column, row], axis=-1)

    def drawn(self, u, part):
        """The places ``(N, 2)`` that the warp of slices `part`, ``(N,)``, sends random numbers ``(N, 2)`` to.

        >>> density = Density(1.0 + np.arange(12.0).reshape(1, 3, 4))
        >>> place, slices = np.array([[0.3, 0.8]]), np.array([0])
        >>> density.drawn(density.inverted(place, np.zeros(1)), slices).round(12).tolist()
        [[0.3, 0.8]]
        """
        column, row = np.asarray(u, float).T
        across = self._across.reshape(-1, self.rows)[part]
        j = _before(across, row, self.rows)
        whole = [self._along_at(part, j + dj, self.columns - 1) for dj in (0, 1)]
        y = _way(row - np.take_along_axis(across, j[:, None], 1)[:, 0], *whole)
        along = self._along.reshape(-1, self.rows, self.columns)
        along = (1.0 - y)[:, None] * along[part, j] + y[:, None] * along[part, j + 1]
        column = column * along[:, -1]
        i = _before(along, column, self.columns)
        ends = [(1.0 - y) * self._node(part, j, i + di) + y * self._node(part, j + 1, i + di) for di in (0, 1)]
        x = _way(column - np.take_along_axis(along, i[:, None], 1)[:, 0], *ends)
        return np.stack([(i + x) / (self.columns - 1), (j + y) / (self.rows - 1)], axis=-1)

    def _along_at(self, part, row, column):
        return self._along[(part * self.rows + row) * self.columns + column]


def _before(cumulative, value, count):
    """The last of `count` nodes but one whose cumulative value ``(N, count)`` is not above a value, ``(N,)``."""
    return np.clip(np.sum(cumulative <= value[:, None], axis=1) - 1, 0, count - 2)


def _way(area, first, second):
    """The share x of the way at which the area below a straight line from first to second is this."""
    root = np.sqrt(np.maximum(first * first + 2.0 * area * (second - first), 0.0))
    return np.clip(2.0 * area / np.maximum(first + root, 1e-30), 0.0, 1.0)
