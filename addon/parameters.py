"""The parameters of a Cook-Torrance material, checked: what scripts, panels and presets all go through."""

from dataclasses import dataclass, replace

from .errors import FacetFilmError, choice, number, numbers_of

__all__ = ["CookTorrance", "REALISATIONS", "DISTRIBUTIONS", "SCALES", "DEFAULT_SAMPLING_WIDTH"]

REALISATIONS = ("fast", "exact", "osl", "osl_fast")
DISTRIBUTIONS = ("beckmann", "gaussian")
SCALES = ("energy", "published")
MOST_SLOPES = 4
DEFAULT_SAMPLING_WIDTH = 0.2


@dataclass(frozen=True)
class CookTorrance:
    """One material of the 1982 model, by the paper's symbols.

    slopes          up to four (m, w): rms slope in (0, 1], share in [0, 1]; the shares sum to at most 1
    distribution    "beckmann" or "gaussian"
    specular        s in [0, 1]; the diffuse share is d = 1 - s
    n, k            complex refractive index for red, green and blue, n > 0, k >= 0
    diffuse         RGB of pi Rd, each in [0, 1]
    scale           "energy", or "published", which is four times as bright and may reflect more than arrives
    gaussian_c      the paper's arbitrary c of the Gaussian, used in the published scale
    sampling_width  of the exact realisations, as a share of m in [0, 1]; 0 is the formula itself
    """

    slopes: tuple = ((0.2, 1.0),)
    distribution: str = "beckmann"
    specular: float = 1.0
    n: tuple = (0.2, 0.92, 1.1)
    k: tuple = (3.91, 2.45, 2.14)
    diffuse: tuple = (0.8, 0.8, 0.8)
    scale: str = "energy"
    gaussian_c: float = 1.0
    sampling_width: float = DEFAULT_SAMPLING_WIDTH

    def __post_init__(self):
        checked = {
            "slopes": slopes_of(self.slopes),
            "distribution": choice("distribution", self.distribution, DISTRIBUTIONS),
            "specular": number("specular", self.specular, 0.0, 1.0),
            "n": numbers_of("n", self.n, 3, high=100.0, above=0.0),
            "k": numbers_of("k", self.k, 3, 0.0, 100.0),
            "diffuse": numbers_of("diffuse", self.diffuse, 3, 0.0, 1.0),
            "scale": choice("scale", self.scale, SCALES),
            "gaussian_c": number("gaussian_c", self.gaussian_c, 0.0, 1000.0),
            "sampling_width": number("sampling_width", self.sampling_width, 0.0, 1.0),
        }
        for name, value in checked.items():
            object.__setattr__(self, name, value)

    def changed(self, **parameters):
        """The same material with other values for the named parameters.

        >>> CookTorrance().changed(specular=0.1).specular
        0.1
        >>> CookTorrance().changed(speculr=0.1)
        Traceback (most recent call last):
        ...
        addon.errors.FacetFilmError: parameter 'speculr' is unknown; did you mean 'specular' or 'scale'? Valid: \
'slopes', 'distribution', 'specular', 'n', 'k', 'diffuse', 'scale', 'gaussian_c', 'sampling_width'.
        """
        for name in parameters:
            choice("parameter", name, self.__dataclass_fields__)
        return replace(self, **parameters)


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
