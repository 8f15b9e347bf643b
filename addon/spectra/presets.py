"""Curated materials: which dataset, how rough, how much of it is diffuse."""

import dataclasses
import functools
import json
import pathlib

from ..errors import FacetFilmError, choice

__all__ = ["Preset", "find", "constants", "names", "all_presets"]

FILE = pathlib.Path(__file__).parent / "data" / "presets.json"


@dataclasses.dataclass(frozen=True)
class Preset:
    """A material with the parameters of Cook and Torrance's model.

    name          what scripts call it, small letters and underscores
    title         what people call it
    kind          "metal", "dielectric", "semiconductor", "liquid", … for lists
    dataset       "shelf/book/page" whose F is the specular part's; "" where there is none
    index         in place of a dataset: ((wavelength in nm, n, k), …)
    reflectance   in place of a dataset: ((wavelength in nm, normal reflectance), …), k = 0
    aliases       other names
    specular      s, the specular fraction; d = 1 − s
    slopes        ((rms slope m, weight w), …)
    distribution  "beckmann" or "gaussian"
    diffuse       where the diffuse colour comes from: the id of the dataset whose normal
                  reflectance it is, three linear Rec.709 numbers, or "specular": the normal
                  reflectance of the specular part
    note          where the parameters are from
    estimated     what of it is no measurement, and from what it was guessed; "" where all is measured
    """

    name: str
    title: str
    kind: str
    dataset: str = ""
    index: tuple = ()
    reflectance: tuple = ()
    aliases: tuple = ()
    specular: float = 1.0
    slopes: tuple = ((0.2, 1.0),)
    distribution: str = "beckmann"
    diffuse: object = "specular"
    note: str = ""
    estimated: str = ""


def constants(preset):
    """The OpticalConstants of a Preset: its dataset's, its own, or those of its normal reflectance.

    >>> constants(find("copper")).dataset
    'main/Cu/Johnson'
    """
    from . import optical_constants  # not before a bake: lists of presets have to be there at once
    if preset.dataset:
        return optical_constants.load(preset.dataset)
    make = optical_constants.OpticalConstants if preset.index else optical_constants.from_normal_reflectance
    return make(*zip(*(preset.index or preset.reflectance)), f"preset {preset.name}", title=preset.title,
                citation=preset.estimated or preset.note, licence="CC0-1.0")


@functools.lru_cache(maxsize=1)
def all_presets():
    """Every preset by its name, in the order of the file."""
    records = json.loads(FILE.read_text(encoding="utf-8"))
    return {record["name"]: _preset(record) for record in records}


def names():
    """The names of all presets.

    >>> {"copper", "gold", "vinyl"} <= set(names())
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


def _preset(record):
    lists = {key: tuple(map(tuple, value)) if key in {"slopes", "index", "reflectance"} else tuple(value)
             for key, value in record.items() if isinstance(value, list)}
    return Preset(**{**record, **lists})
