"""The operator that renders a material by another realisation."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_
from bpy.app.translations import pgettext_tip as tip_

from ...errors import FacetFilmError
from ...models.realisations import REALISATIONS
from .. import datablocks
from ..settings import realisation_property
from .targets import active_material

__all__ = ["CLASSES"]


class FACET_FILM_OT_switch_realisation(bpy.types.Operator):
    """Render this material by another realisation; every value and link that you set stays"""

    bl_idname = "facet_film.switch_realisation"
    bl_label = "Switch Realisation"
    bl_options = {"REGISTER", "UNDO"}

    realisation: realisation_property(usual=False)

    @classmethod
    def description(cls, _context, properties):
        """What the realisation of a button is for, in one sentence."""
        return tip_(REALISATIONS[properties.realisation].tip)

    @classmethod
    def poll(cls, context):
        """Needs a material of ours in this file."""
        material = active_material(context)
        if material is None or datablocks.materials.model_of(material) is None:
            cls.poll_message_set(rpt_("Bake a preset first: this material is not one of Facet & Film"))
            return False
        if datablocks.locked.why_locked(material):
            cls.poll_message_set(datablocks.locked.why_locked(material))
            return False
        return True

    def execute(self, context):
        """Switch, and say what the realisation needs."""
        from ...api import switch_realisation
        from ..missing import shown_name, what_is_missing
        material = active_material(context)
        try:
            switch_realisation(material, self.realisation)
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        missing = what_is_missing(context.scene, self.realisation)
        self.report({"WARNING" if missing else "INFO"},
                    missing or rpt_("{:s} renders by {:s}").format(material.name, shown_name(self.realisation)))
        return {"FINISHED"}


CLASSES = (FACET_FILM_OT_switch_realisation,)
