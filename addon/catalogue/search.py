"""Finds materials by what people call them, in several languages and spellings; then measurements of the database.

A material is found by its title, its other names and its tags: what it is, what it looks like, its formula.  Authors,
citations and notes are read only where nothing is called so, and what they lead to stands among the measurements.
What is not there is said to be missing, and the nearest that is there is called the nearest.
"""

import functools
import re
from typing import NamedTuple

from ..spectra import tables
from . import entries
from .categories import CATEGORIES

__all__ = ["Found", "Results", "forget", "line_of", "look_up", "notes_of", "search", "tags_of", "words_of"]

# How well a text fits a material, best first.
TITLE, ALIAS, TITLE_BEGINS, ALIAS_BEGINS, TITLE_WORDS, NAME_WORDS, TAG_WORDS, INSIDE = range(8)
PART = "|"
"""In a line of the index, between the title, the other names and the tags."""
WORD = re.compile(r"[a-z0-9α-ω.\u4e00-\u9fff]+")
SHORTEST_INSIDE = 3
"""Letters of a word that is looked for inside of words; of Chinese, whose words stand without spaces, any number."""
SHORTEST_TAG = 4
NEAREST = 8
"""How many are given where nothing fits."""
SHORTEST_GUESSED = 5
"""Letters of a word that may be read as another."""


class Found(NamedTuple):
    """A material or measurement that a search found.

    id              what bake() takes: a preset's name or a dataset's id
    title           for people
    kind            "metal", "glass", …
    dataset         "shelf/book/page" of the data
    is_preset       whether it is a preset
    covers_visible  whether 400 to 700 nm were measured; else the ends are held
    words           all that the search reads of it, in small letters
    """

    id: str
    title: str
    kind: str
    dataset: str
    is_preset: bool
    covers_visible: bool
    words: str = ""


class Results(NamedTuple):
    """What a search found, best first.

    materials     presets
    measurements  datasets of the materials that the words name; where nothing is called so, whatever their words,
                  authors and citations lead to
    missing       the text, where nothing fits it: then the others are the nearest; else ""
    """

    materials: tuple[Found, ...] = ()
    measurements: tuple[Found, ...] = ()
    missing: str = ""


def search(text, limit=50, *, guess=True):
    """What :func:`look_up` finds, in one row: materials first.

    guess  whether the nearest is given where nothing fits

    >>> [found.id for found in search("gold babar", 2)]
    ['gold', 'main/Au/Babar']
    >>> search("tungstn")[0].dataset.split("/")[1]
    'W'
    """
    found = look_up(text, limit)
    return [] if found.missing and not guess else [*found.materials, *found.measurements][:limit]


def look_up(text, limit=50):
    """The Results for words in any order: "brass", "gold babar", "TiO2", "金"; or for the address of a dataset's page.

    limit  at most so many of each; None for all

    >>> look_up("copper").materials[0].id
    'copper'
    >>> look_up("silver unobtainium").missing
    'silver unobtainium'
    """
    text = str(text)
    dataset = _addressed(text) if "/" in text else None
    if dataset:
        return _of_dataset(dataset)
    words = words_of(text)
    if not words:
        return Results(missing=text) if text.strip() else Results(_presets(range(len(_all())), limit))
    places = _materials(words, text.strip())
    measured = _measurements(words, limit) if limit is None or len(places) < limit else ()
    if places or measured:
        return Results(_presets(places, limit), measured)
    cited = _cited(words, limit)
    return Results(measurements=cited) if cited else _nearest(text, words)


def words_of(text):
    """Words of a text as the search compares them: small letters without accents, subscripts as digits.

    >>> words_of("Fe₂O₃, Café")
    ['fe2o3', 'cafe']
    """
    if not text.isascii():
        import unicodedata  # for few
        text = unicodedata.normalize("NFKD", text)
    return WORD.findall(text.lower())


def line_of(title, aliases, tags):
    """A material's line of the index: its title, its other names and its tags, parted by strokes.

    >>> line_of("Red copper", ["Cu", "Kupfer"], ["metal"])
    '; red copper;| ; cu; kupfer;| metal '
    """
    def whole(names):
        return "".join(f" {' '.join(words_of(name))};" for name in dict.fromkeys(names))
    of_tags = dict.fromkeys(word for tag in tags for word in words_of(tag))
    return f";{whole([title])}{PART} ;{whole(aliases)}{PART} {' '.join(of_tags)} "


def tags_of(preset):
    """What a preset is found by beside its names: what it is, what it looks like, its chemical names and formula."""
    from ..spectra.names import material_names
    looks = [word for word in words_of(CATEGORIES.get(preset.category, "")) if len(word) >= SHORTEST_TAG]
    chemical = (*material_names(preset.dataset), preset.dataset.split("/")[1]) if preset.dataset else ()
    return (preset.kind, *looks, *chemical)


def notes_of(preset, others=()):
    """A preset's line of all its words, read where nothing is called so: names, tags, notes, and other texts."""
    texts = (preset.title, *preset.aliases, *tags_of(preset), preset.note, preset.estimated, *others)
    return f" {' '.join(dict.fromkeys(word for text in texts for word in words_of(text)))} "


def forget():
    """Look at the presets anew, after a model was put on the path of addon.models or taken off it."""
    for kept in (_all, _lines, _notes, _vocabulary):
        kept.cache_clear()


# --- Materials ---

@functools.lru_cache(maxsize=1)
def _all():
    return tuple(entries.entries().values())


