"""What a material is made of, as one value: every door takes it and gives it, files keep it as JSON."""

import dataclasses
import functools
import json
from collections.abc import Mapping
from typing import Any

from ..finishes.feeding import held as finish_held
from . import named
from .parameters import Checked
from .realisations import realisation_named

__all__ = ["FORMAT", "Record", "Source", "baked_in", "finish_in", "is_measured", "from_dict", "from_json", "space_in"]

FORMAT = 2
"""Of the JSON; 1 is what 0.1.0 kept, a bare bake without parameters."""

OWN_PREFIX = "file:"
NO_FACTS: Mapping[str, Any] = {}


@dataclasses.dataclass(frozen=True)
class Source:
    """What a material was baked from, so that it can be baked again.

    name  a preset's name or a dataset's id; of the user's own data what it is called
    data  the user's own spectrum as CSV, or those that a stack of layers names, as
          :func:`addon.catalogue.resolving.layers_in` reads them; or ""
    """

    name: str
    data: str = ""

    def meant(self):
        """What :func:`addon.catalogue.resolving.resolve` understands."""
        if not self.data:
            return self.name
        from ..catalogue.resolving import is_stack, of_stack
        if is_stack(self.name):
            return of_stack(self.name, self.data)
        from ..spectra.readers import read_text
        return read_text(self.data, self.name.removeprefix(OWN_PREFIX))


@dataclasses.dataclass(frozen=True)
class Record:
    """What a material is made of.

    model        name of its model
    realisation  how the formula is rendered
    group        id of the node group that renders it
    version      of that group
    parameters   the model's checked parameters, as they are now
    source       the Source, or None where the parameters alone make it
    viewing      options that it was baked with: illuminant, observer, space, adapt, gamut, medium; {} where nothing
                 was baked
    baked        what was found then: title, colours, errors, citation; {} where nothing was baked
    finish       name of the finish that was put on it, or ""
    controls     {socket: value} of the finish's group where they are not the finish's own
    """

    model: str
    realisation: str
    group: str
    version: int
    parameters: Checked
    source: Source | None = None
    viewing: Mapping[str, Any] = dataclasses.field(default_factory=dict)
    baked: Mapping[str, Any] = dataclasses.field(default_factory=dict)
    finish: str = ""
    controls: Mapping[str, Any] = dataclasses.field(default_factory=dict)

    @property
    def title(self) -> str:
        """What people call it: the preset's title, or the model's."""
        return self.baked.get("title") or named(self.model).title

    @property
    def measured(self) -> bool:
        """Whether a spectrum was baked into it."""
        return is_measured(self.baked)

    def changed(self, **fields: Any) -> "Record":
        """The same with other fields."""
        return dataclasses.replace(self, **fields)

    def to_dict(self) -> dict[str, Any]:
        """The same as dicts, lists, numbers and texts, ready for JSON."""
        return {"format": FORMAT, "model": self.model, "realisation": self.realisation, "group": self.group,
                "version": self.version, "parameters": self.parameters.to_dict(),
                "source": self.source and dataclasses.asdict(self.source), "viewing": dict(self.viewing),
                "baked": dict(self.baked), "finish": self.finish, "controls": dict(self.controls)}

    def to_json(self) -> str:
        """The same as JSON text."""
        return json.dumps(self.to_dict(), ensure_ascii=False)


def is_measured(baked: Mapping[str, Any]) -> bool:
    """Whether a spectrum was baked: then what was baked names the light."""
    return "illuminant" in baked


def from_json(text: str, current: Record) -> Record:
    """The Record of a material's JSON, of this version or of 0.1.0.

    text     as :meth:`Record.to_json` or 0.1.0 wrote it; "" and what is no JSON say nothing
    current  what the material's nodes hold: model, realisation, group, version, parameters, and the finish whose group
             feeds them, which users change
    """
    held = _held(text)
    if "format" not in held:
        return _of_0_1_0(held, current)
    return current.changed(source=_source(held["source"]), viewing=held["viewing"], baked=held["baked"],
                           finish=finish_held(held.get("finish", ""), current.finish))


def baked_in(text: str) -> Mapping[str, Any]:
    """What was baked, alone, of a material's JSON: what panels draw at each redraw."""
    held = _held(text)
    return held.get("baked", {}) if "format" in held else _without_source(held)


def finish_in(text: str) -> str:
    """Name of the finish, alone, of a material's JSON."""
    return _held(text).get("finish", "")


def space_in(text: str) -> str:
    """The scene-linear space that was baked for, alone, of a material's JSON; "" where none was."""
    held = _held(text)
    return held["viewing"].get("space", "") if "format" in held else held.get("space", "")


@functools.lru_cache(maxsize=256)
def _held(text):
    """What the JSON holds; {} for what is none, and for what a newer version wrote."""
    try:
        held = json.loads(text)
    except (TypeError, ValueError):
        return {}
    return held if isinstance(held, dict) and held.get("format", 1) <= FORMAT else {}


def from_dict(held: Mapping[str, Any]) -> Record:
    """The Record that :meth:`Record.to_dict` wrote.

    >>> from .making import made
    >>> record = made(preset="copper")
    >>> from_dict(record.to_dict()) == record
    True
    """
    parameters = {name: _tuples(value) for name, value in held["parameters"].items()}
    return Record(held["model"], realisation_named(held["realisation"]), held["group"], held["version"],
                  named(held["model"]).parameters(**parameters), _source(held["source"]), held["viewing"],
                  held["baked"], held.get("finish", ""),
                  {name: _tuples(value) for name, value in held.get("controls", {}).items()})


def _of_0_1_0(held, current):
    """What 0.1.0 kept is what was baked; source and viewing stand among it."""
    if not held.get("name"):
        return current
    baked = _without_source(held)
    if "conductor" not in held:
        return current.changed(source=Source(held["name"]), baked=baked)
    viewing = {option: held[option] for option in ("illuminant", "observer", "space")}
    viewing.update(adapt=held["adapted"], gamut=held["gamut"]["method"], medium=held.get("medium", 1.0))
    name = held["source"]["dataset"] if "own_data" in held else held["name"]
    return current.changed(source=Source(name, held.get("own_data", "")), viewing=viewing, baked=baked)


def _without_source(held):
    return {key: value for key, value in held.items() if key not in ("own_data", "model")}


def _source(held):
    return Source(**held) if held else None


def _tuples(value):
    return tuple(map(_tuples, value)) if isinstance(value, list) else value
