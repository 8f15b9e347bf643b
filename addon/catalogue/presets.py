"""The presets of all models, as their folders' presets.json hold them."""

import dataclasses
import functools
import json
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from .. import models
from ..errors import FacetFilmError, choice

__all__ = ["Preset", "all_presets", "constants", "find", "forget", "names"]


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


@functools.lru_cache(maxsize=1)
def all_presets():
    """Every preset by its name, model by model, in the order of the files."""
    found = {}
    for model, folder in models.folders().items():
        file = folder / "presets.json"
        for record in json.loads(file.read_text(encoding="utf-8")) if file.exists() else ():
            preset = Preset(model=model, **{key: _frozen(value) for key, value in record.items()})
            if preset.name in found:
                raise ValueError(f"two presets are called {preset.name!r}: see {file}")
            found[preset.name] = preset
    return found


def names():
    """The names of all presets.

    >>> {"copper", "gold", "vinyl", "nacre"} <= set(names())
    True
    """
    return tuple(all_presets())


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
    if name in all_presets():
        return all_presets()[name]
    as_spelt, by_plain_name = _by_any_name()
    found = as_spelt.get(name.strip()) or by_plain_name.get(_plain(name))
    if not found:
        choice("preset", name, by_plain_name)
    return all_presets()[found]


def forget():
    """Read the files anew, after a model was put on the path of addon.models or taken off it."""
    all_presets.cache_clear()
    _by_any_name.cache_clear()


@functools.lru_cache(maxsize=1)
def _by_any_name():
    """Names of presets by what else they are called: as spelt, and in plain letters."""
    as_spelt, plain = {}, {name: name for name in names()}
    for preset in all_presets().values():
        for other in (preset.name, preset.title, *preset.aliases):
            as_spelt[other] = preset.name
            plain.setdefault(_plain(other), preset.name)
    return as_spelt, plain


def _plain(name):
    return "_".join(name.strip().lower().replace("-", " ").replace("_", " ").split())


def _frozen(value):
    """Lists as tuples, dicts that cannot be changed."""
    if isinstance(value, list):
        return tuple(map(_frozen, value) if isinstance(value and value[0], (list, dict)) else value)
    return MappingProxyType({key: _frozen(item) for key, item in value.items()}) if isinstance(value, dict) else value
