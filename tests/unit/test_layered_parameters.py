"""Layered RGB parameters and presets: ranges, contradictions, what the paper states."""

import math

import pytest

from addon.catalogue.presets import all_presets
from addon.errors import FacetFilmError
from addon.models.layered_rgb.parameters import LayeredRGB
from addon.models.making import made


@pytest.mark.parametrize("parameters, named", [
    ({"ior": (1.0, 1.4, 1.5)}, "ior"), ({"ior": (1.4, 0.9, 1.5)}, "ior"), ({"ior": 1.5}, "ior"),
    ({"ior": (1.4, 1.5)}, "ior"), ({"ior": (1.4, 1.5, math.nan)}, "ior"),
    ({"thickness": -1}, "thickness"), ({"thickness": "thick"}, "thickness"),
    ({"thickness": math.inf}, "thickness"),
    ({"thickness_range": (-1, 30)}, "thickness_range"), ({"thickness_range": (30, 1)}, "thickness_range"),
    ({"thickness_range": 30}, "thickness_range"),
    ({"exponent_r": -0.1}, "exponent_r"), ({"exponent_t": -5}, "exponent_t"),
    ({"deviation": math.pi / 2}, "deviation"), ({"deviation": 10}, "deviation"),
    ({"deviation": -0.1}, "deviation"),
    ({"wavelengths": (0, 525, 445)}, "wavelengths"), ({"specular": 1.5}, "specular"),
    ({"diffuse": -0.1}, "diffuse"),
    ({"scale": "print"}, "scale"), ({"sampling_width": 1.0}, "sampling_width"),
    ({"noise_scale": 0}, "noise_scale"),
    ({"azimuth": math.nan}, "azimuth"), ({"correlated": 1, "thickness_range": (1, 2)}, "correlated"),
    ({"thicknes": 70}, "thickness"),
])
def test_what_cannot_be_used_is_named(parameters, named):
    with pytest.raises(FacetFilmError, match=named):
        LayeredRGB().changed(**parameters)


def test_contradictions_are_errors():
    with pytest.raises(FacetFilmError, match="contradict"):
        LayeredRGB(thickness=70, thickness_range=(66, 76))
    with pytest.raises(FacetFilmError, match="thickness_range"):
        LayeredRGB(correlated=True)


def test_degrees_are_recognised():
    with pytest.raises(FacetFilmError, match="14° are 0.244 radians"):
        LayeredRGB(deviation=14)


def test_a_thickness_takes_the_place_of_a_range():
    varied = LayeredRGB(thickness_range=(66, 76), correlated=True)
    constant = varied.changed(thickness=92)
    assert (constant.thickness, constant.thickness_range, constant.correlated) == (92.0, None, False)
    again = constant.changed(thickness_range=(1, 30))
    assert (again.thickness, again.thickness_range) == (None, (1.0, 30.0))


def test_bounds_are_open_to_their_ends():
    LayeredRGB(thickness=0, exponent_r=0, exponent_t=0, deviation=0, sampling_width=0,
                           ior=(1.001, 1.2, 9.9))


PRESETS = {name: preset for name, preset in all_presets().items() if preset.model == "layered_rgb"}


def layered_preset(name):
    """The parameters of a preset, by its old name too."""
    return made("layered_rgb", name).parameters


@pytest.mark.parametrize("name", PRESETS)
def test_every_preset_is_valid_and_says_what_it_is(name):
    preset = PRESETS[name]
    assert isinstance(layered_preset(name), LayeredRGB)
    assert preset.kind == ("figure" if name.startswith("figure") else "look")
    assert ("not a measurement" in preset.note) == (preset.kind == "look")


def test_the_figures_parameters_are_the_papers():
    figure_2 = {"old metal": ((1, 30), 1.5), "coloured": ((1, 210), 1.3), "clay": ((67, 73), 1.4)}
    for name, (thickness, index) in figure_2.items():
        p = layered_preset(f"figure 2, {name}")
        assert (p.thickness_range, p.ior, p.specular, p.diffuse) == (thickness, (index,) * 3, 0.0, 1.0)
    for name, deviation in (("parallel", 0.0), ("deviation", math.radians(10.0))):
        p = layered_preset(f"figure 3, {name}")
        assert (p.thickness_range, p.ior, p.exponent_r, p.exponent_t) == ((66, 76), (1.4, 1.45, 1.6), 90, 170)
        assert (p.deviation, p.specular, p.diffuse) == (deviation, 1.0, 0.7)
    p = layered_preset("figure_4")
    assert (p.correlated, p.diffuse, p.ior, p.exponent_r) == (True, 0.0, (1.4, 1.45, 1.6), 90)
    for thickness in ((1, 30), (79, 106), (146, 200)):
        p = layered_preset(f"figure 5, {thickness[0]}-{thickness[1]} nm")
        assert (p.thickness_range, p.ior) == (thickness, (1.5, 1.6, 1.8))
        assert (p.exponent_r, p.exponent_t) == (130, 130)
        assert (p.deviation, p.specular, p.diffuse) == (math.radians(14.0), 1.0, 0.5)
    assert sum(preset.kind == "look" for preset in PRESETS.values()) >= 8


def test_an_unknown_preset_is_named_with_the_nearest():
    with pytest.raises(FacetFilmError, match="nacre"):
        layered_preset("nacer")
