"""The table of Cook and Torrance's parameters, by the paper's symbols."""

from ...errors import FacetFilmError, number
from ...operands import clip, maximum, part
from ..parameters import Choice, Colour, Direction, Number, Parameter, Socket, Triple, checked_class

__all__ = ["CookTorrance", "MOST_SLOPES", "SMALLEST_SLOPE", "TABLE", "slope_operands", "slopes_of"]

MOST_SLOPES = 4
SMALLEST_SLOPE = 0.001
USUAL_SLOPE = 0.2
UNUSED_RATIOS = (1.0, 2.0, 0.5, 3.0)
"""What the sliders of slopes stand at that have no weight."""

SAME = 1e-4
"""Relative difference up to which a roughness and a slope are the same."""


def rms_slope(roughness):
    """m = roughness², as Blender's closures have it, and never quite 0.

    >>> rms_slope(0.3), rms_slope(0.2 ** 0.5), rms_slope(0.0)
    (0.09, 0.2, 0.001)
    """
    return max(round(roughness * roughness, 12), SMALLEST_SLOPE)  # a root squared is the number again


def _shown_slope(roughness):
    return f"m {rms_slope(roughness):.3g}"


class Roughness(Number):
    """The first slope said otherwise: √m. All slopes follow it in proportion."""

    unsaid = None


class Slopes(Parameter):
    """Up to four pairs (m, w): the first m from Roughness, the others as ratios to it, and a weight each."""

    unsaid = None

    def sockets(self):
        """All but Roughness: a ratio for each slope after the first, and a weight each."""
        found = []
        for j in range(1, MOST_SLOPES + 1):
            if j > 1:
                found.append(Socket(f"Slope Ratio {j}", f"ratio{j}", "FLOAT", UNUSED_RATIOS[j - 1],
                                    f"Rms slope m{j} of this roughness over that of the first, m{j}/m1", 0.001, 1000.0,
                                    panel=self.panel, never_zero=True))
            found.append(Socket(f"Weight {j}", f"w{j}", "FLOAT", 1.0 if j == 1 else 0.0,
                                f"Share w{j} of this slope; the shares of all slopes sum to 1", 0.0, 1.0,
                                subtype="FACTOR", panel=self.panel))
        return tuple(found)

    def is_in(self, values):
        """Of a group of today, or of one of 0.1.0, which held the slopes themselves."""
        return "Weight 1" in values and ("Roughness" in values or "Slope 1" in values)

    def checked(self, value):
        """As :func:`slopes_of`."""
        return slopes_of(value)

    def written(self, value):
        """Ratios and weights of all four, those that are not used with a weight of 0."""
        first = value[0][0]
        pairs = [(m / first, w) for m, w in value] + [(ratio, 0.0) for ratio in UNUSED_RATIOS[len(value):]]
        ratios = {f"Slope Ratio {j}": ratio for j, (ratio, _) in enumerate(pairs, 1) if j > 1}
        return {**ratios, **{f"Weight {j}": w for j, (_, w) in enumerate(pairs, 1)}}

    def read(self, values):
        """The first, and those others that have a weight."""
        numbers = range(1, MOST_SLOPES + 1)
        if "Roughness" in values:
            first = rms_slope(values["Roughness"])
            slopes = [first * (values[f"Slope Ratio {j}"] if j > 1 else 1.0) for j in numbers]
        else:
            slopes = [values[f"Slope {j}"] for j in numbers]
        pairs = [(min(m, 1.0), values[f"Weight {j}"]) for j, m in zip(numbers, slopes)]
        return (pairs[0], *(pair for pair in pairs[1:] if pair[1] > 0.0))

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
    Roughness(name="roughness", symbol="√m", socket="Roughness", default=USUAL_SLOPE ** 0.5, low=0.0, high=1.0,
              subtype="FACTOR", never_zero=True, beside=_shown_slope,
              tip="Its square is the rms slope m of the facets: 0.3 is polished, 0.45 satin, 0.7 rough. All slopes "
                  "follow it in proportion"),
    Colour(name="tint", socket="Tint", default=(1.0, 1.0, 1.0), low=0.0, high=1.0,
           tip="Dyes what metals reflect, at normal incidence by just this, and the diffuse part; highlights of "
               "dielectrics, whose k is 0, stay as they are"),
    Number(name="anisotropy", symbol="a", socket="Anisotropy", default=0.0, low=0.0, below=1.0, slider=(0.0, 0.999),
           subtype="FACTOR",
           tip="Above 0 the slopes are m/√(1 - 0.9 a) along the tangent, where they end at 1, and m √(1 - 0.9 a) "
               "across it"),
    Number(name="rotation", socket="Rotation", default=0.0, low=0.0, high=1.0, subtype="FACTOR",
           tip="Turns the tangent about the normal; 1 is a whole turn"),
    Number(name="specular", symbol="s", socket="Specular", default=1.0, low=0.0, high=1.0, subtype="FACTOR",
           tip="Share s of the light that the facets reflect; the rest d = 1 - s is diffuse"),
    Colour(name="diffuse", symbol="π Rd", socket="Diffuse Color", default=(0.8, 0.8, 0.8), low=0.0, high=1.0,
           tip="Diffuse reflectance pi Rd, in the paper the reflectance at normal incidence"),
    Number(name="sampling_width", socket="Sampling Width", key="width", default=0.2, low=0.0, high=1.0,
           subtype="FACTOR", realisations=("exact", "osl"),
           tip="0: the formula itself, by mirrors, lit only by what they happen to hit; above: narrow lobes, "
               "as a share of the slope, which lamps of any size light and which blur the formula a little"),
    Direction(name="normal", symbol="N", socket="Normal",
              tip="Shading normal; the surface's own where nothing is plugged in"),
    Direction(name="tangent", socket="Tangent",
              tip="Direction that anisotropy is along; around the object's Z axis where nothing is plugged in"),
    Triple(name="n", symbol="n", socket="Refractive Index n", default=(0.2, 0.92, 1.1), above=0.0, high=100.0,
           slider=(0.001, 100.0), panel="Refractive Index",
           tip="Real part of the complex refractive index for red, green and blue"),
    Triple(name="k", symbol="k", socket="Extinction k", default=(3.91, 2.45, 2.14), low=0.0, high=100.0,
           panel="Refractive Index",
           tip="Imaginary part of the complex refractive index for red, green and blue; 0 for dielectrics"),
    Slopes(name="slopes", symbol="m, w", default=((USUAL_SLOPE, 1.0),), panel="Slopes",
           tip="Pairs of the facets' rms slope m and its share w; the first m is the roughness squared"),
    Choice(name="distribution", symbol="D", socket="Gaussian", key="gaussian", default="beckmann",
           options=("beckmann", "gaussian"), panel="Model",
           tip="0: Beckmann slope distribution; 1: Gaussian slope distribution"),
    Choice(name="scale", socket="Published Scale", key="published", default="energy", options=("energy", "published"),
           panel="Model", tip="0: energy-conserving scale; 1: as printed, four times as bright, "
                              "which can reflect more light than arrives"),
    Number(name="gaussian_c", symbol="c", socket="Gaussian c", default=1.0, low=0.0, high=1000.0, panel="Model",
           tip="The paper's arbitrary factor of the Gaussian distribution, used in the published scale only"),
)


