"""What operators work on: the active material, the slots of the selected objects; and what they say afterwards."""

from contextlib import contextmanager
from types import SimpleNamespace

from bpy.app.translations import pgettext_iface as iface_
from bpy.app.translations import pgettext_rpt as rpt_

from ..datablocks.locked import is_editable, why_locked
from ..datablocks.materials import baked_of, our_node

__all__ = ["OnActiveObject", "active_material", "put_on_selected", "said_of", "target_material", "why_not"]


class OnActiveObject:
    """For operators that bake onto the active object."""

    @classmethod
    def poll(cls, context):
        """Needs an active object of this file that takes materials."""
        reason = why_not(context)
        if reason:
            cls.poll_message_set(reason)
        return not reason


def active_material(context):
    """The material that a panel shows, or that of the active object, or None."""
    return getattr(context, "material", None) or getattr(context.active_object, "active_material", None)


@contextmanager
def target_material(context):
    """The material of the active object's slot that may be made over as `.material`, or None where a new one is due.

    Whatever `.material` is at the end stands in the slot.  A material that someone made by hand, and one of ours that
    something else uses too, stay as they are.
    """
    target = context.active_object
    held = SimpleNamespace(material=target.active_material if _may_be_made_over(context) else None)
    yield held
    if target.active_material != held.material:
        target.active_material = held.material


def _may_be_made_over(context):
    """Whether the active material is ours, of this file, and in no slot but those of the selected objects."""
    material = context.active_object.active_material
    if material is None or not is_editable(material) or our_node(material) is None:
        return False
    slots = {(slot.id_data if slot.link == "OBJECT" else slot.id_data.data, number)
             for target in {context.active_object, *context.selected_objects}
             for number, slot in enumerate(target.material_slots) if slot.material == material}
    return material.users - material.use_fake_user <= len(slots)


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


def said_of(material):
    """One sentence on what was baked."""
    baked = baked_of(material)
    if "conductor" not in baked:
        return f"{baked['title']}: {baked['note']}"
    said = rpt_("{:s} baked from {:s}: largest CIEDE2000 of the fit {:.2f}").format(
        baked["title"], baked["source"]["dataset"] or baked["name"], baked["conductor"]["delta_e_2000_max"])
    if baked["gamut"]["outside"]:
        said += rpt_("; outside the gamut, mapped by {:s}").format(iface_(baked["gamut"]["method"].capitalize()))
    return said
