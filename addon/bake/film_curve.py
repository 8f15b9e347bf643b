"""A Fresnel curve in one line, in place of a stack: ``Fresnel 0° 0.31 0.25 0.52 / 45° 0.2 0.3 0.5 / 90° 1 1 1``.

Reflectances in red, green and blue, linear Rec.709, at angles between light
and facet; between the angles √R is straight over √cos θ, as between the
entries of the tables that films are looked up in.  What was measured and has
no known layers: paints and wraps whose colour changes with the angle.
"""

import dataclasses

import numpy as np

from ..errors import FacetFilmError
from .baking import plain
from .colour import rgb_to_xyz
from .reflected import Viewing

__all__ = ["CurveTable", "curve_in_words", "curve_table", "is_curve", "knots_of"]

WORD = "Fresnel"
ROWS = 64


def is_curve(text):
    """Whether a text is meant as a curve.

    >>> is_curve("Fresnel 0° 0.1 0.1 0.1 / 90° 1 1 1"), is_curve("SiO2 60 nm / Si")
    (True, False)
    """
    return isinstance(text, str) and text.lstrip().startswith(WORD + " ")


def curve_in_words(degrees, rgb):
    """The text of a curve, ``(K,)`` and ``(K, 3)``.

    >>> curve_in_words((0, 90), [(0.1, 0.2, 0.3), (1, 1, 1)])
    'Fresnel 0° 0.1 0.2 0.3 / 90° 1 1 1'
    """
    knots = (f"{angle:g}° " + " ".join(f"{x:.9g}" for x in colour) for angle, colour in zip(degrees, rgb))
    return f"{WORD} " + " / ".join(knots)


def knots_of(text):
    """(degrees ``(K,)``, linear Rec.709 ``(K, 3)``) of a curve in words, by ascending angle.

    Raises FacetFilmError for a text that is no curve.

    >>> knots_of("Fresnel 0° 0.1 0.2 0.3 / 90° 1 1 1")[1].tolist()
    [[0.1, 0.2, 0.3], [1.0, 1.0, 1.0]]
    """
    try:
        knots = np.array([[float(word) for word in knot.replace("°", " ").split()]
                          for knot in text.strip()[len(WORD):].split("/")])
    except ValueError:
        knots = np.zeros((0, 0))
    good = knots.ndim == 2 and knots.shape[1:] == (4,) and len(knots) >= 2
    if not (good and np.all(np.diff(knots[:, 0]) > 0.0) and 0.0 <= knots[0, 0] and knots[-1, 0] <= 90.0
            and np.all((knots[:, 1:] >= 0.0) & (knots[:, 1:] <= 1.0))):
        raise FacetFilmError("A Fresnel curve is angles from 0° to 90° with three reflectances from 0 to 1 each, such "
                             "as 'Fresnel 0° 0.1 0.1 0.1 / 90° 1 1 1', not {value!r}.", value=text)
    return knots[:, 0], knots[:, 1:]


@dataclasses.dataclass(frozen=True, eq=False)
class CurveTable:
    """A curve as films' tables are looked up: one column, rows even in √cos θ.

    text     the curve in words
    viewing  whose working space the colours are in
    rgb      linear RGB, ``(rows, 1, 3)``
    """

    text: str
    viewing: Viewing
    rgb: np.ndarray
    thickness_range_nm = (0.0, 0.0)
    is_pane = False
    absorbs = False

    @property
    def size(self):
        """(rows, columns)."""
        return self.rgb.shape[:2]

    def pixels(self):
        """What an image of it holds, ``(rows, 1, 4)`` in single precision: √R, and alpha 1."""
        found = np.ones((*self.size, 4), np.float32)
        found[..., :3] = np.sqrt(self.rgb)
        return found

    def at(self, cos_theta, thickness_nm=0.0):
        """Linear RGB as a renderer reads it, ``(..., 3)``; there is one thickness."""
        cos_theta, _ = np.broadcast_arrays(np.asarray(cos_theta, float), thickness_nm)
        row = np.sqrt(np.clip(cos_theta, 0.0, 1.0)) * (ROWS - 1)
        low = np.minimum(row.astype(int), ROWS - 2)
        share = (row - low)[..., None]
        root = np.sqrt(self.rgb[:, 0])
        return (root[low] * (1.0 - share) + root[low + 1] * share) ** 2

    def said(self):
        """One sentence on it."""
        return "A Fresnel curve over the angle, as it was given."

    def curves(self, thicknesses_nm, cos_theta):
        """The linear RGB over the angle, the same at each thickness, ``(D, A, 3)``."""
        return np.stack([self.at(cos_theta)] * len(thicknesses_nm))

    def to_dict(self):
        """What a record keeps of it, ready for JSON."""
        return plain({"stack": self.text, "space": self.viewing.space, "f0": self.rgb[-1, 0].tolist(),
                      "table": {"size": self.size}})


def curve_table(text, viewing=None):
    """The CurveTable of a curve in words.

    >>> curve_table("Fresnel 0° 0.25 0.25 0.25 / 90° 1 1 1").at(1.0).tolist()
    [0.25, 0.25, 0.25]
    """
    viewing = viewing or Viewing()
    degrees, rgb = knots_of(text)
    knots = np.sqrt(np.clip(np.cos(np.radians(degrees)), 0.0, 1.0))
    grid = np.linspace(0.0, 1.0, ROWS)
    root = np.stack([np.interp(grid, knots[::-1], channel[::-1]) for channel in np.sqrt(rgb).T], axis=-1)
    colours = root**2
    if viewing.space != "Rec.709":
        to_space = np.linalg.solve(rgb_to_xyz(viewing.space), rgb_to_xyz("Rec.709"))
        colours = np.clip(colours @ to_space.T, 0.0, 1.0)
    return CurveTable(text.strip(), viewing, colours[:, None])
