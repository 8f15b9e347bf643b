"""The panel of the asset library."""

import bpy

from ..assets.library import ours

__all__ = ["CLASSES"]


class FACET_FILM_PT_asset_library(bpy.types.Panel):
    """The materials and node groups as assets to drag"""

    bl_label = "Asset Library"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"
    bl_parent_id = "FACET_FILM_PT_material"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, _context):
        """One button: add, or remove."""
        if ours():
            self.layout.label(text="In the Asset Browser as Facet & Film", icon="ASSET_MANAGER")
            self.layout.operator("facet_film.remove_asset_library", icon="REMOVE")
        else:
            self.layout.operator("facet_film.add_asset_library", icon="ASSET_MANAGER")


CLASSES = (FACET_FILM_PT_asset_library,)
