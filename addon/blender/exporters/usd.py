"""USD: what the hook of Blender's exporter writes of a material."""

from bpy.app.translations import pgettext_rpt as rpt_

from .told import told_of

__all__ = ["write_material"]

SURFACE, OPENPBR = "Facet_Film", "Facet_Film_OpenPBR"


def write_material(material, usd_material):
    """Write what a material of ours is, in place of what the exporter found in its nodes; whether it is one."""
    from ...export import lost_in, openpbr, preview_surface
    told = told_of(getattr(material, "original", material))
    if told is None:
        return False
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
