"""What the panels remember between clicks: the preset, realisation and light to apply next."""

import functools

import bpy

from ..models.realisations import REALISATIONS
from .panels import picker

__all__ = ["CLASSES", "Viewing", "attach", "copy_viewing", "detach", "preset_property", "realisation_property",
           "search_presets", "viewing_of"]

USUAL_ITEM = ("usual", "Usual", "Fast; Dispersive for diamond, lead crystal and what else is known by its rainbow")
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
IN_AIR = ("", "air", "1", "1.0")


def search_presets(_settings, _context, text):
    """What a text property lists while one types: presets and datasets with their titles."""
    return picker.lines(text)


def _drop_title(properties, _context):
    """Keep the name alone of what was chosen from the list."""
    if picker.name_in(properties.preset) != properties.preset:
        properties.preset = picker.name_in(properties.preset)


def preset_property():
    """A text property `preset` that offers presets and datasets while one types."""
    return bpy.props.StringProperty(
        name="Preset", default="copper", search=search_presets, search_options={"SUGGESTION"}, update=_drop_title,
        description="Material: a preset's name, or a dataset such as main/Cu/Johnson. Type to search")


def realisation_property(*, usual=True):
    """The choice of how the formula becomes a material; first the one that the material is meant for."""
    return bpy.props.EnumProperty(
        name="Realisation", items=[USUAL_ITEM] * usual + REALISATION_ITEMS,
        description="How the formula becomes a Cycles material")


@functools.lru_cache(maxsize=1)
def _illuminants():
    from ..spectra.illuminants import names, title
    by_use = sorted(names(), key=lambda name: name != "D65")
    return [(name, name, title(name), number) for number, name in enumerate(by_use)]


class Viewing:
    """Properties of those who bake: in which light, for which eye, into which numbers."""

    illuminant: bpy.props.EnumProperty(
        name="Illuminant", items=lambda _self, _context: _illuminants(),
        description="Light in which the material has its colour; D65 is daylight, and white in Blender")
    observer: bpy.props.EnumProperty(
        name="Observer", items=OBSERVER_ITEMS, description="CIE standard observer")
    space: bpy.props.EnumProperty(
        name="Working Space", items=SPACE_ITEMS, description="Scene-linear space that the colours are written in")
    gamut: bpy.props.EnumProperty(
        name="Gamut", items=GAMUT_ITEMS, description="What to do with colours that the working space cannot hold")
    medium: bpy.props.StringProperty(
        name="Outside", default="air", search=lambda _self, _context, text: picker.lines(text),
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
        found["medium"] = picker.name_in(properties.medium)
    if properties.space != SAME_AS_FILE:
        found["space"] = properties.space
    return found


def copy_viewing(source, target):
    """Hand the same choices on, from a panel's settings to an operator."""
    for name in Viewing.__annotations__:
        setattr(target, name, getattr(source, name))


def _thumbnails(settings, _context=None):
    return picker.thumbnail_items(settings.kind, settings.preset)


def _chosen_thumbnail(settings):
    return next(item[4] for item in _thumbnails(settings) if item[0] == settings.preset)


def _choose_thumbnail(settings, number):
    settings.preset = _thumbnails(settings)[number][0]


class FacetFilmSettings(Viewing, bpy.types.PropertyGroup):
    """Choices of the Facet & Film panels."""

    preset: preset_property()
    thumbnail: bpy.props.EnumProperty(
        name="Presets", items=_thumbnails, get=_chosen_thumbnail, set=_choose_thumbnail,
        description="Preset by its picture; the filter beside the name chooses the kind")
    kind: bpy.props.EnumProperty(name="Kind", items=picker.KIND_ITEMS, description="Which presets to show pictures of")
    realisation: realisation_property()


CLASSES = (FacetFilmSettings,)


def attach():
    """Hang the settings on the window manager, where they are not saved with files."""
    bpy.types.WindowManager.facet_film = bpy.props.PointerProperty(type=FacetFilmSettings)


def detach():
    """Take them off again, with what was chosen."""
    for manager in bpy.data.window_managers:
        manager.property_unset("facet_film")
    del bpy.types.WindowManager.facet_film
