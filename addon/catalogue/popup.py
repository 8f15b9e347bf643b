"""What Blender's search popup is given to search, so that what a person means comes first there, too.

Blender ranks by itself: every word that is typed has to begin one of the text's; words behind the last ▸ count more
than those before it; among equals the text with the fewest letters behind the ▸ is first.  So the title stands there,
and its other names before it.  Where another material would still come before the one that is called just what is typed
("glass": a filter glass before window glass), that one is listed once more, with this name behind the ▸.
"""

import bisect
import re
from collections.abc import Iterable

from .entries import Entry

__all__ = ["MAIN", "labels"]

BETWEEN, MAIN = " · ", " ▸ "
WORDS = re.compile(r"[^ \-_/▸]+")
"""What Blender takes for words: a point between two names is one, too, which nobody types."""


def labels(found: Iterable[Entry]) -> list[tuple[str, str]]:
    """(name, text) of all materials, and of some of them again by another name.

    >>> from .entries import entries
    >>> [text for name, text in labels(entries().values()) if name == "window_glass"][1:]
    ['Window glass ▸ glass', 'Window glass ▸ window', 'Window glass ▸ Glas']
    """
    found = sorted(found, key=lambda entry: entry.title.casefold())
    return [(entry.name, _all_names(entry)) for entry in found] + _again(found)


def _all_names(entry):
    """The other names, and the title behind them."""
    others = [alias for alias in entry.aliases if alias.casefold() != entry.title.casefold()]
    return BETWEEN.join(others) + MAIN + entry.title if others else entry.title


def _again(found):
    """(name, text) of the names by which Blender would show another material first."""
    titles = {entry.name: _words(entry.title) for entry in found}
    begin = sorted({(word, entry.name) for entry in found for text in (entry.title, *entry.aliases)
                    for word in _words(text)})
    taken = {entry.title.casefold() for entry in found}
    again = []
    for entry in found:
        for alias in entry.aliases:
            typed = _words(alias)
            if not typed or alias.casefold() in taken:
                continue
            others = set.intersection(*(_beginning_with(word, begin) for word in typed)) - {entry.name}
            if any(_comes_first(typed, titles[other], titles[entry.name]) for other in others):
                taken.add(alias.casefold())
                again.append((entry.name, entry.title + MAIN + alias))
    return again


def _words(text):
    return WORDS.findall(text.casefold())


def _beginning_with(typed, begin):
    """Names of the entries that have a word which begins so; `begin` is sorted."""
    names = set()
    for word, name in begin[bisect.bisect_left(begin, (typed,)):]:
        if not word.startswith(typed):
            break
        names.add(name)
    return names


def _comes_first(typed, other, own):
    """Whether a title that all typed words begin, or one of no more letters, is before our own."""
    begun = all(any(word.startswith(letters) for word in other) for letters in typed)
    return begun or sum(map(len, other)) <= sum(map(len, own))
