"""The operators that bake: a preset into the active material slot, and a material's own measurement again."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError
from .. import datablocks
from ..settings import Viewing, preset_property, realisation_property, viewing_of
from .targets import OnObjects, Reasoned, active_material, put, put_said, said_of

__all__ = ["CLASSES"]


class FACET_FILM_OT_bake_preset(OnObjects, Viewing, bpy.types.Operator):
    """Bake a material of the catalogue or a dataset, in the light chosen here, and put it on the selected objects"""

    bl_idname = "facet_film.bake_preset"
    bl_label = "Bake Spectral Preset"
    bl_options = {"REGISTER", "UNDO"}

    preset: preset_property()
    realisation: realisation_property()

    def execute(self, context):
        """Bake, and put the material in the slots."""
        from ...api import create_material
        try:
            done = put(context, lambda material: create_material(
                preset=self.preset, realisation=self.realisation, material=material, viewing=viewing_of(self)))
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        kind, said = put_said(done)
        self.report({kind}, f"{said}. {said_of(done.material)}")
        return {"FINISHED"}


class FACET_FILM_OT_rebake(Reasoned, Viewing, bpy.types.Operator):
    """Bake this material's measurement again in the light and working space chosen here; what else you set stays"""

    bl_idname = "facet_film.rebake"
    bl_label = "Re-bake"
    bl_options = {"REGISTER", "UNDO"}

    @staticmethod
    def why_not(context):
        """Needs a material of this file with a measurement."""
        material = active_material(context)
        if material is None or not datablocks.materials.is_measured(material):
            return rpt_("Bake a measured material first: there is nothing to bake again")
        return datablocks.locked.why_locked(material)

    def execute(self, context):
        """Bake, write, say what came out."""
        from ...api import rebake
        try:
            rebake(active_material(context), viewing_of(self))
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        self.report({"INFO"}, said_of(active_material(context)))
        return {"FINISHED"}


CLASSES = (FACET_FILM_OT_bake_preset, FACET_FILM_OT_rebake)
