"""Finds presets and datasets by material, author, chemical formula and common name."""

import dataclasses
import functools
import re
import unicodedata

from ..spectra import tables
from .presets import all_presets

__all__ = ["Found", "END_OF_NAMES", "forget", "index_line", "search", "words_of"]

# How well a word of the query fits a material, best first.
EXACT, BEGINNING, ELSEWHERE, IN_THE_NOTES = 8, 4, 2, 1
END_OF_NAMES = "|"
"""In a line of the index, between the words of a material's names and all its other words."""
WORD = re.compile(r"[a-z0-9α-ω.\u4e00-\u9fff]+")
SHORTEST_GUESSED, MUCH_ALIKE = 5, 0.88
"""Of words that are read as others: how long, and how alike, 1 being the same."""


@dataclasses.dataclass(frozen=True)
class Found:
    """A material that a search found.

    id              what bake() takes: a preset's name or a dataset's id
    title           for people
    kind            "metal", "glass", …
    dataset         "shelf/book/page" of the data
    is_preset       whether it is a curated preset
    covers_visible  whether 400 to 700 nm were measured; else the ends are held
    words           all that the search reads of it: its names, then the rest, in small letters
    """

    id: str
    title: str
    kind: str
    dataset: str
    is_preset: bool
    covers_visible: bool
    words: str = dataclasses.field(default="", repr=False, compare=False)


def search(text, limit=50, *, guess=True):
    """The materials that every word of the text fits, best first.

    text   words in any order: "brass", "gold babar", "TiO2", "titanium oxide"; or the address of a dataset's page
    limit  at most so many; None for all
    guess  whether words of which nothing is known are read as the nearest known ones

    Presets come first among equals, then datasets by shelf.

    >>> [found.id for found in search("gold babar", 2)]
    ['gold', 'main/Au/Babar']
    >>> search("tungstn")[0].dataset.split("/")[1]
    'W'
    """
    named = _addressed(text) if "/" in str(text) else None
    words = words_of(" ".join(named.split("/")[1:]) if named else text)
    found = _fitting(words) if words or not str(text).strip() else []
    if not found and words and guess:
        found = _fitting([_nearest(word) for word in words])
    entry = _entries()[1]
    return [entry(place) for place in found[:limit]]


def _addressed(text):
    """The dataset that a text is the address of, or None."""
    from ..spectra.optical_constants import (
        dataset_of_address,  # not before one is typed: the first letter is waited for
    )
    return dataset_of_address(text)


def words_of(text):
    """Words of a text as the search compares them: small letters without accents, subscripts as digits.

    >>> words_of("Fe₂O₃, Café")
    ['fe2o3', 'cafe']
    """
    text = str(text)
    plain = text if text.isascii() else unicodedata.normalize("NFKD", text)
    return WORD.findall(plain.lower())


def index_line(named, others, whole=()):
    """A material's line of the index: the words of its names, then its whole names, then all other words, each once.

    named, others, whole  texts

    >>> index_line(["Red copper", "Cu"], ["measured copper"], ["Red copper"])
    ' red copper cu | ;red copper; measured'
    """
    names = "".join(f";{name}" for name in dict.fromkeys(" ".join(words_of(text)) for text in whole))
    of_names = dict.fromkeys(word for text in named for word in words_of(text))
    of_others = dict.fromkeys(word for text in others for word in words_of(text) if word not in of_names)
    return f" {' '.join(of_names)} {END_OF_NAMES} {names + '; ' if names else ''}{' '.join(of_others)}"


@functools.lru_cache(maxsize=1)
def _entries():
    """(lines, function of a place to its Found): presets first, then datasets.

    The index is as ``tools/build_search.py`` wrote it; before it stand presets that came later, as of a model that
    someone added.
    """
    kept = tables.lines("search", "words")
    known = set(tables.part("search", "presets")["names"])
    later = [preset for name, preset in all_presets().items() if name not in known]
    lines = [index_line([p.name, p.title, p.kind, *p.aliases], [p.note, p.estimated], [p.name, p.title, *p.aliases])
             for p in later]

    @functools.lru_cache(maxsize=512)
    def found(place):
        if place < len(later):
            p = later[place]
            return Found(p.name, p.title, p.kind, p.dataset, True, True, words=lines[place])
        row = tables.line("search", "found", place - len(later))
        return Found(*row, words=kept[place - len(later)])
    return (*lines, *kept), found


def _lines():
    """Of every material its words, spaces around each."""
    return _entries()[0]


def forget():
    """Look at the presets anew, after a model was put on the path of addon.models or taken off it."""
    _entries.cache_clear()
    _vocabulary.cache_clear()


def _fitting(words):
    """Places of the materials that all words fit, best first: what is called just so, then by how well each fits."""
    scores, whole = [], f";{' '.join(words)};"
    for place, line in enumerate(_lines()):
        for word in words:
            if word not in line:
                break
        else:
            names_text = line.partition(END_OF_NAMES)[0]
            scores.append((whole not in line, -sum(_fit(word, names_text) for word in words), place))
    return [place for *_, place in sorted(scores)]


def _fit(word, names_text):
    if f" {word} " in names_text:
        return EXACT
    if f" {word}" in names_text:
        return BEGINNING
    return ELSEWHERE if word in names_text else IN_THE_NOTES


@functools.lru_cache(maxsize=1)
def _vocabulary():
    return sorted({word for line in _lines() for word in line.partition(END_OF_NAMES)[0].split() if len(word) > 3})


def _nearest(word):
    """The word itself where it occurs or is short, as formulas are; else the nearest of the materials' names."""
    if len(word) < SHORTEST_GUESSED or any(word in line for line in _lines()):
        return word
    import difflib  # for a misspelt word alone
    return (difflib.get_close_matches(word, _vocabulary(), 1, MUCH_ALIKE) or [word])[0]
