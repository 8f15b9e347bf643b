"""A stack as a renderer takes it: a table of colours over angle and thickness, with how far off it is at worst.

Rows are even in √cos θ, as films change most near grazing, columns in
thickness; what the image holds is √R, in which straight lines between its
pixels come closer.  A stack of which nothing varies is a table of one column.
"""

import dataclasses

import numpy as np

from ..errors import FacetFilmError, choice, number
from . import film_colours
from .baking import plain
from .colour import delta_e_2000, lab
from .film_gamut import FilmGamutReport, map_film_colours
from .reflected import Viewing
from .stack_notation import written

__all__ = ["FilmTable", "film_table", "smallest_table", "curve_over_angle", "ROWS", "COLUMNS", "SIZES", "MOST_PIXELS"]

ROWS, COLUMNS = 64, 512
SIZES = ((16, 64), (32, 128), (32, 256), (64, 256), (64, 512), (64, 1024))
MOST_PIXELS = 1 << 20
MOST_AT_ONCE = 16.0
"""Of an error over the tolerance: no more than this is taken to tell which sizes cannot do."""
LOSSLESS = 2e-3
"""Absorbed shares up to this are rounding and gamut mapping of films that absorb nothing."""
LIGHTS = ("reflected", "transmitted")
COMPARED_COLUMNS = 73
"""Thicknesses between columns at which a table is held against the exact spectrum, at an angle between any two rows."""


@dataclasses.dataclass(frozen=True, eq=False)
class FilmTable:
    """Colours of a stack over angle and thickness.

    stack, viewing       that it was baked of and for
    rgb                  linear RGB in the gamut, ``(rows, columns, 3)``, rows from grazing to normal incidence
    thickness_range_nm   of the first and last column
    f0                   linear RGB at normal incidence and the first thickness, before gamut mapping
    delta_e_2000_max     largest CIEDE2000 of the table, bilinear, from the exact spectrum between its nodes, 0 to 89°
    delta_e_2000_mean    the mean
    gamut                FilmGamutReport
    of                   "reflected" or "transmitted": which light
    steps                wavelength steps in nm that it was made with: at grazing angles, at others; None where nothing
                         varies, and it is every nm
    """

    stack: object
    viewing: Viewing
    rgb: np.ndarray
    thickness_range_nm: tuple
    f0: tuple
    delta_e_2000_max: float
    delta_e_2000_mean: float
    gamut: FilmGamutReport
    of: str = "reflected"
    steps: tuple | None = None

    @property
    def size(self):
        """(rows, columns)."""
        return self.rgb.shape[:2]

    def pixels(self):
        """What an image of it holds, ``(rows, columns, 4)`` in single precision: √R, and alpha 1."""
        found = np.ones((*self.size, 4), np.float32)
        found[..., :3] = np.sqrt(self.rgb)
        return found

    def at(self, cos_theta, thickness_nm):
        """Linear RGB as a renderer reads it, ``(..., 3)``: bilinear in √R over √cos θ and thickness, ends held."""
        rows, columns = self.size
        low, high = self.thickness_range_nm
        share = (np.asarray(thickness_nm, float) - low) / (high - low or 1.0)
        y, x = np.broadcast_arrays(np.sqrt(np.clip(cos_theta, 0.0, 1.0)) * (rows - 1), share * (columns - 1))
        return _bilinear(np.sqrt(self.rgb), y, np.clip(x, 0.0, columns - 1)) ** 2

    @property
    def is_pane(self):
        """Whether there is air on both sides."""
        return self.stack.outside == self.stack.below == "air"

    @property
    def absorbs(self):
        """Whether its films absorb more than rounding."""
        visible = np.arange(400.0, 701.0, 10.0)
        return any(float(np.max(film.constants.at(visible)[1])) * film.high > LOSSLESS for film in self.stack.films)

    @property
    def text(self):
        """The stack in words."""
        return written(self.stack)

    def said(self):
        """One sentence on it."""
        return f"Largest CIEDE2000 of the table {self.delta_e_2000_max:.2f}."

    def curves(self, thicknesses_nm, cos_theta):
        """The linear RGB in the gamut of the spectra at even thicknesses ``(D,)`` and cos θ ``(A,)``, ``(D, A, 3)``."""
        if len(thicknesses_nm) == 1:
            return curve_over_angle(self.stack, self.viewing, float(thicknesses_nm[0]), cos_theta)[None]
        found = film_colours.stepped_colours(self.stack, self.viewing, cos_theta, len(thicknesses_nm),
                                             thicknesses_nm[0], thicknesses_nm[-1], self.steps, self.of)
        return np.moveaxis(map_film_colours(found, self.viewing)[0], 1, 0).astype(float)

    def to_dict(self):
        """What a record keeps of it, ready for JSON: everything but the table itself."""
        return plain({
            "stack": self.text, "k_left_out_outside": self.stack.k_left_out, "of": self.of, "f0": self.f0,
            "table": {"thickness_range_nm": self.thickness_range_nm, "size": self.size,
                      "delta_e_2000_max": self.delta_e_2000_max, "delta_e_2000_mean": self.delta_e_2000_mean},
            "gamut": self.gamut, "illuminant": self.viewing.illuminant, "observer": self.viewing.observer,
            "space": self.viewing.space, "adapted": self.viewing.adapt,
            "layers": [{"word": word, "dataset": constants.dataset, "citation": constants.citation,
                        "licence": constants.licence, "covers_visible": constants.covers_visible}
                       for word, constants in self.stack.layers]})