@functools.lru_cache(maxsize=1)
def _lines():
    """Of every Entry its line of the index."""
    return entries.column("lines", lambda preset: line_of(preset.title, preset.aliases, tags_of(preset)))


@functools.lru_cache(maxsize=1)
def _notes():
    return entries.column("notes", notes_of)


def _presets(places, limit):
    """The Founds of some Entries."""
    shown, lines = _all(), _lines()
    return tuple(Found(shown[place].name, shown[place].title, shown[place].kind, shown[place].dataset, True,
                       shown[place].covers_visible, lines[place]) for place in places[:limit])


def _materials(words, spelt=""):
    """Places of the Entries that all words fit, best first; of those that fit alike, what is no variant first.

    spelt  the text as it was typed: what is called so to the letter is before all, as TiN before tin
    """
    found, whole, shown = [], " ".join(words), _all()
    inside = all(len(word) >= SHORTEST_INSIDE or not word.isascii() for word in words)
    for place, line in enumerate(_lines()):
        for word in words:
            if word not in line:
                break
        else:
            fit = _fit(words, whole, line)
            if fit < INSIDE or inside:
                to_the_letter = fit <= ALIAS and (spelt == shown[place].title or spelt in shown[place].aliases)
                found.append((not to_the_letter, fit, bool(shown[place].variant_of), place))
    return [place for *_, place in sorted(found)]


def _fit(words, whole, line):
    """How well words, all of which are in a line, fit it."""
    title, others, _ = line.split(PART)
    name = f"; {whole}"
    if name in title:
        return TITLE if f"{name};" in title else TITLE_BEGINS if f"{name};" not in others else ALIAS
    if name in others:
        return ALIAS if f"{name};" in others else ALIAS_BEGINS
    for text, fit in ((title, TITLE_WORDS), (title + others, NAME_WORDS), (line, TAG_WORDS)):
        if all(f" {word}" in text for word in words):
            return fit
    return INSIDE


# --- Measurements ---

def _addressed(text):
    """The dataset that a text is the address of, or None."""
    from ..spectra.optical_constants import (
        dataset_of_address,  # not before one is typed: the first letter is waited for
    )
    return dataset_of_address(text)


def _of_dataset(dataset):
    """The materials that were measured so, and the measurement."""
    places = [place for place, entry in enumerate(_all()) if entry.dataset == dataset]
    return Results(_presets(places, None), (_measurement(_ids().index(dataset)),))


def _ids():
    return tables.part("search", "ids")["ids"]


@functools.lru_cache(maxsize=512)
def _measurement(place):
    title, kind, covers_visible = tables.line("search", "found", place)
    dataset = _ids()[place]
    return Found(dataset, title, kind, dataset, False, covers_visible, tables.line("search", "names", place))


def _measurements(words, limit):
    """The datasets whose material is called so, those first of which more words are whole."""
    found = []
    for place, line in enumerate(tables.lines("search", "names")):
        for word in words:
            if f" {word}" not in line:
                break
        else:
            found.append((-sum(f" {word} " in line for word in words), place))
    return tuple(_measurement(place) for _, place in sorted(found)[:limit])


def _cited(words, limit):
    """Presets, then datasets, to which words of notes, authors and citations lead."""
    typed = [*(f" {word} " for word in words[:-1]), f" {words[-1]}"]  # the last one may be half typed
    presets = [place for place, line in enumerate(_notes()) if all(word in line for word in typed)]
    cited = []
    for place, (names, rest) in enumerate(zip(tables.lines("search", "names"), tables.lines("search", "rest"))):
        for word in typed:
            if word not in names and word not in rest:
                break
        else:
            cited.append(place)
    return (*_presets(presets, limit), *map(_measurement, cited[:limit]))[:limit]


# --- What is not there ---

def _nearest(text, words):
    """What nothing is called: that which has the nearest words; else that which has most of the words in its names."""
    read_as = [_alike(word) for word in words]
    places, measured = (_materials(read_as), _measurements(read_as, NEAREST)) if read_as != words else ((), ())
    if not places and not measured:
        fits = [sum(len(word) for word in words if f" {word}" in line) for line in _lines()]
        places = [place for place, fit in enumerate(fits) if fit == max(fits) > 0]
    return Results(_presets(places, NEAREST), measured, text)


@functools.lru_cache(maxsize=1)
def _vocabulary():
    """The words of names, those of presets first."""
    return dict.fromkeys(" ".join((*_lines(), *tables.lines("search", "names"))).replace(";", " ").split())


def _alike(word):
    """The word itself where it is part of a name, or short, as formulas are; else one that it is a slip away from."""
    if len(word) < SHORTEST_GUESSED or word in _vocabulary():
        return word
    return next((one for one in _vocabulary() if abs(len(one) - len(word)) <= 1 and _is_slip(word, one)), word)


def _is_slip(typed, meant):
    """Whether one letter is missing, too many, another, or two neighbours are swapped.

    >>> [_is_slip(typed, "tungsten") for typed in ("tungstn", "tunggsten", "tungsdten", "tugnsten", "tunxsten", "tin")]
    [True, True, True, True, True, False]
    """
    place = next((i for i, (a, b) in enumerate(zip(typed, meant)) if a != b), min(len(typed), len(meant)))
    typed, meant = typed[place:], meant[place:]
    return (typed[1:] in (meant, meant[1:]) or typed == meant[1:]
            or (typed[:2] == meant[:2][::-1] and typed[2:] == meant[2:]))
