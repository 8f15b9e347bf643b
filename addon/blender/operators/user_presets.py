"""Presets of the user's own, kept by Blender's preset system in the user's folder, where updates leave them."""

from pathlib import Path

import bpy
from bl_operators.presets import AddPresetBase
from bl_ui.utils import PresetPanel
from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError
from .. import compat, datablocks
from .targets import OnObjects, active_material, put, put_said

__all__ = ["CLASSES", "draw_header", "preset_text", "preset_from"]

FOLDER = "facet_film"
FIRST_LINE = "# A material of Facet & Film, as JSON in a comment of one line.\n#"
"""Blender keeps presets as Python files; ours hold nothing that runs."""


def preset_text(material):
    """All that makes a material of ours, as the text of a preset file."""
    return FIRST_LINE + datablocks.materials.record_of(material).to_json() + "\n"


def preset_from(text):
    """The Record in the text of a preset file.  Raises FacetFilmError for another text."""
    import json

    from ...models.record import from_dict
    try:
        held = json.loads(text.split("#", 2)[2])
        return from_dict(held if "format" in held else of_0_1_0(held))
    except (IndexError, KeyError, TypeError, ValueError, AttributeError):
        raise FacetFilmError("This file is no preset of Facet & Film.") from None


def of_0_1_0(held):
    """What 0.1.0 wrote, as :func:`addon.models.record.from_dict` takes it."""
    import json

    from ...models.making import made
    from ...models.record import from_json
    parameters = {name: _tuples(value) for name, value in held["parameters"].items()}
    current = made(held["model"], realisation=held["realisation"], **parameters)
    return from_json(json.dumps(held["record"]), current).to_dict()


def _tuples(value):
    return tuple(map(_tuples, value)) if isinstance(value, list) else value


def material_of(text, material=None):
    """The material of a preset file, made over an existing one where that is given."""
    from ...models.making import renewed
    from ...models.moving import moved
    renderer = compat.renderer()
    return datablocks.materials.create(moved(renewed(preset_from(text), renderer), renderer), material=material)


class FACET_FILM_PT_presets(PresetPanel, bpy.types.Panel):
    """Materials that you saved"""

    bl_label = "Presets"
    preset_subdir = FOLDER
    preset_operator = "facet_film.apply_user_preset"
    preset_add_operator = "facet_film.save_user_preset"

    def draw(self, context):
        """Blender's list with its + and −, and the way to another name."""
        super().draw(context)
        self.layout.emboss = "NORMAL"
        self.layout.operator_context = "INVOKE_DEFAULT"
        self.layout.operator("facet_film.rename_user_preset", icon="GREASEPENCIL")


class FACET_FILM_OT_save_user_preset(AddPresetBase, bpy.types.Operator):
    """Save the active material under a name of your own, or delete a saved one"""

    bl_idname = "facet_film.save_user_preset"
    bl_label = "Save Preset"
    preset_menu = "FACET_FILM_PT_presets"
    preset_subdir = FOLDER

    def execute(self, context):
        """Save or delete, as Blender does with its own presets."""
        removing = self.remove_name or self.remove_active
        material = active_material(context)
        if not removing and (material is None or datablocks.materials.model_of(material) is None):
            self.report({"ERROR"}, rpt_("Apply a material of Facet & Film first: there is nothing to save"))
            return {"CANCELLED"}
        return super().execute(context)

    def add(self, context, filepath):
        """Write the file."""
        Path(filepath).write_text(preset_text(active_material(context)), encoding="utf-8")


class FACET_FILM_OT_apply_user_preset(OnObjects, bpy.types.Operator):
    """Make the active material slot the material that you saved"""

    bl_idname = "facet_film.apply_user_preset"
    bl_label = "Apply Saved Preset"
    bl_options = {"REGISTER", "UNDO", "INTERNAL"}

    filepath: bpy.props.StringProperty(subtype="FILE_PATH", options={"SKIP_SAVE", "HIDDEN"})
    menu_idname: bpy.props.StringProperty(options={"SKIP_SAVE", "HIDDEN"})

    def execute(self, context):
        """Read the file, put the material in the slots."""
        try:
            text = _text_of(self.filepath)
            done = put(context, lambda material: material_of(text, material))
        except FacetFilmError as error:
            self.report({"ERROR"}, error.said(rpt_))
            return {"CANCELLED"}
        kind, said = put_said(done)
        self.report({kind}, said)
        return {"FINISHED"}


class FACET_FILM_OT_rename_user_preset(bpy.types.Operator):
    """Give a preset that you saved another name"""

    bl_idname = "facet_film.rename_user_preset"
    bl_label = "Rename Preset"
    bl_options = {"REGISTER", "INTERNAL"}

    old: bpy.props.StringProperty(name="Preset", search=lambda _self, _context, text: _saved(text),
                                  description="The preset to rename")
    new: bpy.props.StringProperty(name="New Name", maxlen=64, description="What to call it")

    @classmethod
    def poll(cls, _context):
        """Needs a saved preset."""
        if not _saved():
            cls.poll_message_set(rpt_("You have saved no preset yet"))
            return False
        return True

    def invoke(self, context, _event):
        """Ask for both names."""
        self.old = self.old or _saved()[0]
        return context.window_manager.invoke_props_dialog(self)

    def execute(self, _context):
        """Rename the file, unless the name is taken."""
        stem = AddPresetBase.as_filename(self.new)
        source = bpy.utils.preset_find(self.old, FOLDER, display_name=True) or bpy.utils.preset_find(self.old, FOLDER)
        if not source or not stem:
            self.report({"ERROR"}, rpt_("Name a saved preset, and a new name with at least one letter"))
            return {"CANCELLED"}
        target = Path(source).with_name(stem + ".py")
        if target.exists():
            self.report({"ERROR"}, rpt_("There is a preset called {:s} already").format(self.new))
            return {"CANCELLED"}
        Path(source).rename(target)
        return {"FINISHED"}


def _text_of(path):
    try:
        return Path(path).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        raise FacetFilmError("The preset {file!r} cannot be read.", file=path) from None


def _saved(text=""):
    """Names of the saved presets that hold a text."""
    names = [bpy.path.display_name(file.name, title_case=False)
             for folder in bpy.utils.preset_paths(FOLDER) for file in sorted(Path(folder).glob("*.py"))]
    return [name for name in names if text.casefold() in name.casefold()]


def draw_header(layout):
    """The button of the saved presets, for a panel's header."""
    FACET_FILM_PT_presets.draw_panel_header(layout)


CLASSES = (FACET_FILM_PT_presets, FACET_FILM_OT_save_user_preset, FACET_FILM_OT_apply_user_preset,
           FACET_FILM_OT_rename_user_preset)
