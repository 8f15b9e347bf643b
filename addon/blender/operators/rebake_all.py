"""The operator that bakes all measured materials of the file again, a few at a time."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError
from .. import compat, datablocks
from ..settings import viewing_of

__all__ = ["CLASSES", "OneByOne"]

EVERY_S = 0.01


class OneByOne:
    """For operators that bake many materials: step by step with the status bar, and all at once for scripts.

    They say which by `waiting(context)`, and give the Record of each by `baked(material)`.
    """

    def execute(self, context):
        """All at once, for scripts."""
        self._begin(context)
        while self._waiting:
            self._bake_next()
        return self._write()

    def invoke(self, context, _event):
        """Step by step, with the status bar."""
        self._begin(context)
        manager = context.window_manager
        self._timer = manager.event_timer_add(EVERY_S, window=context.window)
        manager.progress_begin(0, len(self._waiting))
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        """One material a tick; Esc leaves all as they were."""
        if event.type == "ESC":
            self._end(context)
            self.report({"WARNING"}, rpt_("Stopped: no material was changed"))
            return {"CANCELLED"}
        if event.type != "TIMER":
            return {"RUNNING_MODAL"}
        if self._waiting:
            context.workspace.status_text_set(rpt_("Baking {:s}, {:d} more   (Esc stops)").format(
                self._waiting[0].name, len(self._waiting) - 1))
            context.window_manager.progress_update(len(self._baked))
            self._bake_next()
            return {"RUNNING_MODAL"}
        self._end(context)
        return self._write()

    def cancel(self, context):
        """Blender opens another file or closes: nothing was changed yet."""
        self._end(context)

    def _begin(self, context):
        self._waiting = list(self.waiting(context))
        self._baked = []

    def _bake_next(self):
        material = self._waiting.pop(0)
        try:
            self._baked.append((material, self.baked(material)))
        except FacetFilmError as error:
            self.report({"WARNING"}, error.said(rpt_))

    def _write(self):
        for material, record in self._baked:
            datablocks.materials.write(material, record)
        self.report({"INFO"}, rpt_("{:d} materials baked again").format(len(self._baked)))
        return {"FINISHED"}

    def _end(self, context):
        context.window_manager.event_timer_remove(self._timer)
        context.window_manager.progress_end()
        context.workspace.status_text_set(None)


class FACET_FILM_OT_rebake_all(OneByOne, bpy.types.Operator):
    """Bake every measured material of this file again, in the light and working space chosen above. Esc stops it, \
and then nothing is changed"""

    bl_idname = "facet_film.rebake_all"
    bl_label = "Re-bake All Materials"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, _context):
        """Needs a measured material in this file."""
        if not any(True for _ in measured_materials()):
            cls.poll_message_set(rpt_("This file has no material with a measurement: bake a preset first"))
            return False
        return True

    def waiting(self, context):
        """All that hold a measurement."""
        self._viewing = viewing_of(context.window_manager.facet_film)
        return measured_materials()

    def baked(self, material):
        """The record in the chosen light."""
        from ...models.making import rebaked  # which loads numpy, and enabling does not wait for that
        return rebaked(datablocks.materials.record_of(material), compat.renderer(), self._viewing)


def measured_materials():
    """The materials of this file that hold a measurement and may be changed."""
    for material in bpy.data.materials:
        measured = datablocks.locked.is_editable(material) and datablocks.materials.is_measured(material)
        if measured and datablocks.materials.our_node(material) is not None:
            yield material


CLASSES = (FACET_FILM_OT_rebake_all,)
