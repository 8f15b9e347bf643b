"""The reflectance models, one folder each; this is the only list of them.

A model is a package of this one whose ``MODEL`` is an :class:`addon.models.model.Model`: a folder that is put here, or
on this package's path, is a model of the extension.  Nothing of a model is loaded before it is asked for.
"""

from functools import lru_cache
from importlib import import_module
from pathlib import Path

from ..errors import choice

__all__ = ["DEFAULT", "all_models", "folders", "forget", "named", "names"]

DEFAULT = "cook_torrance"
"""The model that a measurement becomes where none is named."""


@lru_cache(maxsize=1)
def folders():
    """The folder of every model by its name, the default one first."""
    found = {file.parent.name: file.parent for place in __path__ for file in sorted(Path(place).glob("*/__init__.py"))}
    return {DEFAULT: found.pop(DEFAULT), **found}


def names():
    """The names of all models.

    >>> names()
    ('cook_torrance', 'clear', 'film', 'layered_rgb')
    """
    return tuple(folders())


def named(name):
    """The Model of this name.

    Raises FacetFilmError with the nearest names for an unknown one.

    >>> named("layered_rgb").title
    'Layered RGB'
    """
    return import_module(f".{choice('model', name, names())}", __name__).MODEL


def all_models():
    """Every Model, in the order of :func:`names`."""
    return tuple(named(name) for name in names())


def forget():
    """Look for the folders anew, after one was put on the package's path or taken off it."""
    folders.cache_clear()
