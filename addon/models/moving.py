"""Records from one scene-linear space to another: baked again, and what the user set moved along."""

import numpy as np

from ..bake.colour import converted
from ..catalogue.resolving import resolve
from . import named
from .making import ANY_RENDERER, made, rebaked
from .model import Renderer
from .parameters import Colour
from .record import Record

__all__ = ["moved", "space_of"]

CLOSE = 2e-3
"""Relative difference up to which a value is still what was baked: sockets and conversions hold single precision."""


def space_of(record: Record) -> str:
    """The scene-linear space that a record's numbers are for, or "" where nothing says so."""
    return record.viewing.get("space", "")


def moved(record: Record, renderer: Renderer = ANY_RENDERER, *, colours: bool = True) -> Record:
    """The Record in the renderer's space, by default linear Rec.709.

    colours  whether the colours that the user set are in the record's space, as in a preset of the user's own; not in
             a file, whose colours Blender converts when its space changes, and when something is appended

    What is still as it was baked is baked again; what the user changed is moved with the least error that its
    parameters allow.

    >>> gold = made(preset="gold")
    >>> made_there = made(preset="gold", renderer=Renderer(space="ACEScg"))
    >>> moved(gold, Renderer(space="ACEScg")).parameters == made_there.parameters
    True
    """
    before, after = space_of(record), renderer.space
    if before in ("", after):
        return record
    model, new = named(record.model), _in(record, renderer)
    changed = {name: getattr(record.parameters, name) for name in _changed(model, record)}
    typed = {row.name: getattr(record.parameters, row.name) for row in record.parameters.TABLE
             if isinstance(row, Colour) and (row.name in changed or row.name not in model.baked_names)}
    kept = {**changed, **model.respaced(record.parameters, set(changed), before, after),
            **{name: converted(rgb, before, after) if colours else rgb for name, rgb in typed.items()}}
    return new.changed(parameters=new.parameters.changed(**kept))


def _in(record, renderer):
    """The Record baked again for the renderer's space, or, of a preset that is stated, made again."""
    if record.measured:
        return rebaked(record, renderer)
    model = named(record.model)
    new = made(record.model, record.source.name, record.realisation, renderer)
    stated = {name: getattr(new.parameters, name) for name in model.baked_names}
    return new.changed(parameters=record.parameters.changed(**stated))


def _changed(model, record):
    """Names of what the bake gave and the user has changed since."""
    words = [name for name in model.baked_names if isinstance(getattr(record.parameters, name), str)]
    numbers = [name for name in model.baked_names if name not in words]
    resolved = resolve(record.source.meant())
    was = _baked_then(model, record, resolved) if numbers else resolved.preset.parameters
    return [name for name in words if getattr(record.parameters, name) != was.get(name, "")] + [
        name for name in numbers if not _close(getattr(record.parameters, name), was[name])]


def _baked_then(model, record, resolved):
    """What the bake gave in the record's own space, by the formula that comes closest to what the record holds."""
    bakes = [model.bake(resolved, dict(record.viewing), record.realisation, Renderer(formula, space_of(record)))
             for formula in ("exact", "blender-4.5")[:2 if "conductor" in record.baked else 1]]
    usual = {name: getattr(model.parameters(), name) for name in model.baked_names}
    return min(({**usual, **found.parameters} for found in bakes), key=lambda was: sum(
        not _close(getattr(record.parameters, name), was[name]) for name in model.baked_names))


def _close(value, other):
    value, other = np.array(value, float), np.array(other, float)
    return bool(np.all(np.abs(value - other) <= CLOSE * np.maximum(1.0, np.abs(other))))
