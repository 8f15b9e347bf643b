"""The operator that brings all materials of the file into its working space, a few at a time."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from .rebake_all import OneByOne

__all__ = ["CLASSES"]


class FACET_FILM_OT_match_space(OneByOne, bpy.types.Operator):
    """Bring all Facet & Film materials that were baked for another working space into this file's: baked again, and \
what you changed moved along. Esc stops it, and then nothing is changed"""

    bl_idname = "facet_film.match_space"
    bl_label = "Match Working Space"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, _context):
        """Off where all are in it."""
        from ..datablocks.spaces import foreign_materials
        if not foreign_materials():
            cls.poll_message_set(rpt_("All materials of Facet & Film in this file are in its working space"))
            return False
        return True

    def waiting(self, _context):
        """Those of another space."""
        from ..datablocks.spaces import foreign_materials
        return foreign_materials()

    def baked(self, material):
        """The record in the file's space."""
        from ..datablocks.spaces import brought
        return brought(material)


CLASSES = (FACET_FILM_OT_match_space,)
