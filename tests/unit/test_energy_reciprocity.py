"""Energy and reciprocity of both models over random materials and directions, and what the layered model
lacks of them.
"""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from addon.models.cook_torrance import formulas as ct
from addon.models.cook_torrance.albedo import cook_torrance_albedo
from addon.models.layered_rgb import formulas as layered
from addon.reflectance.directions import direction

UP, EAST, NORTH = np.eye(3)[[2, 0, 1]]
PERFECT = {"index": np.full(3, 1e-3), "extinction": np.full(3, 100.0)}
QUADRATURE = 2e-3

angles = st.floats(0.0, 1.45)
azimuths = st.floats(0.0, 2.0 * np.pi)
directions = st.builds(direction, angles, azimuths)
indices = st.lists(st.floats(0.05, 5.0), min_size=3, max_size=3).map(np.array)
extinctions = st.lists(st.floats(0.0, 10.0), min_size=3, max_size=3).map(np.array)
layers = st.lists(st.floats(1.05, 2.5), min_size=3, max_size=3).map(np.array)
distributions = st.sampled_from(["beckmann", "gaussian"])


@st.composite
def slopes(draw):
    """One to four slopes whose weights sum to at most one."""
    count = draw(st.integers(1, 4))
    m = draw(st.lists(st.floats(0.05, 1.0), min_size=count, max_size=count))
    w = draw(st.lists(st.floats(0.01, 1.0), min_size=count, max_size=count))
    total = max(sum(w), 1.0)
    return tuple(zip(m, [x / total for x in w]))


# --- Cook-Torrance ---

@settings(max_examples=40)
@given(slopes(), angles, distributions, st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_no_more_leaves_than_arrives(slopes, angle, distribution, s, diffuse):
    """At energy scale, with F = 1, weights that sum to at most one, and any share of a diffuse part."""
    albedo = cook_torrance_albedo(np.cos(angle), slopes=slopes, distribution=distribution, s=s,
                                  normal_reflectance=np.full(3, diffuse), count=64, **PERFECT)
    assert albedo.max() <= 1.0 + QUADRATURE


def test_the_energy_check_fails_for_weights_above_one_and_for_the_published_scale():
    both = cook_torrance_albedo(0.9, slopes=[(0.3, 0.7), (0.2, 0.5)], count=96, **PERFECT)
    printed = cook_torrance_albedo(0.9, slopes=[(0.3, 1.0)], scale=ct.PUBLISHED, count=96, **PERFECT)
    assert both.min() > 1.1 and printed.min() > 3.9


@given(directions, directions, slopes(), distributions, indices, extinctions,
       st.sampled_from([ct.ENERGY, ct.PUBLISHED]))
def test_light_and_viewer_may_change_places(v, l, slopes, distribution, n, k, scale):
    options = dict(slopes=slopes, distribution=distribution, index=n, extinction=k, scale=scale, s=0.7,
                   normal_reflectance=np.array([0.8, 0.4, 0.2]))
    assert_allclose(ct.cook_torrance(UP, v, l, **options), ct.cook_torrance(UP, l, v, **options), rtol=1e-9, atol=1e-12)


def test_the_reciprocity_check_fails_where_one_side_is_masked_alone():
    def lopsided(c, m):
        return np.minimum(1.0, 2.0 * c.n_h * c.n_v / c.v_h)
    options = dict(slopes=[(0.5, 1.0)], masking=lopsided, **PERFECT)
    v, l = direction(1.3, 0.0), direction(0.2, 3.0)
    assert not np.allclose(ct.cook_torrance(UP, v, l, **options), ct.cook_torrance(UP, l, v, **options), rtol=1e-3)


# --- The layered model: what of this it has, and what it lacks as published ---

def layered_albedo(angle, r1, d, exponent, deviation=0.0, published=0.0):
    """∫ ρ (N·L) dω by quadrature about the normal."""
    z, w = np.polynomial.legendre.leggauss(200)
    z, w = (z + 1.0) / 2.0, w / 2.0
    phi = (np.arange(128) + 0.5) / 128 * 2.0 * np.pi
    lights = direction(np.arccos(z)[:, None], phi[None, :])
    n1 = layered.tilted_normal(UP, EAST, NORTH, deviation, 0.0)
    cosines = layered.inner_products(lights, direction(angle, 0.0), UP, n1, r1)
    rho = layered.layered_specular(cosines, r1, d, layered.WAVELENGTHS, exponent, exponent, published)
    return np.sum(rho * (cosines.n0_l * w[:, None])[..., None], axis=(0, 1)) * 2.0 * np.pi / len(phi)


@given(layers, st.floats(0.0, 1000.0))
def test_the_layers_diffuse_part_is_an_albedo(r1, d):
    albedo = layered.rho_d_eq16(r1, d, layered.WAVELENGTHS)
    assert (albedo >= 0.0).all() and (albedo <= 1.0).all()


@given(directions, directions, layers, st.floats(0.0, 1000.0))
def test_the_layers_diffuse_part_is_reciprocal(v, l, r1, d):
    options = dict(r1=r1, d=d, e0=90.0, e1=170.0, specular=0.0)
    assert_allclose(layered.layered_rgb(l, v, UP, UP, **options), layered.layered_rgb(v, l, UP, UP, **options))


def test_the_layers_lobes_may_reflect_more_than_arrives_even_at_energy_scale():
    """T widens on its way out by up to r1², and nothing in the model takes that back.

    At the normal, by the thickness that reflects most: 0.99 for r1 = 1.3, 1.32
    for 1.5 and 1.81 for 1.8 (exponents 130).
    """
    r1 = np.array([1.3, 1.5, 1.8])
    largest = np.max([layered_albedo(0.0, r1, d, 130.0) for d in np.linspace(0.0, 300.0, 31)], axis=0)
    assert_allclose(largest, [0.99, 1.32, 1.81], atol=0.02)


def test_the_layers_lobes_are_not_reciprocal():
    """F and 𝒯 see light and viewer differently, as printed; by up to tens of per cent far from the normal."""
    v, l = direction(0.3, 0.0), direction(0.9, np.pi)
    options = dict(r1=np.full(3, 1.5), d=70.0, e0=5.0, e1=5.0, diffuse=0.0)
    there, back = layered.layered_rgb(l, v, UP, UP, **options), layered.layered_rgb(v, l, UP, UP, **options)
    assert (np.abs(there / back - 1.0) > 0.01).all()


@pytest.mark.parametrize("published", [0.0, 1.0])
def test_the_layers_published_scale_is_another(published):
    albedo = layered_albedo(0.3, np.full(3, 1.5), 70.0, 130.0, published=published)
    assert albedo.max() < 0.1 if published else albedo.max() > 0.5
