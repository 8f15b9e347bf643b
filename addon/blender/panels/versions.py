"""The panel of what in a file is of another version of the extension."""

import bpy
from bpy.app.translations import pgettext_iface as iface_

__all__ = ["CLASSES"]


class FACET_FILM_PT_update(bpy.types.Panel):
    """What in this file is of another version of the extension"""

    bl_label = "Another Version"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"
    bl_parent_id = "FACET_FILM_PT_material"

    @classmethod
    def poll(cls, _context):
        """Shown only where there is something to say."""
        from ..datablocks.versions import outdated_groups
        return bool(outdated_groups())

    def draw(self, _context):
        """A line a group, and the button."""
        from ..datablocks.versions import outdated_groups
        column = self.layout.column(align=True)
        for group in outdated_groups():
            said = iface_("{:s}: version {:d}, now {:d}").format(group.tree.name, group.found, group.now)
            column.label(text=said, icon="FILE_REFRESH", translate=False)
        self.layout.operator("facet_film.update", icon="FILE_REFRESH")


CLASSES = (FACET_FILM_PT_update,)
