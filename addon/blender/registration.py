"""What Blender is told when the extension is enabled, and untold when it is disabled."""

import bpy

from . import settings, translations
from .assets import imported, library, thumbnails
from .datablocks import groups, menu
from .exporters import usd
from .operators import (
    add_group,
    apply_to_node,
    asset_library,
    bake,
    check,
    export,
    finish,
    fit_brdf,
    make_local,
    match_space,
    measurements,
    principled,
    realisation,
    rebake_all,
    update,
    user_presets,
    verify,
)
from .panels import asset_library as asset_library_panel
from .panels import finish as finish_panel
from .panels import load_ahead, material, measurement, node_menu, node_sidebar, picker, preferences, versions

__all__ = ["register", "unregister"]

CLASSES = (*settings.CLASSES, *bake.CLASSES, *realisation.CLASSES, *measurements.CLASSES, *fit_brdf.CLASSES,
           *export.CLASSES, *check.CLASSES, *rebake_all.CLASSES, *make_local.CLASSES, *match_space.CLASSES,
           *principled.CLASSES, *user_presets.CLASSES, *update.CLASSES, *asset_library.CLASSES, *finish.CLASSES,
           *add_group.CLASSES, *apply_to_node.CLASSES, *verify.CLASSES, *material.CLASSES, *finish_panel.CLASSES,
           *versions.CLASSES, *measurement.CLASSES, *material.LAST_CLASSES, *asset_library_panel.CLASSES,
           *node_menu.CLASSES, *node_sidebar.CLASSES, *preferences.CLASSES)
ATTACHED = (translations, settings, material, node_menu, imported, usd)
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
    for module in (load_ahead, picker, groups, menu):
        module.forget()
    thumbnails.clear()
    library.detach()
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)


def _command(arguments):
    """The shell door inside Blender: the same words as ``python -m addon``."""
    from ..cli import main
    return main(arguments)
