"""The face that two clear bodies have in common, such as where water stands in a glass: one mesh, of two indices."""

from ..errors import FacetFilmError
from . import named
from .record import Record

__all__ = ["is_clear", "touching"]


def is_clear(record: Record) -> bool:
    """Whether a record is a clear body whose faces can be against another."""
    return bool(named(record.model).index_outside)


def touching(inside: Record, outside: Record | None) -> Record:
    """The Record of the face where a body touches another: inside's, with the other's index outside of it.

    inside   of the body that the face's normals point out of
    outside  of the body that they point into; None for air

    Raises FacetFilmError where one of them is no clear body.

    >>> from .making import made
    >>> round(touching(made(preset="water"), made(preset="window_glass")).parameters.outside, 3)
    1.523
    """
    for record in (inside, outside):
        if record is not None and not is_clear(record):
            raise FacetFilmError("{material} is no clear body: a common face is between two of them, such as water and "
                                 "glass.", material=record.title)
    index = 1.0 if outside is None else getattr(outside.parameters, named(outside.model).index)
    return inside.changed(parameters=inside.parameters.changed(**{named(inside.model).index_outside: index}))
