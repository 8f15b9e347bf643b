"""The operators that bake: a preset into the active material slot, and a material's own measurement again."""

from contextlib import contextmanager
from types import SimpleNamespace

import bpy
from bpy.app.translations import pgettext_iface as iface_
from bpy.app.translations import pgettext_rpt as rpt_

from ..errors import FacetFilmError
from .materials import model_of, record_of
from .settings import (MODEL_ITEMS, Viewing, chosen_preset, copy_viewing, preset_property, realisation_property,
                       viewing_of)

__all__ = ["CLASSES", "OnActiveObject", "PanelSettings", "active_material", "is_editable", "put_on_selected", "said_of",
           "target_material", "why_locked", "why_not"]


class PanelSettings:
    """For operators that a panel's settings are handed to."""

    def take(self, settings):
        """Do as the panel says."""
        for name in ("model", "realisation"):
            if hasattr(self, name):
                setattr(self, name, getattr(settings, name))
        if hasattr(self, "preset"):
            self.preset = chosen_preset(settings, getattr(self, "model", "cook_torrance"))
        if hasattr(self, "illuminant"):
            copy_viewing(settings, self)
        return self


class OnActiveObject:
    """For operators that bake onto the active object."""

    @classmethod
    def poll(cls, context):
        """Needs an active object of this file that takes materials."""
        reason = why_not(context)
        if reason:
            cls.poll_message_set(reason)
        return not reason


class FACET_FILM_OT_bake_preset(OnActiveObject, PanelSettings, Viewing, bpy.types.Operator):
    """Bake a material into the active material slot of the active object, and put it on the other selected ones"""

    bl_idname = "facet_film.bake_preset"
    bl_label = "Bake Spectral Preset"
    bl_options = {"REGISTER", "UNDO"}

    preset: preset_property()
    model: bpy.props.EnumProperty(name="Model", items=MODEL_ITEMS, description="Reflectance model")
    realisation: realisation_property()

    def execute(self, context):
        """Bake, and put the material in the slots."""
        from ..api import create_material
        try:
            with target_material(context.active_object) as target:
                target.material = create_material(
                    self.model, preset=self.preset, realisation=self.realisation, material=target.material,
                    viewing=viewing_of(self))
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        left_out = put_on_selected(context)
        said = said_of(context.active_object.active_material)
        if left_out:
            said += ". " + rpt_("Left out, as they take no materials or are linked: {:s}").format(", ".join(left_out))
        self.report({"WARNING"} if left_out else {"INFO"}, said)
        return {"FINISHED"}


class FACET_FILM_OT_rebake(PanelSettings, Viewing, bpy.types.Operator):
    """Bake this material's measurement again in the light and working space chosen here; what else you set stays"""

    bl_idname = "facet_film.rebake"
    bl_label = "Re-bake"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        """Needs a Cook-Torrance material of this file with a measurement."""
        material = active_material(context)
        reason = why_locked(material) if material else ""
        if material is None or model_of(material) != "cook_torrance" or "conductor" not in record_of(material):
            reason = rpt_("Bake a measured material first: there is nothing to bake again")
        if reason:
            cls.poll_message_set(reason)
        return not reason

    def execute(self, context):
        """Bake, write, say what came out."""
        from ..api import rebake
        try:
            rebake(active_material(context), viewing_of(self))
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        self.report({"INFO"}, said_of(active_material(context)))
        return {"FINISHED"}


def active_material(context):
    """The material that a panel shows, or that of the active object, or None."""
    return getattr(context, "material", None) or getattr(context.active_object, "active_material", None)


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


def put_on_selected(context):
    """Put the active object's material into the active slots of the other selected ones; names of those it cannot."""
    material = context.active_object.active_material
    left_out = []
    for other in context.selected_objects:
        if other == context.active_object:
            continue
        if _why_not_on(other):
            left_out.append(other.name)
        elif other.active_material != material:
            other.active_material = material
    return left_out


def why_not(context):
    """Why no material can be baked onto the active object, or an empty text."""
    if context.active_object is None:
        return rpt_("Select an object first: the preset is baked into its active material slot")
    return _why_not_on(context.active_object)


def _why_not_on(target):
    if not hasattr(target.data, "materials"):
        return rpt_("{:s} takes no materials: select a mesh, curve, surface, text or volume").format(target.name)
    return why_locked(target) or why_locked(target.data)


def why_locked(datablock):
    """Why a datablock cannot be changed and what to do, or an empty text."""
    if datablock.library is not None:
        return rpt_("{:s} is linked from another file: make it local first (Object, Relations, Make Local)").format(
            datablock.name)
    if datablock.override_library is not None:
        return rpt_("{:s} is a library override, whose nodes and slots belong to another file: make it local first "
                    "(Object, Relations, Make Local)").format(datablock.name)
    return ""


def is_editable(datablock):
    """Whether a datablock belongs to this file, so that it may be changed."""
    return not why_locked(datablock)


def said_of(material):
    """One sentence on what was baked."""
    record = record_of(material)
    if "conductor" not in record:
        return f"{record['title']}: {record['note']}"
    said = rpt_("{:s} baked from {:s}: largest CIEDE2000 of the fit {:.2f}").format(
        record["title"], record["source"]["dataset"] or record["name"], record["conductor"]["delta_e_2000_max"])
    if record["gamut"]["outside"]:
        said += rpt_("; outside the gamut, mapped by {:s}").format(
            iface_(record["gamut"]["method"].capitalize()))
    return said


CLASSES = (FACET_FILM_OT_bake_preset, FACET_FILM_OT_rebake)
