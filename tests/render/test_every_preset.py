"""Every preset of both models by every realisation, and materials at the ends of every parameter's range: they build,
and render finite pixels that are lit.

All of them at once, each on a tile of its own, under an even sky and a sun.
"""

import itertools
import math

import bpy
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from addon import api, models
from addon.catalogue import presets
from addon.errors import FacetFilmError
from tests.render import probes

PIXELS = 3
MOST = 20.0
"""Radiance that no tile exceeds in a sky of 1 and a sun of irradiance 0.2, at energy scale."""

WAYS = [(model.name, realisation) for model in models.all_models() for realisation in model.realisations]
NAMES = {model: [name for name, preset in presets.all_presets().items() if preset.model == model]
         for model in models.names()}


def tiles(make, count, osl):
    """Pixels of each tile, ``(count, PIXELS², 3)``; make(number) gives its material."""
    side = math.ceil(math.sqrt(count))
    scene = probes.empty_scene(side * PIXELS, samples=4, osl=osl, extent=side)
    probes.set_world(scene, 1.0)
    probes.add_sun(scene, 0.3, strength=0.2, diameter=0.5)
    mesh = bpy.data.meshes.new("Tile")
    mesh.from_pydata([(-0.5, -0.5, 0.0), (0.5, -0.5, 0.0), (0.5, 0.5, 0.0), (-0.5, 0.5, 0.0)], [], [(0, 1, 2, 3)])
    for number in range(count):
        tile = bpy.data.objects.new("Tile", mesh.copy())
        tile.data.materials.append(make(number))
        tile.location = (number % side + 0.5 - side / 2, number // side + 0.5 - side / 2, 0.0)
        scene.collection.objects.link(tile)
    picture = probes.render(scene).reshape(side, PIXELS, side, PIXELS, 3).swapaxes(1, 2)
    return picture.reshape(side * side, PIXELS * PIXELS, 3)[:count]


def faults(pixels, names, most=MOST):
    """What is wrong with each tile that is wrong."""
    found = {}
    for name, tile in zip(names, pixels):
        if not np.isfinite(tile).all():
            found[name] = "not finite"
        elif tile.min() < 0.0 or tile.max() > most or tile.mean() <= 0.0:
            found[name] = f"from {tile.min():g} to {tile.max():g}"
    return found


@pytest.mark.parametrize("model, realisation", WAYS)
def test_every_preset_renders(model, realisation):
    names = NAMES[model]
    pixels = tiles(lambda i: api.create_material(model, preset=names[i], realisation=realisation), len(names),
                   realisation.startswith("osl"))
    assert not faults(pixels, names)


def test_a_tile_that_is_not_finite_or_dark_or_too_bright_is_found():
    pixels = np.ones((4, 9, 3))
    pixels[1, 3, 2], pixels[2], pixels[3, 0, 0] = np.nan, 0.0, 100.0
    assert set(faults(pixels, "abcd")) == {"b", "c", "d"}


# --- The ends of every range ---

SLOPES = [((1e-3, 1.0),), ((1.0, 1.0),), ((1e-3, 0.5), (1.0, 0.5)), ((0.3, 0.25),) * 4]
EXTREMES = {
    "cook_torrance": {
        "slopes": SLOPES, "distribution": ["beckmann", "gaussian"], "specular": [0.0, 1.0],
        "n": [(1e-3,) * 3, (100.0,) * 3, (1.0,) * 3, (1e-3, 1.0, 100.0)], "k": [(0.0,) * 3, (100.0,) * 3],
        "diffuse": [(0.0,) * 3, (1.0,) * 3], "scale": ["energy", "published"], "gaussian_c": [0.0, 1000.0],
        "sampling_width": [0.0, 0.01, 1.0]},
    "clear": {
        "roughness": [0.0, 1.0], "tint": [(0.0,) * 3, (1.0,) * 3], "depth_colour": [(0.0,) * 3, (1.0,) * 3],
        "depth": [1e-6, 1e6], "concentration": [0.0, 1e6], "absorption": [(0.0,) * 3, (1e9,) * 3],
        "scene_scale": [1e-9, 1.0, 1e9], "ior": [1.0, 10.0], "outside": [1.0, 10.0], "dispersion": [0.0, 10.0],
        "cauchy_b": [-1.0, 0.0, 1.0], "cauchy_c": [-1.0, 0.0, 1.0], "walls": ["solid", "thin"],
        "thickness": [0.0, 1e6], "see_through": [0.0, 1.0]},
    "layered_rgb": {
        "thickness": [0.0, 1.0, 1e5], "ior": [(1.0001,) * 3, (10.0,) * 3, (1.0001, 1.5, 10.0)],
        "wavelengths": [(1.0,) * 3, (1e4,) * 3], "exponent_r": [0.0, 1e5], "exponent_t": [0.0, 1e5],
        "deviation": [0.0, 1e-6, 1.57], "azimuth": [-1e6, 0.0, 1e6], "specular": [0.0, 1.0], "diffuse": [0.0, 1.0],
        "scale": ["energy", "published"], "sampling_width": [0.0, 0.01, 0.9]},
    "film": {
        "thickness": [0.0, 1.0, 2e4], "roughness": [0.0, 1e-3, 1.0], "specular": [0.0, 1.0], "see_through": [0.0, 1.0],
        "diffuse": [(0.0,) * 3, (1.0,) * 3], "sampling_width": [0.0, 0.01, 1.0],
        "stack": ["TiO2 0-200 nm / Ti", "SiO2 300 nm / Si", "1.4 0-0 nm / glass"]},
}
COUNT = 80


def extreme(model, number):
    """Some combination of extremes; every value comes up."""
    random = np.random.default_rng(number)
    return {name: values[(number + random.integers(len(values))) % len(values)]
            for name, values in EXTREMES[model].items()}


@pytest.mark.parametrize("model, realisation", WAYS)
def test_extremes_render_finite_pixels(model, realisation):
    pixels = tiles(lambda i: api.create_material(model, realisation=realisation, **extreme(model, i)), COUNT,
                   realisation.startswith("osl"))
    wrong = {i: extreme(model, i) for i in range(COUNT) if not np.isfinite(pixels[i]).all() or pixels[i].min() < 0.0}
    assert not wrong


@pytest.mark.parametrize("model", EXTREMES)
def test_every_extreme_comes_up(model):
    for name, values in EXTREMES[model].items():
        assert {repr(extreme(model, i)[name]) for i in range(COUNT)} == {repr(value) for value in values}


# --- Anything at all as a parameter ---

FIELDS = {model.name: model.parameters for model in models.all_models()}
PARAMETERS = [(model, name) for model, fields in FIELDS.items() for name in fields.__dataclass_fields__]
scalars = st.one_of(st.floats(), st.integers(), st.text(max_size=5), st.booleans(), st.none(),
                    st.sampled_from([math.nan, math.inf, -math.inf, -0.0, 1e308, 1e-320, "beckmann", "published",
                                     b"1"]))
anything = st.one_of(scalars, st.lists(scalars, max_size=4), st.lists(st.tuples(scalars, scalars), max_size=5),
                     st.tuples(st.floats(0.0, 2.0), st.floats(0.0, 2.0), st.floats(0.0, 2.0)),
                     st.lists(st.tuples(st.floats(0.0, 1.0), st.floats(0.0, 1.0)), min_size=1, max_size=4),
                     st.dictionaries(st.text(max_size=2), scalars, max_size=2), st.just(np.zeros(3)), st.just(object))


@pytest.mark.parametrize("model, name", PARAMETERS)
@settings(max_examples=60)
@given(value=anything)
def test_any_value_is_taken_or_refused_in_one_sentence(model, name, value):
    """A taken one is within its range; a refused one is named, and nothing is made."""
    before = len(bpy.data.materials)
    try:
        material = api.create_material(model, **{name: value})
    except FacetFilmError as error:
        said = str(error)
        assert said.isprintable() and name.split("_")[0].rstrip("s") in said and len(said) < 400
        assert len(bpy.data.materials) == before
        return
    for node, socket in itertools.product(material.node_tree.nodes, range(40)):
        if socket < len(node.inputs) and hasattr(node.inputs[socket], "default_value"):
            held = node.inputs[socket].default_value
            assert np.isfinite(np.asarray(tuple(held) if hasattr(held, "__len__") else held, float)).all()
    bpy.data.materials.remove(material)


@settings(max_examples=60)
@given(what=st.sampled_from(["model", "preset", "realisation", "name", "unheard_of"]), value=anything)
def test_any_argument_is_taken_or_refused_in_one_sentence(what, value):
    before = len(bpy.data.materials)
    try:
        material = api.create_material(**{what: value})
    except FacetFilmError as error:
        assert str(error).isprintable() and len(bpy.data.materials) == before
    else:
        bpy.data.materials.remove(material)
