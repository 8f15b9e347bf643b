"""What the field lists while one types the name of a material, over the whole database."""

import re

__all__ = ["lines", "name_in", "search"]

LISTED = 40
BETWEEN = " · "
"""Between a name and its title in a line of a list."""
NO_WORD = re.compile(r"[\s/]+")
"""Where Blender's search parts words."""


def search(text):
    """(name, title) of what fits the words typed so far, presets first."""
    return [found[:2] for found in _found(text)]


def lines(text):
    """The same as lines that begin with the name, for Blender's list, which leaves out what lacks a typed word.

    So words that fit an alias, a note or a misspelt name stand at the end of the line.
    """
    return [BETWEEN.join((name, title, *_elsewhere(text, f"{name} {title}", words)))
            for name, title, words in _found(text)]


def name_in(line):
    """The name that a line begins with."""
    return line.split(BETWEEN)[0]


def _found(text):
    """(name, title, all words that are searched) of what fits."""
    from ...catalogue.search import search as found_by
    return [(found.id, found.title, found.words) for found in found_by(text, limit=LISTED)]


def _elsewhere(text, shown, words):
    """The typed words that no shown word begins with, each as the first of `words` that does, or as it is."""
    shown, words = (NO_WORD.split(part.casefold()) for part in (shown, words))
    return [next((word for word in words if word.startswith(typed)), typed) for typed in text.casefold().split()
            if not any(word.startswith(typed) for word in shown)]
