"""What a record is to programs that know base colour, metalness and roughness alone."""

from ..bake.colour import converted
from ..export.standin import LOST, Standin
from . import named
from .making import ANY_RENDERER, renewed
from .moving import moved, space_of
from .parameters import Colour
from .record import Record

__all__ = ["standin_of"]


def standin_of(record: Record, space: str = "Rec.709") -> Standin:
    """The Standin of a record, tuned or not.

    space  of the colours of a record that nothing was baked into

    >>> from .making import made
    >>> standin_of(made(preset="gold")).metallic
    1.0
    """
    model, here = named(record.model), renewed(record)
    if space_of(here):
        here = moved(here, ANY_RENDERER)
    else:
        colours = {row.name: converted(getattr(here.parameters, row.name), space, ANY_RENDERER.space)
                   for row in here.parameters.TABLE if isinstance(row, Colour)}
        here = here.changed(parameters=here.parameters.changed(**colours))
    if model.standin is not None:
        return model.standin(here)
    look = model.look(here.parameters, None)
    return Standin(tuple(map(float, look.colour)), roughness=min(float(look.slope) ** 0.5, 1.0), lost=(LOST["look"],))
