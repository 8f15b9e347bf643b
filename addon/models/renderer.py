"""The renderer that a material is made for."""

from typing import NamedTuple

__all__ = ["Renderer"]


class Renderer(NamedTuple):
    """What decides which numbers a material needs.

    formula  the conductor Fresnel that the renderer's closures evaluate: one of addon.bake.FORMULAS
    space    the scene-linear space of the file
    """

    formula: str = "exact"
    space: str = "Rec.709"
