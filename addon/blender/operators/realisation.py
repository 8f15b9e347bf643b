"""The operator that renders a material by another realisation."""

import bpy
from bpy.app.translations import pgettext_iface as iface_
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError
from ...models.realisations import REALISATIONS
from ..datablocks.locked import why_locked
from ..datablocks.materials import model_of
from ..settings import realisation_property
from .targets import active_material

__all__ = ["CLASSES", "IN_EVERY_ENGINE", "shown_name", "what_is_missing"]


class FACET_FILM_OT_switch_realisation(bpy.types.Operator):
    """Render this material by another realisation; every value and link that you set stays"""

    bl_idname = "facet_film.switch_realisation"
    bl_label = "Switch Realisation"
    bl_options = {"REGISTER", "UNDO"}

    realisation: realisation_property(usual=False)

    @classmethod
    def poll(cls, context):
        """Needs a material of ours in this file."""
        material = active_material(context)
        if material is None or model_of(material) is None:
            cls.poll_message_set(rpt_("Bake a preset first: this material is not one of Facet & Film"))
            return False
        if why_locked(material):
            cls.poll_message_set(why_locked(material))
            return False
        return True

    def execute(self, context):
        """Switch, and say what the realisation needs."""
        from ...api import switch_realisation
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


IN_EVERY_ENGINE = tuple(name for name, found in REALISATIONS.items() if found.native and not found.osl)


def shown_name(realisation):
    """What a realisation is called in the interface's language."""
    return iface_(REALISATIONS[realisation].title)


def what_is_missing(scene, realisation):
    """What the scene's settings lack to render this realisation, or an empty text."""
    engine = scene.render.engine
    if engine == "BLENDER_WORKBENCH":
        return rpt_("Workbench shows the viewport colour only: choose Cycles in the Render properties")
    if engine != "CYCLES":
        return "" if realisation in IN_EVERY_ENGINE else rpt_("This engine renders Standard in its place: "
                                                     "for this realisation choose Cycles in the Render properties")
    if not REALISATIONS[realisation].osl:
        return ""
    if not scene.cycles.shading_system:
        return rpt_("This realisation is an OSL script and would render black: switch on Open Shading Language "
                    "in the Render properties, or take Reference")
    if scene.cycles.device == "GPU" and _gpu_without_osl():
        return rpt_("OSL needs the CPU or OptiX: change the device, or take Reference")
    return ""


def _gpu_without_osl():
    preferences = bpy.context.preferences.addons.get("cycles")
    return preferences is None or preferences.preferences.compute_device_type != "OPTIX"


CLASSES = (FACET_FILM_OT_switch_realisation,)
