"""Operators that bring a user's own measurements in, and baked materials out."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from ..errors import FacetFilmError
from .bake_operator import OnActiveObject, PanelSettings, put_on_selected, said_of, target_material
from .materials import model_of, record_of
from .settings import Viewing, realisation_property, viewing_of

__all__ = ["CLASSES"]

FORMS = (
    ("json", "JSON", "Everything that was baked", ".json"),
    ("csv", "CSV of the Curve", "Colour over angle: cos_theta, r, g, b", ".csv"),
    ("spectrum_csv", "CSV of the Spectrum", "The measured points: wavelength_nm, n, k", ".csv"),
    ("materialx", "MaterialX", "conductor_bsdf and generalized_schlick_bsdf", ".mtlx"),
)

NOT_IN_NAMES = str.maketrans("/:", "__")


class _FromConstants(OnActiveObject, PanelSettings, Viewing):
    """What importing and pasting share: bake OpticalConstants into the active material slot."""

    bl_options = {"REGISTER", "UNDO"}

    def bake(self, context, read):
        """Read, and bake what was read; one clear sentence where it cannot be."""
        from ..api import create_material
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
        from ..spectra.readers import read_file
        return self.bake(context, lambda: read_file(bpy.path.abspath(self.filepath)))


class FACET_FILM_OT_paste_constants(_FromConstants, bpy.types.Operator):
    """Bake optical constants from the clipboard: a table of wavelength, n, k or of wavelength, R"""

    bl_idname = "facet_film.paste_constants"
    bl_label = "Paste Measurement"

    realisation: realisation_property()

    def execute(self, context):
        """Read the clipboard, bake it, put the material in the slot."""
        from ..spectra.readers import read_text
        return self.bake(context, lambda: read_text(context.window_manager.clipboard))


class FACET_FILM_OT_export(bpy.types.Operator):
    """Write what was baked into the active material as JSON, CSV or MaterialX"""

    bl_idname = "facet_film.export"
    bl_label = "Export Measurement"

    filepath: bpy.props.StringProperty(name="File", subtype="FILE_PATH", description="File to write")
    form: bpy.props.EnumProperty(name="Form", items=[item[:3] for item in FORMS], description="What to write")

    @classmethod
    def poll(cls, context):
        """Needs a Cook-Torrance material with a measurement."""
        material = getattr(context.active_object, "active_material", None)
        if material is None or model_of(material) != "cook_torrance" or not record_of(material):
            cls.poll_message_set(rpt_("Bake a measured material first: there is nothing to export"))
            return False
        return True

    def invoke(self, context, _event):
        """Ask for the file."""
        ending = next(item[3] for item in FORMS if item[0] == self.form)
        self.filepath = record_of(context.active_object.active_material)["name"].translate(NOT_IN_NAMES) + ending
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context):
        """Bake again for the exact formula, which other programs evaluate, and write it."""
        from .. import export
        from ..api import bake, measurement_of
        from ..bake.reflected import material as measured
        try:
            measurement = measurement_of(record_of(context.active_object.active_material))
            baked = bake(measurement, formula="exact")
            text = {"json": lambda: export.bake_json(baked), "csv": lambda: export.curve_csv(baked),
                    "spectrum_csv": lambda: export.spectrum_csv(measured(measurement)[1]),
                    "materialx": lambda: export.materialx(baked)}[self.form]()
            written = export.write_text(bpy.path.abspath(self.filepath), text)
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        self.report({"INFO"}, rpt_("Wrote {:s}").format(str(written)))
        return {"FINISHED"}


CLASSES = (FACET_FILM_OT_import_constants, FACET_FILM_OT_paste_constants, FACET_FILM_OT_export)
