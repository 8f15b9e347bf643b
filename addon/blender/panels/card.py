"""The card: a large picture of what the object has now, which opens all others, at the top of the Material properties
and wherever else one looks for a material.
"""

import bpy
from bpy.app.translations import pgettext_iface as iface_

from .. import assets, datablocks, panels
from ..operators.finish import shown_finish
from ..operators.targets import active_material
from .shelves import PICKER

__all__ = ["attach", "detach", "draw_card", "takes_materials"]

SLOT_PANELS = ("EEVEE_MATERIAL_PT_context_material", "CYCLES_PT_context_material")
"""Where Blender lists the material slots, by engine; EEVEE's serves Workbench too. They come first of all."""
PICTURE_SHARE, PICTURE_SCALE = 0.56, 6.0
FACE = ("Roughness", "Tint")


def draw_card(layout, context):
    """The picture on the left, which a click opens; other ways to a material on the right."""
    from .load_ahead import when_idle
    when_idle()
    material = active_material(context)
    shown = assets.library.is_shown()
    split = layout.split(factor=PICTURE_SHARE)
    split.use_property_split = False
    _draw_picture(split.column(), material, shown)
    column = split.column()
    column.operator("facet_film.search", text="Search", icon="VIEWZOOM")
    column.operator("facet_film.shelf", text="Shelf", icon="ASSET_MANAGER")
    if material is not None and not datablocks.locked.is_editable(material):
        column.operator("facet_film.make_local", icon="LIBRARY_DATA_DIRECT")
    if not shown:
        layout.operator("facet_film.choose", text="Choose a Material", icon="MATERIAL")
    if material is not None and datablocks.locked.is_editable(material):
        _draw_face(layout.column(align=True), material)


def _draw_face(column, material):
    """What one turns first, of a material of ours: its finish, and what the table calls Roughness and Tint."""
    node = datablocks.materials.our_node(material)
    if node is None:
        return
    from ...finishes.feeding import takes
    if takes(datablocks.materials.model_of(material)):
        shown = iface_("Finish: {:s}").format(shown_finish(material))
        column.operator_menu_enum("facet_film.apply_finish", "finish", text=shown, translate=False)
    known = panels.drawing.described(node.node_tree)
    marks = datablocks.materials.finish_node(material)
    varied = {socket.name: socket for socket in marks.inputs} if marks is not None else {}
    for socket in node.inputs:
        if socket.name in FACE and socket.name in known:
            turned = varied.get(socket.name, socket)
            panels.drawing.draw_socket(column, marks if turned is not socket else node, turned, known[socket.name])


def _draw_picture(column, material, opens):
    """What the object has now; Blender's button for a shelf, which opens it, needs the library to be there."""
    icon = material.preview_ensure().icon_id if material is not None else 0
    if opens:
        drawn = {"icon_value": icon} if icon else {"icon": "MATERIAL"}
        column.template_asset_shelf_popover(PICKER, name=" ", **drawn)
    elif icon:
        column.template_icon(icon, scale=PICTURE_SCALE)


def takes_materials(target):
    """Whether an object has material slots."""
    return target is not None and hasattr(target.data, "materials")


def draw_first(self, context):
    """The card, before Blender's list of slots."""
    if takes_materials(context.object) or context.material is not None:
        draw_card(self.layout, context)


def attach():
    """Put the card before Blender's own panels."""
    for panel in _panels():
        panel.prepend(draw_first)


def detach():
    """Take it out again."""
    for panel in _panels():
        panel.remove(draw_first)


def _panels():
    return [panel for name in SLOT_PANELS if (panel := getattr(bpy.types, name, None)) is not None]
