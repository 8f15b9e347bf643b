"""The operator that makes a Principled twin of a material."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError
from .. import datablocks
from .targets import active_material

__all__ = ["CLASSES"]


class FACET_FILM_OT_principled_twin(bpy.types.Operator):
    """Make a material of one Principled BSDF that comes closest to this one, and put it in its place: for baking \
textures, for other engines and exporters. The material itself stays in the file"""

    bl_idname = "facet_film.principled_twin"
    bl_label = "Principled Twin"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        """Needs a material of ours on an object of this file."""
        material, target = active_material(context), context.active_object
        if material is None or datablocks.materials.our_node(material) is None:
            cls.poll_message_set(rpt_("Bake a preset first: this material is not one of Facet & Film"))
            return False
        if target is not None and datablocks.locked.why_locked(target):
            cls.poll_message_set(datablocks.locked.why_locked(target))
            return False
        return True

    def execute(self, context):
        """Fit, put the twin in the slot, say how close it comes and what is lost."""
        from ...api import principled_twin
        from ..datablocks.principled import DELTA_E_KEY, LOST_KEY
        material = active_material(context)
        try:
            twin = principled_twin(material)
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        if material.library is None:
            material.use_fake_user = True
        target = context.active_object
        if target is not None and target.active_material == material:
            target.active_material = twin
        said = rpt_("{:s}: {:.1f} CIEDE2000 from {:s} on average over the angle").format(
            twin.name, twin[DELTA_E_KEY], material.name)
        self.report({"INFO"}, ". ".join([said, *(rpt_(sentence).rstrip(".") for sentence in twin[LOST_KEY])]))
        return {"FINISHED"}


CLASSES = (FACET_FILM_OT_principled_twin,)
