"""What assets are called.

The search of Blender's asset shelf reads names alone: so an asset's name has, after the title, the other names that
people type.
"""

import functools

__all__ = ["asset_name", "forget", "preset_of", "title_of"]

BEGIN, BETWEEN, END = " (", ", ", ")"
"""Around and between the other names; the bracket comes before letters where Blender sorts, so that aluminium stands
before its compounds.
"""
MOST_BYTES = 63
"""Of a datablock's name in Blender 4.5."""


def asset_name(entry):
    """Title and as many of the other names as there is room for.

    entry  an addon.catalogue.entries.Entry, or a preset

    >>> from addon.catalogue.entries import entries
    >>> asset_name(entries()["aluminium"])
    'Aluminium (Al, aluminum, 铝, Alu)'
    """
    others, room = [], MOST_BYTES - len(f"{entry.title}{BEGIN}{END}".encode())
    for other in entry.aliases:
        if other.casefold() != entry.title.casefold() and len(BETWEEN.join((*others, other)).encode()) <= room:
            others.append(other)
    return f"{entry.title}{BEGIN}{BETWEEN.join(others)}{END}" if others else entry.title


def title_of(name):
    """The title that an asset's name begins with."""
    return name.split(BEGIN)[0]


def preset_of(name):
    """Name of the preset that an asset of this name is of, or None.

    >>> preset_of("Aluminium (Al, aluminum, 铝, Alu)"), preset_of("Suzanne")
    ('aluminium', None)
    """
    return _by_title().get(title_of(name))


@functools.cache
def _by_title():
    from ...catalogue.entries import entries
    return {entry.title: entry.name for entry in entries().values()}


def forget():
    """Look at the catalogue anew."""
    _by_title.cache_clear()
