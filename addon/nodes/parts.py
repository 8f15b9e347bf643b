"""Parts: formulas whose nodes stand in a group of their own inside the group under construction.

What repeats, a slope or a Fresnel term, is built once and stands wherever it is used.  The renderer sees none of that:
it takes groups apart before it evaluates them.
"""

import dataclasses
import inspect
from types import SimpleNamespace
from typing import NamedTuple

from .facts import UNKNOWN, Facts, of_number
from .operand import NodeOperand

__all__ = ["call", "shown_name"]

HIDDEN = "."
"""What the names of groups begin with that menus do not offer."""

SYMBOLS = {"n_v": "N·V", "n_l": "N·L", "n_h": "N·H", "v_h": "V·H", "v_t": "V·T", "v_b": "V·B", "slope_t": "mt",
           "slope_b": "mb", "cos_theta": "cos θ", "h": "H", "v": "V", "f0": "F0", "uv": "UV",
           **{name: name for name in ("m1", "m2", "m3", "m4")}}
"""How people read the names of arguments that are symbols."""


class Part(NamedTuple):
    """A formula's nodes.

    tree      the group
    inputs    [(path of an argument, identifier of its socket)] of those that the formula uses
    result    what the formula gives, an :class:`Inside` in the place of each operand
    """

    tree: object
    inputs: list
    result: object


@dataclasses.dataclass(frozen=True)
class Inside:
    """One operand of a part's result: the socket it leaves the part by, or the argument that it is."""

    identifier: str = ""
    argument: tuple = ()
    facts: Facts = UNKNOWN


def shown_name(name):
    """An argument's name as people read it; that of a socket as it is.

    >>> shown_name("n_v"), shown_name("anisotropy"), shown_name("gaussian_c"), shown_name("m1"), shown_name("IOR")
    ('N·V', 'Anisotropy', 'Gaussian c', 'm1', 'IOR')
    """
    if name in SYMBOLS or name != name.lower():
        return SYMBOLS.get(name, name)
    first, *others = name.split("_")
    return " ".join([first if len(first) < 2 else first.capitalize(), *others])


def call(builder, name, formula, gives, operands, options):
    """What a formula gives of these arguments, its nodes in a group inside the builder's.

    name      what people call the part
    gives     names of its results, in their order; by default their own in a namespace
    operands, options  arguments: node operands and numbers, also in tuples, dicts and namespaces, which become sockets;
              the builder itself, for which the part's own stands in; texts and functions, of which each makes another
              part
    """
    bound = inspect.signature(formula).bind(*operands, **options)
    leaves = dict(_leaves(bound.arguments))
    key = (name, formula, tuple((path, _sort(builder, value)) for path, value in leaves.items()))
    if key not in builder.parts:
        builder.parts[key] = _built(builder, name, formula, gives, bound, leaves)
    part = builder.parts[key]
    return _placed(builder, name, part, leaves)


def _leaves(value, path=()):
    """(path, leaf) of everything within an argument: what its operands and numbers are is up to :func:`_sort`."""
    inner = _within(value)
    if inner is None:
        yield path, value
        return
    for name, member in inner.items():
        yield from _leaves(member, (*path, name))


def _within(value):
    """{name: member} of what holds several operands, or None."""
    if isinstance(value, SimpleNamespace):
        return vars(value)
    if isinstance(value, dict):
        return value
    if isinstance(value, (list, tuple)) and not _is_number(value):
        return {str(number): member for number, member in enumerate(value, 1)}
    return None


def _is_number(value):
    """Whether it is a number, or three of them."""
    if isinstance(value, (list, tuple)):
        return len(value) == 3 and all(map(_is_number, value))
    return not isinstance(value, bool) and isinstance(value, (int, float))


def _sort(builder, value):
    """What of a leaf the part depends on: the kind of an operand or number and what is known of it, or the leaf."""
    if isinstance(value, NodeOperand):
        return value.kind, builder.facts(value)
    if _is_number(value):
        # The same part serves what varies, for numbers are folded whatever its nodes are.
        return "VECTOR" if isinstance(value, (list, tuple)) else "FLOAT", of_number(value)._replace(varies=True)
    return None if value is builder else value


def _built(builder, name, formula, gives, bound, leaves):
    """The Part of a formula for arguments of these sorts."""
    inside = type(builder)(HIDDEN + name, builder.parts)
    names = _socket_names(leaves)
    operands = {path: inside.part_input(label, *_sort(builder, leaves[path])) for path, label in names.items()}

    def inner(path, leaf):
        return operands.get(path, inside if leaf is builder else leaf)

    for argument, value in bound.arguments.items():
        bound.arguments[argument] = _mapped(value, (argument,), inner)
    given = formula(*bound.args, **bound.kwargs)
    paths = {label: path for path, label in names.items()}
    outputs, labels = {}, iter(gives)

    def leave(path, leaf):
        label = next(labels, path[-1] if path else name)
        number = "".join(f" {word}" for word in path[:-1] if not gives and word.isdigit())
        if not isinstance(leaf, NodeOperand):
            return leaf
        if isinstance(leaf.source, str):
            return Inside(argument=paths[leaf.source])
        if leaf.key() not in outputs:
            label = "BSDF" if leaf.kind == "SHADER" else shown_name(label)
            outputs[leaf.key()] = Inside(inside.part_output(label + number, leaf), facts=inside.facts(leaf))
        return outputs[leaf.key()]

    result = _mapped(given, (), leave)
    identifiers = inside.part_inputs()
    return Part(inside.finish(), [(paths[name], identifiers[name]) for name in identifiers], result)


def _socket_names(leaves):
    """{path: name of its socket} of the leaves that get one, each another; whole arguments have theirs first."""
    shown = [path for path, value in leaves.items() if isinstance(value, NodeOperand) or _is_number(value)]
    found = {}
    for path in sorted(shown, key=len):
        words = [word for word in path if not word.isdigit()][-1:] + [word for word in path if word.isdigit()]
        name = " ".join([shown_name(words[0]), *words[1:]])
        found[path] = " ".join(map(shown_name, path)) if name in found.values() else name
    if len(set(found.values())) < len(found):
        raise ValueError(f"two arguments of a part would share a socket: {sorted(found.values())}")
    return {path: found[path] for path in shown}


def _mapped(value, path, change):
    """The same with change(path, leaf) in each leaf's place."""
    inner = _within(value)
    if inner is None:
        return change(path, value)
    members = {name: _mapped(member, (*path, name), change) for name, member in inner.items()}
    if isinstance(value, SimpleNamespace):
        return SimpleNamespace(**members)
    return members if isinstance(value, dict) else type(value)(members.values())


def _placed(builder, name, part, leaves):
    """The result of a part of these arguments: outputs of a node of it."""
    inputs = {identifier: leaves[path] for path, identifier in part.inputs}

    def outside(_, leaf):
        if not isinstance(leaf, Inside):
            return leaf
        if leaf.argument:
            return leaves[leaf.argument]
        return builder.part_node(name, part.tree, inputs, leaf.identifier, leaf.facts)

    return _mapped(part.result, (), outside)
