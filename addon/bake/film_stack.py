"""A stack of measured layers: what is outside, films of a thickness or a range of them, what is below."""

import dataclasses

import numpy as np

from ..errors import FacetFilmError
from ..spectra.optical_constants import CORE_NM, OpticalConstants

__all__ = ["Film", "Stack", "MOST_FILMS", "MOST_OPTICAL_NM", "LARGEST_K_OUTSIDE", "LEAST_MEASURED_NM"]

MOST_FILMS = 100
MOST_OPTICAL_NM = 20000.0
"""Σ n d of the films: spectra at every nm miss lines of thicker ones, by 0.4 CIEDE2000 for titania on titanium."""
LARGEST_K_OUTSIDE = 1e-4
"""Extinction that what is outside may have; it is left out then, as water's 1e-9: 0.1 mm at the least go unabsorbed."""
LEAST_MEASURED_NM = 50.0
"""Of 400 to 700 nm that every layer has to be measured in."""


@dataclasses.dataclass(frozen=True)
class Film:
    """One film of a stack.

    word       what it is called in the notation
    constants  its OpticalConstants
    low, high  its thickness in nm, from 0 on; one is the other where it does not vary
    """

    word: str
    constants: OpticalConstants
    low: float
    high: float

    @property
    def varies(self):
        """Whether its thickness is a range."""
        return self.high > self.low


@dataclasses.dataclass(frozen=True)
class Stack:
    """Films between what is outside and what is below, from the outside in.

    outside, below    words of the notation
    outside_constants, below_constants  their OpticalConstants
    films             Film values; none for a bare surface

    Films with a range vary together, each from its low to its high.  What a
    stack's thickness is called is the sum of those that vary: that of the one
    film as a rule, of all of them where a multilayer swells.

    Raises FacetFilmError for a layer that has no data in the visible or only a
    normal reflectance, for an absorbing outside, for more than 100 films, and
    for films too thick to interfere.
    """

    outside: str
    outside_constants: OpticalConstants
    films: tuple
    below: str
    below_constants: OpticalConstants

    def __post_init__(self):
        if len(self.films) > MOST_FILMS:
            raise FacetFilmError("A stack has at most {most} films; this one has {count}.",
                                 most=MOST_FILMS, count=len(self.films))
        for word, constants in self.layers:
            _check_layer(word, constants)
        k = self.k_left_out
        if k > LARGEST_K_OUTSIDE:
            raise FacetFilmError("{word!r} is outside of the stack and must not absorb, but has k up to {k:.2g}; "
                                 "name something clear, such as air or water.", word=self.outside, k=k)
        for film in self.films:
            if not (np.isfinite(film.high) and 0.0 <= film.low <= film.high):
                raise FacetFilmError("The thickness of {word!r} must be from 0 nm on, the lower end of a range first; "
                                     "it is {low:g} to {high:g} nm.", word=film.word, low=film.low, high=film.high)
        optical = sum(film.high * float(film.constants.at(CORE)[0].max()) for film in self.films)
        if optical > MOST_OPTICAL_NM:
            raise FacetFilmError("The films come to {optical:.0f} nm of n times thickness, and interference is "
                                 "calculated to {most:.0f}; make them thinner, or what is thick the layer below.",
                                 optical=optical, most=MOST_OPTICAL_NM)

    @property
    def k_left_out(self):
        """Largest k in the visible of what is outside: left out, as light there would have no end of its way."""
        return float(self.outside_constants.at(CORE)[1].max())

    @property
    def layers(self):
        """(word, OpticalConstants) of every layer, outside and below included."""
        return ((self.outside, self.outside_constants), *((film.word, film.constants) for film in self.films),
                (self.below, self.below_constants))

    @property
    def varying(self):
        """Places of the films whose thickness is a range."""
        return tuple(place for place, film in enumerate(self.films) if film.varies)

    @property
    def thickness_range_nm(self):
        """(low, high) of the stack's thickness: of the films that vary, or of all where none does."""
        counted = [film for film in self.films if film.varies] or self.films
        return float(sum(film.low for film in counted)), float(sum(film.high for film in counted))

    def indices(self, wavelength_nm):
        """n + ik of every layer, outside first, each of the wavelengths' shape; the outside's real."""
        found = [n + 1j * k for n, k in (constants.at(wavelength_nm) for _, constants in self.layers)]
        return [found[0].real, *found[1:]]

    def thicknesses(self, thickness_nm):
        """Of every film, at the stack's thickness ``(...)`` within its range; films that do not vary as they are.

        Raises FacetFilmError for a thickness outside of the range.
        """
        low, high = self.thickness_range_nm
        thickness = np.asarray(thickness_nm, float)
        if not self.varying:
            return [film.low for film in self.films]
        if not (np.all(thickness >= low - 1e-9) and np.all(thickness <= high + 1e-9)):
            raise FacetFilmError("The thickness must be from {low:g} to {high:g} nm, as the stack says; it is "
                                 "{given:g}.", low=low, high=high, given=float(_farthest(thickness, low, high)))
        share = (thickness - low) / (high - low)
        return [film.low + share * (film.high - film.low) if film.varies else film.low for film in self.films]

    def from_below(self):
        """The same stack as light from below meets it, for what is seen through; FacetFilmError if that absorbs."""
        return Stack(self.below, self.below_constants, self.films[::-1], self.outside, self.outside_constants)

    def at(self, thickness_nm):
        """The same stack with nothing that varies, at one thickness within its range."""
        films = [dataclasses.replace(film, low=float(d), high=float(d))
                 for film, d in zip(self.films, self.thicknesses(float(thickness_nm)))]
        return dataclasses.replace(self, films=tuple(films))


CORE = np.arange(CORE_NM[0], CORE_NM[1] + 1.0)


def _check_layer(word, constants):
    low, high = constants.range_nm
    if min(high, CORE_NM[1]) - max(low, CORE_NM[0]) < LEAST_MEASURED_NM:
        raise FacetFilmError("{word!r} is measured from {low:g} to {high:g} nm, so hardly in the visible, 400 to 700 "
                             "nm; choose another dataset.", word=word, low=low, high=high)
    if constants.normal_only:
        raise FacetFilmError("Of {word!r} only the normal reflectance is known, and a stack needs n and k; choose "
                             "another dataset.", word=word)


def _farthest(thickness, low, high):
    values = np.ravel(thickness)
    return values[np.argmax(np.maximum(low - values, values - high))]
