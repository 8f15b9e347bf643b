"""What Blender is told when the extension is enabled, and untold when it is disabled."""

import bpy

from . import bake_operator, material_panel, settings

__all__ = ["register", "unregister"]

CLASSES = (*settings.CLASSES, *bake_operator.CLASSES, *material_panel.CLASSES)


def register():
    """Register every class, and the settings that the panel shows."""
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    settings.attach()


def unregister():
    """The mirror image of register()."""
    settings.detach()
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
