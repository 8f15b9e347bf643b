"""The operator that puts a finish on a material."""

import bpy
from bpy.app.translations import pgettext_iface as iface_
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError
from .. import datablocks
from ..settings import FINISH_ITEMS, OWN_FINISH, finish_property
from .targets import Reasoned, active_material

__all__ = ["CLASSES", "shown_finish", "why_not"]



def shown_finish(material):
    """What a material's finish is called in the interface's language."""
    name = datablocks.materials.finish_of(material) or OWN_FINISH
    return iface_(next(title for item, title, _ in FINISH_ITEMS if item == name))


class FACET_FILM_OT_apply_finish(Reasoned, bpy.types.Operator):
    """Give this material another finish; what it is made of stays"""

    bl_idname = "facet_film.apply_finish"
    bl_label = "Apply Finish"
    bl_options = {"REGISTER", "UNDO"}

    finish: finish_property()

    @staticmethod
    def why_not(context):
        """Needs a material of ours in this file, whose model has a roughness."""
        return why_not(active_material(context))

    def execute(self, context):
        """Put it on, and say so."""
        from ...api import apply_finish
        material = active_material(context)
        try:
            apply_finish(material, "" if self.finish == OWN_FINISH else self.finish)
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        self.report({"INFO"}, rpt_("{:s}: finish {:s}").format(material.name, shown_finish(material)))
        return {"FINISHED"}


def why_not(material):
    """Why a material takes no finish, or an empty text."""
    from ...finishes.feeding import takes
    model = datablocks.materials.model_of(material)
    if model is None:
        return rpt_("Bake a preset first: this material is not one of Facet & Film")
    if not takes(model):
        return rpt_("This model has no roughness that a finish could vary")
    return datablocks.locked.why_locked(material)


CLASSES = (FACET_FILM_OT_apply_finish,)
