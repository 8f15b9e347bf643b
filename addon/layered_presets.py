"""Presets of the layered RGB model: every parameter set of the paper's figures, and looks of our own.

A figure's preset holds what the paper states (X. Granier, W. Heidrich, "A Simple
Layered RGB BRDF Model", Graphical Models 65(4), 2003); what it leaves open is
said in the note.  A look is a heuristic: chosen by eye, no measurement.
"""

import math
from dataclasses import dataclass, field

from .errors import choice
from .layered_parameters import LayeredRGB

__all__ = ["LayeredPreset", "PRESETS", "layered_preset"]

LOOK = "A heuristic look, chosen by eye; not a measurement."
NOISE = " Scale and detail of the noise are not stated."


@dataclass(frozen=True)
class LayeredPreset:
    """Title, kind ("figure" or "look"), a note for the user, and what differs from the default parameters."""

    title: str
    kind: str
    note: str
    parameters: dict = field(default_factory=dict)

    def layered_rgb(self):
        """The parameters as a checked LayeredRGB.

        >>> layered_preset("figure 5, 79-106 nm").layered_rgb().thickness_range
        (79.0, 106.0)
        """
        return LayeredRGB().changed(**self.parameters)


def _diffuse(thickness_range, index, **parameters):
    return dict(thickness_range=thickness_range, ior=(index,) * 3, specular=0.0, diffuse=1.0, **parameters)


FIGURE_3 = dict(ior=(1.4, 1.45, 1.6), exponent_r=90.0, exponent_t=170.0)
FIGURE_5 = dict(ior=(1.5, 1.6, 1.8), exponent_r=130.0, exponent_t=130.0, deviation=math.radians(14.0),
                specular=1.0, diffuse=0.5)

