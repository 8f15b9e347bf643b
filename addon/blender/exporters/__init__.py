"""What Blender's exporters find of materials of ours, each by the hook that it has.

It is here when Blender starts; what a hook does loads when an exporter calls it.
"""

from importlib.machinery import PathFinder

import bpy

__all__ = ["attach", "detach", "glTF2ExportUserExtension"]

USD_HOOK = getattr(bpy.types, "USDHook", object)
"""What the exporter of USD asks; a Blender that was built without has none."""


class glTF2ExportUserExtension:  # noqa: N801  (the exporter's name, looked for in an add-on's main module)
    """Materials of ours leave as glTF has them."""

    def gather_material_hook(self, target, material, settings):
        """Called for each material of the document, once the exporter has done what it can."""
        from .gltf import write_material
        write_material(target, material, settings)


class FACET_FILM_USD_hook(USD_HOOK):
    """Materials of ours leave as UsdPreviewSurface, and as OpenPBR for programs that read MaterialX"""

    bl_idname = "FACET_FILM_USD_hook"
    bl_label = "Facet & Film"

    @staticmethod
    def on_material_export(_context, material, usd_material):
        """Called for each material; whether it was one of ours."""
        from .usd import write_material
        return write_material(material, usd_material)


def _file_export_opens(_menu, _context):
    """Drawn with the menu File, Export: nothing is shown."""
    from .standins import when_export_opens
    when_export_opens()


def attach():
    """Be found: by USD's where its Python module is to be had, as Blender ends at once where it calls one without."""
    if USD_HOOK is not object and PathFinder.find_spec("pxr") is not None:
        bpy.utils.register_class(FACET_FILM_USD_hook)
    bpy.types.TOPBAR_MT_file_export.append(_file_export_opens)


def detach():
    """Take it all back."""
    from .standins import forget
    bpy.types.TOPBAR_MT_file_export.remove(_file_export_opens)
    if getattr(FACET_FILM_USD_hook, "is_registered", False):
        bpy.utils.unregister_class(FACET_FILM_USD_hook)
    forget()
