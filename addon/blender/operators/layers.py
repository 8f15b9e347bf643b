"""The operators of the panel of layers: bake what is written there, and change its list."""

import time

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError
from .. import compat, datablocks
from ..layers import say_layers
from .targets import Reasoned, active_material, said_of

__all__ = ["CLASSES"]

SHOWN_AFTER_S = 0.5
CHANGES = (("ADD", "Add", "Add a layer below the chosen one"), ("REMOVE", "Remove", "Remove the chosen layer"),
           ("UP", "Outwards", "Move the chosen layer outwards"), ("DOWN", "Inwards", "Move the chosen layer inwards"))
PLACES = (("FILM", "Layer", "The chosen layer"), ("BELOW", "Substrate", "What is below all layers"))


class FACET_FILM_OT_bake_layers(Reasoned, bpy.types.Operator):
    """Bake these layers into the material: its roughness, its textures and what else you set stay"""

    bl_idname = "facet_film.bake_layers"
    bl_label = "Bake"
    bl_options = {"REGISTER", "UNDO"}

    text: bpy.props.StringProperty(
        name="Layers in Words", description="Layers from the outside in, such as 'SiO2 0-1000 nm / Si'")

    @staticmethod
    def why_not(context):
        """Needs a material of this file that is made of layers."""
        material = active_material(context)
        model = datablocks.materials.model_of(material)
        if model is None or not model.made_of:
            return rpt_("Choose a material that is made of layers first, such as anodised titanium")
        return datablocks.locked.why_locked(material)

    def execute(self, context):
        """Bake, with progress at the mouse where it takes long, and write."""
        from ...models.making import of_other_words
        material = active_material(context)
        try:
            with _Progress(context.window_manager) as told:
                before = datablocks.materials.record_of(material)
                datablocks.materials.write(
                    material, of_other_words(before, self.text, compat.renderer(), progress=told))
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        self.report({"INFO"}, said_of(material))
        return {"FINISHED"}


class _Progress:
    """Shows a share at the mouse once something takes longer than a moment."""

    def __init__(self, manager):
        self.manager, self.begun, self.is_shown = manager, time.perf_counter(), False

    def __enter__(self):
        return self._tell

    def __exit__(self, *_):
        if self.is_shown:
            self.manager.progress_end()

    def _tell(self, share):
        if not self.is_shown and time.perf_counter() - self.begun > SHOWN_AFTER_S:
            self.manager.progress_begin(0, 100)
            self.is_shown = True
        if self.is_shown:
            self.manager.progress_update(int(100 * share))


class FACET_FILM_OT_change_layers(bpy.types.Operator):
    """Change the list of layers"""

    bl_idname = "facet_film.change_layers"
    bl_label = "Change Layers"
    bl_options = {"INTERNAL"}

    what: bpy.props.EnumProperty(name="Change", items=CHANGES, description="What to do with the list")

    @classmethod
    def description(cls, _context, properties):
        """What this button does."""
        return next(tip for name, _, tip in CHANGES if name == properties.what)

    def execute(self, context):
        """Change the list, and the text with it."""
        settings = context.window_manager.facet_film
        layers, at = settings.layers, settings.layer
        if self.what == "ADD":
            added = layers.add()
            added.material = layers[at].material if len(layers) > 1 else "SiO2"
            layers.move(len(layers) - 1, min(at + 1, len(layers) - 1))
            settings.layer = min(at + 1, len(layers) - 1)
        elif at < len(layers):
            self._change(settings, layers, at)
        say_layers(settings)
        return {"FINISHED"}

    def _change(self, settings, layers, at):
        if self.what == "REMOVE":
            layers.remove(at)
            settings.layer = max(0, min(at, len(layers) - 1))
        else:
            to = at + (1 if self.what == "DOWN" else -1)
            if 0 <= to < len(layers):
                layers.move(at, to)
                settings.layer = to


class FACET_FILM_OT_layer_file(bpy.types.Operator):
    """Take a measurement of your own as a layer: a file of n and k"""

    bl_idname = "facet_film.layer_file"
    bl_label = "Layer From a File"
    bl_options = {"INTERNAL"}

    filepath: bpy.props.StringProperty(name="File", subtype="FILE_PATH", description="File of optical constants")
    filter_glob: bpy.props.StringProperty(options={"HIDDEN"})
    place: bpy.props.EnumProperty(name="Place", items=PLACES, description="Which layer is of it")

    def invoke(self, context, _event):
        """Ask for the file."""
        from ...spectra.readers import SUFFIXES
        self.filter_glob = ";".join("*" + suffix for suffix in SUFFIXES)
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context):
        """Read it, and name it in the list."""
        from ...spectra.readers import read_file
        settings, path = context.window_manager.facet_film, bpy.path.abspath(self.filepath)
        try:
            read_file(path)
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        if self.place == "BELOW":
            settings.layers_below = path
        elif settings.layer < len(settings.layers):
            settings.layers[settings.layer].material = path
        return {"FINISHED"}


CLASSES = (FACET_FILM_OT_bake_layers, FACET_FILM_OT_change_layers, FACET_FILM_OT_layer_file)
