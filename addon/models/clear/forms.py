"""A clear material for other programs."""

from ...export import json_text
from .formulas import sigma_of

__all__ = ["gltf", "openpbr", "principled", "write_form"]

import numpy as np

FARTHEST = 1e3
"""Metres beyond which what is left of the light is not asked for."""


def write_form(_form, record):
    """The text of the form "json": what was baked, the parameters, and both as glTF and OpenPBR call them."""
    return json_text({**record.baked, "parameters": record.parameters.to_dict(), "gltf": gltf(record),
                      "openpbr": openpbr(record)})


def _body(parameters):
    """(colour, distance in metres): what white light is after the distance, at which its middle channel is a half."""
    p = parameters
    sigma = sigma_of(np.array(p.absorption), np.array(p.depth_colour), p.depth, p.concentration, 1.0)
    middle = float(np.median(sigma))
    if middle <= np.log(2.0) / FARTHEST:
        return tuple(np.exp(-sigma * p.depth).tolist()), p.depth
    return tuple(np.exp(-sigma * np.log(2.0) / middle).tolist()), float(np.log(2.0) / middle)


def _abbe(record):
    return record.baked.get("abbe")


def gltf(record):
    """The extensions KHR_materials_ior, _transmission, _volume and _dispersion."""
    p, (colour, distance) = record.parameters, _body(record.parameters)
    thin = p.walls == "thin"
    found = {"KHR_materials_ior": {"ior": p.ior}, "KHR_materials_transmission": {"transmissionFactor": 1.0}}
    if not thin:
        found["KHR_materials_volume"] = {"thicknessFactor": p.thickness, "attenuationColor": list(colour),
                                         "attenuationDistance": distance}
    if _abbe(record) and not thin:
        found["KHR_materials_dispersion"] = {"dispersion": 20.0 / _abbe(record)}
    return {"pbrMetallicRoughness": {"baseColorFactor": [*p.tint, 1.0], "metallicFactor": 0.0,
                                     "roughnessFactor": p.roughness}, "extensions": found}


def openpbr(record):
    """OpenPBR's parameters, which MaterialX's open_pbr_surface takes by the same names."""
    p, (colour, distance) = record.parameters, _body(record.parameters)
    found = {"specular_ior": p.ior, "specular_roughness": p.roughness, "transmission_weight": 1.0,
             "transmission_color": list(colour), "transmission_depth": distance,
             "geometry_thin_walled": p.walls == "thin"}
    if _abbe(record):
        found.update(transmission_dispersion_scale=1.0, transmission_dispersion_abbe_number=_abbe(record))
    return found


def principled(record):
    """Settings of a Principled BSDF: its base colour is the transmittance of one face, Thickness deep by two."""
    p = record.parameters
    sigma = sigma_of(np.array(p.absorption), np.array(p.depth_colour), p.depth, p.concentration, 1.0)
    colour = np.exp(-0.5 * sigma * p.thickness) * np.sqrt(p.tint)
    return {"Base Color": (*colour.tolist(), 1.0), "Metallic": 0.0, "Roughness": p.roughness, "IOR": p.ior,
            "Transmission Weight": 1.0}
