"""What Blender's glTF exporter looks for in an add-on's main module.  Loaded at start-up, so it loads nothing."""

__all__ = ["glTF2ExportUserExtension"]


class glTF2ExportUserExtension:  # noqa: N801  (the exporter's name)
    """Materials of ours leave as glTF has them."""

    def gather_material_hook(self, target, material, settings):
        """Called for each material of the document, once the exporter has done what it can."""
        from .gltf import write_material
        write_material(target, material, settings)
