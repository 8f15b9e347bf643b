"""Finds presets and datasets by material, author, chemical formula and common name."""

import dataclasses
import difflib
import functools
import re
import unicodedata

from . import names, presets, tables

__all__ = ["Found", "search"]

# How well a word of the query fits a material, best first.
EXACT, BEGINNING, ELSEWHERE, IN_THE_NOTES = 8, 4, 2, 1
SHELVES = ("main", "other", "organic", "glass", "3d", "popular_glass", "specs")


@dataclasses.dataclass(frozen=True)
class Found:
    """A material that a search found.

    id              what bake() takes: a preset's name or a dataset's id
    title           for people
    kind            "metal", "glass", …
    dataset         "shelf/book/page" of the data
    is_preset       whether it is a curated preset
    covers_visible  whether 400 to 700 nm were measured; else the ends are held
    """

    id: str
    title: str
    kind: str
    dataset: str
    is_preset: bool
    covers_visible: bool


def search(text, limit=50, *, guess=True):
    """The materials that every word of the text fits, best first.

    text   words in any order: "brass", "gold babar", "TiO2", "titanium oxide"
    limit  at most so many; None for all
    guess  whether words of which nothing is known are read as the nearest known ones

    Presets come first among equals, then datasets by shelf.

    >>> [found.id for found in search("gold babar", 2)]
    ['gold', 'main/Au/Babar']
    >>> search("tungstn")[0].dataset.split("/")[1]
    'W'
    """
    words = _words(text)
    found = _fitting(words)
    if not found and words and guess:
        found = _fitting([_nearest(word) for word in words])
    return found[:limit]


def _fitting(words):
    records = _records()
    scores = []
    for place, (_, names_text, all_text) in enumerate(records):
        score = 0
        for word in words:
            if word not in all_text:
                break
            score += _fit(word, names_text)
        else:
            scores.append((-score, place))
    return [records[place][0] for _, place in sorted(scores)]


def _fit(word, names_text):
    if f" {word} " in names_text:
        return EXACT
    if f" {word}" in names_text:
        return BEGINNING
    return ELSEWHERE if word in names_text else IN_THE_NOTES


@functools.lru_cache(maxsize=None)
def _words(text):
    """Small letters without accents; subscripts are digits, and what is no letter or digit parts words."""
    text = str(text)
    plain = text if text.isascii() else unicodedata.normalize("NFKD", text)
    return re.findall(r"[a-z0-9α-ω.]+", plain.lower())


def _text(*parts):
    return f" {' '.join(word for part in parts for word in _words(part))} "


@functools.lru_cache(maxsize=1)
def _records():
    """(Found, its names as words, all its text as words), presets first."""
    _, index, values = tables.read("refractiveindex")
    datasets = {record[0]: record for record in index["records"]}
    found = [_preset(preset, datasets.get(preset.dataset), index)
             for preset in presets.all_presets().values()]
    for record in sorted(datasets.values(), key=lambda record: SHELVES.index(record[0].split("/")[0])):
        found.append(_dataset(record, index, values))
    return found


def _preset(preset, record, index):
    covers = _covers(record) if record else presets.constants(preset).covers_visible
    entry = Found(preset.name, preset.title, preset.kind, preset.dataset, True, covers)
    named = _text(preset.name, preset.title, preset.kind, *preset.aliases)
    if record is None:
        return entry, named, named + _text(preset.note, preset.estimated)
    named += _text(*names.material_names(preset.dataset), *preset.dataset.split("/")[1:])
    return entry, named, named + _text(record[1], preset.note) + _text(index["citations"][record[2]])


def _dataset(record, index, values):
    dataset, title, citation, comment, _, k_model = record
    k = values[k_model[2]:k_model[2] + k_model[3]].mean() if k_model else 0.0
    title_shown, kind = names.title_of(dataset, title), names.kind_of(dataset, k)
    entry = Found(dataset, title_shown, kind, dataset, False, _covers(record))
    named = _text(*names.material_names(dataset), *dataset.split("/")[1:])
    return entry, named, named + _text(title, comment) + _text(index["citations"][citation])


def _covers(record):
    ranges = [model[-2:] for model in record[4:6] if model]
    return max(low for low, _ in ranges) <= 400.0 and min(high for _, high in ranges) >= 700.0


@functools.lru_cache(maxsize=1)
def _vocabulary():
    return sorted({word for _, named, _ in _records() for word in named.split() if len(word) > 3})


def _nearest(word):
    """The word itself where it occurs, else the nearest of the materials' names."""
    if any(word in all_text for _, _, all_text in _records()):
        return word
    return (difflib.get_close_matches(word, _vocabulary(), 1, 0.7) or [word])[0]
