"""The operator that fits a model to a measured BRDF: a share of the search a tick, so that Blender stays awake."""

import time
from pathlib import Path

import bpy
from bl_operators.presets import AddPresetBase
from bpy.app.translations import pgettext_iface as iface_
from bpy.app.translations import pgettext_n as n_
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError
from .. import compat, datablocks
from ..settings import realisation_property
from .targets import OnObjects, put
from .user_presets import FOLDER, preset_from, preset_text

__all__ = ["CLASSES", "VERDICTS"]

EVERY_S, AT_ONCE_S = 0.01, 0.05
FRESNEL_ITEMS = (
    ("best", "Best", "The simplest of the others of which no other comes clearly closer"),
    ("f0", "F0", "A dielectric's, by its reflectance at normal incidence"),
    ("n_k", "n and k", "A conductor's, by its complex refractive index"),
    ("curve", "Curve", "Free over the angle, for colours that change with it; with two slopes at most"),
)
DISTRIBUTION_ITEMS = (("beckmann", "Beckmann", "Cook and Torrance's own choice, with a wider foot"),
                      ("gaussian", "Gaussian", "As published beside it"))
VERDICTS = (
    n_("alike"), n_("good"), n_("fair"),
    n_("this model cannot, because its colour changes with the angle in another way than one Fresnel term on facets "
       "does"),
    n_("this model cannot, because towards grazing it reflects otherwise than facets do"),
    n_("this model cannot, because its highlights have another shape than facets of a few slopes make, as those of "
       "flakes"),
    n_("this model cannot, because away from its highlights it is not evenly diffuse, as where fibres or flakes send "
       "light back"),
)
"""All that addon.measured.fit.Fit.verdict says."""


