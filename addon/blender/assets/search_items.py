"""What the search popup lists: every material with all its names, and its picture."""

import functools

from .thumbnails import preset_icon

__all__ = ["forget", "items", "preset_of_item"]

AGAIN = " "
"""Between a material's name and a number, where it is listed once more by another name; names have none."""


@functools.lru_cache(maxsize=1)
def items():
    """Items of an enumeration; Blender needs their texts to live on."""
    from ...catalogue.entries import entries
    from ...catalogue.popup import labels
    found, listed = [], set()
    for number, (name, text) in enumerate(labels(entries().values())):
        identifier = f"{name}{AGAIN}{number}" if name in listed else name
        found.append((identifier, text, "", preset_icon(name), number))
        listed.add(name)
    return found


def preset_of_item(identifier):
    """Name of the material that an item stands for.

    >>> preset_of_item("window_glass 430"), preset_of_item("gold")
    ('window_glass', 'gold')
    """
    return identifier.partition(AGAIN)[0]


def forget():
    """Drop the list, whose icons are about to go."""
    items.cache_clear()
