"""The operators that put a material of the catalogue on objects: a click on a picture, a search, a drop."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError
from .. import datablocks
from ..settings import OWN_FINISH, preferences, preset_property, viewing_of
from .targets import TO, OnObjects, Put, put, put_in, put_said, why_not_on

__all__ = ["CLASSES"]

ASSET_LIBRARIES = tuple((name, "", "", number) for name, number in (
    ("LOCAL", 1), ("ALL", 2), ("ESSENTIALS", 3), ("ONLINE_ESSENTIALS", 4), ("CUSTOM", 100)))
"""Blender's numbers for where an asset is from."""


class _OfAsset:
    """Properties that an asset shelf sets for the operator that it runs."""

    asset_library_type: bpy.props.EnumProperty(items=ASSET_LIBRARIES, options={"SKIP_SAVE", "HIDDEN"})
    asset_library_identifier: bpy.props.StringProperty(options={"SKIP_SAVE", "HIDDEN"})
    relative_asset_identifier: bpy.props.StringProperty(options={"SKIP_SAVE", "HIDDEN"})

    def chosen(self):
        """Name of the preset whose picture was clicked."""
        from ..assets.names import preset_of
        name = self.relative_asset_identifier.rpartition("/Material/")[2]
        found = preset_of(name)
        if found is None:
            raise FacetFilmError("There is no material of Facet & Film called {name!r}.", name=name)
        return found


def maker(context, preset):
    """A function of a material that may be made over, or None, that makes it the preset in the chosen light.

    It renders by the Reference or OSL where the material did that it replaces, and has that one's finish; else both are
    as the preferences say, where the preset's model can.
    """
    from ...api import create_material
    from ...catalogue.resolving import resolve
    from ...finishes.feeding import takes
    from ...models import DEFAULT, named
    from ...models.making import USUAL
    from ..missing import IN_EVERY_ENGINE
    resolved = resolve(preset)
    model = named(resolved.preset.model or DEFAULT)
    viewing = viewing_of(context.window_manager.facet_film)

    def make(material):
        had = datablocks.materials.realisation_of(material)
        wanted = preferences().realisation if had is None or had in IN_EVERY_ENGINE else had
        realisation = wanted if wanted in model.realisations else USUAL
        finish = preferences().finish if had is None and takes(model) else OWN_FINISH
        return create_material(preset=resolved, realisation=realisation, material=material, viewing=viewing,
                               finish=None if finish == OWN_FINISH else finish)
    return make


def _apply(operator, context, name, to):
    """Put a preset on the objects that are meant and say so; for operators."""
    try:
        done = put(context, maker(context, name()), to)
    except FacetFilmError as error:
        operator.report({"ERROR"}, error.said(rpt_))
        return {"CANCELLED"}
    kind, said = put_said(done)
    operator.report({kind}, said)
    return {"FINISHED"}


class FACET_FILM_OT_apply(_OfAsset, OnObjects, bpy.types.Operator):
    """Put this material on the selected objects. What you made by hand stays: the slot gets a new material"""

    bl_idname = "facet_film.apply"
    bl_label = "Apply Material"
    bl_options = {"REGISTER", "UNDO"}

    preset: preset_property(default="", options={"SKIP_SAVE"})
    to: bpy.props.EnumProperty(name="To", items=TO, description="Where the material goes", options={"SKIP_SAVE"})

    def execute(self, context):
        """Make the material, put it in the slots, say where it is."""
        return _apply(self, context, lambda: self.preset or self.chosen(), self.to)


def _listed(_self, _context):
    from ..assets.search_items import items
    return items()


