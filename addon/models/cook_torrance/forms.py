"""A Cook-Torrance material for other programs: what its node holds now, in the light that it was baked in."""

import numpy as np

from ... import export
from ...bake import bake
from ...bake.baking import bake_with_index
from ...bake.standin_fit import COS_THETA, fit_dielectric, fit_metal, fit_mirror
from ...catalogue.resolving import resolve
from ...export.standin import LOST, Standin, index_of
from ...reflectance import fresnel
from ..moving import moved
from ..standins import standin_of
from . import MODEL
from .formulas import dyed

__all__ = ["baked_for_export", "shape", "standin", "write_form"]

LARGEST_DIELECTRIC_K = 0.1
"""k below which F is a dielectric's: k² is less than 0.2 % of (n+1)² there."""


def write_form(form, record):
    """The text of a form of MODEL.forms.

    form    "json", "csv", "spectrum_csv" or "materialx"
    record  an addon.models.record.Record with a measurement
    """
    if form == "spectrum_csv":
        return export.spectrum_csv(resolve(record.source.meant()).constants)
    if form == "materialx":
        here = record if record.viewing["space"] in export.COLOUR_SPACES else moved(record)
        return export.materialx(baked_for_export(here), **shape(here.parameters), standin=standin_of(record))
    baked, p = baked_for_export(record), record.parameters
    if form == "csv":
        return export.curve_csv(baked)
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


def standin(record):
    """The Standin: a metal by base colour and edge tint, a diffuse colour under a clear coat, or a metal with a share.

    A metal's mirror and a coat are fitted at the angles that a ball shows.
    """
    p = record.parameters
    (n, k, diffuse), s = (np.array(channels) for channels in dyed(p)), p.specular
    mirror = fresnel.conductor(COS_THETA[:, None], n, k)
    seen = s * sum(w for _, w in p.slopes) * mirror + (1.0 - s) * diffuse
    surface = {"roughness": min(_slope(p) ** 0.5, 1.0), "anisotropy": p.anisotropy, "rotation": p.rotation,
               "lost": _lost(p)}
    if k.max() < LARGEST_DIELECTRIC_K:
        fit = fit_dielectric(seen, float(s * mirror[-1].mean()))
        return Standin(fit.base, ior=max(index_of(fit.beside[0]), 1.0), delta_e=(fit.delta_e_mean,) * 2, **surface)
    if s < 1.0:
        fit = fit_metal(seen, s)
        return Standin(fit.base, fit.beside[0], specular=0.0, delta_e=(fit.delta_e_mean,) * 2, **surface)
    fit, alone = fit_mirror(seen), fit_mirror(seen, with_edge=False)
    return Standin(fit.base, 1.0, edge=fit.beside, base_alone=alone.base,
                   delta_e=(fit.delta_e_mean, alone.delta_e_mean), **surface)


def _slope(parameters):
    """The rms slope of all facets together."""
    return (sum(w * m * m for m, w in parameters.slopes) / sum(w for _, w in parameters.slopes)) ** 0.5


def _lost(parameters):
    """What no such shader has."""
    return (LOST["facets"], LOST["slopes"]) if len(parameters.slopes) > 1 else (LOST["facets"],)


def shape(parameters):
    """What the surface adds to a Bake, for other programs."""
    p = parameters
    return {"slopes": p.slopes, "specular": p.specular, "diffuse": tuple(map(float, dyed(p)[2])),
            "anisotropy": p.anisotropy, "rotation": p.rotation}


def _of_the_surface(parameters):
    held = parameters.to_dict()
    return {name: held[name] for name in ("specular", "roughness", "slopes", "anisotropy", "rotation", "distribution")}
