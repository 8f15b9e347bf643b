"""Reads .bsdf files of the RGL-EPFL database: isotropic ones in RGB.

J. Dupuy, W. Jakob, "An Adaptive Parameterization for Efficient Material
Acquisition and Rendering", ACM Transactions on Graphics 37(6), 2018.  The file
tables f·cos θo, over random numbers of a warp that draws visible normals; held
against Mitsuba's plugin "measured".
"""

import numpy as np

from ..errors import FacetFilmError
from .bilinear import Density, Table
from .half_difference import grid
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
        m = v + l
        m = m / np.linalg.norm(m, axis=-1, keepdims=True)
        theta_i, theta_m = _elevation(v), _elevation(m)
        turn = (np.arctan2(m[:, 1], m[:, 0]) - np.arctan2(v[:, 1], v[:, 0]) + np.pi) / (2.0 * np.pi)
        at_m = np.stack([_unit(theta_m), turn - np.floor(turn)], axis=-1)
        found = self._rgb.at(self._visible.inverted(at_m, theta_i), theta_i)
        if self._scaled:
            at_i = np.stack([_unit(theta_i), np.zeros_like(theta_i)], axis=-1)
            found = found * (self._facets.at(at_m) / (4.0 * self._area.at(at_i)))[:, None]
        above = (v[:, 2] > 0.0) & (l[:, 2] > 0.0)
        return np.where(above[:, None], np.maximum(found, 0.0), 0.0)

    def brdf(self, v, l):
        """f in 1/sr, ``(N, 3)``."""
        return self.f_cos(v, l) / np.maximum(l[:, 2:], LEAST_COSINE)


def read_rgl(data, name):
    """The Measurement of a .bsdf file's bytes.  Raises FacetFilmError for anisotropic, spectral and damaged ones."""
    fields = fields_of(data, name)
    _require_isotropic_rgb(fields, name)
    brdf = Rgl(fields).brdf
    v, l, weight = grid()
    f = brdf(v, l)
    title = fields["description"].tobytes().decode("utf-8", "replace").strip() if "description" in fields else ""
    good = np.all(np.isfinite(f), axis=-1) & np.any(f > 0.0, axis=-1)
    samples = Samples(v[good], l[good], f[good], weight[good] / weight[good].sum())
    return Measurement(name, title or name.rsplit(".", 1)[0], "RGL", samples, int((~good).sum()), brdf)


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


def _elevation(x):
    """Angle from the z axis in radians, exact near it too."""
    return 2.0 * np.arcsin(np.clip(0.5 * np.linalg.norm(x - (0.0, 0.0, 1.0), axis=-1), 0.0, 1.0))


def _unit(theta):
    """√(2θ/π): what a table's first coordinate is."""
    return np.sqrt(theta * (2.0 / np.pi))
