"""Choosing a preset: by its thumbnail among those of its kind, or by typing, over the whole database."""

import functools
import re

from .thumbnails import preset_icon

__all__ = ["KIND_ITEMS", "draw_card", "forget", "lines", "name_in", "search", "thumbnail_items", "title_of"]

KIND_ITEMS = (
    ("metal", "Metals", ""), ("alloy", "Alloys", ""), ("conductor", "Other Conductors", ""),
    ("semiconductor", "Semiconductors", ""), ("oxide", "Oxides", ""), ("sulphide", "Sulphides", ""),
    ("crystal", "Crystals", ""), ("glass", "Glasses", ""), ("liquid", "Liquids", ""),
    ("polymer", "Polymers", ""), ("figure", "The Paper's Figures", "As Cook and Torrance published them in 1982"),
)
LISTED = 40
BETWEEN = " · "
"""Between a name and its title in a line of a list."""
NO_WORD = re.compile(r"[\s/]+")
"""Where Blender's search parts words."""


def search(model, text):
    """(name, title) of what fits the words typed so far, presets first."""
    return [found[:2] for found in _found(model, text)]


def lines(model, text):
    """The same as lines that begin with the name, for Blender's list, which leaves out what lacks a typed word.

    So words that fit an alias, a note or a misspelt name stand at the end of the line.
    """
    return [BETWEEN.join((name, title, *_elsewhere(text, f"{name} {title}", words)))
            for name, title, words in _found(model, text)]


def name_in(line):
    """The name that a line begins with."""
    return line.split(BETWEEN)[0]


def _found(model, text):
    """(name, title, all words that are searched) of what fits."""
    if model == "layered_rgb":
        from ..layered_presets import PRESETS
        texts = {name: f"{name} {preset.title} {preset.kind} {preset.note}".casefold() for name, preset in PRESETS.items()}
        return [(name, PRESETS[name].title, words) for name, words in texts.items()
                if all(word in words for word in text.casefold().split())]
    from ..spectra.search import search as found_by
    return [(found.id, found.title, found.words) for found in found_by(text, limit=LISTED)]


def _elsewhere(text, shown, words):
    """The typed words that no shown word begins with, each as the first of `words` that does, or as it is."""
    shown, words = (NO_WORD.split(part.casefold()) for part in (shown, words))
    return [next((word for word in words if word.startswith(typed)), typed) for typed in text.casefold().split()
            if not any(word.startswith(typed) for word in shown)]


def thumbnail_items(model, kind, chosen):
    """Items of an enumeration: the presets of a kind with their icons, and first the chosen one if it is none of them.

    Blender needs the texts to live on; they do, as both parts are kept.
    """
    listed = _of_kind(model, kind)
    if any(item[0] == chosen for item in listed):
        return listed
    return [_alone(model, chosen), *(item[:4] + (number,) for number, item in enumerate(listed, 1))]


@functools.lru_cache(maxsize=None)
def _of_kind(model, kind):
    if model == "layered_rgb":
        from ..layered_presets import PRESETS as presets
        found = list(presets.items())
    else:
        from ..spectra.presets import all_presets
        found = [(name, preset) for name, preset in all_presets().items() if preset.kind == kind]
    return [(name, preset.title, preset.note, preset_icon(model, name), number)
            for number, (name, preset) in enumerate(found)]


@functools.lru_cache(maxsize=None)
def _alone(model, name):
    return (name, name, "", preset_icon(model, name), 0)


def forget():
    """Drop the lists, whose icons are about to go."""
    _of_kind.cache_clear()
    _alone.cache_clear()


def draw_card(layout, settings, draw_apply, model=None):
    """A thumbnail that opens all of its kind, a field to type in, and what else is asked, in three rows.

    draw_apply  draws the last row into the layout that it is given
    model       whose presets; by default the settings' own, which can then be chosen
    """
    of_model = model or settings.model
    preset = "layered_preset" if of_model == "layered_rgb" else "preset"
    row = layout.row()
    row.use_property_split = False
    picture = row.column()
    picture.ui_units_x = 4.2
    picture.template_icon_view(settings, "layered_thumbnail" if of_model == "layered_rgb" else "thumbnail",
                               show_labels=True, scale=3.4, scale_popup=4.0)
    column = row.column()
    typed = column.row(align=True)
    typed.prop(settings, preset, text="", icon="VIEWZOOM")
    if of_model == "cook_torrance":
        typed.prop_menu_enum(settings, "kind", text="", icon="FILTER")
    choices = column.row(align=True)
    if model is None:
        choices.prop(settings, "model", text="")
        choices.prop(settings, "realisation", text="")
    draw_apply(column)


def title_of(model, name):
    """What a preset is called, or the name itself where it is a dataset or unknown."""
    if model == "layered_rgb":
        from ..layered_presets import PRESETS as presets
    else:
        from ..spectra.presets import all_presets
        presets = all_presets()
    return presets[name].title if name in presets else name
