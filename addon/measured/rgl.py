"""Reads .bsdf files of the RGL-EPFL database: isotropic ones in RGB.

J. Dupuy, W. Jakob, "An Adaptive Parameterization for Efficient Material
Acquisition and Rendering", ACM Transactions on Graphics 37(6), 2018.  The file
tables f·cos θo, over random numbers of a warp that draws visible normals; held
against Mitsuba's plugin "measured".
"""

import numpy as np

from ..columns import columns
from ..errors import FacetFilmError
from .bilinear import Density, Table
from .half_difference import STEEPEST, grid
from .measurement import Measurement, Samples, require_values
from .tensor_file import MAGIC, fields_of

__all__ = ["MAGIC", "Rgl", "read_rgl"]

NEEDED = ("theta_i", "phi_i", "ndf", "sigma", "vndf", "rgb", "jacobian")
MOST_PHI = 2
"""Azimuths of incidence that an isotropic file has at most."""
LEAST_COSINE = 1e-6


class Rgl:
    """The BRDF of a file's fields."""

    def __init__(self, fields):
        angles = fields["theta_i"]
        self._facets, self._area = (Table(fields[name][None]) for name in ("ndf", "sigma"))
        self._visible = Density(fields["vndf"][0], angles)
        self._rgb = Table(np.moveaxis(fields["rgb"][0], 1, -1), angles)
        self._scaled = bool(fields["jacobian"][0])

    def f_cos(self, v, l):
        """f·cos θo, ``(N, 3)``: θi is V's, θo is L's; 0 where one is below the horizon.

        Dupuy and Jakob 2018, equations (10) to (13); θm, φm are those of the half vector.
        """
        at_m, theta_i = self._place(v, l)
        found = self._rgb.at(self._visible.inverted(at_m, theta_i), theta_i)
        if self._scaled:
            at_i = np.stack([_unit(theta_i), np.zeros_like(theta_i)], axis=-1)
            found = found * (self._facets.at(at_m) / (4.0 * self._area.at(at_i)))[:, None]
        above = (v[:, 2] > 0.0) & (l[:, 2] > 0.0)
        return np.where(above[:, None], np.maximum(found, 0.0), 0.0)

    def entries(self, v, l):
        """(V, L) of the file's own entries nearest to directions ``(N, 3)``, ``(M, 3)`` each, and which is for which,
        ``(N,)``.
        """
        angles, (rows, columns) = self._rgb.angles, self._rgb.values.shape[1:3]
        at_m, theta_i = self._place(v, l)
        part = np.argmin(np.abs(theta_i[:, None] - angles), axis=1)
        last = np.array([columns - 1, rows - 1])
        node = np.rint(self._visible.inverted(at_m, angles[part]) * last).astype(int)
        one, which = np.unique(np.column_stack([part, node]), axis=0, return_inverse=True)
        place = self._visible.drawn(one[:, 1:] / last, one[:, 0])
        v, m = _direction(angles[one[:, 0]], 0.0), _direction(place[:, 0] ** 2 * np.pi / 2.0,
                                                              (place[:, 1] * 2.0 - 1.0) * np.pi)
        return v, 2.0 * np.sum(v * m, axis=-1, keepdims=True) * m - v, which.ravel()

    def brdf(self, v, l):
        """f in 1/sr, ``(N, 3)``."""
        return self.f_cos(v, l) / np.maximum(l[:, 2:], LEAST_COSINE)


    def _place(self, v, l):
        """Where the half vectors are in the warp's square, ``(N, 2)``, and θi."""
        m = v + l
        m = m / np.linalg.norm(m, axis=-1, keepdims=True)
        (m_x, m_y, _), (v_x, v_y, _) = columns(m), columns(v)
        turn = (np.arctan2(m_y, m_x) - np.arctan2(v_y, v_x) + np.pi) / (2.0 * np.pi)
        return np.stack([_unit(_elevation(m)), turn - np.floor(turn)], axis=-1), _elevation(v)


def read_rgl(data, name):
    """The Measurement of a .bsdf file's bytes.  Raises FacetFilmError for anisotropic, spectral and damaged ones."""
    fields = fields_of(data, name)
    _require_isotropic_rgb(fields, name)
    rgl = Rgl(fields)
    samples, rejected = _samples(rgl)
    title = fields["description"].tobytes().decode("utf-8", "replace").strip() if "description" in fields else ""
    return Measurement(name, title or name.rsplit(".", 1)[0], "RGL", samples, rejected, rgl.brdf)


def _samples(rgl):
    """(Samples, how many are left out): entries near the grid that fits sample, as what is between them is a guess."""
    v, l, weight = grid()
    v, l, which = rgl.entries(v, l)
    f, weight = rgl.brdf(v, l), np.bincount(which, weight)
    wanted = np.minimum(v[:, 2], l[:, 2]) > np.cos(STEEPEST)
    good = wanted & np.all(np.isfinite(f), axis=-1) & np.any(f > 0.0, axis=-1)
    return Samples(v[good], l[good], f[good], weight[good] / weight[good].sum()), int(np.sum(wanted & ~good))


def _require_isotropic_rgb(fields, name):
    if "spectra" in fields and "rgb" not in fields:
        raise FacetFilmError("{file!r} holds spectra: take the file of the same material that ends in _rgb.bsdf.",
                             file=name)
    if any(field not in fields for field in NEEDED):
        raise FacetFilmError("{file!r} is no BRDF of the RGL-EPFL database: it lacks some of its tables.", file=name)
    if fields["phi_i"].size > MOST_PHI:
        raise FacetFilmError("{file!r} is anisotropic: it reflects otherwise when it is turned, which the fit does "
                             "not know; take an isotropic material.", file=name)
    count = fields["theta_i"].size
    rgb, vndf = fields["rgb"].shape, fields["vndf"].shape
    fits = (len(rgb) == 5 and len(vndf) == 4 and rgb[:3] == (1, count, 3) and vndf[:2] == (1, count)
            and min(*rgb[3:], *vndf[2:]) >= 2 and all(fields[x].ndim == 2 and min(fields[x].shape) >= 2
                                                      for x in ("ndf", "sigma"))
            and count >= 2 and np.all(np.diff(fields["theta_i"]) > 0.0))
    if not fits:
        raise FacetFilmError("{file!r} has tables of the wrong dimensions: download it again.", file=name)
    for field in ("rgb", "vndf", "ndf", "sigma"):
        require_values(fields[field], name)


def _direction(theta, phi):
    return np.stack(np.broadcast_arrays(np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)),
                    axis=-1)


def _elevation(x):
    """Angle from the z axis in radians, exact near it too."""
    return 2.0 * np.arcsin(np.clip(0.5 * np.linalg.norm(x - (0.0, 0.0, 1.0), axis=-1), 0.0, 1.0))


def _unit(theta):
    """√(2θ/π): what a table's first coordinate is."""
    return np.sqrt(theta * (2.0 / np.pi))
