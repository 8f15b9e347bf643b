"""The operator that bakes a preset into the active material slot."""

from contextlib import contextmanager
from types import SimpleNamespace

import bpy

from ..errors import FacetFilmError
from .settings import MODEL_ITEMS, REALISATION_ITEMS, preset_property

__all__ = ["CLASSES", "is_editable", "said_of", "target_material", "why_not"]


class FACET_FILM_OT_bake_preset(bpy.types.Operator):
    """Bake a measured material into the active material slot of the active object"""

    bl_idname = "facet_film.bake_preset"
    bl_label = "Bake Spectral Preset"
    bl_options = {"REGISTER", "UNDO"}

    preset: preset_property()
    model: bpy.props.EnumProperty(name="Model", items=MODEL_ITEMS, description="Reflectance model")
    realisation: bpy.props.EnumProperty(
        name="Realisation", items=REALISATION_ITEMS, description="How the formula becomes a Cycles material")

    @classmethod
    def poll(cls, context):
        """Needs an active object of this file that takes materials."""
        reason = why_not(context.active_object)
        if reason:
            cls.poll_message_set(reason)
        return not reason

    def execute(self, context):
        """Bake, and put the material in the slot."""
        from ..api import create_material
        try:
            with target_material(context.active_object) as target:
                target.material = create_material(
                    self.model, preset=self.preset, realisation=self.realisation, material=target.material)
        except FacetFilmError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self.report({"INFO"}, said_of(context.active_object.active_material))
        return {"FINISHED"}


@contextmanager
def target_material(target):
    """The editable material in the object's active slot as `.material`, or None where there is none.

    Whatever `.material` is at the end stands in the slot.
    """
    found = target.active_material
    held = SimpleNamespace(material=found if found and is_editable(found) else None)
    yield held
    if target.active_material != held.material:
        target.active_material = held.material


def why_not(target):
    """Why no material can be baked onto this object, or an empty text."""
    if target is None:
        return "Select an object first: the preset is baked into its active material slot"
    if not hasattr(target.data, "materials"):
        return f"{target.name} takes no materials: select a mesh, curve, surface, text or volume"
    if not is_editable(target) or not is_editable(target.data):
        return f"{target.name} is linked from another file: make it local or override it first"
    return ""


def is_editable(datablock):
    """Whether a datablock belongs to this file, so that it may be changed."""
    return datablock.library is None and datablock.override_library is None


def said_of(material):
    """One sentence on what was baked."""
    from .materials import record_of
    record = record_of(material)
    if "conductor" not in record:
        return f"{record['title']}: {record['note']}"
    fit = record["conductor"]["delta_e_2000_max"]
    outside = record["gamut"]["outside"]
    mapped = f"; outside the gamut, mapped by {record['gamut']['method']}" if outside else ""
    return f"{record['title']} baked from {record['source']['dataset']}: largest CIEDE2000 of the fit {fit:.2f}{mapped}"


CLASSES = (FACET_FILM_OT_bake_preset,)
