"""What was found of the presets' stacks in the usual light, so that a click does not wait for it to be found again.

films.table is made by tools/build_film_facts.py; what is not in it is worked out.
"""

import functools

from ...bake.film_errors import RealisationErrors
from ...spectra import tables as packed

__all__ = ["NAME", "errors", "forget", "tables"]

NAME = "films"


def _part(name):
    return packed.part(NAME, name)["rows"] if (packed.DIRECTORY / f"{NAME}.table").exists() else []


@functools.cache
def tables():
    """{stack in words: (size of its table, wavelength steps or None, (largest, mean) CIEDE2000 of it)}."""
    return {stack: (tuple(size), steps and tuple(steps), tuple(found)) for stack, size, steps, found in _part("tables")}


@functools.cache
def errors():
    """{(stack in words, slope): {realisation: its RealisationErrors}}."""
    return {(stack, m): {name: RealisationErrors(*values) for name, values in found.items()}
            for stack, m, found in _part("errors")}


def forget():
    """Read the table anew."""
    tables.cache_clear()
    errors.cache_clear()
