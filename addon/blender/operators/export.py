"""The operator that writes a material for other programs."""

import functools

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError
from ...models import all_models
from .. import datablocks
from .targets import active_material

__all__ = ["CLASSES"]

NOT_IN_NAMES = str.maketrans("/:", "__")


def _forms_of(model):
    """Items of the forms that a model's materials leave in."""
    return [(name, form.title, form.tip) for name, form in model.forms.items()]


@functools.lru_cache(maxsize=1)
def _all_forms():
    """Items of every form of any model; Blender needs their texts to live on."""
    return list({item[0]: item for model in all_models() for item in _forms_of(model)}.values())


class FACET_FILM_OT_export(bpy.types.Operator):
    """Write the active material as its node holds it now: JSON, CSV or MaterialX"""

    bl_idname = "facet_film.export"
    bl_label = "Export Measurement"

    filepath: bpy.props.StringProperty(name="File", subtype="FILE_PATH", description="File to write")
    form: bpy.props.EnumProperty(name="Form", items=lambda _self, _context: _all_forms(), description="What to write")

    @classmethod
    def poll(cls, context):
        """Needs a material of ours that a preset was baked into."""
        material = active_material(context)
        materials = datablocks.materials
        if material is None or materials.model_of(material) is None or not materials.baked_of(material):
            cls.poll_message_set(rpt_("Bake a measured material first: there is nothing to export"))
            return False
        return True

    def invoke(self, context, _event):
        """Ask for the file."""
        material = active_material(context)
        form = datablocks.materials.model_of(material).forms.get(self.form)
        ending = form.ending if form else ".txt"
        self.filepath = datablocks.materials.baked_of(material)["name"].translate(NOT_IN_NAMES) + ending
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context):
        """Write what the material is now."""
        from ...api import export
        from ...export import write_text
        try:
            written = write_text(bpy.path.abspath(self.filepath), export(active_material(context), self.form))
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        said = rpt_("Wrote {:s}").format(str(written))
        if datablocks.materials.finish_node(active_material(context)) is not None:
            said += rpt_("; the marks of the finish stay in Blender, its roughness is in it")
        self.report({"INFO"}, said)
        return {"FINISHED"}


CLASSES = (FACET_FILM_OT_export,)
