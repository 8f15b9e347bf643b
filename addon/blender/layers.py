"""What the panel of layers edits, and how its list and its text are kept in step; both follow the material shown."""

import contextlib
import functools

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from ..errors import FacetFilmError
from . import datablocks

__all__ = ["FacetFilmLayer", "LayersEditor", "follow", "forget", "load", "made_of", "redraw", "say_layers", "why_not"]

THICKEST = 20000.0
USUAL_END = 200.0
DIGITS = 3
"""Of a thickness in nm that are read from a property, which holds single precision."""
AIR = "air"

_at_work, _shown, _asked = [], [], []


def made_of(material):
    """What a material is made of in words, or ""."""
    model = datablocks.materials.model_of(material)
    return _values(material).get(model.made_of, "") if model is not None and model.made_of else ""


def _values(material):
    shown = datablocks.pictures.image_in(datablocks.materials.our_node(material).node_tree)
    return datablocks.pictures.values_of_image(shown)


def why_not(material, text):
    """Why a material of ours cannot be made of a text, as one sentence that names the place; or ""."""
    model = datablocks.materials.model_of(material)
    return _why_not(model, text, _values(material).get(model.own_data, ""), bpy.app.translations.locale)


@functools.lru_cache(maxsize=64)
def _why_not(model, text, own, _language):
    from ..catalogue.resolving import of_stack
    try:
        of_stack(getattr(model.parameters(**{model.made_of: text}), model.made_of), own)
    except FacetFilmError as error:
        return error.said(rpt_)
    return ""


def searched(_layer, _context, text):
    """What a field lists while one types: what stacks call by a word, then presets and datasets with their titles."""
    from ..bake.film_names import AIR as AIRS
    from ..bake.film_names import DATASETS
    from .panels.picker import BETWEEN, lines
    begun = [word for word in (*DATASETS, *AIRS) if word.casefold().startswith(text.casefold())]
    return [*(BETWEEN.join((word, DATASETS.get(word, word))) for word in begun), *lines(text)]


@contextlib.contextmanager
def _alone():
    """What is set within changes nothing else."""
    _at_work.append(True)
    try:
        yield
    finally:
        _at_work.pop()


def _list_changed(_owner, _context):
    if not _at_work:
        say_layers(bpy.context.window_manager.facet_film)


def say_layers(settings):
    """Say the list as text."""
    from ..bake.stack_notation import Layers, text_of
    from .panels.picker import name_in
    with _alone():
        for owner, name in ((settings, "layers_outside"), (settings, "layers_below"),
                            *((layer, "material") for layer in settings.layers)):
            if name_in(getattr(owner, name)) != getattr(owner, name):
                setattr(owner, name, name_in(getattr(owner, name)))
        films = tuple(layer.said() for layer in settings.layers)
        settings.layers_text = text_of(Layers(settings.layers_outside.strip() or AIR, films, settings.layers_below))


def _text_changed(settings, _context):
    """List what the text says; what cannot be read leaves the list as it is."""
    if _at_work:
        return
    from ..bake.film_curve import is_curve
    from ..bake.stack_notation import layers_of
    settings.is_layered = not is_curve(settings.layers_text)
    try:
        said = layers_of(settings.layers_text)
    except FacetFilmError:
        return
    with _alone():
        settings.layers_outside, settings.layers_below = said.outside, said.below
        settings.layers.clear()
        for film in said.films if settings.is_layered else ():
            settings.layers.add().take(film)
        settings.layer = max(0, min(settings.layer, len(settings.layers) - 1))


class FacetFilmLayer(bpy.types.PropertyGroup):
    """A film of the list."""

    material: bpy.props.StringProperty(
        name="Material", search=searched, search_options={"SUGGESTION"}, update=_list_changed,
        description="What the layer is of: a formula such as SiO2, a preset, a dataset, a file, or an index such as "
                    "1.38 or 2.5+0.1i. Type to search")
    thickness: bpy.props.FloatProperty(
        name="Thickness", min=0.0, max=THICKEST, soft_max=2000.0, default=100.0, step=100, precision=0,
        update=_list_changed, description="Thickness in nanometres; where it varies, the least")
    greatest: bpy.props.FloatProperty(
        name="Greatest Thickness", min=0.0, max=THICKEST, soft_max=2000.0, default=USUAL_END, step=100, precision=0,
        update=_list_changed, description="The greatest thickness in nanometres")
    varies: bpy.props.BoolProperty(
        name="Varies", update=_list_changed,
        description="The thickness is a range, from which the material's own, a texture or a gradient take theirs")

    def take(self, film):
        """Be an addon.bake.stack_notation.Layer."""
        self.material, self.thickness, self.varies = film.word, film.low, film.high > film.low
        self.greatest = film.high if self.varies else max(USUAL_END, film.high)

    def said(self):
        """The Layer."""
        from ..bake.stack_notation import Layer
        low, high = round(self.thickness, DIGITS), round(self.greatest, DIGITS)
        return Layer(self.material.strip(), low, max(low, high) if self.varies else low)


class LayersEditor:
    """Properties of the panel's settings."""

    layers: bpy.props.CollectionProperty(type=FacetFilmLayer, name="Layers", description="Films from the outside in")
    layer: bpy.props.IntProperty(name="Layer", description="The chosen layer")
    layers_outside: bpy.props.StringProperty(
        name="Outside", default=AIR, search=searched, search_options={"SUGGESTION"}, update=_list_changed,
        description="What the layers are in: air, or something clear such as water")
    layers_below: bpy.props.StringProperty(
        name="Substrate", search=searched, search_options={"SUGGESTION"}, update=_list_changed,
        description="What is below all layers, without a thickness: a metal, a glass, air for a soap film")
    layers_text: bpy.props.StringProperty(
        name="Layers in Words", update=_text_changed,
        description="The same layers as one line, such as 'SiO2 0-1000 nm / Si': it can be copied and pasted")
    is_layered: bpy.props.BoolProperty(options={"HIDDEN"}, default=True)


def load(material):
    """Show what a material is made of."""
    settings = bpy.context.window_manager.facet_film
    settings.layers_text = made_of(material)
    _shown[:] = [_key(material)]


def follow(material):
    """Show what a material is made of as soon as the window is idle, unless it is shown: drawing may set nothing."""
    if _shown != [_key(material)] and not _asked and not bpy.app.background:
        _asked.append(material.name_full)
        bpy.app.timers.register(_load_asked)


def forget():
    """Show nothing any more."""
    _shown.clear()
    _asked.clear()
    if bpy.app.timers.is_registered(_load_asked):
        bpy.app.timers.unregister(_load_asked)


def _load_asked():
    name = _asked.pop()
    material = next((one for one in bpy.data.materials if one.name_full == name), None)
    if material is not None and made_of(material):
        load(material)
        redraw()


def redraw():
    """Have the properties drawn again."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "PROPERTIES":
                area.tag_redraw()


def _key(material):
    return material.name_full, made_of(material)
