"""Every function of the OSL scripts against the formula that it repeats, at the same arguments.

The formulas are written once, in numpy, and a second time in OSL, for people to read: what one of them says and
the other does not shows here, function by function, where pictures would bury it in noise.
"""

import numpy as np
import pytest

from addon import models
from tests import osl_probe
from tests.render import osl_cook_torrance, osl_film, osl_layered_rgb
from tests.render.osl_grids import joined

SCRIPTS = [osl_cook_torrance, osl_film, osl_layered_rgb]

TOLERANCE = 1e-5
"""Of a result up to 1, and as a share of larger ones: single precision has no more than 6e-8 of each."""


def source_of(script):
    return (models.named(script.SCRIPT.removesuffix(".osl")).folder / script.SCRIPT).read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def returned():
    """What the functions of each script return, by script and signature: one render a script."""
    return {script: osl_probe.call_all(source_of(script), arguments_of(script)) for script in SCRIPTS}


def arguments_of(script):
    return {key: arguments for key, (_formula, arguments) in script.FORMULAS.items()}


def largest_difference(script, key, found):
    """The largest difference of a result, in units of 1 or of the larger result, and the words for where it is."""
    formula, arguments = script.FORMULAS[key]
    expected = joined(formula(*arguments))
    assert found.shape == expected.shape
    off = np.nan_to_num(np.abs(found - expected) / np.maximum(np.abs(expected), 1.0), nan=np.inf)
    case, number = np.unravel_index(np.argmax(off), off.shape)
    return off.max(), f"number {number} of {key} is off by {off.max():.2g} at {osl_probe.flattened(arguments)[case]}"


@pytest.mark.parametrize("script, key", [(script, key) for script in SCRIPTS for key in script.FORMULAS],
                         ids=lambda value: value if isinstance(value, str) else value.SCRIPT)
def test_a_function_gives_what_the_formula_gives(script, key, returned):
    off, where = largest_difference(script, key, returned[script][key])
    assert off < TOLERANCE, where


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda script: script.SCRIPT)
def test_no_function_is_left_out(script):
    defined = [function.key for function in osl_probe.functions_of(source_of(script))]
    assert sorted(defined) == sorted([*script.FORMULAS, *script.NOT_COMPARED])


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda script: script.SCRIPT)
def test_only_closures_and_random_numbers_are_let_off(script):
    for function in osl_probe.functions_of(source_of(script)):
        if function.key in script.NOT_COMPARED:
            assert function.type == "closure color" or function.name == "random"


@pytest.mark.parametrize("script, key, right, wrong", [
    (osl_cook_torrance, "gaussian_c(float, float)", "-0.66751", "-0.66761"),
    (osl_cook_torrance, "sharpened_v_cavity(Facet)", "1.69 * change", "1.68 * change"),
    (osl_layered_rgb, "f_normal(float)", "(r1 - 1.0) * (r1 - 1.0)", "(r1 - 1.0)"),
    (osl_layered_rgb, "peak_of(Plane, output float, output float)", "step = 0.62 * sigma", "step = 0.61 * sigma"),
], ids=lambda value: value if isinstance(value, str) and "(" in value else "")
def test_a_wrong_constant_shows(script, key, right, wrong):
    source = source_of(script)
    assert source.count(right) == 1
    found = osl_probe.call_all(source.replace(right, wrong), {key: script.FORMULAS[key][1]})
    assert largest_difference(script, key, found[key])[0] > TOLERANCE


def test_functions_are_found_whatever_they_take():
    source = """
struct Pair { float a, b; };  // float not_this(float x) {
float one(float x) { return x; }
void two(vector v[4], output Pair p,
         output int n)
{
}
closure color three(Pair p) { return 0; }
shader four(float x = 1.0)
{
}
"""
    assert [function.key for function in osl_probe.functions_of(source)] == [
        "one(float)", "two(vector[4], output Pair, output int)", "three(Pair)"]
    assert osl_probe.structs_of(source) == {"Pair": [("float", "a"), ("float", "b")]}
