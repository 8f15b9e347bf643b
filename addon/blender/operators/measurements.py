"""Operators that bring a user's own measurements in: from a file, seen before it is imported, or from the clipboard."""

import functools
import os

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError
from ..settings import Viewing, realisation_property, viewing_of
from .targets import OnObjects, put, said_of

__all__ = ["CLASSES"]


@functools.lru_cache(maxsize=8)
def _seen(path, _changed, choose):
    from ...bake import preview
    return preview(path, choose)


def preview_of(operator):
    """The Preview of the file that is chosen at the moment, or None where none is."""
    path = bpy.path.abspath(operator.filepath)
    if not os.path.isfile(path):
        return None
    return _seen(path, os.path.getmtime(path), operator.choose)


def _choices(operator, _context, text):
    """The readings or things in the file that hold a text."""
    seen = operator.seen()
    return [name for name in (seen.choices if seen else ()) if text.casefold() in name.casefold()]


class _FromMeasurement(OnObjects, Viewing):
    """What importing and pasting share: bake a measurement into the active material slot."""

    bl_options = {"REGISTER", "UNDO"}

    choose: bpy.props.StringProperty(
        name="Read As", search=_choices, options={"SKIP_SAVE"},
        description="Of a file that holds or can mean several things: which. Empty where its meaning is plain")
    realisation: realisation_property()

    def bake(self, context, read):
        """Read, and bake what was read; one clear sentence where it cannot be."""
        from ...api import create_material
        try:
            constants = read()
            done = put(context, lambda material: create_material(
                preset=constants, realisation=self.realisation, material=material, viewing=viewing_of(self)))
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        assumed = [line[0].upper() + line[1:] for line in constants.assumed]
        said = ". ".join([said_of(done.material), *assumed])
        self.report({"INFO"} if constants.covers_visible else {"WARNING"}, said)
        return {"FINISHED"}

    def draw(self, context):
        """What it is read as."""
        from ..panels.preview import draw_preview
        draw_preview(self.layout, self, self.seen(), context.region)


class FACET_FILM_OT_import_constants(_FromMeasurement, bpy.types.Operator):
    """Bake a measurement from a file: tables of n and k, permittivity or reflectance in any layout and unit; \
refractiveindex.info, SOPRA, WVASE, Zemax, CGATS, JSON and others"""

    bl_idname = "facet_film.import_constants"
    bl_label = "Import Measurement"

    filepath: bpy.props.StringProperty(name="File", subtype="FILE_PATH", description="File of optical constants")
    filter_glob: bpy.props.StringProperty(options={"HIDDEN"})

    def invoke(self, context, _event):
        """Ask for the file."""
        from ...spectra.readers import SUFFIXES
        self.filter_glob = ";".join("*" + suffix for suffix in SUFFIXES)
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def seen(self):
        """The Preview of the chosen file."""
        return preview_of(self)

    def execute(self, context):
        """Read the file, bake it, put the material in the slot."""
        from ...spectra.readers import read_file
        return self.bake(context, lambda: read_file(bpy.path.abspath(self.filepath), self.choose))


class FACET_FILM_OT_paste_constants(_FromMeasurement, bpy.types.Operator):
    """Bake a measurement from the clipboard: a table of n and k, permittivity or reflectance"""

    bl_idname = "facet_film.paste_constants"
    bl_label = "Paste Measurement"

    def invoke(self, context, _event):
        """Ask only where the text can mean several things."""
        if self.seen().choices:
            return context.window_manager.invoke_props_dialog(self, width=400)
        return self.execute(context)

    def seen(self):
        """The Preview of the clipboard."""
        from ...bake import preview_text
        return preview_text(bpy.context.window_manager.clipboard, choose=self.choose)

    def execute(self, context):
        """Read the clipboard, bake it, put the material in the slot."""
        from ...spectra.readers import read_text
        return self.bake(context, lambda: read_text(context.window_manager.clipboard, choose=self.choose))


CLASSES = (FACET_FILM_OT_import_constants, FACET_FILM_OT_paste_constants)
