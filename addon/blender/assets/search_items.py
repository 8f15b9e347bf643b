"""What the search popup lists: every material with all its names, and its picture."""

import functools

from .names import BETWEEN
from .thumbnails import preset_icon

__all__ = ["forget", "items"]


@functools.lru_cache(maxsize=1)
def items():
    """Items of an enumeration; Blender needs their texts to live on."""
    from ...catalogue.presets import all_presets
    return [(preset.name, BETWEEN.join((preset.title, *preset.aliases)), preset.note, preset_icon(preset.name), number)
            for number, preset in enumerate(sorted(all_presets().values(), key=lambda preset: preset.title.casefold()))]


def forget():
    """Drop the list, whose icons are about to go."""
    items.cache_clear()
