"""Choosing a preset: by its thumbnail among those of its kind, or by typing, over the whole database."""

import functools
import re

from ...catalogue.kinds import KINDS
from ..assets.thumbnails import preset_icon

__all__ = ["KIND_ITEMS", "draw_card", "forget", "lines", "name_in", "search", "thumbnail_items"]

KIND_ITEMS = [(kind, title, "") for kind, title in KINDS.items()]
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


def thumbnail_items(kind, chosen):
    """Items of an enumeration: the presets of a kind with their icons, and first the chosen one if it is none of them.

    Blender needs the texts to live on; they do, as both parts are kept.
    """
    listed = _of_kind(kind)
    if any(item[0] == chosen for item in listed):
        return listed
    return [_alone(chosen), *(item[:4] + (number,) for number, item in enumerate(listed, 1))]


@functools.cache
def _of_kind(kind):
    from ...catalogue.entries import entries
    found = [entry for entry in entries().values() if entry.kind == kind]
    return [(entry.name, entry.title, "", preset_icon(entry.name), number) for number, entry in enumerate(found)]


@functools.cache
def _alone(name):
    return (name, name, "", preset_icon(name), 0)


def forget():
    """Drop the lists, whose icons are about to go."""
    _of_kind.cache_clear()
    _alone.cache_clear()


def draw_card(layout, settings, draw_apply, *, realisation=True):
    """A thumbnail that opens all of its kind, a field to type in, and what else is asked, in three rows.

    draw_apply   draws the last row into the layout that it is given
    realisation  whether it can be chosen
    """
    row = layout.row()
    row.use_property_split = False
    picture = row.column()
    picture.ui_units_x = 4.2
    picture.template_icon_view(settings, "thumbnail", show_labels=True, scale=3.4, scale_popup=4.0)
    column = row.column()
    typed = column.row(align=True)
    typed.prop(settings, "preset", text="", icon="VIEWZOOM")
    typed.prop_menu_enum(settings, "kind", text="", icon="FILTER")
    if realisation:
        column.row(align=True).prop(settings, "realisation", text="")
    draw_apply(column)
