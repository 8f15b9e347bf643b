"""What the panel remembers between clicks: the preset, model and realisation to apply next."""

import bpy

__all__ = ["CLASSES", "MODEL_ITEMS", "REALISATION_ITEMS", "attach", "detach", "preset_property"]

MODEL_ITEMS = (
    ("cook_torrance", "Cook–Torrance", "Facets with rms slope m, conductor Fresnel, diffuse part (1982)"),
)
REALISATION_ITEMS = (
    ("fast", "Fast", "Native closures: light-sampled, on every device, and in EEVEE"),
)


def preset_property():
    """A text property that offers the presets while one types."""
    return bpy.props.StringProperty(
        name="Preset", default="copper", search=_search_presets, search_options={"SUGGESTION"},
        description="Measured material: a preset's name, or a dataset such as main/Cu/Johnson")


def _search_presets(_self, _context, text):
    from ..spectra import presets
    wanted = text.casefold()
    return [name for name in presets.names() if wanted in name.casefold()]


class FacetFilmSettings(bpy.types.PropertyGroup):
    """Choices of the Facet & Film panel."""

    preset: preset_property()
    model: bpy.props.EnumProperty(name="Model", items=MODEL_ITEMS, description="Reflectance model")
    realisation: bpy.props.EnumProperty(
        name="Realisation", items=REALISATION_ITEMS, description="How the formula becomes a Cycles material")


CLASSES = (FacetFilmSettings,)


def attach():
    """Hang the settings on the window manager, where they are not saved with files."""
    bpy.types.WindowManager.facet_film = bpy.props.PointerProperty(type=FacetFilmSettings)


def detach():
    """Take them off again."""
    del bpy.types.WindowManager.facet_film
