"""The layered RGB sampler: its density is that of its draws, its weights average to the integral."""

import math

import numpy as np
import pytest
from scipy import stats

from addon.models.layered_rgb import formulas as layered
from addon.models.layered_rgb import sampler
from addon.reflectance import directions

UP, EAST, NORTH = np.eye(3)[[2, 0, 1]]
CASES = [
    # r1, d, e0, e1, deviation in degrees
    ((1.4, 1.45, 1.6), 70.0, 90.0, 170.0, 0.0),
    ((1.4, 1.45, 1.6), 70.0, 90.0, 170.0, 10.0),
    ((1.5, 1.6, 1.8), 170.0, 130.0, 130.0, 14.0),
    ((1.3, 1.35, 1.4), 400.0, 20.0, 5.0, 30.0),
]
VIEWS = [(0.0, 0.0), (40.0, 0.0), (40.0, 180.0), (75.0, 90.0)]


def direction(polar, azimuth):
    return directions.direction(math.radians(polar), math.radians(azimuth))


def grid(polar=900, azimuthal=300):
    """Directions over the hemisphere and the solid angle of each: even in cosine and azimuth."""
    z = (np.arange(polar) + 0.5) / polar
    phi = (np.arange(azimuthal) + 0.5) / azimuthal * 2 * math.pi
    z, phi = np.meshgrid(z, phi, indexing="ij")
    s = np.sqrt(1 - z * z)
    return np.stack([s * np.cos(phi), s * np.sin(phi), z], axis=-1), 2 * math.pi / z.size


def numbers(count, seed):
    return np.random.default_rng(seed).random((3, count))


def setting(case, view):
    r1, d, e0, e1, deviation = case
    n1 = layered.tilted_normal(UP, EAST, NORTH, math.radians(deviation), 0.0)
    return np.array(r1), d, e0, e1, n1, direction(*view)


def narrow_lobes(view, n1, r1, e0, e1, width=0.0):
    """The lobes that L is drawn from, at a Sampling Width."""
    lobes = sampler.proposal(view, UP, n1, r1, e0, e1)
    return lobes, sampler.narrowed(lobes, r1, e0, e1, sampler.tapered_width(lobes, width))


@pytest.mark.parametrize("view", VIEWS)
@pytest.mark.parametrize("case", CASES)
def test_weights_average_to_the_integral(case, view):
    """Mean weight = ∫ ρ (N.L) dω by quadrature, within its standard error."""
    r1, d, e0, e1, n1, v = setting(case, view)
    lobes, narrow = narrow_lobes(v, n1, r1, e0, e1)
    drawn = sampler.draw(lobes, narrow, v, UP, n1, r1, *numbers(40000, 1))
    weights = sampler.weight(lobes, narrow, drawn, v, UP, n1, r1, d, layered.WAVELENGTHS, e0, e1)
    lights, solid_angle = grid()
    cosines = layered.inner_products(lights, v, UP, n1, r1)
    rho = layered.layered_specular(cosines, r1, d, layered.WAVELENGTHS, e0, e1)
    albedo = np.sum(rho * cosines.n0_l[..., None], axis=(0, 1)) * solid_angle
    error = weights.std(axis=0) / math.sqrt(len(weights))
    z = (weights.mean(axis=0) - albedo) / np.hypot(error, 2e-4 * albedo)
    assert np.abs(z).max() < 4.5, (z, weights.mean(axis=0), albedo)


@pytest.mark.parametrize("case, view", [(CASES[0], VIEWS[1]), (CASES[1], VIEWS[2]), (CASES[2], VIEWS[3]),
                                        (CASES[3], VIEWS[2])])
def test_density_is_that_of_the_draws(case, view):
    """χ² of the draws, over bins of direction, against the density that the weights divide by."""
    r1, d, e0, e1, n1, v = setting(case, view)
    lobes, narrow = narrow_lobes(v, n1, r1, e0, e1)
    drawn = sampler.draw(lobes, narrow, v, UP, n1, r1, *numbers(100000, 2))
    lights, solid_angle = grid()
    density = sampler._density(lobes, narrow, layered.inner_products(lights, v, UP, n1, r1), r1) * solid_angle
    bins = 30
    expected = density.reshape(bins, 30, bins, 10).sum(axis=(1, 3)).ravel() * 100000
    light = drawn.light[drawn.valid > 0.5]
    row = np.minimum((light[:, 2] * bins).astype(int), bins - 1)
    column = ((np.arctan2(light[:, 1], light[:, 0]) / (2 * math.pi) % 1.0) * bins).astype(int) % bins
    found = np.bincount(row * bins + column, minlength=bins * bins)
    found = np.append(found, 100000 - len(light))      # draws that do not leave the layer
    expected = np.append(expected, 100000 - expected.sum())
    many = expected > 10
    found = np.append(found[many], found[~many].sum())
    expected = np.append(expected[many], expected[~many].sum())
    chi2 = np.sum((found - expected) ** 2 / np.maximum(expected, 1.0))
    assert stats.chi2.sf(chi2, len(found) - 1) > 1e-4


