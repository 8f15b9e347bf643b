"""What lists show of every material, at once: names and looks, without what the material is made of.

As ``tools/build_search.py`` wrote it into catalogue.table; of a model that is not in there, or whose presets.json is of
another size than then, as its presets are.
"""

import functools
from pathlib import Path
from typing import NamedTuple

from .. import models

__all__ = ["Entry", "THUMBNAILS", "column", "entries", "forget", "in_category", "size_of", "stated", "thumbnail"]

THUMBNAILS = Path(__file__).parents[1] / "thumbnails"


class Entry(NamedTuple):
    """A material of the catalogue, as :class:`addon.catalogue.presets.Preset` has it.

    name            what scripts call it
    title           what people call it
    category        what it looks like: one of addon.catalogue.categories.CATEGORIES
    kind            what it is: one of addon.catalogue.kinds.KINDS
    model           the model that it is a material of
    dataset         "shelf/book/page" that it was measured as, or ""
    variant_of      name of the material under which lists show it, or ""
    covers_visible  whether 400 to 700 nm were measured; else the ends are held
    aliases         other names
    """

    name: str
    title: str
    category: str
    kind: str
    model: str
    dataset: str
    variant_of: str
    covers_visible: bool
    aliases: tuple[str, ...]


@functools.lru_cache(maxsize=1)
def entries():
    """Every Entry by its name, model by model, in the order of the files.

    >>> entries()["copper"].title, entries()["copper"].category
    ('Copper', 'metal')
    """
    found = {}
    for rows in _by_model().values():
        found.update((row[0], Entry._make(row)) for row in rows)
    return found


def column(part, make):
    """Of every Entry, in their order, a text that the table keeps beside it.

    part  name of the table's part
    make  function(preset) -> the text, where the table has it not
    """
    from ..spectra import tables
    rows = tables.part("catalogue", "entries")["rows"]
    kept = {row[0]: text for row, text in zip(rows, tables.part("catalogue", part)["texts"])}
    return tuple(kept[entry.name] if _is_kept(entry.model) else make(_presets_of(entry.model)[entry.name])
                 for entry in entries().values())


def in_category(category):
    """The Entries of a category, those that are no variants of others first.

    >>> in_category("precious")[0].name
    'gold'
    """
    found = [entry for entry in entries().values() if entry.category == category]
    return sorted(found, key=lambda entry: bool(entry.variant_of))


def thumbnail(name):
    """Path of a material's picture, whether there is one or not.

    >>> thumbnail("copper").name
    'copper.webp'
    """
    return THUMBNAILS / f"{name}.webp"


def forget():
    """Look at the presets anew, after a model was put on the path of addon.models or taken off it."""
    entries.cache_clear()
    _is_kept.cache_clear()


def size_of(model):
    """Bytes of a model's presets.json; 0 without one."""
    try:
        return (models.folders()[model] / "presets.json").stat().st_size
    except FileNotFoundError:
        return 0


def stated(preset):
    """The fields of a Preset's Entry, as the table holds them."""
    from .presets import constants
    known = constants(preset)
    return (preset.name, preset.title, preset.category, preset.kind, preset.model, preset.dataset, preset.variant_of,
            known is None or known.covers_visible, preset.aliases)


def _by_model():
    """The fields of the Entries by model, in the order of the models."""
    from ..spectra import tables
    kept = {}
    for row in tables.part("catalogue", "entries")["rows"]:
        kept.setdefault(row[4], []).append(row)
    return {model: kept.get(model, ()) if _is_kept(model) else [*map(stated, _presets_of(model).values())]
            for model in models.names()}


@functools.cache
def _is_kept(model):
    from ..spectra import tables
    return tables.part("catalogue", "models").get(model) == size_of(model)


def _presets_of(model):
    from .presets import of_model
    return of_model(model)
