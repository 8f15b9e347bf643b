"""USD: a USDHook, which Blender's exporter calls for each material."""

import importlib.util

import bpy
from bpy.app.translations import pgettext_rpt as rpt_

__all__ = ["attach", "detach"]

SURFACE, OPENPBR = "Facet_Film", "Facet_Film_OpenPBR"


HOOK = getattr(bpy.types, "USDHook", object)
"""What Blender's exporter asks; a Blender that was built without USD has none."""


class FACET_FILM_USD_hook(HOOK):
    """Materials of ours leave as UsdPreviewSurface, and as OpenPBR for programs that read MaterialX"""

    bl_idname = "FACET_FILM_USD_hook"
    bl_label = "Facet & Film"

    @staticmethod
    def on_material_export(_context, material, usd_material):
        """Write what this material is, in place of what the exporter found in its nodes."""
        from .told import told_of
        told = told_of(getattr(material, "original", material))
        if told is None:
            return False
        from ...export import lost_in, openpbr, preview_surface
        _write(usd_material, SURFACE, "UsdPreviewSurface", preview_surface(told), "")
        _write(usd_material, OPENPBR, "ND_open_pbr_surface_surfaceshader", openpbr(told), "mtlx")
        for sentence in lost_in(told, "UsdPreviewSurface"):
            print(f"{material.name}, UsdPreviewSurface: {rpt_(sentence)}")
        return True


def _write(usd_material, name, identifier, values, context):
    """A shader under the material that its surface output of a render context is connected to."""
    from pxr import UsdShade
    stage, prim = usd_material.GetPrim().GetStage(), usd_material.GetPrim()
    shader = UsdShade.Shader.Define(stage, prim.GetPath().AppendChild(name))
    shader.CreateIdAttr(identifier)
    for key, value in values.items():
        kind, given = _typed(value)
        shader.CreateInput(key, kind).Set(given)
    output = usd_material.CreateSurfaceOutput(context) if context else usd_material.CreateSurfaceOutput()
    output.ClearSources()
    output.ConnectToSource(shader.ConnectableAPI(), "surface" if not context else "out")


def _typed(value):
    from pxr import Gf, Sdf
    if isinstance(value, bool):
        return Sdf.ValueTypeNames.Bool, value
    if isinstance(value, tuple):
        return Sdf.ValueTypeNames.Color3f, Gf.Vec3f(*map(float, value))
    return Sdf.ValueTypeNames.Float, float(value)


def attach():
    """Register the hook where USD's Python module is to be had: Blender ends at once where it calls one without."""
    if HOOK is not object and importlib.util.find_spec("pxr") is not None:
        bpy.utils.register_class(FACET_FILM_USD_hook)


def detach():
    """Take it back."""
    if getattr(FACET_FILM_USD_hook, "is_registered", False):
        bpy.utils.unregister_class(FACET_FILM_USD_hook)
