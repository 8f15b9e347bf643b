"""The ways from a formula to a Cycles material.  Read when Blender starts, so it loads nothing."""

from typing import NamedTuple

__all__ = ["REALISATIONS", "Realisation"]


class Realisation(NamedTuple):
    """A way from a formula to a Cycles material.

    title        what people call it
    tip          one sentence on when to take it
    native       whether the renderer's own closures draw it, with its own Fresnel term
    osl          whether it is a script, which needs Open Shading Language
    without_osl  name of the realisation that a script's material shows where Open Shading Language is off
    """

    title: str
    tip: str
    native: bool = False
    osl: bool = False
    without_osl: str = ""


REALISATIONS = {
    "fast": Realisation("Fast", "Native closures: light-sampled, on every device, and in EEVEE", native=True),
    "exact": Realisation("Exact", "The published formula itself, sampled with nodes alone, on every device; "
                                  "EEVEE shows Fast"),
    "dispersive": Realisation("Dispersive", "Every wavelength refracted by its own index, for rainbows in gems and "
                                            "prisms; noisier, and EEVEE shows it without them", native=True),
    "osl": Realisation("OSL", "The published formula itself as an OSL script: needs Open Shading Language switched on "
                              "in Render properties, on the CPU or OptiX; EEVEE shows Fast", osl=True,
                       without_osl="exact"),
    "osl_fast": Realisation("OSL Fast", "Native closures from an OSL script: needs Open Shading Language switched on",
                            native=True, osl=True, without_osl="fast"),
}
"""Every realisation that a model may have, by its name."""
