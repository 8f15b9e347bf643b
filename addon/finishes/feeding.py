"""How a finish goes onto a material: the parameters that it sets, the node that stands before the material's own."""

from importlib import import_module

from ..errors import FacetFilmError
from ..models import named
from ..models.model import Feed
from .finish import find, names, of_group

__all__ = ["changed_controls", "feeds", "held", "require_takes", "surface", "takes"]

ALIKE = 1e-5
"""Relative difference up to which a socket still holds its default: Blender keeps single precision."""


def takes(model):
    """Whether finishes go on a Model's materials: its table has a roughness.

    >>> [takes(named(name)) for name in ("film", "layered_rgb")]
    [True, False]
    """
    return "roughness" in model.parameters.__dataclass_fields__


def require_takes(model):
    """Raise FacetFilmError for a Model without a roughness."""
    if not takes(model):
        raise FacetFilmError("A finish varies the roughness, which {model} has not: name a material of another model, "
                             "or no finish.", model=model.title)


def surface(finish, model):
    """{parameter: value} of a Model that a Finish sets.

    >>> surface(find("satin"), named("film"))["roughness"] == find("satin").roughness
    True
    """
    known = model.parameters.__dataclass_fields__
    found = {"slopes": finish.slopes} if "slopes" in known else {"roughness": finish.roughness}
    if "anisotropy" in known:
        found["anisotropy"] = finish.anisotropy
    return found


def feeds(record):
    """The Feed of a Record's finish before its node, as a tuple; () where the finish leaves no marks.

    Where the group has an input for what it drives, that gets the material's own value.
    """
    finish = record.finish and find(record.finish)
    if not finish or not finish.group:
        return ()
    model, marks = named(record.model), _module(finish.group)
    sockets = {socket.name for socket in model.sockets(record.realisation)}
    defaults = _defaults(marks)
    shared = {name: value for name, value in model.written(record.parameters, record.realisation).items()
              if name in defaults and name in marks.DRIVES}
    links = {name: name for name in marks.DRIVES if name in sockets}
    return (Feed(finish.group, {**defaults, **finish.controls, **record.controls, **shared}, links),)


def held(kept, fed):
    """The name of the finish that a material has: the one it was given, unless another one's group feeds it.

    kept  name that its record holds, or ""
    fed   name of a finish whose group feeds its node, or ""

    >>> held("satin", ""), held("satin", "brushed"), held("brushed", ""), held("of a newer version", "")
    ('satin', 'brushed', '', '')
    """
    given = find(kept) if kept in names() else None
    return kept if given and given.group == (find(fed).group if fed else "") else fed


def changed_controls(group, values, shared):
    """{socket: value} of a finish's group where they are not what the finish has.

    group   its id
    values  {socket: value} of its node
    shared  names of the sockets that are the material's own
    """
    usual = {**_defaults(_module(group)), **of_group(group).controls}
    return {name: values[name] for name, value in usual.items()
            if name in values and name not in shared and not _alike(values[name], value)}


def _alike(a, b):
    pairs = zip(a, b) if isinstance(b, tuple) else [(a, b)]
    return all(abs(x - y) <= ALIKE * max(1.0, abs(y)) for x, y in pairs)


def _module(group):
    """What makes the group with this id."""
    from .groups import GROUPS
    build = next(found.build for found in GROUPS if found.identifier == group)
    return import_module("." + build.partition(".")[0], __package__)


def _defaults(marks):
    """{socket: default} of the inputs that have a value."""
    found = {}
    for row in marks.TABLE:
        for socket in row.sockets():
            if not socket.plugged:
                found[socket.name] = (*socket.default, 1.0) if socket.kind == "COLOR" else socket.default
    return found
