"""The Facet & Film panel in the Material properties."""

import textwrap

import bpy

from .materials import our_node, realisation_of, record_of
from .realisation_operator import what_is_missing
from .settings import REALISATION_ITEMS

__all__ = ["CLASSES"]


class _MaterialPanel:
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"


class FACET_FILM_PT_material(_MaterialPanel, bpy.types.Panel):
    """Bake a measured material"""

    bl_label = "Facet & Film"

    @classmethod
    def poll(cls, context):
        """Shown for objects that take materials."""
        return context.object is not None and hasattr(context.object.data, "materials")

    def draw(self, context):
        """What, by which model and how, do it; and how the material that is there renders."""
        settings = context.window_manager.facet_film
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        layout.prop(settings, "model")
        layout.prop(settings, "preset", icon="MATERIAL")
        layout.prop(settings, "realisation")
        operator = layout.operator("facet_film.bake_preset", icon="SHADING_RENDERED")
        operator.preset = settings.preset
        operator.model = settings.model
        operator.realisation = settings.realisation
        realisation = realisation_of(context.material)
        if realisation is not None:
            missing = what_is_missing(context.scene, realisation)
            if missing:
                _lines(layout, missing, "ERROR")
            shown = dict((item[0], item[1]) for item in REALISATION_ITEMS)[realisation]
            layout.operator_menu_enum("facet_film.switch_realisation", "realisation", text=f"Renders by {shown}")


def _lines(layout, text, icon, width=52):
    """A long sentence as labels of one line each."""
    box = layout.box().column(align=True)
    for number, line in enumerate(textwrap.wrap(text, width)):
        box.label(text=line, icon=icon if number == 0 else "BLANK1")


class FACET_FILM_PT_parameters(_MaterialPanel, bpy.types.Panel):
    """The parameters of the material's model"""

    bl_label = "Parameters"
    bl_parent_id = "FACET_FILM_PT_material"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        """Shown for materials of ours."""
        return our_node(context.material) is not None

    def draw(self, context):
        """The group node's sockets."""
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        node = our_node(context.material)
        for socket in node.inputs:
            if not socket.hide_value:
                layout.template_node_view(node.id_data, node, socket)


class FACET_FILM_PT_baked(_MaterialPanel, bpy.types.Panel):
    """What was baked into this material, and how far it is from the measurement"""

    bl_label = "Measurement"
    bl_parent_id = "FACET_FILM_PT_material"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        """Shown for materials of ours that were baked."""
        return our_node(context.material) is not None and bool(record_of(context.material))

    def draw(self, context):
        """The record of the bake, a line each."""
        record = record_of(context.material)
        column = self.layout.column(align=True)
        column.label(text=record["title"])
        if "conductor" not in record:
            _lines(self.layout, record["note"], "INFO")
            return
        column.label(text=f"{record['source']['dataset']}: {record['source']['citation']}")
        column.label(text="F0  " + "  ".join(f"{value:.4f}" for value in record["f0"]))
        column.label(text="F82 tint  " + "  ".join(f"{value:.4f}" for value in record["f82_tint"]))
        column.label(text=f"Largest CIEDE2000 of the fit: {record['conductor']['delta_e_2000_max']:.2f}")
        gamut = record["gamut"]
        if gamut["outside"]:
            column.label(text=f"Outside the gamut: {gamut['method']}, largest change {gamut['largest_change']:.4f}")


class FACET_FILM_PT_data(_MaterialPanel, bpy.types.Panel):
    """Measurements in and out, and compared"""

    bl_label = "Data"
    bl_parent_id = "FACET_FILM_PT_material"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        """Import, paste, export, check, compare."""
        settings = context.window_manager.facet_film
        column = self.layout.column(align=True)
        column.operator("facet_film.import_constants", icon="FILEBROWSER").realisation = settings.realisation
        column.operator("facet_film.paste_constants", icon="PASTEDOWN").realisation = settings.realisation
        column.operator_menu_enum("facet_film.export", "form", icon="EXPORT")
        column = self.layout.column(align=True)
        column.operator("facet_film.check", icon="CHECKMARK").against = settings.preset
        column.operator("facet_film.spread", icon="SORTSIZE").material = settings.preset


CLASSES = (FACET_FILM_PT_material, FACET_FILM_PT_parameters, FACET_FILM_PT_baked, FACET_FILM_PT_data)
