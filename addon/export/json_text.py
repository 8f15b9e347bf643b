"""A bake as JSON."""

import json

__all__ = ["bake_json"]


def bake_json(bake):
    """Everything that an addon.bake.Bake holds, as JSON text.

    bake  a Bake

    >>> from addon.bake import bake
    >>> json.loads(bake_json(bake("copper")))["source"]["dataset"]
    'main/Cu/Johnson'
    """
    return json.dumps(bake.to_dict(), ensure_ascii=False, indent=1, allow_nan=False) + "\n"
