"""Every difference between Blender 4.5 and 5.2 that this extension meets, tested by feature."""

import functools

import bpy
from mathutils import Color

__all__ = ["conductor_formula", "converts_colours", "drags_from_shelves", "enable", "enable_nodes", "eevee_engine",
           "has_native_film", "is_enabled", "is_unused_newcomer", "renderer", "set_refraction", "working_space"]


AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


@functools.cache
def conductor_formula():
    """The conductor Fresnel that this Blender evaluates: "exact", or the approximation "blender-4.5".

    The Metallic BSDF got thin-film sockets with the release that made its Fresnel exact.
    """
    thin_film = "Thin Film Thickness"
    tree = bpy.data.node_groups.new(".facet_film probe", "ShaderNodeTree")
    try:
        metallic = tree.nodes.new("ShaderNodeBsdfMetallic")
        exact = any(socket.identifier == thin_film for socket in metallic.inputs)
    finally:
        bpy.data.node_groups.remove(tree)
    return "exact" if exact else "blender-4.5"


def has_native_film():
    """Whether the Metallic BSDF of this Blender has a thin film of its own."""
    return conductor_formula() == "exact"


def working_space():
    """The file's scene-linear space as addon.bake takes it: "Rec.709", "Rec.2020", "ACEScg", or one measured.

    Measured by the matrix that Blender itself converts colours with, so that any OpenColorIO configuration will do.
    """
    return _space_of(tuple(tuple(Color(axis).from_scene_linear_to_xyz_d65()) for axis in AXES))


@functools.lru_cache(maxsize=8)
def _space_of(columns):
    from ..bake.colour import space_of_matrix  # which loads numpy, and enabling the extension does not wait for that
    return space_of_matrix(tuple(zip(*columns)))


def converts_colours():
    """Whether Blender converts the colours of a file's sockets when its space changes and when something is appended.

    From 5.0, whose files say which space they are in.
    """
    return hasattr(bpy.data, "colorspace")


def renderer():
    """What decides which numbers a material needs here, as an addon.models.model.Renderer."""
    from ..models.renderer import Renderer
    return Renderer(conductor_formula(), working_space())


def enable_nodes(material):
    """Give a new material a node tree; from 5.0 it always has one."""
    if material.node_tree is None:
        material.use_nodes = True


def set_refraction(material, refracts, sheet=False):
    """Tell EEVEE whether light is bent by a material, and that the body is as thick as a ball of its size; or that it
    is one sheet, whose colour EEVEE keeps only where it blends.
    """
    material.surface_render_method = "BLENDED" if sheet else "DITHERED"
    material.use_raytrace_refraction = refracts
    if refracts:
        material.thickness_mode = "SPHERE"


def eevee_engine():
    """The identifier of EEVEE, renamed in 5.0."""
    engines = bpy.types.RenderSettings.bl_rna.properties["engine"].enum_items.keys()
    return "BLENDER_EEVEE_NEXT" if "BLENDER_EEVEE_NEXT" in engines else "BLENDER_EEVEE"


def is_unused_newcomer(socket):
    """Whether a socket came to its node after 4.5 and does nothing as it stands: the Metallic BSDF's thin film."""
    thickness = "Thin Film Thickness"
    return (socket.identifier == "Thin Film IOR"
            or socket.identifier == thickness and socket.default_value == 0.0)


def is_enabled(library):
    """Whether an asset library of the preferences is shown; before 5.1 each is."""
    return getattr(library, "enabled", True)


def enable(library, shown):
    """Show an asset library of the preferences or not; False where this Blender can only take it out."""
    if not hasattr(library, "enabled"):
        return False
    library.enabled = shown
    return True


def drags_from_shelves():
    """Whether an asset shelf runs an operator of ours for what is dragged from it, which came with 5.0."""
    return "bl_drag_operator" in bpy.types.AssetShelf.bl_rna.properties