class CookTorrance(checked_class("CookTorrance", TABLE)):
    """One material of the 1982 model, by the paper's symbols; a field a row of TABLE.

    >>> CookTorrance().changed(specular=0.1).specular
    0.1
    >>> CookTorrance().changed(speculr=0.1)
    Traceback (most recent call last):
    ...
    addon.errors.FacetFilmError: parameter 'speculr' is unknown; did you mean 'specular' or 'scale'? Valid: \
'roughness', 'tint', 'anisotropy', 'rotation', 'specular', 'diffuse', 'sampling_width', 'n', 'k', 'slopes', \
'distribution', 'scale', ….
    """

    def __post_init__(self):
        """Roughness and slopes from each other, where one of them is not said."""
        super().__post_init__()
        slopes = self.slopes or _in_proportion(((USUAL_SLOPE, 1.0),), self.roughness)
        roughness = slopes[0][0] ** 0.5 if self.roughness is None else self.roughness
        m = rms_slope(roughness)
        if abs(m - max(slopes[0][0], SMALLEST_SLOPE)) > SAME * m:
            raise FacetFilmError("A roughness of {roughness:g} means a rms slope of {m:g}, and slopes begin with "
                                 "{first:g}: give one of them.", roughness=roughness, m=m, first=slopes[0][0])
        object.__setattr__(self, "slopes", slopes)
        object.__setattr__(self, "roughness", roughness)

    def check(self, row, value):
        """As the row has it; roughness and slopes may be left to each other."""
        return None if value is None and row.unsaid is None else row.checked(value)

    def changed(self, **parameters):
        """The same with other values for the named parameters; slopes keep their proportions at another roughness.

        >>> copper = CookTorrance(slopes=[(0.4, 0.4), (0.2, 0.6)])
        >>> [(round(m, 4), w) for m, w in copper.changed(roughness=0.2 ** 0.5).slopes]
        [(0.2, 0.4), (0.1, 0.6)]
        >>> round(copper.changed(slopes=[(0.09, 1.0)]).roughness, 6)
        0.3
        """
        roughness = parameters.get("roughness")
        if "slopes" in parameters:
            parameters.setdefault("roughness", None)
        elif roughness is not None:
            parameters["slopes"] = _in_proportion(self.slopes, ROUGHNESS.checked(roughness))
        return super().changed(**parameters)


ROUGHNESS = TABLE[0]


def _in_proportion(slopes, roughness):
    """The (m, w) pairs, the first of this roughness; as they are where that is None."""
    if roughness is None:
        return slopes
    factor = rms_slope(roughness) / slopes[0][0]
    return tuple((min(factor * m, 1.0), w) for m, w in slopes)


def slope_operands(sockets):
    """The (m, w) pairs among the operands that :func:`addon.models.parameters.add_inputs` made."""
    ratios = [getattr(sockets, f"ratio{j}") for j in range(2, MOST_SLOPES + 1)]
    return [(m, getattr(sockets, f"w{j}")) for j, m in enumerate(_slopes(sockets.roughness, *ratios), 1)]


@part("Slopes m", "m1", "m2", "m3", "m4")
def _slopes(roughness, ratio2, ratio3, ratio4):
    """The rms slopes of a roughness and of ratios to the first."""
    first = maximum(roughness * roughness, SMALLEST_SLOPE)
    return first, *(clip(first * ratio, SMALLEST_SLOPE, 1.0) for ratio in (ratio2, ratio3, ratio4))
