"""Operators that bring a user's own measurements in, and baked materials out."""

import functools

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError
from ...models import all_models
from ..datablocks.materials import baked_of, model_of
from ..settings import Viewing, realisation_property, viewing_of
from .targets import OnActiveObject, active_material, put_on_selected, said_of, target_material

__all__ = ["CLASSES"]

NOT_IN_NAMES = str.maketrans("/:", "__")


class _FromConstants(OnActiveObject, Viewing):
    """What importing and pasting share: bake OpticalConstants into the active material slot."""

    bl_options = {"REGISTER", "UNDO"}

    def bake(self, context, read):
        """Read, and bake what was read; one clear sentence where it cannot be."""
        from ...api import create_material
        try:
            constants = read()
            with target_material(context.active_object) as target:
                target.material = create_material(
                    preset=constants, realisation=self.realisation, material=target.material,
                    viewing=viewing_of(self))
            put_on_selected(context)
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        self.report({"INFO"}, said_of(context.active_object.active_material))
        return {"FINISHED"}


class FACET_FILM_OT_import_constants(_FromConstants, bpy.types.Operator):
    """Bake optical constants from a file: CSV or text of wavelength, n, k or of wavelength, R; refractiveindex.info's \
CSV and YAML; SOPRA and LuxPop .nk"""

    bl_idname = "facet_film.import_constants"
    bl_label = "Import Measurement"

    filepath: bpy.props.StringProperty(name="File", subtype="FILE_PATH", description="File of optical constants")
    filter_glob: bpy.props.StringProperty(default="*.csv;*.txt;*.dat;*.tsv;*.yml;*.yaml;*.nk", options={"HIDDEN"})
    realisation: realisation_property()

    def invoke(self, context, _event):
        """Ask for the file."""
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context):
        """Read the file, bake it, put the material in the slot."""
        from ...spectra.readers import read_file
        return self.bake(context, lambda: read_file(bpy.path.abspath(self.filepath)))


class FACET_FILM_OT_paste_constants(_FromConstants, bpy.types.Operator):
    """Bake optical constants from the clipboard: a table of wavelength, n, k or of wavelength, R"""

    bl_idname = "facet_film.paste_constants"
    bl_label = "Paste Measurement"

    realisation: realisation_property()

    def execute(self, context):
        """Read the clipboard, bake it, put the material in the slot."""
        from ...spectra.readers import read_text
        return self.bake(context, lambda: read_text(context.window_manager.clipboard))


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
        if material is None or model_of(material) is None or not baked_of(material):
            cls.poll_message_set(rpt_("Bake a measured material first: there is nothing to export"))
            return False
        return True

    def invoke(self, context, _event):
        """Ask for the file."""
        material = active_material(context)
        form = model_of(material).forms.get(self.form)
        ending = form.ending if form else ".txt"
        self.filepath = baked_of(material)["name"].translate(NOT_IN_NAMES) + ending
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
        self.report({"INFO"}, rpt_("Wrote {:s}").format(str(written)))
        return {"FINISHED"}


CLASSES = (FACET_FILM_OT_import_constants, FACET_FILM_OT_paste_constants, FACET_FILM_OT_export)
