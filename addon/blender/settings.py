"""What the panels remember between clicks: the preset, model, realisation and light to apply next."""

import functools

import bpy

from . import picker

__all__ = ["CLASSES", "MODEL_ITEMS", "REALISATION_ITEMS", "Viewing", "attach", "chosen_preset", "copy_viewing", "detach",
           "preset_property", "realisation_property", "search_measured", "viewing_of"]

MODEL_ITEMS = (
    ("cook_torrance", "Cook–Torrance", "Facets with rms slope m, conductor Fresnel, diffuse part (1982)"),
    ("layered_rgb", "Layered RGB", "Interference and colour separation in a thin layer (Granier and Heidrich)"),
)
REALISATION_ITEMS = (
    ("fast", "Fast", "Native closures: light-sampled, on every device, and in EEVEE"),
    ("exact", "Exact", "The published formula itself, sampled with nodes alone, on every device; EEVEE shows Fast"),
    ("osl", "OSL", "The published formula itself as an OSL script: needs Open Shading Language switched on in "
                   "Render properties, on the CPU or OptiX; EEVEE shows Fast"),
    ("osl_fast", "OSL Fast", "Native closures from an OSL script: needs Open Shading Language switched on"),
)
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
    ("desaturate", "Desaturate", "Towards grey of the same luminance, until inside: the hue stays"),
    ("scale", "Scale", "Darken all colours of the material alike, until the largest channel fits"),
    ("clip", "Clip", "Cut every channel off at 0 and 1"),
    ("leave", "Leave", "Keep colours outside of the gamut"),
)
SAME_AS_FILE = "FILE"


def _search(settings, _context, text):
    return picker.lines(settings.model, text)


def search_measured(_settings, _context, text):
    """What a text property lists while one types: presets and datasets with their titles."""
    return picker.lines("cook_torrance", text)


def _search_layered(_settings, _context, text):
    return picker.lines("layered_rgb", text)


def _drop_title(attribute):
    """Keep the name alone of what was chosen from the list."""
    def update(properties, _context):
        chosen = getattr(properties, attribute)
        if picker.name_in(chosen) != chosen:
            setattr(properties, attribute, picker.name_in(chosen))
    return update


def preset_property(search=_search, default="copper", attribute="preset"):
    """A text property that offers presets and datasets while one types."""
    return bpy.props.StringProperty(
        name="Preset", default=default, search=search, search_options={"SUGGESTION"},
        update=_drop_title(attribute),
        description="Material: a preset's name, or a dataset such as main/Cu/Johnson. Type to search")


def realisation_property():
    """The choice of how the formula becomes a material."""
    return bpy.props.EnumProperty(
        name="Realisation", items=REALISATION_ITEMS, description="How the formula becomes a Cycles material")


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
    adapt: bpy.props.BoolProperty(
        name="Adapt White", default=False,
        description="A perfect reflector is neutral in any light, as for an eye that is used to it")


def viewing_of(properties):
    """The chosen light, observer, space and gamut as addon.api.bake takes them."""
    found = {"illuminant": properties.illuminant, "observer": properties.observer, "gamut": properties.gamut,
             "adapt": properties.adapt}
    if properties.space != SAME_AS_FILE:
        found["space"] = properties.space
    return found


def copy_viewing(source, target):
    """Hand the same choices on, from a panel's settings to an operator."""
    for name in Viewing.__annotations__:
        setattr(target, name, getattr(source, name))


def _thumbnails_of(model, attribute):
    """A preset by its picture, beside the property that holds its name."""
    def items(settings, _context):
        return picker.thumbnail_items(model, settings.kind, getattr(settings, attribute))

    def get(settings):
        chosen = getattr(settings, attribute)
        return next(item[4] for item in items(settings, None) if item[0] == chosen)

    def put(settings, number):
        setattr(settings, attribute, items(settings, None)[number][0])

    return bpy.props.EnumProperty(name="Presets", items=items, get=get, set=put,
                                  description="Preset by its picture; the filter beside the name chooses the kind")


class FacetFilmSettings(Viewing, bpy.types.PropertyGroup):
    """Choices of the Facet & Film panels."""

    preset: preset_property(search_measured)
    layered_preset: preset_property(_search_layered, "nacre", "layered_preset")
    thumbnail: _thumbnails_of("cook_torrance", "preset")
    layered_thumbnail: _thumbnails_of("layered_rgb", "layered_preset")
    kind: bpy.props.EnumProperty(name="Kind", items=picker.KIND_ITEMS, description="Which presets to show pictures of")
    model: bpy.props.EnumProperty(name="Model", items=MODEL_ITEMS, description="Reflectance model")
    realisation: realisation_property()


CLASSES = (FacetFilmSettings,)


def chosen_preset(settings, model=None):
    """The name of the preset chosen for a model, by default the one that is chosen."""
    return settings.layered_preset if (model or settings.model) == "layered_rgb" else settings.preset


def attach():
    """Hang the settings on the window manager, where they are not saved with files."""
    bpy.types.WindowManager.facet_film = bpy.props.PointerProperty(type=FacetFilmSettings)


def detach():
    """Take them off again, with what was chosen."""
    for manager in bpy.data.window_managers:
        manager.property_unset("facet_film")
    del bpy.types.WindowManager.facet_film
