"""Tables of parameters: one row a parameter, and what is made of a table.

A row says what scripts call a parameter, its symbol in the paper, its socket, default, range, unit and what it means.
The checked dataclass, the sockets of the node groups with their tooltips, reading and writing them, the panels and the
documents' table all come from the rows.
"""

import dataclasses
import math
from collections.abc import Callable
from types import SimpleNamespace

from ..errors import FacetFilmError, choice, number, numbers_of

__all__ = ["Socket", "Parameter", "Number", "Triple", "Colour", "Choice", "Slider", "Direction", "Text", "Checked",
           "checked_class", "add_inputs", "sockets_of", "written", "read"]


@dataclasses.dataclass(frozen=True)
class Socket:
    """An input of a node group.

    name        as the interface shows it
    key         what the formulas that are built call it
    kind        "FLOAT", "VECTOR" or "COLOR"
    default     a number, three numbers, or None for a direction
    low, high   what the slider reaches
    tip         its tooltip
    unit        what the panel shows behind the name, where Blender has no such unit
    subtype     "FACTOR", "ANGLE" or ""
    panel       the closed panel that it stands in, or ""
    plugged     whether it takes links alone: no value is shown
    never_zero  promises that no product with it folds away
    beside      function(value) -> what the panel shows behind the name, or None
    """

    name: str
    key: str
    kind: str
    default: object
    tip: str
    low: float | None = None
    high: float | None = None
    unit: str = ""
    subtype: str = ""
    panel: str = ""
    plugged: bool = False
    never_zero: bool = False
    beside: Callable | None = None


@dataclasses.dataclass(frozen=True, kw_only=True)
class Parameter:
    """A row of a model's table.

    name         what scripts call it
    symbol       the paper's, or ""
    socket       the name of its socket, or ""
    default      where nothing else is said
    tip          what it means, in a sentence or two
    low, high    the range, ends included; above, below: ends that it may not touch
    slider       (low, high) of the socket where they are not those of the range
    unit         "nm", "radians" or ""
    subtype, panel, never_zero, beside  as Socket has them
    realisations  those that have it; () for all
    key          what the formulas that are built call it; by default its name
    group        id of the group that feeds the material's own and has the row's sockets, or "" for the own one
    """

    name: str
    tip: str
    default: object = None
    symbol: str = ""
    socket: str = ""
    low: float = -math.inf
    high: float = math.inf
    above: float | None = None
    below: float | None = None
    slider: tuple = ()
    unit: str = ""
    subtype: str = ""
    panel: str = ""
    never_zero: bool = False
    beside: Callable | None = None
    realisations: tuple = ()
    key: str = ""
    group: str = ""
    kind = "FLOAT"
    is_value = True
    """Whether scripts set it; else it is a socket alone."""
    plugged = False
    """Whether its socket takes links alone."""

    def sockets(self):
        """The row's sockets, in their order."""
        if not self.socket:
            return ()
        low, high = self.slider or (self.low, self.high)
        unit = "" if self.subtype == "ANGLE" else self.unit
        return (Socket(self.socket, self.key or self.name, self.kind, self.default, self.tip,
                       None if low == -math.inf else low, None if high == math.inf else high,
                       unit, self.subtype, self.panel, self.plugged, self.never_zero, self.beside),)

    def read_from(self):
        """Names of the values that it is read from: its sockets'."""
        return tuple(socket.name for socket in self.sockets())

    def is_in(self, values):
        """Whether the values, ``{name: value}``, hold it."""
        return bool(self.read_from()) and all(name in values for name in self.read_from())

    @property
    def unsaid(self):
        """What the checked class holds where nothing is said: the default, or None where it follows from others."""
        return self.default

    def checked(self, value):
        """The value as the row keeps it.  Raises FacetFilmError naming the parameter and its range."""
        raise NotImplementedError

    def written(self, value):
        """{socket's name: its value} of a checked value."""
        return {self.socket: value} if self.socket else {}

    def read(self, values):
        """The value that the sockets hold, ``{name: value}``."""
        return values[self.socket]

    def _bounds(self):
        bounds = {"above": self.above, "below": self.below, "unit": self.unit}
        return {name: bound for name, bound in bounds.items() if bound not in (None, "")}

    def range_text(self):
        """The range in words, for documents.

        >>> Number(name="m", tip="", above=0.0, high=1.0).range_text()
        'above 0, at most 1'
        """
        low = f"above {self.above:g}" if self.above is not None else "" if self.low == -math.inf else f"{self.low:g}"
        high = f"below {self.below:g}" if self.below is not None else "" if self.high == math.inf else f"{self.high:g}"
        if self.above is None and self.below is None and low and high:
            return f"{low} to {high}"
        if low and self.above is None:
            low = f"at least {low}"
        if high and self.below is None:
            high = f"at most {high}"
        return ", ".join(filter(None, (low, high))) or "any"


class Number(Parameter):
    """One number."""

    def checked(self, value):
        """As :func:`addon.errors.number`."""
        return number(self.name, value, self.low, self.high, **self._bounds())


