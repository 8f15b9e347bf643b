"""The table of Cook and Torrance's parameters, by the paper's symbols."""

import dataclasses

from ...errors import FacetFilmError, number
from ..parameters import Choice, Colour, Direction, Number, Parameter, Socket, Triple, checked_class

__all__ = ["CookTorrance", "MOST_SLOPES", "TABLE", "slope_operands", "slopes_of"]

MOST_SLOPES = 4
SMALLEST_SLOPE = 0.001
UNUSED = (0.2, 0.4, 0.1, 0.6)
"""What the sliders of slopes stand at that have no weight."""


@dataclasses.dataclass(frozen=True, kw_only=True)
class Slopes(Parameter):
    """Up to four pairs (m, w), two sockets each."""

    def sockets(self):
        """Slope and weight of each; the first two open to see."""
        (m, w), = self.default
        return tuple(socket for j in range(MOST_SLOPES) for socket in (
            Socket(f"Slope {j + 1}", f"m{j + 1}", "FLOAT", m if j == 0 else UNUSED[j],
                   "Rms slope m of the facets: 0.1 is polished, 0.2 satin, 0.5 rough", SMALLEST_SLOPE, 1.0,
                   subtype="FACTOR", panel="More Slopes" if j else "", never_zero=True),
            Socket(f"Weight {j + 1}", f"w{j + 1}", "FLOAT", 0.0 if j else w,
                   "Share w of this slope; the shares of all slopes sum to 1", 0.0, 1.0, subtype="FACTOR",
                   panel="More Slopes" if j else "")))

    def checked(self, value):
        """As :func:`slopes_of`."""
        return slopes_of(value)

    def written(self, value):
        """All four pairs, those that are not used with a weight of 0."""
        pairs = value + tuple((m, 0.0) for m in UNUSED[len(value):])
        return {f"{name} {j}": pair[i] for j, pair in enumerate(pairs, 1) for i, name in enumerate(("Slope", "Weight"))}

    def read(self, values):
        """Those that have a weight; the first where none has."""
        pairs = tuple((values[f"Slope {j}"], values[f"Weight {j}"]) for j in range(1, MOST_SLOPES + 1))
        return tuple(pair for pair in pairs if pair[1] > 0.0) or pairs[:1]

    def range_text(self):
        """One to four pairs."""
        return f"1 to {MOST_SLOPES} pairs; m above 0, at most 1; w 0 to 1, their sum at most 1"


def slopes_of(slopes):
    """Checked (m, w) pairs.

    >>> slopes_of([(0.4, 0.4), (0.2, 0.6)])
    ((0.4, 0.4), (0.2, 0.6))
    >>> slopes_of([(0.4, 0.0)])
    Traceback (most recent call last):
    ...
    addon.errors.FacetFilmError: The weights of slopes must sum to more than 0 and at most 1, not 0.
    """
    try:
        pairs = [tuple(pair) for pair in slopes]
    except TypeError:
        pairs = None
    if not pairs or any(len(pair) != 2 for pair in pairs) or len(pairs) > MOST_SLOPES:
        raise FacetFilmError(
            f"slopes must be one to {MOST_SLOPES} pairs (rms slope m, weight w), such as "
            f"[(0.4, 0.4), (0.2, 0.6)], not {slopes!r}.")
    pairs = tuple((number(f"slope m {j}", m, high=1.0, above=0.0), number(f"weight w {j}", w, 0.0, 1.0))
                  for j, (m, w) in enumerate(pairs, 1))
    total = sum(w for _, w in pairs)
    if not 0.0 < total <= 1.0 + 1e-6:
        raise FacetFilmError(f"The weights of slopes must sum to more than 0 and at most 1, not {total:g}.")
    return pairs


TABLE = (
    Number(name="specular", symbol="s", socket="Specular", default=1.0, low=0.0, high=1.0, subtype="FACTOR",
           tip="Share s of the light that the facets reflect; the rest d = 1 - s is diffuse"),
    Colour(name="diffuse", symbol="π Rd", socket="Diffuse Color", default=(0.8, 0.8, 0.8), low=0.0, high=1.0,
           tip="Diffuse reflectance pi Rd, in the paper the reflectance at normal incidence"),
    Triple(name="n", symbol="n", socket="Refractive Index n", default=(0.2, 0.92, 1.1), above=0.0, high=100.0,
           slider=(0.001, 100.0), tip="Real part of the complex refractive index for red, green and blue"),
    Triple(name="k", symbol="k", socket="Extinction k", default=(3.91, 2.45, 2.14), low=0.0, high=100.0,
           tip="Imaginary part of the complex refractive index for red, green and blue; 0 for dielectrics"),
    Slopes(name="slopes", symbol="m, w", default=((0.2, 1.0),),
           tip="Pairs of the facets' rms slope m and its share w"),
    Choice(name="distribution", symbol="D", socket="Gaussian", key="gaussian", default="beckmann",
           options=("beckmann", "gaussian"), panel="Model",
           tip="0: Beckmann slope distribution; 1: Gaussian slope distribution"),
    Choice(name="scale", socket="Published Scale", key="published", default="energy", options=("energy", "published"),
           panel="Model", tip="0: energy-conserving scale; 1: as printed, four times as bright, "
                              "which can reflect more light than arrives"),
    Number(name="gaussian_c", symbol="c", socket="Gaussian c", default=1.0, low=0.0, high=1000.0, panel="Model",
           tip="The paper's arbitrary factor of the Gaussian distribution, used in the published scale only"),
    Direction(name="normal", symbol="N", socket="Normal",
              tip="Shading normal; the surface's own where nothing is plugged in"),
    Number(name="sampling_width", socket="Sampling Width", key="width", default=0.2, low=0.0, high=1.0,
           subtype="FACTOR", realisations=("exact", "osl"),
           tip="0: the formula itself, by mirrors, lit only by what they happen to hit; above: narrow lobes, "
               "as a share of the slope, which lamps of any size light and which blur the formula a little"),
)


class CookTorrance(checked_class("CookTorrance", TABLE)):
    """One material of the 1982 model, by the paper's symbols; a field a row of TABLE.

    >>> CookTorrance().changed(specular=0.1).specular
    0.1
    >>> CookTorrance().changed(speculr=0.1)
    Traceback (most recent call last):
    ...
    addon.errors.FacetFilmError: parameter 'speculr' is unknown; did you mean 'specular' or 'scale'? Valid: \
'specular', 'diffuse', 'n', 'k', 'slopes', 'distribution', 'scale', 'gaussian_c', 'sampling_width'.
    """


def slope_operands(sockets):
    """The (m, w) pairs among the operands that :func:`addon.models.parameters.add_inputs` made."""
    return [(getattr(sockets, f"m{j}"), getattr(sockets, f"w{j}")) for j in range(1, MOST_SLOPES + 1)]
