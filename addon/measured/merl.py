"""Reads .binary files of the MERL database.

W. Matusik, H. Pfister, M. Brand, L. McMillan, "A Data-Driven Reflectance
Model", ACM Transactions on Graphics 22(3), 2003: three planes, red, green and
blue, over θh (even in its root), θd and φd (even), with a scale for each.
"""

import numpy as np

from ..errors import FacetFilmError
from .half_difference import STEEPEST, angles_of, directions_of, solid_angle
from .measurement import Measurement, Samples, require_values

__all__ = ["SCALE", "Merl", "looks_like_merl", "read_merl"]

SCALE = np.array([1.0, 1.15, 1.66]) / 1500.0
"""1/sr of a stored 1 in red, green and blue."""
SIZES = ((90, 90, 180), (90, 90, 360))
STEPS = (3, 6, 20)
"""Every how many-th entry of θh, θd and φd is fitted to."""


class Merl:
    """The BRDF of a table ``(θh, θd, φd, 3)`` in 1/sr, below 0 where nothing was measured."""

    def __init__(self, table):
        self.table = table

    def angles(self, i, j, k):
        """θh, θd and φd of entries: θh goes with the square."""
        halves, differences, turns = self.table.shape[:3]
        return ((i / halves) ** 2 * np.pi / 2.0, j / differences * np.pi / 2.0, k / turns * np.pi)

    def brdf(self, v, l):
        """f in 1/sr, ``(N, 3)``: linear between the entries that were measured, 0 where none was."""
        halves, differences, turns = self.table.shape[:3]
        theta_h, theta_d, phi_d = angles_of(v, l)
        x = np.stack([np.sqrt(theta_h * (2.0 / np.pi)) * halves, theta_d * (2.0 / np.pi) * differences,
                      phi_d / np.pi * turns], axis=-1)
        x[:, :2] = np.clip(x[:, :2], 0.0, (halves - 1.0, differences - 1.0))
        low = np.floor(x).astype(int)
        low[:, :2] = np.minimum(low[:, :2], (halves - 2, differences - 2))
        share = x - low
        total, weights = 0.0, 0.0
        for corner in np.ndindex(2, 2, 2):
            at = low + corner
            f = self.table[at[:, 0], at[:, 1], at[:, 2] % turns]
            weight = np.prod(np.where(corner, share, 1.0 - share), axis=-1) * (f.min(axis=-1) >= 0.0)
            total, weights = total + weight[:, None] * f, weights + weight
        return np.maximum(total, 0.0) / np.maximum(weights, 1e-12)[:, None]


def looks_like_merl(data):
    """Whether bytes begin as a MERL file does: with three axes of a plausible length."""
    if len(data) < 12:
        return False
    sizes = np.frombuffer(data, "<i4", 3)
    return bool(np.all((sizes > 0) & (sizes <= 1024)))


def read_merl(data, name):
    """The Measurement of a .binary file's bytes.  Raises FacetFilmError for another size, and a damaged one."""
    sizes = tuple(map(int, np.frombuffer(data, "<i4", 3)))
    if sizes not in SIZES:
        raise FacetFilmError("{file!r} has {sizes} entries; a file of the MERL database has 90 × 90 × 180.", file=name,
                             sizes=" × ".join(map(str, sizes)))
    if len(data) != 12 + 8 * 3 * np.prod(sizes):
        raise FacetFilmError("{file!r} is damaged or ends too early: download it again.", file=name)
    stored = np.frombuffer(data, "<f8", offset=12).reshape(3, *sizes)
    require_values(stored, name)
    merl = Merl(np.moveaxis(stored, 0, -1) * SCALE)
    samples, rejected = _samples(merl)
    return Measurement(name, name.rsplit(".", 1)[0], "MERL", samples, rejected, merl.brdf)


def _samples(merl):
    """Entries of the table itself, so that nothing is between them; those that were not measured are left out."""
    i, j, k = (a.ravel() for a in np.meshgrid(*(
        np.arange(first, size, step) for first, size, step in zip((0, 2, 10), merl.table.shape, STEPS)),
        indexing="ij"))
    theta_h, theta_d, phi_d = merl.angles(i, j, k)
    v, l = directions_of(theta_h, theta_d, phi_d)
    f = merl.table[i, j, k]
    inside = np.minimum(v[:, 2], l[:, 2]) > np.cos(STEEPEST)
    good = inside & (f.min(axis=-1) >= 0.0)
    least = merl.angles(1, 0, 0)[0]  # the first entry is a spot about the normal
    weight = solid_angle(np.maximum(theta_h, 0.5 * least), np.sqrt(np.maximum(theta_h, 0.5 * least)), theta_d)[good]
    return Samples(v[good], l[good], f[good], weight / weight.sum()), int((inside & ~good).sum())
