"""The node groups that a shader can be made of by hand: those of the models and finishes, and the Fresnel ramp."""

import functools

from ...models import all_models
from .ramps import RAMP_ID

__all__ = ["forget", "group_items", "parts"]

RAMP = (RAMP_ID, "Fresnel Ramp", "Colour of a preset's mirror over the angle, for any shader")


def parts():
    """[[(group's id, title, summary), …] of each model, of the finishes, and of what belongs to none]."""
    from ...finishes.groups import GROUPS
    return [[(group.identifier, group.name, group.summary) for group in model.groups if group.in_menu]
            for model in all_models()] + [[(group.identifier, group.name, group.summary) for group in GROUPS], [RAMP]]


@functools.lru_cache(maxsize=1)
def group_items():
    """All of them, as items of an enumeration; Blender needs their texts to live on."""
    return [item for part in parts() for item in part]


def forget():
    """Ask the models anew."""
    group_items.cache_clear()
