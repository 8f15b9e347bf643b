"""Reads scattered points of a BRDF as text: θi φi θo φo, then red green blue, or a value for each wavelength.

Columns may have a heading; angles are in degrees or radians, as the heading
says, else as their size shows.  Wavelengths in nm head their columns.
"""

import re

import numpy as np

from ..bake.colour import spectral_weights
from ..errors import FacetFilmError
from ..spectra.observers import WAVELENGTH_NM
from .measurement import Measurement, Samples, require_values

__all__ = ["FEWEST", "read_points"]

FEWEST = 100
"""Points that a fit needs: with forty noisy ones it finds what is not there."""
SPLIT = re.compile(r"[\s,;]+")
COMMENT = ("#", "//", "%")
ANGLES = {
    "theta_i": ("theta_i", "thetai", "theta_in", "θi", "theta_l", "incident_theta"),
    "phi_i": ("phi_i", "phii", "phi_in", "φi", "phi_l", "incident_phi"),
    "theta_o": ("theta_o", "thetao", "theta_r", "theta_out", "θo", "theta_v", "exitant_theta"),
    "phi_o": ("phi_o", "phio", "phi_r", "phi_out", "φo", "phi_v", "exitant_phi"),
}
CHANNELS = {"r": 0, "red": 0, "g": 1, "green": 1, "b": 2, "blue": 2}
VISIBLE = (450.0, 650.0)
"""What wavelengths have to reach from and to, in nm."""


def read_points(text, name):
    """The Measurement of a text.  i is the light's direction, o the viewer's; values are f in 1/sr.

    Raises FacetFilmError for a text without such columns, and for too few points.
    """
    heading, rows = _rows(text)
    if not rows:
        raise FacetFilmError("{file!r} holds no measured BRDF: take .bsdf of RGL-EPFL, .binary of MERL, or a text of "
                             "points, each θi φi θo φo and red green blue.", file=name)
    table, notes = np.array(rows), []
    angles, colour = _columns(heading, table, name)
    found = table[:, angles]
    if _in_degrees(heading, found):
        found = np.radians(found)
        notes.append("angles in degrees")
    else:
        notes.append("angles in radians")
    f = _rgb(heading, table, colour, name)
    require_values(np.nan_to_num(f), name)
    return _measurement(found, f, name, tuple(notes))


def _measurement(angles, f, name, notes):
    theta_i, phi_i, theta_o, phi_o = angles.T
    l, v = _direction(theta_i, phi_i), _direction(theta_o, phi_o)
    horizon = np.cos(np.radians(85.0))
    good = (np.minimum(l[:, 2], v[:, 2]) > horizon) & np.all(np.isfinite(f), axis=-1) & np.all(f >= 0.0, axis=-1)
    count = int(good.sum())
    if count < FEWEST:
        raise FacetFilmError("{file!r} has {count} usable points; a fit needs {fewest}, and 400 where they are noisy.",
                             file=name, count=count, fewest=FEWEST)
    if np.ptp(np.sin(phi_o - phi_i)[good]) < 1e-3:
        notes += ("all points are in the plane of incidence: the fit knows nothing of the rest",)
    samples = Samples(v[good], l[good], f[good], np.full(count, 1.0 / count))
    return Measurement(name, name.rsplit(".", 1)[0], "points", samples, int((~good).sum()), notes=notes)


def _direction(theta, phi):
    return np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=-1)


def _rows(text):
    """(words of the heading, rows of numbers of one length)."""
    heading, rows = [], []
    for line in text.splitlines():
        said = line.strip()
        words = [word for word in SPLIT.split(said.lstrip("#/% ")) if word]
        numbers = [] if said.startswith(COMMENT) else _numbers(words)
        if numbers:
            rows.append(numbers)
        elif words and not rows and any(word.lower().startswith(("theta", "θ", "phi", "φ")) for word in words):
            heading = words
    width = len(rows[0]) if rows else 0
    return heading, [row for row in rows if len(row) == width and width >= 7]


def _numbers(words):
    try:
        return [float(word) for word in words]
    except ValueError:
        return []


def _columns(heading, table, name):
    """(columns of the four angles, columns of the values)."""
    plain = [_plain(word) for word in heading]
    if not heading:
        if table.shape[1] != 7:
            raise FacetFilmError("{file!r} has {count} columns without a heading: name them, as in theta_i phi_i "
                                 "theta_o phi_o 450 550 650.", file=name, count=table.shape[1])
        return [0, 1, 2, 3], [4, 5, 6]
    angles = [next((i for i, word in enumerate(plain) if word in ANGLES[angle]), None) for angle in ANGLES]
    if None in angles or len(heading) != table.shape[1]:
        raise FacetFilmError("{file!r} has a heading that does not name theta_i, phi_i, theta_o, phi_o and a column "
                             "for every number.", file=name)
    return angles, [i for i in range(len(plain)) if i not in angles]


def _plain(word):
    return re.sub(r"[\[(].*", "", word.lower()).removesuffix("_deg").removesuffix("_rad").strip("_")


def _in_degrees(heading, angles):
    said = " ".join(heading).lower()
    if "deg" in said or "°" in said:
        return True
    return "rad" not in said and bool(np.nanmax(np.abs(angles[:, [0, 2]])) > np.pi / 2.0 + 0.01)


def _rgb(heading, table, columns, name):
    """Linear Rec.709 of the values, ``(N, 3)``: as they are, or of the spectrum under D65."""
    plain = [_plain(heading[i]) if heading else "rgb"[j] for j, i in enumerate(columns)]
    if len(columns) == 3 and set(plain) <= set(CHANNELS) and len({CHANNELS[word] for word in plain}) == 3:
        return table[:, [columns[i] for i in np.argsort([CHANNELS[word] for word in plain])]]
    try:
        wavelengths = np.array([float(word.removesuffix("nm").strip("_λ")) for word in plain])
    except ValueError:
        wavelengths = np.zeros(0)
    order = np.argsort(wavelengths)
    if len(wavelengths) < 3 or wavelengths.min() > VISIBLE[0] or wavelengths.max() < VISIBLE[1]:
        raise FacetFilmError("{file!r} names its values neither red, green and blue nor by wavelengths in nm that "
                             "reach from 450 to 650.", file=name)
    values = table[:, [columns[i] for i in order]]
    good = np.all(values >= 0.0, axis=-1)[:, None]  # colours outside of the gamut are none of the measurement's fault
    rgb = np.maximum(np.where(good, values, 0.0) @ _resampling(wavelengths[order]) @ spectral_weights("D65"), 0.0)
    return np.where(good, rgb, -1.0)


def _resampling(wavelengths):
    """Matrix ``(W, 421)`` of straight lines between wavelengths, the ends held."""
    return np.array([np.interp(WAVELENGTH_NM, wavelengths, row) for row in np.eye(len(wavelengths))])

