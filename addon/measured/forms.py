"""The forms that measurements are fitted in: those that the models have."""

import functools
from importlib import import_module

from ..errors import choice, number
from ..models import all_models

__all__ = ["form_names", "form_of"]

DISTRIBUTIONS = ("beckmann", "gaussian")


@functools.lru_cache(maxsize=1)
def _forms():
    """{name of F: (Model, "module.Class")}, the simplest first."""
    return {name: (model, place) for model in all_models() for name, place in model.fits.items()}


def form_names():
    """What F may be.

    >>> form_names()
    ('f0', 'n_k', 'curve')
    """
    return tuple(_forms())


def form_of(fresnel, slopes=2, distribution="beckmann"):
    """The addon.models.fitted.Form of a name.  Raises FacetFilmError for another, or other slopes or distribution."""
    model, place = _forms()[choice("fresnel", fresnel, form_names())]
    module, _, form = place.partition(".")
    slopes = int(number("slopes", slopes, 1, 3))
    return getattr(import_module(f".{module}", model.package), form)(model, slopes, choice(
        "distribution", distribution, DISTRIBUTIONS))
