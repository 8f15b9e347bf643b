"""Fresnel ramps in the open file: one node group a baked curve, found again by its contents."""

import hashlib
import json

import bpy

from .fingerprints import ID_KEY
from .groups import VERSION_KEY

__all__ = ["RAMP_ID", "fresnel_ramp_group"]

RAMP_ID = "fresnel_ramp"
CURVE_KEY = "facet_film_curve"


def fresnel_ramp_group(baked):
    """The ramp group of a baked material, built where the file has none with the same curve."""
    from ...nodes import fresnel_ramp
    record = baked.to_dict()
    cos_theta, rgb = record["fresnel"]["cos_theta"], record["fresnel"]["rgb"]
    stamp = hashlib.sha256(json.dumps([record["name"], cos_theta, rgb]).encode()).hexdigest()[:16]
    for tree in bpy.data.node_groups:
        if (tree.get(ID_KEY) == RAMP_ID and tree.get(VERSION_KEY) == fresnel_ramp.VERSION
                and tree.get(CURVE_KEY) == stamp and not tree.library):
            return tree
    tree = fresnel_ramp.build()
    tree.name = f"{fresnel_ramp.NAME} {record['title']}"
    fresnel_ramp.set_curve(tree, cos_theta, rgb)
    tree[ID_KEY] = RAMP_ID
    tree[VERSION_KEY] = fresnel_ramp.VERSION
    tree[CURVE_KEY] = stamp
    return tree
