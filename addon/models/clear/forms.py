"""A clear material for other programs."""

import numpy as np

from ... import export
from ...export.standin import LOST, Standin
from ..standins import standin_of
from .formulas import sigma_of

__all__ = ["standin", "write_form"]

FARTHEST = 1e3
"""Metres beyond which what is left of the light is not asked for."""


def write_form(form, record):
    """The text of a form: "materialx"; or "json", what was baked, the parameters, and both as glTF and OpenPBR say."""
    found = standin_of(record)
    if form == "materialx":
        source = record.baked["source"]
        said = "; ".join((record.title, *(source[key] for key in ("dataset", "k_dataset", "citation", "licence"))))
        return export.materialx_of_standin(record.baked["name"], said, found)
    core, extensions = export.gltf(found)
    return export.json_text({**record.baked, "parameters": record.parameters.to_dict(),
                             "gltf": {"pbrMetallicRoughness": core, "extensions": extensions},
                             "openpbr": export.openpbr(found)})


def standin(record):
    """The Standin, its lengths in scene units, which glTF and USD take for metres."""
    p = record.parameters
    colour, distance = _body(p)
    lost = (LOST["shadows"],) if p.see_through > 0.0 else ()
    return Standin(tuple(p.tint), roughness=p.roughness, ior=p.ior / p.outside if p.outside > 0.0 else p.ior,
                   transmission=1.0, thin_walled=p.walls == "thin", attenuation=(colour, distance / p.scene_scale),
                   thickness=p.thickness / p.scene_scale, abbe=record.baked.get("abbe"), lost=lost)


def _body(parameters):
    """(colour, distance in metres): what white light is after the distance, at which its middle channel is a half."""
    p = parameters
    sigma = sigma_of(np.array(p.absorption), np.array(p.depth_colour), p.depth, p.concentration, 1.0)
    middle = float(np.median(sigma))
    if middle <= np.log(2.0) / FARTHEST:
        return tuple(np.exp(-sigma * p.depth).tolist()), p.depth
    return tuple(np.exp(-sigma * np.log(2.0) / middle).tolist()), float(np.log(2.0) / middle)
