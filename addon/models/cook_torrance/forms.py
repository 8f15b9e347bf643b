"""A Cook-Torrance material for other programs: what its node holds now, in the light that it was baked in."""

from ... import export
from ...bake import bake
from ...bake.baking import bake_with_index
from ...catalogue.resolving import resolve
from . import MODEL
from .formulas import dyed

__all__ = ["baked_for_export", "principled", "shape", "write_form"]


def write_form(form, record):
    """The text of a form of MODEL.forms.

    form    "json", "csv", "spectrum_csv" or "materialx"
    record  an addon.models.record.Record with a measurement
    """
    if form == "spectrum_csv":
        return export.spectrum_csv(resolve(record.source.meant()).constants)
    baked, p = baked_for_export(record), record.parameters
    if form == "csv":
        return export.curve_csv(baked)
    if form == "materialx":
        return export.materialx(baked, **shape(p))
    return export.json_text({**baked.to_dict(), "diffuse_rgb": dyed(p)[2].tolist(), **_of_the_surface(p),
                             "finish": record.finish})


def baked_for_export(record):
    """The Bake of a record for the exact formula, which other programs evaluate.

    Where the user has changed n or k, or dyes them, colours, curve and fits are those of what
    the node holds, and its difference from the measurement is stated anew.
    """
    source, p = record.source.meant(), record.parameters
    if MODEL.as_baked(p, record.baked) and min(p.tint) == 1.0:
        return bake(source, **record.viewing, formula="exact")
    n, k, _ = (tuple(map(float, channels)) for channels in dyed(p))
    return bake_with_index(source, n, k, **record.viewing)


def principled(record):
    """The settings of a Principled BSDF: see :func:`addon.export.principled.principled_settings`."""
    p = record.parameters
    return export.principled_settings(baked_for_export(record), **shape(p))


def shape(parameters):
    """What the surface adds to a Bake, for other programs."""
    p = parameters
    return {"slopes": p.slopes, "specular": p.specular, "diffuse": tuple(map(float, dyed(p)[2])),
            "anisotropy": p.anisotropy, "rotation": p.rotation}


def _of_the_surface(parameters):
    held = parameters.to_dict()
    return {name: held[name] for name in ("specular", "roughness", "slopes", "anisotropy", "rotation", "distribution")}