class Slider(Number):
    """A socket with a number that scripts do not set."""

    is_value = False


class Triple(Parameter):
    """Three numbers, for red, green and blue, that are no colour."""

    kind = "VECTOR"

    def checked(self, value):
        """As :func:`addon.errors.numbers_of`."""
        return numbers_of(self.name, value, 3, self.low, self.high, **self._bounds())


class Colour(Triple):
    """A linear RGB colour."""

    kind = "COLOR"

    def written(self, value):
        """With the alpha that colour sockets have."""
        return {self.socket: (*value, 1.0)}

    def read(self, values):
        """Without it."""
        return values[self.socket][:3]

    def sockets(self):
        """A colour's socket has no range of its own."""
        return tuple(dataclasses.replace(socket, low=None, high=None) for socket in super().sockets())


@dataclasses.dataclass(frozen=True, kw_only=True)
class Choice(Parameter):
    """One of two names; the socket is 0 for the first and 1 for the second."""

    options: tuple = ()

    def checked(self, value):
        """As :func:`addon.errors.choice`."""
        return choice(self.name, value, self.options)

    def sockets(self):
        """A factor between the two."""
        return tuple(dataclasses.replace(socket, default=float(self.options.index(self.default)), low=0.0, high=1.0,
                                         subtype="FACTOR") for socket in super().sockets())

    def written(self, value):
        """0 or 1."""
        return {self.socket: float(self.options.index(value))}

    def read(self, values):
        """The nearer one."""
        return self.options[int(values[self.socket] > 0.5)]

    def range_text(self):
        """The names."""
        return ", ".join(self.options)


class Direction(Parameter):
    """A socket for a normal or tangent, which takes links alone."""

    kind = "VECTOR"
    is_value = False
    plugged = True


class Text(Parameter):
    """A text, which no socket holds: what the material's Picture is made of."""

    def read_from(self):
        """A value of its own name."""
        return (self.name,)

    def checked(self, value):
        """A text that is not empty."""
        if not isinstance(value, str) or not value.strip():
            raise FacetFilmError("{name} must be a text, not {value!r}.", name=self.name, value=value)
        return value.strip()

    def read(self, values):
        """The text."""
        return values[self.name]


class Checked:
    """What every class of checked parameters shares; the rows are in TABLE."""

    TABLE = ()

    def __post_init__(self):
        for row in self.TABLE:
            if row.is_value:
                object.__setattr__(self, row.name, self.check(row, getattr(self, row.name)))

    def check(self, row, value):
        """A row's checked value; models whose parameters exclude each other override this."""
        return row.checked(value)

    def changed(self, **parameters):
        """The same material with other values for the named parameters.

        Raises FacetFilmError for an unknown name, with the nearest ones, or a value out of range.
        """
        for name in parameters:
            choice("parameter", name, self.__dataclass_fields__)
        return dataclasses.replace(self, **parameters)

    def to_dict(self):
        """The parameters as dicts, lists, numbers and texts, ready for JSON; without those that are None."""
        return {name: _plain(getattr(self, name)) for name in self.__dataclass_fields__
                if getattr(self, name) is not None}


def _plain(value):
    return [_plain(item) for item in value] if isinstance(value, tuple) else value


def checked_class(name, table):
    """A frozen dataclass with a field a row, checked as the rows say, whose defaults are the rows'.

    >>> Size = checked_class("Size", (Number(name="width", default=1.0, low=0.0, tip="in metres"),))
    >>> Size().changed(width=2).width
    2.0
    >>> Size(width=-1)
    Traceback (most recent call last):
    ...
    addon.errors.FacetFilmError: width must be a number at least 0, not -1.
    """
    fields = [(row.name, object, dataclasses.field(default=row.unsaid)) for row in table if row.is_value]
    said = {"__doc__": "Checked parameters, a field a row of TABLE.", "TABLE": table}  # it else reads its signature
    return dataclasses.make_dataclass(name, fields, bases=(Checked,), frozen=True, namespace=said)


def sockets_of(table, realisation="", group=""):
    """The sockets, in their order, of a table's rows that a realisation has; or of those in a group that feeds it."""
    return tuple(socket for row in table
                 if row.group == group and (not row.realisations or realisation in row.realisations)
                 for socket in row.sockets())


def add_inputs(builder, table, realisation="", group=""):
    """Add those sockets to the group under construction; their operands by the keys that formulas have."""
    return SimpleNamespace(**{socket.key: builder.input(socket) for socket in sockets_of(table, realisation, group)})


def written(parameters, group=""):
    """{socket's name: value} of checked parameters, in the material's own group or one that feeds it."""
    found = {}
    for row in parameters.TABLE:
        if row.is_value and row.group == group:
            found.update(row.written(getattr(parameters, row.name)))
    return found


def read(table, values, group=""):
    """{parameter's name: value} of the rows that the values, ``{name: value}``, hold."""
    return {row.name: row.read(values) for row in table
            if row.is_value and row.group == group and row.is_in(values)}
