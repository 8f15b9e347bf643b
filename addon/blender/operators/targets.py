"""What operators work on: slots of the objects that are meant, the material that is shown; and what they say
afterwards.
"""

import bpy
from bpy.app.translations import pgettext_iface as iface_
from bpy.app.translations import pgettext_rpt as rpt_

from .. import datablocks

__all__ = ["OnObjects", "Put", "Reasoned", "TO", "active_material", "put", "put_in", "put_said", "said_of",
           "slot_for_faces", "to_faces", "why_not", "why_not_on"]

SLOT, NEW_SLOT, ALL_SLOTS, IN_PLACE = "SLOT", "NEW_SLOT", "ALL_SLOTS", "IN_PLACE"
TO = (
    (SLOT, "Active Slot", "Into the active material slot of every selected object"),
    (NEW_SLOT, "New Slot", "Into a slot of its own; in Edit Mode for the selected faces"),
    (ALL_SLOTS, "All Slots", "Into every material slot of every selected object"),
    (IN_PLACE, "In Place", "Make the active material itself over, wherever it is used"),
)
"""Items of an enumeration: where a material goes."""
NAMED = 3
"""Of objects that are told by their names."""


class Put:
    """What was put where: the material, the objects that have it now, and those that could not take it."""

    def __init__(self, material, objects, left_out):
        self.material, self.objects, self.left_out = material, objects, left_out


class Reasoned:
    """For operators that say why they cannot run: `why_not(context)` is that, or an empty text."""

    @classmethod
    def poll(cls, context):
        """Whether it can run, else with the reason."""
        reason = cls.why_not(context)
        if reason:
            cls.poll_message_set(reason)
        return not reason


class OnObjects(Reasoned):
    """For operators that put a material on objects: they need an object of this file that takes materials."""

    @staticmethod
    def why_not(context):
        """That of the objects that are meant."""
        return why_not(context)


def active_material(context):
    """The material that a panel shows, or that of the active object, or None."""
    return getattr(context, "material", None) or getattr(context.active_object, "active_material", None)


def put(context, make, to=SLOT):
    """Put a material on the objects that are meant: the selected ones, and the one that an editor shows.

    make  function(material or None) -> material: of the material that may be made over, or None where a new one is due
    to    one of TO

    A material that someone made by hand, and one of ours that is used elsewhere too, stay as they are.  Returns Put.
    """
    objects, left_out = _meant(context)
    if to == IN_PLACE and objects and is_editable_material(objects[0].active_material):
        material = make(objects[0].active_material)
        return Put(material, _objects_with(material), left_out)
    slots = [slot for target in objects for slot in _slots(target, to)]
    return Put(put_in(slots, make), objects, left_out)


def put_in(slots, make):
    """Put one material into slots, ``[(object, number)]``; make as :func:`put` has it.  Returns the material."""
    there = [target.material_slots[number].material for target, number in slots]
    first = next((material for material in there if _may_be_made_over(material, slots)), None)
    material = make(first)
    for (target, number), before in zip(slots, there):
        slot = target.material_slots[number]
        if slot.material != material:
            slot.material = material
            _keep(before)
        if to_faces(target):
            target.active_material_index = number
    return material


def is_editable_material(material):
    """Whether there is a material that may be changed."""
    return material is not None and datablocks.locked.is_editable(material)


def to_faces(target):
    """Whether the object's faces are being edited."""
    return target.type == "MESH" and target.mode == "EDIT"


def _slots(target, to):
    """[(object, number)] of an object's slots, one made where there is none or a new one is asked."""
    if to == ALL_SLOTS and target.material_slots:
        return [(target, number) for number in range(len(target.material_slots))]
    if to == NEW_SLOT and to_faces(target):
        return [(target, slot_for_faces(target))]
    if to == NEW_SLOT or not target.material_slots:
        _new_slot(target)
    return [(target, target.active_material_index)]


def slot_for_faces(target):
    """Number of a new slot, which the selected faces of a mesh in Edit Mode have now."""
    _new_slot(target)
    _assign_to_faces(target)
    return target.active_material_index


def _new_slot(target):
    target.data.materials.append(None)
    target.active_material_index = len(target.material_slots) - 1


def _assign_to_faces(target):
    """Give the selected faces the active slot; Blender's own operator, as Edit Mode keeps faces of its own."""
    with bpy.context.temp_override(object=target, active_object=target, edit_object=target):
        bpy.ops.object.material_slot_assign()


def _may_be_made_over(material, slots):
    """Whether a material is ours, of this file, and in no slot but these."""
    if not is_editable_material(material) or datablocks.materials.our_node(material) is None:
        return False
    owners = {(_owner(target, number), number) for target, number in slots
              if target.material_slots[number].material == material}
    return material.users - material.use_fake_user <= len(owners)


def _owner(target, number):
    return target if target.material_slots[number].link == "OBJECT" else target.data


def _keep(material):
    """What someone made by hand does not go with the file when nothing uses it any more."""
    if is_editable_material(material) and not material.users and datablocks.materials.our_node(material) is None:
        from ..datablocks.untouched import is_untouched
        material.use_fake_user = not is_untouched(material)


def _meant(context):
    """(objects that are meant, those of them that take no material of this file): the shown or active one first."""
    shown = context.object
    meant = [] if getattr(context.space_data, "pin_id", None) else list(context.selected_objects)
    in_view = context.area is not None and context.area.type == "VIEW_3D"
    if shown is not None and (shown in meant or not (in_view and meant)):
        meant = [shown, *(target for target in meant if target != shown)]
    return [target for target in meant if not why_not_on(target)], [target for target in meant if why_not_on(target)]


def _objects_with(material):
    return [target for target in bpy.data.objects
            if any(slot.material == material for slot in target.material_slots)]


def why_not(context):
    """Why no material can be put anywhere, or an empty text."""
    objects, left_out = _meant(context)
    if objects:
        return ""
    if not left_out:
        return rpt_("Select an object first: the material goes into its active material slot")
    return why_not_on(left_out[0])


def why_not_on(target):
    if not hasattr(target.data, "materials"):
        return rpt_("{:s} takes no materials: select a mesh, curve, surface, text or volume").format(target.name)
    return datablocks.locked.why_locked(target) or datablocks.locked.why_locked(target.data)


def put_said(done):
    """(report's type, sentence) on what was put where: "Gold on Cube"."""
    names = [target.name for target in done.objects]
    where = ", ".join(names) if len(names) <= NAMED else rpt_("{:d} objects").format(len(names))
    said = rpt_("{:s} on {:s}").format(done.material.name, where)
    if not done.left_out:
        return "INFO", said
    left_out = rpt_("Left out, as they take no materials or are linked: {:s}").format(
        ", ".join(target.name for target in done.left_out))
    return "WARNING", f"{said}. {left_out}"


def said_of(material):
    """One sentence on what was baked."""
    baked = datablocks.materials.baked_of(material)
    if "conductor" not in baked:
        return f"{baked['title']}: {baked['note']}"
    said = rpt_("{:s} baked from {:s}: largest CIEDE2000 of the fit {:.2f}").format(
        baked["title"], baked["source"]["dataset"] or baked["name"], baked["conductor"]["delta_e_2000_max"])
    if baked["gamut"]["outside"]:
        said += rpt_("; outside the gamut, mapped by {:s}").format(iface_(baked["gamut"]["method"].capitalize()))
    return said
