"""Where a material's picture is in the popover of all materials: Blender tells where areas are, but not that."""

import re
from importlib import import_module

import hands

__all__ = ["place_of"]

PITCH, ROW = 60, 86
"""Pixels from one picture to the next, across and down, where the interface has its own size."""
ACROSS = 17
"""Pictures in a row, where the window is as wide as the popover wants to be."""
FROM_RIGHT, FROM_TOP = 1032, 76
"""From the right end and the top of the window to the first picture: the popover stands as far right and up as it can
where it is opened from the right half of the upper edge.
"""


def place_of(name):
    """Where to click for a material."""
    row, column = divmod(_names().index(name), ACROSS)
    return hands.window().width - FROM_RIGHT + PITCH * column, hands.window().height - FROM_TOP - ROW * row


def _names():
    """Names of the materials as the popover sorts them: by catalogue, and then by what the asset is called."""
    addon = f"{hands.MODULE}.addon"
    catalogue, names = import_module(f"{addon}.catalogue.entries"), import_module(f"{addon}.blender.assets.names")
    paths = import_module(f"{addon}.catalogue.categories").CATEGORIES
    shown = [entry for entry in catalogue.entries().values() if not entry.variant_of]
    shown.sort(key=lambda entry: (_natural(paths[entry.category]), _natural(names.asset_name(entry))))
    return [entry.name for entry in shown]


def _natural(text):
    """Blender's order: small and capital letters alike, numbers by their size."""
    return [(0, int(part), "") if part.isdigit() else (1, 0, part) for part in re.split(r"(\d+)", text.casefold())]
