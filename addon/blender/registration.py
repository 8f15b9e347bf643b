"""What Blender is told when the extension is enabled, and untold when it is disabled."""

import bpy

from . import exporters, layers, settings, translations
from .assets import imported
from .operators import (
    add_group,
    apply,
    apply_to_node,
    asset_library,
    bake,
    check,
    choose,
    common_face,
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
from .operators import layers as layers_operators
from .panels import (
    card,
    material,
    measurement,
    menus,
    node_menu,
    node_sidebar,
    preferences,
    shelves,
    versions,
)
from .panels import finish as finish_panel
from .panels import layers as layers_panel

__all__ = ["register", "unregister"]

CLASSES = (*settings.CLASSES, *apply.CLASSES, *shelves.CLASSES, *choose.CLASSES, *bake.CLASSES, *realisation.CLASSES,
           *common_face.CLASSES,
           *measurements.CLASSES, *fit_brdf.CLASSES, *export.CLASSES, *check.CLASSES, *rebake_all.CLASSES,
           *make_local.CLASSES, *match_space.CLASSES, *principled.CLASSES, *user_presets.CLASSES, *update.CLASSES,
           *asset_library.CLASSES, *finish.CLASSES, *add_group.CLASSES, *apply_to_node.CLASSES, *verify.CLASSES,
           *layers_operators.CLASSES, *material.CLASSES, *layers_panel.CLASSES, *finish_panel.CLASSES,
           *versions.CLASSES, *measurement.CLASSES, *menus.CLASSES, *node_menu.CLASSES, *node_sidebar.CLASSES,
           *preferences.CLASSES)
ATTACHED = (translations, settings, card, menus, node_menu, imported, exporters)
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
    from .assets import library, names, search_items, swatches, thumbnails
    from .datablocks import groups, menu
    from .panels import load_ahead
    for module in (load_ahead, choose, search_items, names, groups, menu, layers):
        module.forget()
    swatches.clear()
    thumbnails.clear()
    library.detach()
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)


def _command(arguments):
    """The shell door inside Blender: the same words as ``python -m addon``."""
    from ..cli import main
    return main(arguments)
