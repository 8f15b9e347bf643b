"""glTF: the hook of Blender's exporter, which asks each add-on's main module for a glTF2ExportUserExtension."""

from bpy.app.translations import pgettext_rpt as rpt_

from .told import told_of

__all__ = ["write_material"]


def write_material(target, material, settings):
    """Make a material of the document what a material of ours is.

    target    io_scene_gltf2's Material, ready but for this
    material  the bpy.types.Material
    settings  the exporter's, with the log that people see after an export
    """
    from io_scene_gltf2.io.com import gltf2_io
    from io_scene_gltf2.io.com.gltf2_io_extensions import Extension

    from ...export import gltf, lost_in
    told = told_of(getattr(material, "original", material))
    if told is None:
        return
    core, extensions = gltf(told)
    target.pbr_metallic_roughness = gltf2_io.MaterialPBRMetallicRoughness(
        base_color_factor=core["baseColorFactor"], base_color_texture=None, extensions=None, extras=None,
        metallic_factor=core["metallicFactor"], metallic_roughness_texture=None,
        roughness_factor=core["roughnessFactor"])
    target.alpha_mode, target.alpha_cutoff = None, None
    target.emissive_factor = None
    if "KHR_materials_volume" in extensions:
        target.double_sided = False
    target.extensions = {name: Extension(name, value, False) for name, value in extensions.items()}
    for sentence in lost_in(told, "glTF"):
        settings["log"].warning(f"{material.name}: {rpt_(sentence)}")
