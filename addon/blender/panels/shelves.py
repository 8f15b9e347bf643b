"""The catalogue as Blender's asset shelves: one for popovers anywhere, one along the 3D viewport."""

import bpy

from .. import assets, compat
from ..operators.targets import TO

__all__ = ["CLASSES", "PICKER", "SHELF"]

PICKER, SHELF = "FACET_FILM_AST_picker", "FACET_FILM_AST_view3d"


class _Shelf:
    """What both share: our materials, and what a click and a drag do."""

    bl_activate_operator = "FACET_FILM_OT_apply"
    bl_drag_operator = "FACET_FILM_OT_drop"
    bl_options = set() if compat.drags_from_shelves() else {"NO_ASSET_DRAG"}
    bl_default_preview_size = 96
    filter_material = True

    @classmethod
    def asset_poll(cls, asset):
        """Whether it is a material of ours; asked twice for every asset at every redraw.

        Its full_path begins with the library's, and costs a twentieth of asking for that alone.
        """
        return asset.id_type == "MATERIAL" and asset.full_path.startswith(assets.library.OURS)

    @classmethod
    def draw_context_menu(cls, _context, asset, layout):
        """The other places that a material can go to."""
        for to, title, _ in TO[1:]:
            operator = layout.operator("facet_film.apply", text=title)
            operator.relative_asset_identifier = f"{assets.library.FILE.name}/Material/{asset.name}"
            operator.to = to


class FACET_FILM_AST_picker(_Shelf, bpy.types.AssetShelf):
    """For popovers alone: no editor has a shelf's region for this type of space"""

    bl_idname = PICKER
    bl_space_type = "PROPERTIES"

    @classmethod
    def poll(cls, _context):
        """Everywhere."""
        return True


class FACET_FILM_AST_view3d(_Shelf, bpy.types.AssetShelf):
    """Along the 3D viewport, to drag from; hidden until it is asked for"""

    bl_idname = SHELF
    bl_space_type = "VIEW_3D"

    @classmethod
    def poll(cls, context):
        """In Object Mode, where materials are dropped."""
        return context.mode == "OBJECT"


CLASSES = (FACET_FILM_AST_picker, FACET_FILM_AST_view3d)
