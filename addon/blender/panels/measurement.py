"""The panels of measurements: what was baked into a material, in which light the next is, data in and out."""

import bpy
from bpy.app.translations import pgettext_iface as iface_
from bpy.app.translations import pgettext_n as n_

from .. import datablocks, panels
from ..operators.targets import active_material
from ..settings import copy_viewing, preferences
from .material import MaterialPanel

__all__ = ["CLASSES", "draw_measurement"]


class FACET_FILM_PT_measurement(MaterialPanel, bpy.types.Panel):
    """What was measured and baked into this material, how far it is from the measurement, and any other measurement"""

    bl_label = "Measurement"
    bl_parent_id = "FACET_FILM_PT_material"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        """The colours and the record of the bake; the field for any material or dataset."""
        settings = context.window_manager.facet_film
        ours = datablocks.materials.our_node(context.material) is not None
        baked = datablocks.materials.baked_of(context.material) if ours else {}
        if baked:
            draw_measurement(self.layout, baked, context.region)
        row = self.layout.row(align=True)
        row.prop(settings, "preset", text="", icon="VIEWZOOM")
        operator = row.operator("facet_film.bake_preset", text="Apply", icon="SHADING_RENDERED")
        operator.preset = settings.preset
        operator.realisation = datablocks.materials.realisation_of(context.material) or preferences().realisation
        copy_viewing(settings, operator)


class FACET_FILM_PT_light(MaterialPanel, bpy.types.Panel):
    """In which light materials are baked from now on, for which observer and into which numbers"""

    bl_label = "Light and Gamut"
    bl_parent_id = "FACET_FILM_PT_measurement"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        """Illuminant, observer, working space and gamut; and what is there already, baked again."""
        settings = context.window_manager.facet_film
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        for name in ("illuminant", "adapt", "observer", "medium", "space", "gamut"):
            layout.prop(settings, name)
        column = layout.column(align=True)
        if datablocks.materials.is_measured(context.material):
            copy_viewing(settings, column.operator("facet_film.rebake", icon="FILE_REFRESH"))
        column.operator("facet_film.rebake_all", icon="FILE_REFRESH")


class FACET_FILM_MT_export(bpy.types.Menu):
    """The forms that the material can be written in"""

    bl_label = "Export Measurement"

    def draw(self, context):
        """An entry a form of the material's model."""
        model = datablocks.materials.model_of(active_material(context))
        for name, form in (model.forms if model else {}).items():
            self.layout.operator("facet_film.export", text=form.title).form = name


class FACET_FILM_PT_data(MaterialPanel, bpy.types.Panel):
    """Measurements in and out, and compared"""

    bl_label = "Data"
    bl_parent_id = "FACET_FILM_PT_measurement"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        """Import, paste, fit, export, check, compare."""
        settings = context.window_manager.facet_film
        column = self.layout.column(align=True)
        for name, icon in (("import", "FILEBROWSER"), ("paste", "PASTEDOWN")):
            operator = column.operator(f"facet_film.{name}_constants", icon=icon)
            operator.realisation = preferences().realisation
            copy_viewing(settings, operator)
        column.operator("facet_film.fit_brdf", icon="SHADING_RENDERED").realisation = preferences().realisation
        column.menu("FACET_FILM_MT_export", icon="EXPORT")
        column.operator("facet_film.principled_twin", icon="MATERIAL")
        column = self.layout.column(align=True)
        column.operator("facet_film.check", icon="CHECKMARK").against = settings.preset
        column.operator("facet_film.spread", icon="SORTSIZE").material = settings.preset


def draw_measurement(layout, record, region):
    """What a record of a bake says: colours, fit, source, gamut."""
    layout.label(text=record["title"], icon="MATERIAL", translate=False)
    if "conductor" not in record:
        panels.drawing.draw_sentence(layout, record["note"], "INFO", region)
        if "fitted" in record:
            panels.drawing.draw_facts(layout, facts_of_fit(record["fitted"]), region)
        return
    _draw_colours(layout, record)
    panels.drawing.draw_facts(layout, facts_of(record), region)


def _draw_colours(layout, record):
    from ..assets.thumbnails import colour_icon, strip_icon
    row = layout.row()
    curve, space = record["fresnel"], record["space"]
    for text, icon in ((iface_("At 0°"), colour_icon(curve["rgb"][-1], space)),
                       (iface_("0° to 90°"), strip_icon(curve["cos_theta"], curve["rgb"], space))):
        column = row.column(align=True)
        column.label(text=text, translate=False)
        column.template_icon(icon, scale=3.0)


def facts_of(record):
    """(name, value) of what the panel says."""
    source, gamut = record["source"], record["gamut"]
    low, high = source["wavelength_range_nm"]
    reach = f"{low:.0f}–{high:.0f} nm" + ("" if source["covers_visible"] else iface_("; ends held"))
    moved = iface_("Inside, unchanged")
    if gamut["outside"]:
        moved = iface_("Outside: {:s}, channels moved by up to {:.3f}").format(
            iface_(gamut["method"].capitalize()), gamut["largest_change"])
    assumed = [(n_("Read As"), line) for line in source.get("assumed", ())]
    outside = [(n_("Outside"), str(record["medium"]))] if record.get("medium", 1.0) != 1.0 else []
    return (
        ("F0", _three(record["f0"])),
        (n_("F82 Tint"), _three(record["f82_tint"])),
        (n_("Fit"), iface_("CIEDE2000 at most {:.2f}").format(record["conductor"]["delta_e_2000_max"])),
        (n_("Wavelengths"), reach),
        (n_("Light"), f"{record['illuminant']}, {record['observer']}"),
        (n_("Working Space"), record["space"]),
        (n_("Gamut"), moved),
        (n_("Dataset"), source["dataset"]),
        (n_("Citation"), source["citation"]),
        *outside, *assumed,
    )


def facts_of_fit(fitted):
    """(name, value) of what a fit to a measured BRDF said of itself."""
    difference, samples = fitted["delta_e_2000"], fitted["samples"]
    return (
        (n_("File"), fitted["file"]),
        (n_("Fit"), iface_("CIEDE2000 {:.2f} on average, below {:.1f} in 95 %").format(
            difference["mean"], difference["p95"])),
        (n_("Verdict"), iface_(fitted["verdict"])),
        (n_("Samples"), iface_("{:d} used, {:d} left out").format(samples["used"], samples["rejected"])),
    )


def _three(values):
    return "  ".join(f"{value:.3f}" for value in values)


CLASSES = (FACET_FILM_PT_measurement, FACET_FILM_PT_light, FACET_FILM_MT_export, FACET_FILM_PT_data)
