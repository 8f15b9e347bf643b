"""What the search popup lists: every material with all its names, and its picture."""

import functools

from .thumbnails import preset_icon

__all__ = ["forget", "items"]

BETWEEN = " · "


@functools.lru_cache(maxsize=1)
def items():
    """Items of an enumeration; Blender needs their texts to live on."""
    from ...catalogue.entries import entries
    found = sorted(entries().values(), key=lambda entry: entry.title.casefold())
    return [(entry.name, BETWEEN.join((entry.title, *entry.aliases)), "", preset_icon(entry.name), number)
            for number, entry in enumerate(found)]


def forget():
    """Drop the list, whose icons are about to go."""
    items.cache_clear()
