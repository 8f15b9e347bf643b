"""The operator that renders a material by another realisation."""

import bpy

from ..errors import FacetFilmError
from .bake_operator import is_editable
from .materials import model_of
from .settings import REALISATION_ITEMS

__all__ = ["CLASSES"]


class FACET_FILM_OT_switch_realisation(bpy.types.Operator):
    """Render this material by another realisation; every value and link that you set stays"""

    bl_idname = "facet_film.switch_realisation"
    bl_label = "Switch Realisation"
    bl_options = {"REGISTER", "UNDO"}

    realisation: bpy.props.EnumProperty(
        name="Realisation", items=REALISATION_ITEMS, description="How the formula becomes a Cycles material")

    @classmethod
    def poll(cls, context):
        """Needs a material of ours in this file."""
        material = getattr(context, "material", None) or getattr(context.active_object, "active_material", None)
        if material is None or model_of(material) is None:
            cls.poll_message_set("Bake a preset first: this material is not one of Facet & Film")
            return False
        if not is_editable(material):
            cls.poll_message_set(f"{material.name} is linked from another file: make it local first")
            return False
        return True

    def execute(self, context):
        """Switch, and say what the realisation needs."""
        from ..api import switch_realisation
        material = getattr(context, "material", None) or context.active_object.active_material
        try:
            switch_realisation(material, self.realisation)
        except FacetFilmError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        missing = what_is_missing(context.scene, self.realisation)
        self.report({"WARNING" if missing else "INFO"}, missing or f"{material.name} renders by {self.realisation}")
        return {"FINISHED"}


def what_is_missing(scene, realisation):
    """What the scene's settings lack to render this realisation in Cycles, or an empty text."""
    if realisation not in ("osl", "osl_fast") or scene.render.engine != "CYCLES":
        return ""
    if not scene.cycles.shading_system:
        return "This realisation is an OSL script and would render black: switch on Open Shading Language " \
               "in the Render properties, or take Exact"
    if scene.cycles.device == "GPU" and _gpu_without_osl():
        return "OSL needs the CPU or OptiX: change the device, or take Exact"
    return ""


def _gpu_without_osl():
    preferences = bpy.context.preferences.addons.get("cycles")
    return preferences is None or preferences.preferences.compute_device_type != "OPTIX"


CLASSES = (FACET_FILM_OT_switch_realisation,)
