"""A measured BRDF, whatever file it came in."""

import dataclasses
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ..errors import FacetFilmError

__all__ = ["Measurement", "Samples", "require_values"]


class Samples(NamedTuple):
    """What a fit compares.

    v, l    unit directions to the viewer and to the light, the normal along z, ``(N, 3)``
    f       the BRDF in 1/sr, linear Rec.709, ``(N, 3)``
    weight  what each counts, ``(N,)``, sum 1
    """

    v: np.ndarray
    l: np.ndarray
    f: np.ndarray
    weight: np.ndarray


@dataclasses.dataclass(frozen=True, eq=False)
class Measurement:
    """A measured BRDF.

    name      of the file
    title     what the file says it is of; else its name without the ending
    form      "RGL", "MERL" or "points"
    samples   what is fitted to
    rejected  how many samples were left out: negative, not a number, or below the horizon
    brdf      function (v, l) -> f in 1/sr, ``(N, 3)`` each; None where only points are known
    notes     what was assumed, a sentence each
    """

    name: str
    title: str
    form: str
    samples: Samples
    rejected: int
    brdf: Callable | None = None
    notes: tuple[str, ...] = ()


def require_values(values, name):
    """Raise FacetFilmError for values of which one is not a number, or none is above 0."""
    if not np.all(np.isfinite(values)):
        raise FacetFilmError("{file!r} holds values that are no numbers (NaN or infinite): download it again.",
                             file=name)
    if not np.any(np.asarray(values) > 0.0):
        raise FacetFilmError("{file!r} holds no value above 0: there is nothing to fit.", file=name)