PRESETS = {
    "figure 2, old metal": LayeredPreset(
        "Figure 2: old metal", "figure", "Diffuse part only, 1 to 30 nm, index 1.5: a grey that grows warm and "
        "dark with the thickness." + NOISE,
        _diffuse((1, 30), 1.5)),
    "figure 2, coloured": LayeredPreset(
        "Figure 2: coloured", "figure", "Diffuse part only, 1 to 210 nm, index 1.3." + NOISE,
        _diffuse((1, 210), 1.3)),
    "figure 2, clay": LayeredPreset(
        "Figure 2: clay", "figure", "Diffuse part only, 67 to 73 nm, index 1.4." + NOISE,
        _diffuse((67, 73), 1.4)),
    "figure 3, parallel": LayeredPreset(
        "Figure 3: parallel boundaries", "figure",
        "66 to 76 nm, exponents 90 and 170, Phong to diffuse 1 to 0.7." + NOISE,
        dict(FIGURE_3, thickness_range=(66, 76), diffuse=0.7)),
    "figure 3, deviation": LayeredPreset(
        "Figure 3: constant deviation 10°", "figure",
        "As figure 3 with the lower boundary tilted by 10°; its azimuth is not stated." + NOISE,
        dict(FIGURE_3, thickness_range=(66, 76), diffuse=0.7, deviation=math.radians(10.0))),
    "figure 4": LayeredPreset(
        "Figure 4: deviation correlated with the thickness", "figure",
        "Phong part only. Thickness, indices and exponents are not stated: figure 3's; nor is the strength "
        "of the deviation." + NOISE,
        dict(FIGURE_3, thickness_range=(66, 76), diffuse=0.0, deviation=math.radians(4.0), correlated=True)),
    "figure 5, 1-30 nm": LayeredPreset(
        "Figure 5: 1 to 30 nm", "figure", "Indices 1.5, 1.6, 1.8, exponents 130, deviation 14°." + NOISE,
        dict(FIGURE_5, thickness_range=(1, 30))),
    "figure 5, 79-106 nm": LayeredPreset(
        "Figure 5: 79 to 106 nm", "figure", "Indices 1.5, 1.6, 1.8, exponents 130, deviation 14°." + NOISE,
        dict(FIGURE_5, thickness_range=(79, 106))),
    "figure 5, 146-200 nm": LayeredPreset(
        "Figure 5: 146 to 200 nm", "figure", "Indices 1.5, 1.6, 1.8, exponents 130, deviation 14°." + NOISE,
        dict(FIGURE_5, thickness_range=(146, 200))),
    "soap film": LayeredPreset(
        "Soap film", "look", LOOK,
        dict(thickness_range=(120, 520), noise_scale=1.2, noise_detail=1.0, ior=(1.331, 1.335, 1.341),
             exponent_r=900.0, exponent_t=900.0, diffuse=0.0)),
    "oil on water": LayeredPreset(
        "Oil on water", "look", LOOK,
        dict(thickness_range=(150, 480), noise_scale=1.6, noise_detail=3.0, ior=(1.46, 1.47, 1.49),
             exponent_r=500.0, exponent_t=350.0, deviation=math.radians(3.0), correlated=True, diffuse=0.05)),
    "nacre": LayeredPreset(
        "Nacre", "look", LOOK,
        dict(thickness_range=(140, 205), noise_scale=1.5, noise_detail=2.0, ior=(1.53, 1.55, 1.58),
             exponent_r=60.0, exponent_t=30.0, deviation=math.radians(5.0), correlated=True,
             specular=0.5, diffuse=0.8)),
    "beetle": LayeredPreset(
        "Beetle", "look", LOOK,
        dict(thickness_range=(56, 75), noise_scale=0.8, noise_detail=0.0, ior=(2.98, 4.0, 4.8),
             exponent_r=60.0, exponent_t=600.0, deviation=math.radians(3.0), correlated=True,
             specular=0.1, diffuse=0.3)),
    "tempered steel": LayeredPreset(
        "Tempered steel", "look", LOOK,
        dict(thickness_range=(10, 76), noise_scale=0.85, noise_detail=0.0, ior=(2.7, 2.7, 2.7),
             exponent_r=80.0, exponent_t=250.0, specular=0.25, diffuse=0.5)),
    "old bronze": LayeredPreset(
        "Old bronze", "look", LOOK,
        dict(thickness_range=(43, 60), noise_scale=2.2, noise_detail=7.0, ior=(2.1, 3.65, 2.7),
             exponent_r=40.0, exponent_t=120.0, specular=0.07, diffuse=0.55)),
    "clay": LayeredPreset(
        "Clay", "look", LOOK,
        dict(thickness_range=(25, 31), noise_scale=7.0, noise_detail=8.0, ior=(1.9, 2.4, 2.7),
             exponent_r=6.0, exponent_t=10.0, specular=0.015, diffuse=0.7)),
    "pearl lacquer": LayeredPreset(
        "Pearl lacquer", "look", LOOK,
        dict(thickness_range=(185, 215), noise_scale=0.8, noise_detail=0.0, ior=(1.6, 1.62, 1.66),
             exponent_r=2000.0, exponent_t=30.0, specular=0.35, diffuse=0.7)),
    "raku glaze": LayeredPreset(
        "Raku glaze", "look", LOOK,
        dict(thickness_range=(20, 190), noise_scale=2.5, noise_detail=6.0, ior=(1.5, 1.55, 1.65),
             exponent_r=160.0, exponent_t=60.0, deviation=math.radians(8.0), correlated=True,
             specular=0.6, diffuse=0.6)),
    "heat-tinted titanium": LayeredPreset(
        "Heat-tinted titanium", "look", LOOK,
        dict(thickness_range=(20, 125), noise_scale=0.7, noise_detail=0.0, ior=(2.4, 2.5, 2.6),
             exponent_r=60.0, exponent_t=200.0, specular=0.25, diffuse=0.5)),
}


def layered_preset(name):
    """The preset of this name.

    Raises FacetFilmError with the nearest names for an unknown one.

    >>> layered_preset("nacre").kind
    'look'
    """
    return PRESETS[choice("preset", name, PRESETS)]
