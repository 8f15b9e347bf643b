"""The operator that brings a file of an older version up to date."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

__all__ = ["CLASSES"]


class FACET_FILM_OT_update(bpy.types.Operator):
    """Bring this file's materials by an older Facet & Film up to date; every value and link stays"""

    bl_idname = "facet_film.update"
    bl_label = "Update Materials"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, _context):
        """Off where nothing is of another version."""
        from ..datablocks.versions import outdated_groups
        if not outdated_groups():
            cls.poll_message_set(rpt_("Everything in this file is of this version"))
            return False
        return True

    def execute(self, _context):
        """Update, and say what was left alone and why."""
        from ..datablocks.versions import update
        updated, reasons = update()
        if updated:
            self.report({"INFO"}, rpt_("Nodes updated: {:d}").format(updated))
        for reason in reasons:
            self.report({"WARNING"}, reason)
        return {"FINISHED"} if updated else {"CANCELLED"}


CLASSES = (FACET_FILM_OT_update,)
