"""The vocabulary in which every formula of this extension is written once.

A formula is a Python function over operands that know ``+ - * /``, unary minus
and the functions of this module.  Given numpy arrays it *is* the reference;
given node operands (:mod:`addon.nodes.builder`) it *builds* the node tree, one
node an operation.

Shapes with numpy: a number has any shape ``(...)``; a direction or an RGB
colour has a last axis of 3, ``(..., 3)``.  A number that meets a direction or
a colour is widened with :func:`widen` first (with nodes that is free).
"""

import functools
import itertools
from types import SimpleNamespace

import numpy as np

__all__ = [
    "sqrt", "inverse_sqrt", "exp", "log", "sin", "cos", "tan", "arccos", "power", "absolute", "multiply_add",
    "minimum", "maximum", "clip", "fraction", "less", "where", "mix", "lookup", "lookup_three",
    "dot", "cross", "length", "normalize", "rotate", "vector", "x_of", "y_of", "z_of", "widen",
    "part", "term",
]


def _nodes(operands):
    """The node operand among the operands, or None where all are numbers."""
    for operand in operands:
        if getattr(operand, "is_node_operand", False):
            return operand
    return None


def _with_members(operands):
    """The operands, and the members of those that bring several by name."""
    members = [vars(operand).values() for operand in operands if isinstance(operand, SimpleNamespace)]
    return [*operands, *itertools.chain(*members)]


def _apply(name, on_arrays, *operands):
    node = _nodes(operands)
    if node is not None:
        return node.builder.apply(name, operands)
    return on_arrays(*operands)


def sqrt(x):
    """Square root; 0 where x is below 0, as the shader's own square root."""
    return _apply("sqrt", lambda a: np.sqrt(np.maximum(a, 0.0)), x)


def inverse_sqrt(x):
    """1/√x, x above 0."""
    return _apply("inverse_sqrt", lambda a: 1.0 / np.sqrt(a), x)


def exp(x):
    """e to the power of x."""
    return _apply("exp", np.exp, x)


def log(x):
    """Natural logarithm; 0 where x is 0 or below, as the shader's own logarithm."""
    return _apply("log", lambda a: np.log(np.where(np.greater(a, 0.0), a, 1.0)), x)


def multiply_add(x, y, z):
    """x·y + z, with nodes in one of them.

    >>> float(multiply_add(2.0, 3.0, 4.0))
    10.0
    """
    return _apply("multiply_add", lambda a, b, c: np.asarray(a) * b + c, x, y, z)


def sin(x):
    """Sine of x in radians."""
    return _apply("sin", np.sin, x)


def cos(x):
    """Cosine of x in radians."""
    return _apply("cos", np.cos, x)


def tan(x):
    """Tangent of x in radians."""
    return _apply("tan", np.tan, x)


def arccos(x):
    """Angle in radians whose cosine is x; x is held to [-1, 1]."""
    return _apply("arccos", lambda a: np.arccos(np.clip(a, -1.0, 1.0)), x)


def power(x, exponent):
    """x to the power of exponent, for x at or above 0."""
    return _apply("power", np.power, x, exponent)


def absolute(x):
    """x without its sign."""
    return _apply("absolute", np.abs, x)


def minimum(x, *others):
    """The smallest of the operands, element by element."""
    for other in others:
        x = _apply("minimum", np.minimum, x, other)
    return x


def maximum(x, *others):
    """The largest of the operands, element by element."""
    for other in others:
        x = _apply("maximum", np.maximum, x, other)
    return x


def clip(x, low, high):
    """x held to [low, high]."""
    return _apply("clip", lambda a, b, c: np.minimum(np.maximum(a, b), c), x, low, high)


def fraction(x):
    """x less the largest whole number that is not above it, [0, 1).

    >>> float(fraction(-0.25))
    0.75
    """
    return _apply("fraction", lambda a: np.asarray(a) - np.floor(a), x)


def less(x, y):
    """1.0 where x < y, else 0.0."""
    return _apply("less", lambda a, b: np.less(a, b).astype(float), x, y)


def where(condition, x, y):
    """x where the condition is 1.0, y where it is 0.0.

    With nodes both sides are evaluated; neither may be infinite or NaN.
    """
    return _apply("where", lambda c, a, b: np.where(np.asarray(c) > 0.5, a, b), condition, x, y)


def mix(share, x, y):
    """This share of x, and the rest of y; with nodes neither is evaluated where the other is all of it.

    >>> float(mix(0.25, 4.0, 8.0))
    7.0
    """
    return _apply("where", lambda s, a, b: b + s * (np.asarray(a) - b), share, x, y)


