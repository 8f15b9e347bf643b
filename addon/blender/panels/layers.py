"""The panel of what a material is made of in words: its layers as a list, the text that says the same, its colours."""

import bpy
from bpy.app.translations import pgettext_n as n_

from .. import datablocks, panels
from ..layers import follow, made_of, why_not
from .material import MaterialPanel

__all__ = ["CLASSES"]

ROWS = 3
SWATCH_SCALE = 5.0


class FACET_FILM_UL_layers(bpy.types.UIList):
    """Films from the outside in, each with its thickness"""

    def draw_item(self, _context, layout, _data, item, _icon, _active_data, _active_property):
        """What it is of; how thick, or from where to where."""
        row = layout.row()
        row.label(text=item.material, translate=False)
        thick = row.row()
        thick.alignment = "RIGHT"
        to = f"–{item.greatest:g}" if item.varies else ""
        thick.label(text=f"{item.thickness:g}{to} nm", translate=False)


class FACET_FILM_MT_layers(bpy.types.Menu):
    """What else can be done with the chosen layer"""

    bl_label = "Layer"

    def draw(self, _context):
        """A file of the user's own as what the layer is of."""
        for place, text in (("FILM", n_("Layer From a File...")), ("BELOW", n_("Substrate From a File..."))):
            self.layout.operator("facet_film.layer_file", text=text, icon="FILEBROWSER").place = place


class FACET_FILM_PT_layers(MaterialPanel, bpy.types.Panel):
    """The layers that the material is made of, from the outside in"""

    bl_label = "Layers"
    bl_parent_id = "FACET_FILM_PT_material"

    @classmethod
    def poll(cls, context):
        """Shown for materials of ours that are made of what a text says."""
        model = datablocks.materials.model_of(context.material)
        return model is not None and bool(model.made_of)

    def draw(self, context):
        """The colours, the list, the text, and Bake."""
        material, settings, layout = context.material, context.window_manager.facet_film, self.layout
        layout.enabled = not datablocks.locked.why_locked(material)
        follow(material)
        _draw_swatch(layout, material)
        if settings.is_layered:
            _draw_layers(layout, settings)
        layout.prop(settings, "layers_text", text="")
        trouble = why_not(material, settings.layers_text)
        if trouble:
            panels.drawing.draw_sentence(layout, trouble, "ERROR", context.region)
        row = layout.row()
        row.enabled = not trouble
        changed = settings.layers_text != made_of(material)
        row.operator("facet_film.bake_layers", icon="SHADING_RENDERED", depress=changed).text = settings.layers_text


def _draw_layers(layout, settings):
    column = layout.column()
    column.use_property_split, column.use_property_decorate = True, False
    column.prop(settings, "layers_outside")
    row = layout.row()
    row.template_list("FACET_FILM_UL_layers", "", settings, "layers", settings, "layer", rows=ROWS)
    beside = row.column(align=True)
    for what, icon in (("ADD", "ADD"), ("REMOVE", "REMOVE")):
        beside.operator("facet_film.change_layers", text="", icon=icon).what = what
    beside.menu("FACET_FILM_MT_layers", icon="DOWNARROW_HLT", text="")
    if len(settings.layers) > 1:
        beside.separator()
        for what, icon in (("UP", "TRIA_UP"), ("DOWN", "TRIA_DOWN")):
            beside.operator("facet_film.change_layers", text="", icon=icon).what = what
    column = layout.column()
    column.use_property_split, column.use_property_decorate = True, False
    if settings.layer < len(settings.layers):
        _draw_layer(column, settings.layers[settings.layer])
    column.prop(settings, "layers_below")


def _draw_layer(column, layer):
    """What can be set of the layer that is chosen in the list."""
    column.prop(layer, "material")
    column.prop(layer, "thickness")
    if layer.varies:
        column.prop(layer, "greatest")
    column.prop(layer, "varies")


def _draw_swatch(layout, material):
    """Its colours, as soon as they are drawn; what the strip's sides are."""
    from ..assets.swatches import swatch_icon
    image = datablocks.pictures.image_in(datablocks.materials.our_node(material).node_tree)
    found = swatch_icon(material, datablocks.pictures.key_of(image))
    column = layout.column(align=True)
    column.template_icon(found.icon if found else 0, scale=SWATCH_SCALE)  # an empty one keeps its place until then
    row = column.row()
    row.alignment = "CENTER"
    row.label(text=_sides(found) if found else "", translate=False)


def _sides(found):
    """What a strip is over, across and down."""
    down = "   ↓ 0°–85°" if found.has_angles else ""
    return f"→ {found.first:g}–{found.last:g} {found.unit}{down}"


CLASSES = (FACET_FILM_UL_layers, FACET_FILM_MT_layers, FACET_FILM_PT_layers)
