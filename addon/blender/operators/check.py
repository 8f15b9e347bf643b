"""The checker and the spread of measurements, asked from the panel."""

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError

__all__ = ["CLASSES"]

KINDS = (
    ("nk", "n and k", "Refractive index and extinction for red, green and blue"),
    ("f0", "F0 and Edge Tint", "Reflectance at normal incidence and F82 tint for red, green and blue"),
    ("material", "Material", "A preset, or a dataset of the database"),
)


class _ShowsText:
    """Shows what was found as lines in a dialog."""

    bl_options = {"REGISTER", "INTERNAL"}

    def invoke(self, context, _event):
        """Open the dialog; it works anew at every change."""
        return context.window_manager.invoke_props_dialog(self, width=640)

    def draw(self, context):
        """What is asked, and what was found."""
        self.ask(self.layout)
        column = self.layout.box().column(align=True)
        for line in self.found().splitlines():
            column.label(text=line, translate=False)

    def found(self):
        """What was found, or why nothing was, as text."""
        try:
            return self.answer()
        except FacetFilmError as error:
            return error.said(rpt_)

    def execute(self, _context):
        """From a script: report what was found."""
        try:
            self.report({"INFO"}, self.answer())
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        return {"FINISHED"}


class FACET_FILM_OT_check(_ShowsText, bpy.types.Operator):
    """Show F0, F82 and how many CIEDE2000 typed-in values or a material lie from a measured material"""

    bl_idname = "facet_film.check"
    bl_label = "Check Against a Measurement"

    against: bpy.props.StringProperty(
        name="Measured Material", default="copper", description="Preset or dataset to compare with")
    kind: bpy.props.EnumProperty(name="Check", items=KINDS, description="What to compare")
    material: bpy.props.StringProperty(name="Material", default="gold", description="Preset or dataset to compare")
    n: bpy.props.FloatVectorProperty(name="n", default=(0.2, 1.0, 1.3), min=0.001, max=100.0,
                                     description="Refractive index for red, green and blue")
    k: bpy.props.FloatVectorProperty(name="k", default=(3.2, 2.6, 2.4), min=0.0, max=100.0,
                                     description="Extinction for red, green and blue")
    f0: bpy.props.FloatVectorProperty(name="F0", default=(0.93, 0.62, 0.52), min=0.0, max=1.0, subtype="COLOR",
                                      description="Reflectance at normal incidence")
    tint: bpy.props.FloatVectorProperty(name="Edge Tint", default=(1.0, 1.0, 1.0), min=0.0, max=1.0,
                                        subtype="COLOR", description="F82 tint")

    def ask(self, layout):
        """The two sides of the comparison."""
        layout.prop(self, "against")
        layout.prop(self, "kind", expand=True)
        for name in {"nk": ("n", "k"), "f0": ("f0", "tint"), "material": ("material",)}[self.kind]:
            layout.prop(self, name)

    def answer(self):
        """The check as text."""
        from ...bake import check
        from ...shell import text as cli_text
        given = {"nk": lambda: {"n": self.n[:], "k": self.k[:]}, "f0": lambda: {"f0": self.f0[:], "tint": self.tint[:]},
                 "material": lambda: {"preset": self.material}}[self.kind]()
        return cli_text.checked(check(self.against, **given))


class FACET_FILM_OT_spread(_ShowsText, bpy.types.Operator):
    """Show all measurements of the same material side by side: published values differ from lab to lab"""

    bl_idname = "facet_film.spread"
    bl_label = "Compare Measurements"

    material: bpy.props.StringProperty(name="Material", default="gold", description="Preset or dataset")

    def ask(self, layout):
        """The material whose measurements to compare."""
        layout.prop(self, "material")

    def answer(self):
        """The spread as text."""
        from ...bake import spread
        from ...shell import text as cli_text
        return cli_text.spread(spread(self.material))


CLASSES = (FACET_FILM_OT_check, FACET_FILM_OT_spread)