class FACET_FILM_OT_fit_brdf(OnObjects, bpy.types.Operator):
    """Fit a model to a measured BRDF, put it in the material slot and save it as a preset of your own: .bsdf of \
RGL-EPFL, .binary of MERL, or points as text. Takes a few seconds; Esc stops it"""

    bl_idname = "facet_film.fit_brdf"
    bl_label = "Fit Measured BRDF"
    bl_options = {"REGISTER", "UNDO"}

    filepath: bpy.props.StringProperty(name="File", subtype="FILE_PATH", description="File of a measured BRDF",
                                       options={"SKIP_SAVE"})
    filter_glob: bpy.props.StringProperty(options={"HIDDEN"})
    chosen: bpy.props.BoolProperty(options={"HIDDEN", "SKIP_SAVE"})
    fresnel: bpy.props.EnumProperty(name="Fresnel", items=FRESNEL_ITEMS, description="What the reflectance F may be")
    slopes: bpy.props.IntProperty(name="Slopes", default=2, min=1, max=3,
                                  description="How many rms slopes the facets have")
    distribution: bpy.props.EnumProperty(name="Distribution", items=DISTRIBUTION_ITEMS,
                                         description="How the facets' slopes are distributed")
    save: bpy.props.BoolProperty(name="Save as Preset", default=True,
                                 description="Keep it among your own presets, with what it was fitted from")
    realisation: realisation_property()

    def draw(self, _context):
        """What is asked beside the file."""
        layout = self.layout
        layout.use_property_split = True
        for name in ("fresnel", "slopes", "distribution", "save", "realisation"):
            layout.prop(self, name)

    def invoke(self, context, _event):
        """Ask for the file; with one chosen, fit step by step."""
        if self.chosen:
            return self._start(context)
        from ...measured import SUFFIXES
        self.filter_glob = ";".join("*" + suffix for suffix in SUFFIXES)
        self._asked = True
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context):
        """From a script all at once; from the file browser step by step, as an operator of its own."""
        if getattr(self, "_asked", False):
            given = {name: getattr(self, name) for name in ("filepath", "fresnel", "slopes", "distribution", "save",
                                                            "realisation")}
            bpy.ops.facet_film.fit_brdf("INVOKE_DEFAULT", chosen=True, **given)
            return {"CANCELLED"}  # the other one goes on, and is what can be undone
        try:
            self._steps = self._begin()
            while self._fit is None:
                self._go_on()
        except FacetFilmError as error:
            return self._failed(error)
        return self._apply(context)

    def modal(self, context, event):
        """A part of the search a tick; Esc stops it, and nothing is changed."""
        if event.type == "ESC":
            self._end(context)
            self.report({"WARNING"}, rpt_("Stopped: nothing was fitted"))
            return {"CANCELLED"}
        if event.type != "TIMER":
            return {"RUNNING_MODAL"}
        until = time.perf_counter() + AT_ONCE_S
        try:
            while self._fit is None and time.perf_counter() < until:
                self._go_on()
        except FacetFilmError as error:
            self._end(context)
            return self._failed(error)
        if self._fit is None:
            self._show(context)
            return {"RUNNING_MODAL"}
        self._end(context)
        return self._apply(context)

    def cancel(self, context):
        """Blender opens another file or closes: nothing was changed yet."""
        if getattr(self, "_timer", None):
            self._end(context)

    def _start(self, context):
        try:
            self._steps = self._begin()
        except FacetFilmError as error:
            return self._failed(error)
        manager = context.window_manager
        self._timer = manager.event_timer_add(EVERY_S, window=context.window)
        manager.progress_begin(0, 100)
        manager.modal_handler_add(self)
        self._show(context)
        return {"RUNNING_MODAL"}

    def _begin(self):
        """The steps of the fit; the file is read here, so that what is wrong with it is said at once."""
        from ...measured import fit_steps, read_brdf
        self._fit, self._share = None, 0.0
        measurement = read_brdf(bpy.path.abspath(self.filepath))
        return fit_steps(measurement, fresnel=self.fresnel, slopes=self.slopes, distribution=self.distribution)

    def _go_on(self):
        try:
            self._share = next(self._steps)
        except StopIteration as end:
            self._fit = end.value

    def _show(self, context):
        percent = int(100.0 * self._share)
        context.window_manager.progress_update(percent)
        context.workspace.status_text_set(rpt_("Fitting {:s}: {:d} %   (Esc stops)").format(
            Path(self.filepath).name, percent))

    def _end(self, context):
        self._steps.close()
        context.window_manager.event_timer_remove(self._timer)
        self._timer = None
        context.window_manager.progress_end()
        context.workspace.status_text_set(None)

    def _failed(self, error):
        self.report({"ERROR"}, error.said(rpt_))
        return {"CANCELLED"}

    def _apply(self, context):
        """Put the material in the slots, and save it."""
        record = self._fit.record(self.realisation, compat.renderer())
        done = put(context, lambda material: datablocks.materials.create(record, material=material))
        said = rpt_("{:s} fitted, CIEDE2000 {:.2f} on average: {:s}").format(
            self._fit.title, self._fit.mean, iface_(self._fit.verdict))
        if self.save:
            path = _free(AddPresetBase.as_filename(self._fit.title), self._fit.file)
            path.write_text(preset_text(done.material), encoding="utf-8")
            said += rpt_(". Saved among your presets as {:s}").format(path.stem)
        self.report({"WARNING"} if self._fit.reason else {"INFO"}, said)
        return {"FINISHED"}


def _free(name, source):
    """The path of a preset: one that was fitted to the same file is replaced, any other stays."""
    folder = Path(bpy.utils.user_resource("SCRIPTS", path=f"presets/{FOLDER}", create=True))
    number, path = 1, folder / f"{name}.py"
    while path.exists() and _fitted_to(path) != source:
        number += 1
        path = folder / f"{name}_{number}.py"
    return path


def _fitted_to(path):
    try:
        return preset_from(path.read_text(encoding="utf-8")).baked.get("fitted", {}).get("file", "")
    except (OSError, UnicodeDecodeError, FacetFilmError):
        return ""


CLASSES = (FACET_FILM_OT_fit_brdf,)
