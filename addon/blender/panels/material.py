"""The Facet & Film panel in the Material properties, and its row under the material slots."""

import bpy
from bpy.app.translations import pgettext_iface as iface_

from ...models.realisations import REALISATIONS
from ..datablocks.locked import why_locked
from ..datablocks.materials import is_measured, model_of, our_node, realisation_of
from ..datablocks.spaces import said_of_space
from ..missing import shown_name, what_is_missing
from ..operators.targets import active_material
from ..operators.user_presets import draw_header
from ..settings import copy_viewing
from . import load_ahead
from .drawing import draw_parameters, draw_sentence
from .picker import draw_card

__all__ = ["CLASSES", "LAST_CLASSES", "MaterialPanel", "attach", "detach", "draw_state"]

SLOT_PANELS = ("EEVEE_MATERIAL_PT_context_material", "CYCLES_PT_context_material")
"""Where Blender lists the material slots, by engine; EEVEE's serves Workbench too."""


class MaterialPanel:
    """Where the panels are, and what they share."""

    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"


class FACET_FILM_PT_material(MaterialPanel, bpy.types.Panel):
    """Measured metals and layered films"""

    bl_label = "Facet & Film"

    @classmethod
    def poll(cls, context):
        """Shown for objects that take materials, and for a pinned material."""
        return context.material is not None or _takes_materials(context.object)

    def draw_header_preset(self, _context):
        """The materials that the user saved."""
        draw_header(self.layout)

    def draw(self, context):
        """Choose a material, apply it; and how the one that is there renders."""
        settings = context.window_manager.facet_film
        layout = self.layout
        draw_card(layout, settings, lambda column: draw_apply(column, settings))
        draw_state(layout, context, context.material)


def draw_apply(layout, settings):
    """The button that does what the panel says."""
    load_ahead.when_idle()
    operator = layout.operator("facet_film.bake_preset", text="Apply", icon="SHADING_RENDERED")
    operator.preset = settings.preset
    operator.realisation = settings.realisation
    copy_viewing(settings, operator)


def draw_state(layout, context, material):
    """How a material of ours renders and what it lacks for that, or why it cannot be changed."""
    if material is not None and why_locked(material):
        draw_sentence(layout, why_locked(material), "LIBRARY_DATA_DIRECT", context.region)
        if our_node(material) is not None:
            layout.operator("facet_film.make_local", icon="LIBRARY_DATA_OVERRIDE_NONEDITABLE")
    realisation = realisation_of(material)
    if realisation is None:
        return
    draw_space(layout, context, material)
    missing = what_is_missing(context.scene, realisation)
    if missing:
        draw_sentence(layout, missing, "ERROR", context.region)
        if REALISATIONS[realisation].osl and context.scene.render.engine == "CYCLES":
            layout.prop(context.scene.cycles, "shading_system")
    row = layout.row(align=True)
    row.operator_menu_enum("facet_film.switch_realisation", "realisation",
                           text=iface_("Renders by {:s}").format(shown_name(realisation)))
    if is_measured(material):
        copy_viewing(context.window_manager.facet_film, row.operator("facet_film.rebake", icon="FILE_REFRESH"))


def draw_space(layout, context, material):
    """That a material is for another working space than the file's, and the button for all such; else nothing."""
    said = said_of_space(material)
    if said:
        draw_sentence(layout, said, "ERROR", context.region)
        layout.operator("facet_film.match_space", icon="COLOR")


class FACET_FILM_PT_parameters(MaterialPanel, bpy.types.Panel):
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
        self.layout.enabled = not why_locked(context.material)
        draw_parameters(self.layout, our_node(context.material))


class FACET_FILM_PT_light(MaterialPanel, bpy.types.Panel):
    """In which light the next material is baked, for which observer and into which numbers"""

    bl_label = "Light and Gamut"
    bl_parent_id = "FACET_FILM_PT_material"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        """Illuminant, observer, working space and gamut."""
        settings = context.window_manager.facet_film
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        for name in ("illuminant", "adapt", "observer", "medium", "space", "gamut"):
            layout.prop(settings, name)
        layout.operator("facet_film.rebake_all", icon="FILE_REFRESH")


class FACET_FILM_MT_export(bpy.types.Menu):
    """The forms that the material can be written in"""

    bl_label = "Export Measurement"

    def draw(self, context):
        """An entry a form of the material's model."""
        model = model_of(active_material(context))
        for name, form in (model.forms if model else {}).items():
            self.layout.operator("facet_film.export", text=form.title).form = name


class FACET_FILM_PT_data(MaterialPanel, bpy.types.Panel):
    """Measurements in and out, and compared"""

    bl_label = "Data"
    bl_parent_id = "FACET_FILM_PT_material"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        """Import, paste, fit, export, check, compare."""
        settings = context.window_manager.facet_film
        column = self.layout.column(align=True)
        for name, icon in (("import", "FILEBROWSER"), ("paste", "PASTEDOWN")):
            operator = column.operator(f"facet_film.{name}_constants", icon=icon)
            operator.realisation = settings.realisation
            copy_viewing(settings, operator)
        column.operator("facet_film.fit_brdf", icon="SHADING_RENDERED").realisation = settings.realisation
        column.menu("FACET_FILM_MT_export", icon="EXPORT")
        column.operator("facet_film.principled_twin", icon="MATERIAL")
        column = self.layout.column(align=True)
        column.operator("facet_film.check", icon="CHECKMARK").against = settings.preset
        column.operator("facet_film.spread", icon="SORTSIZE").material = settings.preset


def _takes_materials(target):
    return target is not None and hasattr(target.data, "materials")


def draw_below_slots(self, context):
    """One row under the material slots, for those who look there: a preset, and Apply."""
    if not _takes_materials(context.object):
        return
    settings = context.window_manager.facet_film
    row = self.layout.row(align=True)
    row.prop(settings, "preset", text="", icon="VIEWZOOM")
    draw_apply(row, settings)


CLASSES = (FACET_FILM_PT_material, FACET_FILM_PT_parameters)
LAST_CLASSES = (FACET_FILM_PT_light, FACET_FILM_MT_export, FACET_FILM_PT_data)


def attach():
    """Add the row to Blender's own panels."""
    for name in SLOT_PANELS:
        panel = getattr(bpy.types, name, None)
        if panel is not None:
            panel.append(draw_below_slots)


def detach():
    """Take it out again."""
    for name in SLOT_PANELS:
        panel = getattr(bpy.types, name, None)
        if panel is not None:
            panel.remove(draw_below_slots)
