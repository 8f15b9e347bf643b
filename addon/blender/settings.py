"""What the panel remembers between clicks: the preset, model and realisation to apply next."""

import bpy

__all__ = ["CLASSES", "MODEL_ITEMS", "REALISATION_ITEMS", "attach", "detach", "preset_property"]

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


def preset_property():
    """A text property that offers the presets while one types."""
    return bpy.props.StringProperty(
        name="Preset", default="copper", search=_search_presets, search_options={"SUGGESTION"},
        description="Measured material: a preset's name, or a dataset such as main/Cu/Johnson")


def _search_presets(settings, _context, text):
    if settings.model == "layered_rgb":
        from ..layered_presets import PRESETS
        return [name for name in PRESETS if text.casefold() in name.casefold()]
    from ..spectra.search import search
    return [found.id for found in search(text, limit=40)]


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