def lookup(x, knots, values):
    """The value at x of straight lines between knots, its ends held.

    knots   ascending from 0 to 1, ``(K,)``
    values  ``(K,)``

    With nodes a curve, which the renderer keeps as a table of 257 entries; x may be a colour, for each of its channels.

    >>> float(lookup(0.25, [0.0, 0.5, 1.0], [1.0, 3.0, 2.0]))
    2.0
    """
    node = _nodes([x])
    if node is not None:
        return node.builder.lookup(x, knots, values)
    return np.interp(x, knots, values)


def lookup_three(x, knots, values):
    """Three values at x, ``(..., 3)``, as :func:`lookup` finds one; values ``(K, 3)``, K at most 32.

    With nodes a color ramp, which the renderer keeps as a table of 256 entries.

    >>> lookup_three(0.5, [0.0, 1.0], [[0.0, 1.0, 2.0], [1.0, 1.0, 0.0]]).tolist()
    [0.5, 1.0, 1.0]
    """
    node = _nodes([x])
    if node is not None:
        return node.builder.lookup_three(x, knots, values)
    return np.stack([np.interp(x, knots, channel) for channel in np.transpose(values)], axis=-1)


def dot(a, b):
    """Inner product of two directions, ``(..., 3)`` and ``(..., 3)`` to ``(...)``."""
    return _apply("dot", lambda p, q: np.sum(np.asarray(p) * np.asarray(q), axis=-1), a, b)


def cross(a, b):
    """Cross product of two directions."""
    return _apply("cross", np.cross, a, b)


def length(a):
    """Euclidean length of a vector, ``(..., 3)`` to ``(...)``."""
    return _apply("length", lambda p: np.linalg.norm(p, axis=-1), a)


def normalize(a):
    """The vector with length 1; the zero vector stays zero."""
    return _apply("normalize", _normalize, a)


def _normalize(a):
    a = np.asarray(a, dtype=float)
    size = np.linalg.norm(a, axis=-1, keepdims=True)
    return a / np.where(size > 0.0, size, 1.0)


def rotate(a, axis, angle):
    """The vector a turned about the unit axis, ``(..., 3)`` each, by an angle ``(...)`` in radians.

    >>> rotate([1.0, 0.0, 0.0], [0.0, 0.0, 1.0], np.pi / 2).round(6).tolist()
    [0.0, 1.0, 0.0]
    """
    return _apply("rotate", _rotate, a, axis, angle)


def _rotate(a, axis, angle):
    """By Rodrigues' formula."""
    a, axis, angle = (np.asarray(x, dtype=float) for x in (a, axis, angle))
    cosine, sine = np.cos(angle)[..., None], np.sin(angle)[..., None]
    along = np.sum(axis * a, axis=-1, keepdims=True)
    return cosine * a + sine * np.cross(axis, a) + ((1.0 - cosine) * along) * axis


def vector(x, y, z):
    """A direction or colour from three numbers."""
    return _apply("vector", lambda *xyz: np.stack(np.broadcast_arrays(*xyz), axis=-1), x, y, z)


def x_of(a):
    """First component, or red."""
    return _apply("x_of", lambda p: np.asarray(p)[..., 0], a)


def y_of(a):
    """Second component, or green."""
    return _apply("y_of", lambda p: np.asarray(p)[..., 1], a)


def z_of(a):
    """Third component, or blue."""
    return _apply("z_of", lambda p: np.asarray(p)[..., 2], a)


def widen(x):
    """A number made ready to meet a direction or a colour: ``(...)`` to ``(..., 1)``."""
    return _apply("widen", lambda a: np.asarray(a, dtype=float)[..., None], x)


def term(symbol):
    """Name the nodes that a formula builds: they stand in a frame with this label."""
    def decorate(formula):
        @functools.wraps(formula)
        def named(*operands, **options):
            node = _nodes(_with_members([*operands, *options.values()]))
            if node is None:
                return formula(*operands, **options)
            with node.builder.frame(symbol):
                return formula(*operands, **options)
        return named
    return decorate


def part(name, *gives):
    """Name the node group that a formula builds, for what stands in a material more than once or is a step by itself.

    name   what people call it
    gives  names of its results, where it has several in a tuple

    The formula's arguments become the group's sockets.  It may be handed the group under construction as well, to build
    nodes of its own; with numbers alone it is just the formula.
    """
    def decorate(formula):
        @functools.wraps(formula)
        def grouped(*operands, **options):
            builder = _builder([*operands, *options.values()])
            if builder is None:
                return formula(*operands, **options)
            return builder.part(name, formula, gives, operands, options)
        return grouped
    return decorate


def _builder(operands):
    """The group under construction that operands belong to, or None for numbers."""
    for operand in operands:
        if hasattr(operand, "part_node"):
            return operand
    lists = itertools.chain(*(operand for operand in operands if isinstance(operand, list)))
    node = _nodes([*_with_members(operands), *lists])
    return None if node is None else node.builder
