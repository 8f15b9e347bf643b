"""The extension's entry in the preferences: the verification."""

import bpy

__all__ = ["CLASSES"]


class FacetFilmPreferences(bpy.types.AddonPreferences):
    """What Preferences, Add-ons shows under Facet & Film."""

    bl_idname = __package__.rsplit(".", 3)[0]

    def draw(self, _context):
        """Two buttons and what runs at the moment."""
        from ..operators.verify import progress
        column = self.layout.column()
        column.label(text="Does this Blender render the published formulas? Find out on this machine:")
        row = column.row()
        row.operator("facet_film.verify", text="Verify on CPU", icon="CHECKMARK").device = "CPU"
        row.operator("facet_film.verify", text="Verify on GPU", icon="CHECKMARK").device = "GPU"
        if progress():
            column.label(text=progress(), translate=False)


CLASSES = (FacetFilmPreferences,)
