"""What the panels remember between clicks: the preset, realisation and light to apply next; and the preferences."""

import functools
from types import SimpleNamespace

import bpy
from bpy.app.translations import pgettext_iface as iface_

from ..finishes import all_finishes
from ..models.realisations import REALISATIONS
from .layers import FacetFilmLayer, LayersEditor

__all__ = ["CLASSES", "FINISH_ITEMS", "OWN_FINISH", "PACKAGE", "Viewing", "attach", "copy_viewing", "detach",
           "finish_property", "preferences", "preset_property", "realisation_property", "search_presets", "viewing_of"]

PACKAGE = __package__.rsplit(".", 2)[0]
"""Under this name Blender keeps the extension's preferences."""
OWN_FINISH = "NONE"
"""In place of a finish: the preset's own surface."""
FINISH_ITEMS = ((OWN_FINISH, "Preset's Own", "As smooth or rough as the preset says"),
                *((finish.name, finish.title, finish.note) for finish in all_finishes()))
DEFAULTS = SimpleNamespace(realisation="usual", finish=OWN_FINISH, in_headers=True, in_menus=True, in_sidebar=False)
"""Of the preferences, which scripts that import this package alone have not."""

USUAL_ITEM = ("usual", "Usual", "Standard; Dispersive for diamond, lead crystal and what else is known by its rainbow")
REALISATION_ITEMS = [(name, found.title, found.tip) for name, found in REALISATIONS.items()]
OBSERVER_ITEMS = (
    ("1931", "CIE 1931, 2°", "Small fields of view; what displays are calibrated for"),
    ("1964", "CIE 1964, 10°", "Large fields of view"),
)
SPACE_ITEMS = (
    ("FILE", "File's Working Space", "The scene-linear space of this file"),
    ("Rec.709", "Rec.709", "Linear Rec.709, Blender's default"),
    ("Rec.2020", "Rec.2020", "Linear Rec.2020"),
    ("ACEScg", "ACEScg", "ACEScg"),
)
GAMUT_ITEMS = (
    ("nearest", "Nearest", "The colour inside that looks most alike, by CIEDE2000"),
    ("desaturate", "Desaturate", "Towards grey of the same luminance, until inside: the 1982 paper's way"),
    ("scale", "Scale", "Darken all colours of the material alike, until the largest channel fits"),
    ("clip", "Clip", "Cut every channel off at 0 and 1"),
    ("leave", "Leave", "Keep colours outside of the gamut"),
)
SAME_AS_FILE = "FILE"
FIRST_ILLUMINANTS = ("D65", "D50", "D55", "D75", "A", "E", "F2", "F4", "F11", "LED-B1", "LED-B4", "HP1")
IN_AIR = ("", "air", "1", "1.0")


def search_presets(_settings, _context, text):
    """What a text property lists while one types: presets and datasets with their titles."""
    from .panels.picker import lines
    return lines(text)


def _drop_title(properties, _context):
    """Keep the name alone of what was chosen from the list."""
    from .panels.picker import name_in
    if name_in(properties.preset) != properties.preset:
        properties.preset = name_in(properties.preset)


def preferences():
    """The extension's preferences."""
    found = bpy.context.preferences.addons.get(PACKAGE)
    return getattr(found, "preferences", None) or DEFAULTS


def preset_property(default="copper", options=frozenset()):
    """A text property `preset` that offers presets and datasets while one types."""
    return bpy.props.StringProperty(
        name="Preset", default=default, search=search_presets, search_options={"SUGGESTION"}, update=_drop_title,
        options=set(options),
        description="Material: a preset's name, or a dataset such as main/Cu/Johnson. Type to search")


def finish_property():
    """The choice of what was done to a surface."""
    return bpy.props.EnumProperty(name="Finish", items=FINISH_ITEMS, description="What was done to the surface")


def realisation_property(*, usual=True):
    """The choice of how the formula becomes a material; first the one that the material is meant for."""
    return bpy.props.EnumProperty(
        name="Realisation", items=[USUAL_ITEM] * usual + REALISATION_ITEMS,
        description="How the formula becomes a Cycles material")


@functools.lru_cache(maxsize=2)
def _illuminants(_language):
    """Items of an enumeration: the twelve that people use first, and below them all others."""
    from ..spectra.illuminants import names, title
    others = [name for name in names() if name not in FIRST_ILLUMINANTS]
    items = [(name, f"{name}: {iface_(title(name))}", "", number)
             for number, name in enumerate((*FIRST_ILLUMINANTS, *others))]
    return [*items[:len(FIRST_ILLUMINANTS)], ("", "", ""), *items[len(FIRST_ILLUMINANTS):]]


class Viewing:
    """Properties of those who bake: in which light, for which eye, into which numbers."""

    illuminant: bpy.props.EnumProperty(
        name="Illuminant", items=lambda _self, _context: _illuminants(bpy.app.translations.locale),
        description="Light in which the material has its colour; D65 is daylight, and white in Blender")
    observer: bpy.props.EnumProperty(
        name="Observer", items=OBSERVER_ITEMS, description="CIE standard observer")
    space: bpy.props.EnumProperty(
        name="Working Space", items=SPACE_ITEMS, description="Scene-linear space that the colours are written in")
    gamut: bpy.props.EnumProperty(
        name="Gamut", items=GAMUT_ITEMS, description="What to do with colours that the working space cannot hold")
    medium: bpy.props.StringProperty(
        name="Outside", default="air", search=search_presets,
        search_options={"SUGGESTION"},
        description="What the surface is in: air, an index such as 1.33, or a clear material such as water")
    adapt: bpy.props.BoolProperty(
        name="Adapt White", default=False,
        description="A perfect reflector is neutral in any light, as for an eye that is used to it")


def viewing_of(properties):
    """The chosen light, observer, space and gamut as addon.api.bake takes them."""
    found = {"illuminant": properties.illuminant, "observer": properties.observer, "gamut": properties.gamut,
             "adapt": properties.adapt}
    if properties.medium.strip().lower() not in IN_AIR:
        from .panels.picker import name_in
        found["medium"] = name_in(properties.medium)
    if properties.space != SAME_AS_FILE:
        found["space"] = properties.space
    return found


def copy_viewing(source, target):
    """Hand the same choices on, from a panel's settings to an operator."""
    for name in Viewing.__annotations__:
        setattr(target, name, getattr(source, name))


class FacetFilmSettings(Viewing, LayersEditor, bpy.types.PropertyGroup):
    """Choices of the Facet & Film panels."""

    preset: preset_property()


CLASSES = (FacetFilmLayer, FacetFilmSettings)


def attach():
    """Hang the settings on the window manager, where they are not saved with files."""
    bpy.types.WindowManager.facet_film = bpy.props.PointerProperty(type=FacetFilmSettings)


def detach():
    """Take them off again, with what was chosen."""
    for manager in bpy.data.window_managers:
        manager.property_unset("facet_film")
    del bpy.types.WindowManager.facet_film
