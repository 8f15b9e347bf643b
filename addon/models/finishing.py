"""Puts finishes on records, and keeps them where a record is made anew."""

from collections.abc import Mapping
from typing import Any

from ..catalogue.resolving import resolve
from ..finishes import find
from ..finishes.feeding import require_takes, surface, takes
from . import named
from .record import Record

__all__ = ["finished", "kept_finish", "under_finish"]


def finished(record: Record, finish: str) -> Record:
    """The Record with another finish; "" takes it off, and the surface is the preset's own again.

    Raises FacetFilmError for an unknown finish, and for a model without a roughness.

    >>> from .making import made
    >>> glass = finished(made(preset="window_glass"), "sandblasted")
    >>> glass.finish, round(glass.parameters.roughness, 2)
    ('sandblasted', 0.55)
    """
    model = named(record.model)
    require_takes(model)
    found = find(finish) if finish else None
    set_by_it = surface(found, model) if found else _own_surface(record, model)
    return record.changed(parameters=record.parameters.changed(**set_by_it), finish=found.name if found else "",
                          controls={})


def kept_finish(record: Record, new: Record) -> Record:
    """A new Record with another one's finish as it was changed there; as it is where its model takes none.

    >>> from .making import made
    >>> glass = made(preset="window_glass", finish="smudged")
    >>> kept_finish(glass, made(preset="diamond")).finish, kept_finish(glass, made(preset="nacre")).finish
    ('smudged', '')
    """
    model = named(new.model)
    if not record.finish or not takes(model):
        return new
    finish, held = find(record.finish), record.parameters
    usual = surface(finish, model)
    changed = {name: getattr(held, name) for name in usual if hasattr(held, name)} or {"roughness": held.roughness}
    return new.changed(parameters=new.parameters.changed(**usual).changed(**changed), finish=finish.name,
                       controls=record.controls)


def under_finish(finish: str, model: Any, given: Mapping[str, Any]) -> tuple[str, Mapping[str, Any]]:
    """(name of the finish, parameters that it sets with those given over them) of a material that is made.

    finish  a name or title, or "" for none
    model   the Model, which has to have a roughness then
    given   {parameter: value}; a roughness says slopes otherwise
    """
    if not finish:
        return "", given
    require_takes(model)
    found = find(finish)
    set_by_it = {name: value for name, value in surface(found, model).items()
                 if not (name == "slopes" and "roughness" in given)}
    return found.name, {**set_by_it, **given}


def _own_surface(record, model):
    """{parameter: value} of what a finish sets, as the record's preset has it, or by default the model."""
    usual = model.parameters()
    stated = resolve(record.source.meant()).preset.parameters if record.source else {}
    return {name: stated.get(name, getattr(usual, name)) for name in surface(find("satin"), model)}
