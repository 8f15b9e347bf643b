"""The operators for faces where two clear bodies touch, which are to be there once: what a face is against, by a menu;
and the common face of two objects, cut out and given its material.
"""

import bpy
from bpy.app.translations import pgettext_iface as iface_
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError
from .. import datablocks
from .targets import Reasoned, active_material, put_in, slot_for_faces, to_faces

__all__ = ["AIR", "CLASSES", "is_clear", "shown_outside"]

AIR = "."
"""In place of a material's name: no material is called so by default, and none by ours."""
_items = []


def is_clear(material):
    """Whether a material is a clear body of ours, whose faces can be against another."""
    model = datablocks.materials.model_of(material)
    return model is not None and bool(model.index_outside)


def shown_outside(material):
    """What a clear material's faces are against, in a word: air, or its index."""
    model = datablocks.materials.model_of(material)
    name = next(row.socket for row in model.parameters.TABLE if row.name == model.index_outside)
    inputs = datablocks.materials.our_node(material).inputs
    index = next(socket.default_value for socket in inputs if socket.name == name)
    return iface_("Air") if index == 1.0 else f"n = {index:.3f}"


def _outsides(_self, context):
    """Air, and the file's other clear materials."""
    shown = active_material(context)
    _items[:] = [(AIR, iface_("Air"), ""), *(
        (material.name, material.name, "") for material in bpy.data.materials
        if material != shown and is_clear(material))]
    return _items


class FACET_FILM_OT_touch(Reasoned, bpy.types.Operator):
    """Say what this face of a clear body is against: air, or another clear material, as water in a glass is. In Edit \
Mode the selected faces get a material of their own"""

    bl_idname = "facet_film.touch"
    bl_label = "Face Is Against"
    bl_options = {"REGISTER", "UNDO"}

    outside: bpy.props.EnumProperty(name="Against", items=_outsides, description="What is on the face's other side")

    @staticmethod
    def why_not(context):
        """Needs a clear material of ours in a slot of an object of this file."""
        return _why_not_touch(context)

    def execute(self, context):
        """Write it into the material, or into a new one where others use it too or faces are meant."""
        target, inside = context.object, active_material(context)
        try:
            outside = None if self.outside == AIR else _named(self.outside)
            slot = slot_for_faces(target) if to_faces(target) else target.active_material_index
            made = put_in([(target, slot)], lambda own: _against(inside, outside, own))
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        self.report({"INFO"}, rpt_("{:s} on {:s}").format(made.name, target.name))
        return {"FINISHED"}


def _named(name):
    found = bpy.data.materials.get(name)
    if found is None:
        raise FacetFilmError("There is no material {material!r} in this file any more.", material=name)
    return found


def _against(inside, outside, own):
    """The material `own`, or a new one, as inside's face against outside, or against air for None."""
    from ...api import common_face
    from ...models.touching import touching
    if own is None:
        return common_face(inside, outside)
    record_of = datablocks.materials.record_of
    datablocks.materials.write(own, touching(record_of(inside), outside and record_of(outside)))
    return own


def _why_not_touch(context):
    target, material = context.object, active_material(context)
    if material is None or not is_clear(material):
        return rpt_("Choose a clear material first, such as water: it is what the face's normals point out of")
    if target is None or target.active_material != material:
        return rpt_("Select the object whose face it is")
    why_locked = datablocks.locked.why_locked
    return why_locked(material) or why_locked(target) or why_locked(target.data)


class FACET_FILM_OT_common_face(Reasoned, bpy.types.Operator):
    """Make one face of two clear bodies that touch, as water does in a glass. Select the glass, then the water: the \
faces of the water on the glass get their material, and the glass's below them go"""

    bl_idname = "facet_film.common_face"
    bl_label = "Common Face of Two Bodies"
    bl_options = {"REGISTER", "UNDO"}

    @staticmethod
    def why_not(context):
        """Needs two mesh objects of this file, each with a clear material."""
        return _why_not_common(context)

    def execute(self, context):
        """Find the faces, give them their material, and take away those that they cover."""
        inner, outer = _bodies(context)
        wet = datablocks.wet_faces.wet_faces(inner, outer)
        if not wet.inner:
            self.report({"ERROR"}, rpt_(
                "No face of {:s} lies on {:s} with its normal the other way: duplicate the wet faces of the one, flip "
                "their normals, and close them to the other").format(inner.name, outer.name))
            return {"CANCELLED"}
        made = _against(inner.active_material, outer.active_material, None)
        inner.data.materials.append(made)
        for number in wet.inner:
            inner.data.polygons[number].material_index = len(inner.data.materials) - 1
        datablocks.wet_faces.remove_faces(outer.data, wet.outer)
        self.report(*_said(made, inner, outer, wet))
        return {"FINISHED"}


def _bodies(context):
    """(the active object, the other selected one), or (None, None)."""
    inner, chosen = context.active_object, context.selected_objects
    if inner is None or len(chosen) != 2 or inner not in chosen:
        return None, None
    return inner, next(target for target in chosen if target != inner)


def _why_not_common(context):
    both = _bodies(context)
    if context.mode != "OBJECT" or None in both or any(target.type != "MESH" for target in both):
        return rpt_("In Object Mode select two meshes: the glass, and then the water")
    for target in both:
        if target.active_material is None or not is_clear(target.active_material):
            return rpt_("{:s} has no clear material: give it one first, such as glass or water").format(target.name)
        if datablocks.locked.why_locked(target) or datablocks.locked.why_locked(target.data):
            return datablocks.locked.why_locked(target) or datablocks.locked.why_locked(target.data)
    return ""


def _said(made, inner, outer, wet):
    said = rpt_("{:s}: {:d} faces of {:s}; {:d} faces of {:s} below them went").format(
        made.name, len(wet.inner), inner.name, len(wet.outer), outer.name)
    if not wet.half:
        return {"INFO"}, said
    left = rpt_("{:d} lie below them in part: cut {:s} where the common face ends").format(len(wet.half), outer.name)
    return {"WARNING"}, f"{said}. {left}"


CLASSES = (FACET_FILM_OT_touch, FACET_FILM_OT_common_face)