class FACET_FILM_OT_search(OnObjects, bpy.types.Operator):
    """Find a material by its name, its formula or any other name for it, and put it on the selected objects"""

    bl_idname = "facet_film.search"
    bl_label = "Search Facet & Film Materials"
    bl_property = "preset"
    bl_options = {"REGISTER", "UNDO"}

    preset: bpy.props.EnumProperty(
        name="Material", items=_listed, description="Which material to apply")

    def invoke(self, context, _event):
        """Open the search."""
        context.window_manager.invoke_search_popup(self)
        return {"RUNNING_MODAL"}

    def execute(self, context):
        """Apply what was chosen."""
        from ..assets.search_items import preset_of_item
        return _apply(self, context, lambda: preset_of_item(self.preset), TO[0][0])


class FACET_FILM_OT_drop(_OfAsset, bpy.types.Operator):
    """Drop this material on an object: it goes into the slot of the face under the mouse"""

    bl_idname = "facet_film.drop"
    bl_label = "Drop Material"
    bl_options = {"REGISTER", "UNDO", "INTERNAL"}

    def invoke(self, context, _event):
        """Wait for where the button is let go."""
        context.window.cursor_modal_set("EYEDROPPER")
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        """Say what would get it; Esc leaves all as it was."""
        dropped = event.type == "LEFTMOUSE" and event.value == "RELEASE"
        if dropped or event.type in {"ESC", "RIGHTMOUSE"}:
            self.cancel(context)
            return self._put(context, event) if dropped else {"CANCELLED"}
        if event.type == "MOUSEMOVE":
            target, _ = under_mouse(context, event)
            context.workspace.status_text_set(
                rpt_("Drop on {:s}   (Esc stops)").format(target.name) if target else None)
        return {"RUNNING_MODAL"}

    def cancel(self, context):
        """Blender opens another file or closes, or it is over: take the cursor and the line back."""
        context.window.cursor_modal_restore()
        context.workspace.status_text_set(None)

    def _put(self, context, event):
        target, face = under_mouse(context, event)
        if target is None:
            return {"CANCELLED"}
        if why_not_on(target):
            self.report({"WARNING"}, why_not_on(target))
            return {"CANCELLED"}
        try:
            material = put_in([(target, slot_of_face(target, face))], maker(context, self.chosen()))
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        self.report({"INFO"}, put_said(Put(material, [target], []))[1])
        return {"FINISHED"}


def slot_of_face(target, face):
    """Number of the slot that a face of the evaluated object shows, a slot made where there is none."""
    if not target.material_slots:
        target.data.materials.append(None)
    shown = target.data.polygons[face].material_index if target.type == "MESH" and face < len(target.data.polygons) \
        else target.active_material_index
    return min(shown, len(target.material_slots) - 1)


def under_mouse(context, event):
    """(object, number of its face) under the mouse in a 3D view of the window, or (None, 0)."""
    from bpy_extras import view3d_utils
    for area in context.window.screen.areas:
        region = next((region for region in area.regions if region.type == "WINDOW"), None)
        if area.type == "VIEW_3D" and _is_in(area, event) and not _covered(area, event):
            at = event.mouse_x - region.x, event.mouse_y - region.y
            view = area.spaces.active.region_3d
            found, _, _, face, target, _ = context.scene.ray_cast(
                context.view_layer.depsgraph, view3d_utils.region_2d_to_origin_3d(region, view, at),
                view3d_utils.region_2d_to_vector_3d(region, view, at))
            return (target.original, face) if found else (None, 0)
    return None, 0


def _is_in(place, event):
    return place.x <= event.mouse_x < place.x + place.width and place.y <= event.mouse_y < place.y + place.height


def _covered(area, event):
    """Whether the mouse is over something that lies over the view: the shelf itself, a sidebar, a header."""
    over = {"ASSET_SHELF", "ASSET_SHELF_HEADER", "UI", "HEADER", "TOOL_HEADER"}
    return any(region.type in over and region.width > 1 and region.height > 1 and _is_in(region, event)
               for region in area.regions)


CLASSES = (FACET_FILM_OT_apply, FACET_FILM_OT_search, FACET_FILM_OT_drop)
