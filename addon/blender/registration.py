"""What Blender is told when the extension is enabled, and untold when it is disabled."""

import bpy

from . import (asset_library, bake_operator, check_operator, data_operators, load_ahead, material_panel,
               measurement_panel, node_menu, node_sidebar, picker, preferences, realisation_operator,
               rebake_all_operator, settings, thumbnails, translations, updates, user_presets, verify_operator)

__all__ = ["register", "unregister"]

CLASSES = (*settings.CLASSES, *bake_operator.CLASSES, *realisation_operator.CLASSES, *data_operators.CLASSES,
           *check_operator.CLASSES, *rebake_all_operator.CLASSES, *user_presets.CLASSES, *material_panel.CLASSES,
           *updates.CLASSES, *measurement_panel.CLASSES, *material_panel.LAST_CLASSES, *asset_library.CLASSES,
           *node_menu.CLASSES, *node_sidebar.CLASSES, *verify_operator.CLASSES, *preferences.CLASSES)
ATTACHED = (translations, settings, material_panel, node_menu)
COMMAND = "facet_film"
_commands = []


def register():
    """Register every class, the settings that the panels show, menu entries, and ``blender --command facet_film``."""
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    for module in ATTACHED:
        module.attach()
    _commands.append(bpy.utils.register_cli_command(COMMAND, _command))


def unregister():
    """The mirror image of register()."""
    bpy.utils.unregister_cli_command(_commands.pop())
    for module in reversed(ATTACHED):
        module.detach()
    load_ahead.forget()
    picker.forget()
    thumbnails.clear()
    asset_library.detach()
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)


def _command(arguments):
    """The shell door inside Blender: the same words as ``python -m addon``."""
    from ..cli import main
    return main(arguments)
