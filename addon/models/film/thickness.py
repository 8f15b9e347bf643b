"""Thickness as people have it: noise, a gradient or a texture between two thicknesses, volts, temperature and time."""

from ...operands import clip, dot, less, mix, sqrt, where, z_of
from ...spectra.thickness_laws import ANODISING, HEAT_TINTS
from ..parameters import add_inputs
from .parameters import ANODISING_GROUP, HEAT_TINT_GROUP, TABLE, THICKNESS_GROUP

__all__ = ["build", "build_anodising", "build_heat_tint"]

NOTHING = 1e-12
SPREAD = 1.6
"""Noise keeps to the middle of [0, 1]: spread by this much it reaches both thicknesses."""


def build(builder):
    """Build the group of a thickness that varies."""
    sockets = add_inputs(builder, TABLE, group=THICKNESS_GROUP)
    least, greatest = sockets.least, sockets.greatest
    with builder.frame("Field"):
        own = builder.node("ShaderNodeTexCoord", output="Generated")
        at = where(less(dot(sockets.coordinates, sockets.coordinates), NOTHING), own, sockets.coordinates)
        noise = builder.node("ShaderNodeTexNoise", {
            "Vector": at, "Scale": sockets.noise_scale, "Detail": sockets.noise_detail}, "Fac")
        noise = clip(0.5 + SPREAD * (noise - 0.5), 0.0, 1.0)
        field = mix(sockets.gradient, clip(1.0 - z_of(at), 0.0, 1.0), noise)
        field = mix(sockets.texture_share, sockets.texture, field)
    with builder.frame("Thickness"):
        even = least + (greatest - least) * field
        drained = sqrt(least * least + (greatest * greatest - least * least) * field)
        builder.output("Thickness", mix(sockets.drained, drained, even), description="Thickness in nanometres")
    builder.output("Field", field, description="The field between 0 and 1")


def build_anodising(builder):
    """Build the group of volts: an output a metal."""
    sockets = add_inputs(builder, TABLE, group=ANODISING_GROUP)
    for metal, law in ANODISING.items():
        with builder.frame(metal.capitalize()):
            thickness = law.thickness(sockets.volts)
        builder.output(metal.capitalize(), thickness, description=_said(
            f"Nanometres of oxide, {law.native_nm:g} + {law.nm_per_volt:g} a volt, to {law.volts[1]:g} V", law))


def build_heat_tint(builder):
    """Build the group of temperature and time: an output a metal."""
    sockets = add_inputs(builder, TABLE, group=HEAT_TINT_GROUP)
    for metal, law in HEAT_TINTS.items():
        with builder.frame(metal.title()):
            thickness = law.thickness(sockets.celsius, sockets.hours * law.minutes)
        builder.output(metal.title(), thickness, description=_said(
            f"Nanometres of oxide, exp({law.a:g} - {law.b:g} K/T) sqrt(t/{law.minutes:g} min), to "
            f"{law.celsius[1]:g} °C", law))


def _said(formula, law):
    stack = law.stack.format("d")
    return f"{formula}; for {stack}. {'Estimated' if law.estimated else 'From'}: {law.source}"
