"""Finds presets and datasets by material, author, chemical formula and common name."""

import dataclasses
import difflib
import functools
import re
import unicodedata

from . import tables

__all__ = ["Found", "search", "words_of", "END_OF_NAMES"]

# How well a word of the query fits a material, best first.
EXACT, BEGINNING, ELSEWHERE, IN_THE_NOTES = 8, 4, 2, 1
END_OF_NAMES = "|"
"""In a line of the index, between the words of a material's names and all its other words."""
WORD = re.compile(r"[a-z0-9α-ω.]+")


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

    text   words in any order: "brass", "gold babar", "TiO2", "titanium oxide"
    limit  at most so many; None for all
    guess  whether words of which nothing is known are read as the nearest known ones

    Presets come first among equals, then datasets by shelf.

    >>> [found.id for found in search("gold babar", 2)]
    ['gold', 'main/Au/Babar']
    >>> search("tungstn")[0].dataset.split("/")[1]
    'W'
    """
    words = words_of(text)
    found = _fitting(words)
    if not found and words and guess:
        found = _fitting([_nearest(word) for word in words])
    return [_found(place) for place in found[:limit]]


def words_of(text):
    """Words of a text as the search compares them: small letters without accents, subscripts as digits.

    >>> words_of("Fe₂O₃, Café")
    ['fe2o3', 'cafe']
    """
    text = str(text)
    plain = text if text.isascii() else unicodedata.normalize("NFKD", text)
    return WORD.findall(plain.lower())


def _lines():
    """The index as ``tools/build_search.py`` wrote it, presets first: a material's words, spaces around each."""
    return tables.lines("search", "words")


def _fitting(words):
    """Places of the materials that all words fit, best first."""
    scores = []
    for place, line in enumerate(_lines()):
        for word in words:
            if word not in line:
                break
        else:
            names_text = line.partition(END_OF_NAMES)[0]
            scores.append((-sum(_fit(word, names_text) for word in words), place))
    return [place for _, place in sorted(scores)]


def _fit(word, names_text):
    if f" {word} " in names_text:
        return EXACT
    if f" {word}" in names_text:
        return BEGINNING
    return ELSEWHERE if word in names_text else IN_THE_NOTES


@functools.lru_cache(maxsize=512)
def _found(place):
    return Found(*tables.line("search", "found", place), words=tables.line("search", "words", place))


@functools.lru_cache(maxsize=1)
def _vocabulary():
    return sorted({word for line in _lines() for word in line.partition(END_OF_NAMES)[0].split() if len(word) > 3})


def _nearest(word):
    """The word itself where it occurs, else the nearest of the materials' names."""
    if any(word in line for line in _lines()):
        return word
    return (difflib.get_close_matches(word, _vocabulary(), 1, 0.7) or [word])[0]