@pytest.mark.parametrize("case", CASES)
def test_weights_are_bounded(case):
    """No firefly: f (N.L)/p stays below a few times what the lobes reflect."""
    for view in VIEWS:
        r1, d, e0, e1, n1, v = setting(case, view)
        lobes, narrow = narrow_lobes(v, n1, r1, e0, e1)
        drawn = sampler.draw(lobes, narrow, v, UP, n1, r1, *numbers(20000, 3))
        weights = sampler.weight(lobes, narrow, drawn, v, UP, n1, r1, d, layered.WAVELENGTHS, e0, e1)
        assert np.isfinite(weights).all() and weights.min() >= 0.0
        assert weights.max() < 6.0


@pytest.mark.parametrize("exponent", [5.0, 130.0, 2000.0])
@pytest.mark.parametrize("width", [0.0, 0.3, 0.9])
def test_weights_are_bounded_wherever_the_normals_point(exponent, width):
    """From below the surface too, and for a lower boundary that is bumped by up to 85°: both as Normal
    sockets bring.
    """
    count, r1, random = 100000, np.array((1.5, 1.6, 1.8)), np.random.default_rng(4)
    even = random.random((7, count))
    v = directions.direction(np.arccos(2.0 * even[0] - 1.0), 2.0 * math.pi * even[1])
    n1 = directions.direction(math.radians(85.0) * even[2], 2.0 * math.pi * even[3])
    n0 = directions.facing(UP, v)
    lobes = sampler.proposal(v, n0, n1, r1, exponent, exponent)
    narrow = sampler.narrowed(lobes, r1, exponent, exponent, sampler.tapered_width(lobes, width))
    drawn = sampler.draw(lobes, narrow, v, n0, n1, r1, *even[4:])
    weights = sampler.weight(lobes, narrow, drawn, v, n0, n1, r1, 92.0, layered.WAVELENGTHS, exponent, exponent)
    assert np.isfinite(weights).all()
    assert weights.max() < 6.0


def test_shares_sum_to_one_and_every_lobe_is_drawn():
    r1, d, e0, e1, n1, v = setting(CASES[1], VIEWS[1])
    lobes, narrow = narrow_lobes(v, n1, r1, e0, e1)
    assert float(lobes.share_r + lobes.shares.sum()) == pytest.approx(1.0)
    drawn = sampler.draw(lobes, narrow, v, UP, n1, r1, *numbers(20000, 4))
    for index, share in zip((1.0, *r1), (lobes.share_r, *lobes.shares)):
        assert np.mean(np.isclose(drawn.index, index)) == pytest.approx(float(share), abs=0.02)


def test_width_keeps_the_albedo_in_both_scales():
    r1, d, e0, e1, n1, v = setting(CASES[1], (30.0, 0.0))
    for published in (0.0, 1.0):
        means = []
        for width in (0.0, 0.5):
            lobes, narrow = narrow_lobes(v, n1, r1, e0, e1, width)
            drawn = sampler.draw(lobes, narrow, v, UP, n1, r1, *numbers(40000, 7))
            means.append(sampler.weight(lobes, narrow, drawn, v, UP, n1, r1, d, layered.WAVELENGTHS, e0, e1,
                                        published).mean(axis=0))
        np.testing.assert_allclose(means[1], means[0], rtol=0.02)


def test_roughness_and_anisotropy_give_the_slopes_back():
    """Through what Cycles does with them: α = roughness², α (1-a), α/(1-a), or with the sign turned."""
    for slope_in, slope_across in ((0.04, 0.16), (0.16, 0.04), (0.1, 0.1)):
        roughness, a = map(float, sampler.roughness_and_anisotropy(slope_in, slope_across))
        alpha = roughness ** 2
        pair = (alpha * (1 - a), alpha / (1 - a)) if a >= 0 else (alpha / (1 + a), alpha * (1 + a))
        assert pair == pytest.approx((slope_in, slope_across))
