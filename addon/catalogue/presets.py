"""The presets of all models, as their folders' presets.json hold them."""

import dataclasses
import functools
import json
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from .. import models
from ..errors import FacetFilmError, choice
from . import entries

__all__ = ["Preset", "all_presets", "constants", "find", "forget", "names", "of_model"]


@dataclasses.dataclass(frozen=True, eq=False)
class Preset:
    """A material of one of the models.

    name         what scripts call it: small letters, digits and underscores
    title        what people call it
    kind         one of addon.catalogue.kinds.KINDS, or for a dataset or file what :func:`addon.spectra.names.kind_of`
                 says
    category     one of addon.catalogue.categories.CATEGORIES: what it looks like; "" for a dataset or file
    model        the model that it is a material of; "" for a dataset or file, which any that takes a measurement may be
    dataset      "shelf/book/page" that it was measured as, or "" where there is none
    index        in place of a dataset: ((wavelength in nm, n, k), …)
    reflectance  in place of a dataset: ((wavelength in nm, normal reflectance), …), k = 0
    aliases      other names
    variant_of   name of the preset that it looks nearly like, under which lists show it; "" for one of its own
    note         where the parameters are from
    estimated    what of it is no measurement, and from what it was guessed; "" where all is measured
    parameters   {name: value} of the model's, where they are not its defaults, as the model's folder reads them
    realisation  the one that it is made by where none is named; "" for the usual one
    """

    name: str
    title: str
    kind: str
    category: str = ""
    model: str = ""
    dataset: str = ""
    index: tuple = ()
    reflectance: tuple = ()
    aliases: tuple[str, ...] = ()
    variant_of: str = ""
    note: str = ""
    estimated: str = ""
    parameters: Mapping[str, Any] = dataclasses.field(default_factory=dict)
    realisation: str = ""

    @property
    def measured(self):
        """Whether optical constants belong to it."""
        return bool(self.dataset or self.index or self.reflectance)


def constants(preset):
    """The OpticalConstants of a Preset: its dataset's, its own, or those of its normal reflectance; None without one.

    >>> constants(find("copper")).dataset
    'main/Cu/Johnson'
    """
    from ..spectra import optical_constants  # not before a bake: lists of presets have to be there at once
    if preset.dataset:
        return optical_constants.load(preset.dataset)
    if not preset.measured:
        return None
    make = optical_constants.OpticalConstants if preset.index else optical_constants.from_normal_reflectance
    return make(*zip(*(preset.index or preset.reflectance)), f"preset {preset.name}", title=preset.title,
                citation=preset.estimated or preset.note, licence="CC0-1.0")


def all_presets():
    """Every preset by its name, model by model, in the order of the files.

    All of each, which takes a while: what lists show of them is there at once, see addon.catalogue.entries.
    """
    found = {}
    for model in models.names():
        twice = found.keys() & of_model(model).keys()
        if twice:
            raise ValueError(f"two presets are called {min(twice)!r}: one is of the model {model}")
        found |= of_model(model)
    return found


@functools.cache
def of_model(model):
    """The presets of one model by their names, as its presets.json has them; {} without one."""
    return {name: _preset(model, name) for name in _records(model)}


@functools.cache
def _preset(model, name):
    return Preset(model=model, **{key: _frozen(value) for key, value in _records(model)[name].items()})


@functools.cache
def _records(model):
    """{name: what presets.json says of it}: a Preset is made of what is asked for."""
    file = models.folders()[model] / "presets.json"
    records = json.loads(file.read_text(encoding="utf-8")) if file.exists() else []
    found = {record["name"]: record for record in records}
    if len(found) < len(records):
        raise ValueError(f"two presets of {file} are called the same")
    return found


def names():
    """The names of all presets.

    >>> {"copper", "gold", "vinyl", "nacre"} <= set(names())
    True
    """
    return tuple(entries.entries())


def find(name):
    """The preset of this name, title or alias, as spelt; else small and capital letters are alike.

    Raises FacetFilmError with the nearest names.

    >>> find("Cu").title
    'Copper'
    >>> find("TiN").name, find("Tin").name, find("TIN").name
    ('titanium_nitride', 'tin', 'tin')
    >>> find("figure 5, 79-106 nm").model
    'layered_rgb'
    """
    if not isinstance(name, str):
        raise FacetFilmError("A preset is called by its name, such as 'copper', not {value!r}.", value=name)
    known = entries.entries()
    if name not in known:
        as_spelt, by_plain_name = _by_any_name()
        found = as_spelt.get(name.strip()) or by_plain_name.get(_plain(name))
        if not found:
            choice("preset", name, by_plain_name)
        name = found
    return _preset(known[name].model, name)


def forget():
    """Read the files anew, after a model was put on the path of addon.models or taken off it."""
    for read in (of_model, _preset, _records):
        read.cache_clear()
    _by_any_name.cache_clear()


@functools.lru_cache(maxsize=1)
def _by_any_name():
    """Names of presets by what else they are called: as spelt, and in plain letters."""
    as_spelt, plain = {}, {name: name for name in names()}
    for entry in entries.entries().values():
        for other in (entry.name, entry.title, *entry.aliases):
            as_spelt[other] = entry.name
            plain.setdefault(_plain(other), entry.name)
    return as_spelt, plain


def _plain(name):
    return "_".join(name.strip().lower().replace("-", " ").replace("_", " ").split())


def _frozen(value):
    """Lists as tuples, dicts that cannot be changed."""
    if isinstance(value, str):
        return value
    if isinstance(value, list):
        return tuple(map(_frozen, value) if isinstance(value and value[0], (list, dict)) else value)
    return MappingProxyType({key: _frozen(item) for key, item in value.items()}) if isinstance(value, dict) else value