def film_table(stack, viewing=None, *, rows=ROWS, columns=COLUMNS, of="reflected", steps=None, errors=None,
               progress=None):
    """The FilmTable of a Stack.

    viewing        a Viewing; by default Viewing()
    rows, columns  its size, 8 or more each, at most 1,048,576 in all; a stack of
                   which nothing varies has one column
    of             "reflected" or "transmitted", into what is below
    steps          of the wavelength, as :func:`addon.bake.film_colours.steps_for` finds them where none are given
    errors         (largest, mean) CIEDE2000 of just this table, where they are known already
    progress       function that is told the share of the table that is done, for stacks that take seconds

    Raises FacetFilmError for another size or light.
    """
    viewing = viewing or Viewing()
    choice("light", of, LIGHTS)
    rows, columns = _size(rows, columns if stack.varying else 1, bool(stack.varying))
    if stack.varying:
        steps = steps or film_colours.steps_for(stack, viewing, of)
    raw = _colours(stack, viewing, np.linspace(0.0, 1.0, rows) ** 2, columns, of, steps, progress)
    rgb, report = map_film_colours(raw, viewing)
    largest, mean = errors or _errors(stack, viewing, rgb, of, steps)
    return FilmTable(stack, viewing, rgb.astype(np.float32), stack.thickness_range_nm, tuple(raw[-1, 0].tolist()),
                     largest, mean, report, of, steps)


def smallest_table(stack, viewing=None, tolerance=0.5, of="reflected", progress=None):
    """The FilmTable of the smallest of SIZES whose largest error is within a tolerance in CIEDE2000; else of the last.

    Sizes are left out that would need errors to fall faster than with the square of what is between two columns.

    >>> from .stack_notation import parse
    >>> from ..spectra.optical_constants import load
    >>> smallest_table(parse("Fe3O4 0-120 nm / Fe", load)).size
    (32, 128)
    """
    viewing = viewing or Viewing()
    steps = film_colours.steps_for(stack, viewing, of) if stack.varying else None
    least = 0
    for rows, columns in SIZES:
        if rows * columns < least:
            continue
        table = film_table(stack, viewing, rows=rows, columns=columns, of=of, steps=steps, progress=progress)
        over = table.delta_e_2000_max / max(tolerance, 1e-9)
        if over <= 1.0 or not stack.varying and rows == ROWS:
            break
        least = rows * columns * min(over, MOST_AT_ONCE) ** 0.5
    return table


def curve_over_angle(stack, viewing, thickness_nm, cos_theta):
    """The exact linear RGB in the gamut of one thickness, ``(A, 3)`` at cos θ ``(A,)``."""
    return map_film_colours(film_colours.exact_colours(stack, viewing, cos_theta, thickness_nm), viewing)[0]


def _size(rows, columns, varies):
    rows, columns = int(number("rows", rows, 8, 4096)), int(number("columns", columns, 8 if varies else 1, 65536))
    if rows * columns > MOST_PIXELS:
        raise FacetFilmError("A table has at most {most} entries, not {rows} × {columns}; take fewer rows or columns.",
                             most=MOST_PIXELS, rows=rows, columns=columns)
    return rows, columns


def _colours(stack, viewing, cos_theta, columns, of, steps, progress):
    if not stack.varying:
        thickness = np.array([stack.thickness_range_nm[0]])
        return film_colours.exact_colours(stack, viewing, cos_theta[:, None], thickness, of).astype(np.float32)
    return film_colours.stepped_colours(stack, viewing, cos_theta, columns, steps=steps, of=of, progress=progress)


def _errors(stack, viewing, rgb, of, steps):
    """(largest, mean) CIEDE2000 of the mapped table from the mapped spectra's half-way between nodes, up to 89°."""
    rows, columns = rgb.shape[:2]
    y = np.arange(rows - 1) + 0.5
    cos_theta = (y / (rows - 1)) ** 2
    y, cos_theta = y[cos_theta >= film_colours.LEAST_COS_THETA], cos_theta[cos_theta >= film_colours.LEAST_COS_THETA]
    low, high = stack.thickness_range_nm
    if columns == 1:
        x = np.zeros(1)
        exact = film_colours.exact_colours(stack, viewing, cos_theta[:, None], np.array([low]), of)
    else:
        x = np.arange(0, columns - 1, max(1, (columns - 1) // COMPARED_COLUMNS)) + 0.5
        first, last = low + x[[0, -1]] / (columns - 1) * (high - low)
        exact = film_colours.stepped_colours(stack, viewing, cos_theta, len(x), first, last, steps, of)
    exact = map_film_colours(exact, viewing)[0].astype(float)
    shown = _bilinear(np.sqrt(rgb.astype(float)), *np.meshgrid(y, x, indexing="ij")) ** 2
    found = delta_e_2000(lab(exact, viewing.space), lab(shown, viewing.space))
    return float(found.max()), float(found.mean())


def _bilinear(table, y, x):
    """The table ``(rows, columns, 3)`` at places between its entries, ``(..., 3)``."""
    rows, columns = table.shape[:2]
    i, j = (np.clip(at.astype(int), 0, max(size - 2, 0)) for at, size in ((y, rows), (x, columns)))
    right = np.minimum(j + 1, columns - 1)
    u, v = (y - i)[..., None], (x - j)[..., None]
    above = table[i, j] * (1.0 - v) + table[i, right] * v
    below = table[i + 1, j] * (1.0 - v) + table[i + 1, right] * v
    return above * (1.0 - u) + below * u
