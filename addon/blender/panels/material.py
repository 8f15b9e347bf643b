"""The Facet & Film panel in the Material properties: how the material renders, and its parameters."""

import bpy
from bpy.app.translations import pgettext_iface as iface_

from ...models.realisations import REALISATIONS
from .. import datablocks, panels
from ..operators.common_face import is_clear, shown_outside
from ..operators.user_presets import draw_header
from .card import takes_materials

__all__ = ["CLASSES", "MaterialPanel", "draw_state"]


class MaterialPanel:
    """Where the panels are, and what they share."""

    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"


class FACET_FILM_PT_material(MaterialPanel, bpy.types.Panel):
    """What the material is, and how it renders"""

    bl_label = "Facet & Film"

    @classmethod
    def poll(cls, context):
        """Shown for objects that take materials, and for a pinned material."""
        return context.material is not None or takes_materials(context.object)

    def draw_header_preset(self, _context):
        """The materials that the user saved."""
        draw_header(self.layout)

    def draw(self, context):
        """How the material that is there renders; of another, where ours are."""
        material = context.material
        locked = material is not None and datablocks.locked.why_locked(material)
        if datablocks.materials.realisation_of(material) is None and not locked:
            self.layout.label(text="Choose a material by its picture, above", icon="INFO")
        draw_state(self.layout, context, material)


def draw_state(layout, context, material):
    """How a material of ours renders and what it lacks for that, or why it cannot be changed."""
    locked = datablocks.locked.why_locked(material) if material is not None else ""
    if locked:
        panels.drawing.draw_sentence(layout, locked, "LIBRARY_DATA_DIRECT", context.region)
        if datablocks.materials.our_node(material) is not None:
            layout.operator("facet_film.make_local", icon="LIBRARY_DATA_OVERRIDE_NONEDITABLE")
    realisation = datablocks.materials.realisation_of(material)
    if realisation is None:
        return
    draw_space(layout, context, material)
    from ..missing import what_is_missing
    missing = what_is_missing(context.scene, realisation)
    if missing:
        panels.drawing.draw_sentence(layout, missing, "ERROR", context.region)
        if REALISATIONS[realisation].osl and context.scene.render.engine == "CYCLES":
            layout.prop(context.scene.cycles, "shading_system")
    _draw_realisations(layout, datablocks.materials.model_of(material), realisation)
    if is_clear(material):
        against = iface_("Against: {:s}").format(shown_outside(material))
        layout.operator_menu_enum("facet_film.touch", "outside", text=against, translate=False)


def _draw_realisations(layout, model, current):
    """A button for each way in which the model can render, the current one pressed."""
    from ..missing import shown_name
    column = layout.column(align=True)
    column.label(text="Renders by")
    grid = column.grid_flow(row_major=True, columns=2, even_columns=True, align=True)
    for name in model.realisations:
        button = grid.operator("facet_film.switch_realisation", text=shown_name(name), depress=name == current,
                               translate=False)
        button.realisation = name


def draw_space(layout, context, material):
    """That a material is for another working space than the file's, and the button for all such; else nothing."""
    from ..datablocks.spaces import said_of_space
    said = said_of_space(material)
    if said:
        panels.drawing.draw_sentence(layout, said, "ERROR", context.region)
        layout.operator("facet_film.match_space", icon="COLOR")


class FACET_FILM_PT_parameters(MaterialPanel, bpy.types.Panel):
    """The parameters of the material's model"""

    bl_label = "Parameters"
    bl_parent_id = "FACET_FILM_PT_material"

    @classmethod
    def poll(cls, context):
        """Shown for materials of ours."""
        return datablocks.materials.our_node(context.material) is not None

    def draw(self, context):
        """The group node's sockets."""
        self.layout.enabled = not datablocks.locked.why_locked(context.material)
        panels.drawing.draw_parameters(self.layout, datablocks.materials.our_node(context.material))


CLASSES = (FACET_FILM_PT_material, FACET_FILM_PT_parameters)
