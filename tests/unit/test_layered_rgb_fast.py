"""The native lobes of Layered RGB Standard, by nodes and by OSL, against quadrature of the formula: albedo, peaks, no
negative colour."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from addon.models.layered_rgb import formulas as layered
from addon.models.layered_rgb import lobes as scripted
from addon.models.layered_rgb import pairs
from addon.reflectance import directions

UP, EAST, NORTH = np.eye(3)[[2, 0, 1]]
WAVELENGTHS = np.array(layered.WAVELENGTHS)
ANGLES = (0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 75.0, 80.0)
LARGEST_SHIFT = 1.0
FIGURE_3 = ((1.4, 1.45, 1.6), 90.0, 170.0)
FIGURE_5 = ((1.5, 1.6, 1.8), 130.0, 130.0)


def view_at(polar, azimuth=0.0):
    return directions.direction(math.radians(polar), math.radians(azimuth))


def lower_normal(deviation):
    return layered.tilted_normal(UP, EAST, NORTH, math.radians(deviation), 0.0)


def hemisphere(polar=300, azimuthal=240):
    nodes, weights = np.polynomial.legendre.leggauss(polar)
    z, w = (nodes + 1) / 2, weights / 2
    phi = (np.arange(azimuthal) + 0.5) / azimuthal * 2 * math.pi
    z, phi = np.meshgrid(z, phi, indexing="ij")
    s = np.sqrt(1 - z * z)
    solid_angle = np.repeat(w[:, None], azimuthal, axis=1) * 2 * math.pi / azimuthal
    return np.stack([s * np.cos(phi), s * np.sin(phi), z], axis=-1), solid_angle


LIGHTS, SOLID_ANGLE = hemisphere()


def formula_albedos(view, n1, r1, thicknesses, e0, e1):
    """∫ ρ (N.L) dω for each thickness, (thicknesses, 3)."""
    cosines = layered.inner_products(LIGHTS, view, UP, n1, r1)
    r, t = layered.layered_lobes(cosines, r1, e0, e1)
    weight = (cosines.n0_l * SOLID_ANGLE)[..., None]
    path = layered.phase_eq3(cosines.cos_i, cosines.cos_o, r1, 1.0, WAVELENGTHS)
    both, between = (r + t) * weight, 2 * np.sqrt(r * t) * weight
    return [(0.5 * np.sum(both + between * np.cos(2 * path * d), axis=(0, 1))) for d in thicknesses]


def aside(n1):
    """The part of the lower normal across the upper one."""
    return n1 - UP * n1[2]


class ByNodes:
    """Layered RGB Standard."""

    @staticmethod
    def albedo(view, n1, r1, d, e0, e1):
        """What all lobes together are to reflect, (3,)."""
        light = pairs.light_of_the_layer(view, UP, aside(n1), r1, d, WAVELENGTHS, e0, e1)
        return light.r + light.t

    @staticmethod
    def lobes(view, n1, r1, d, e0, e1):
        """Each with normal, colour, slope_in and slope_across, as Cycles makes them of roughness and anisotropy."""
        found = pairs.native_lobes(view, UP, aside(n1), r1, d, WAVELENGTHS, e0, e1)
        return [SimpleNamespace(normal=directions_of(lobe.normal), colour=lobe.colour, **slopes(lobe))
                for lobe in found]


class ByScript:
    """Layered RGB OSL Standard."""

    @staticmethod
    def albedo(view, n1, r1, d, e0, e1):
        """What all lobes together are to reflect, (3,)."""
        f, exits = layered.f_eq8(r1), scripted.exit_directions(view, UP, n1, r1)
        plane = scripted.exit_plane(exits, r1, d, WAVELENGTHS, f, e0, e1)
        return sum(scripted.lobe_colours(exits, plane, r1, f, e0, e1))

    @staticmethod
    def lobes(view, n1, r1, d, e0, e1):
        """Each with normal, colour, slope_in and slope_across."""
        return scripted.native_lobes(view, UP, n1, r1, d, WAVELENGTHS, e0, e1)


STANDARDS = pytest.mark.parametrize("standard", [ByNodes, ByScript])


def directions_of(vectors):
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def slopes(lobe):
    alpha, stretch = lobe.roughness ** 2, 1.0 + np.abs(lobe.anisotropy)
    along = np.where(lobe.anisotropy > 0.0, 1.0 - lobe.anisotropy, stretch)
    return {"slope_in": alpha * along, "slope_across": alpha / along}


@pytest.mark.parametrize("r1, e0, e1", [FIGURE_3, FIGURE_5])
@STANDARDS
def test_albedo_of_parallel_boundaries(standard, r1, e0, e1):
    thicknesses = (15.0, 70.0, 92.0, 170.0, 400.0)
    r1 = np.array(r1)
    for angle in ANGLES:
        expected = formula_albedos(view_at(angle), UP, r1, thicknesses, e0, e1)
        for d, albedo in zip(thicknesses, expected):
            np.testing.assert_allclose(standard.albedo(view_at(angle), UP, r1, d, e0, e1), albedo, rtol=0.02)


@pytest.mark.parametrize("deviation", [5.0, 10.0, 14.0])
@pytest.mark.parametrize("r1, e0, e1", [FIGURE_3, FIGURE_5])
@STANDARDS
def test_albedo_of_deviated_boundaries(standard, r1, e0, e1, deviation):
    """Within 5 % wherever the lobes leave the layer: above a quarter of the albedo at normal incidence."""
    thicknesses = (15.0, 70.0, 170.0)
    r1, n1 = np.array(r1), lower_normal(deviation)
    at_normal = formula_albedos(view_at(0.0), n1, r1, thicknesses, e0, e1)
    for azimuth in (0.0, 90.0, 180.0):
        for angle in ANGLES:
            expected = formula_albedos(view_at(angle, azimuth), n1, r1, thicknesses, e0, e1)
            for d, albedo, normal in zip(thicknesses, expected, at_normal):
                found = standard.albedo(view_at(angle, azimuth), n1, r1, d, e0, e1)
                seen = albedo > 0.25 * normal
                np.testing.assert_allclose(found[seen], albedo[seen], rtol=0.05)


def beckmann(light, view, lobe):
    """The anisotropic Beckmann closure times N.L, with Smith's G."""
    def inner(a, b):
        return np.sum(a * b, axis=-1)

    def smith(w):
        slant = np.hypot(lobe.slope_in * inner(w, x), lobe.slope_across * inner(w, y))
        a = np.abs(inner(w, n)) / np.maximum(slant, 1e-9)
        return np.where(a >= 1.6, 0.0, (1 - 1.259 * a + 0.396 * a * a) / (3.535 * a + 2.181 * a * a))

    n = lobe.normal
    y = np.cross(n, view + [3e-4, 5e-4, 7e-4])
    y /= np.linalg.norm(y)
    x = np.cross(y, n)
    half = light + view
    half = half / np.linalg.norm(half, axis=-1, keepdims=True)
    cosine = np.maximum(half @ n, 1e-3)
    slope2 = ((half @ x / lobe.slope_in) ** 2 + (half @ y / lobe.slope_across) ** 2) / cosine ** 2
    d = np.exp(-np.minimum(slope2, 80.0)) / (math.pi * lobe.slope_in * lobe.slope_across * cosine ** 4)
    return np.where(light @ n > 0.0, d / ((1 + smith(light) + smith(view)) * 4 * (n @ view)), 0.0)


@pytest.mark.parametrize("r1, e0, e1", [FIGURE_3, FIGURE_5])
@STANDARDS
def test_albedo_of_the_closures(standard, r1, e0, e1):
    """What the closures reflect, what they lose at the horizon included: within 2 % up to 75°."""
    r1, thicknesses = np.array(r1), (15.0, 92.0, 400.0)
    for angle in (0.0, 30.0, 60.0, 70.0, 75.0):
        expected = formula_albedos(view_at(angle), UP, r1, thicknesses, e0, e1)
        for d, albedo in zip(thicknesses, expected):
            lobes = standard.lobes(view_at(angle), UP, r1, d, e0, e1)
            found = sum(np.sum(beckmann(LIGHTS, view_at(angle), lobe) * SOLID_ANGLE) * lobe.colour for lobe in lobes)
            np.testing.assert_allclose(found, albedo, rtol=0.02)


def top(angles, seen):
    """Middle of the stretch above four fifths of each channel's largest value: tops may be flat."""
    stretches = [angles[channel > 0.8 * channel.max()] for channel in seen.T]
    return np.array([0.5 * (stretch[0] + stretch[-1]) for stretch in stretches])


def has_one_peak(seen):
    """Whether each channel of the curves has no second peak above half of the first."""
    rising = np.diff(seen, axis=0) > 0.0
    peaks = rising[:-1] & ~rising[1:] & (seen[1:-1] > 0.5 * seen.max(axis=0))
    return peaks.sum(axis=0) == 1


POLARS = (0.5, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 65.0, 70.0, -20.0, -40.0, -60.0)


@pytest.mark.parametrize("deviation", [0.0, 5.0, 10.0, 14.0])
@pytest.mark.parametrize("r1, e0, e1", [FIGURE_3, FIGURE_5])
@STANDARDS
def test_peaks_of_the_channels(standard, r1, e0, e1, deviation):
    """A lamp moved through the plane of V and n0 is brightest at the same angle within 1°, per channel.

    Where interference makes one peak two, or R and T stand apart and are both as
    bright, there is no one place to compare.
    """
    r1, n1 = np.array(r1), lower_normal(deviation)
    angles = np.arange(-89.5, 89.6, 0.1)
    lamps = np.stack([view_at(angle) for angle in angles])
    compared = 0
    for polar in POLARS:
        view = view_at(polar)
        cosines = layered.inner_products(lamps, view, UP, n1, r1)
        for d in (15.0, 70.0, 92.0, 170.0, 400.0):
            formula = layered.layered_specular(cosines, r1, d, WAVELENGTHS, e0, e1) * cosines.n0_l[:, None]
            fast = sum(beckmann(lamps, view, lobe)[:, None] * lobe.colour
                       for lobe in standard.lobes(view, n1, r1, d, e0, e1))
            apart = np.abs(top(angles, fast) - top(angles, formula))
            one = has_one_peak(formula)
            compared += one.sum()
            assert (apart <= LARGEST_SHIFT + 1e-6)[one].all(), (polar, d, apart)
    assert compared > 0.95 * 3 * 5 * len(POLARS)


@STANDARDS
def test_no_colour_is_negative(standard):
    rng = np.random.default_rng(5)
    count = 4000
    view = view_at(0.0) + rng.normal(size=(count, 3))
    view[:, 2] = np.abs(view[:, 2])
    view /= np.linalg.norm(view, axis=-1, keepdims=True)
    n1 = lower_normal(14.0)
    r1 = rng.uniform(1.01, 2.5, (count, 3))
    lobes = standard.lobes(view, n1, r1, rng.uniform(0, 800, count), rng.uniform(0, 2000, count),
                           rng.uniform(0, 2000, count))
    for lobe in lobes:
        assert np.isfinite(lobe.colour).all() and lobe.colour.min() >= 0.0
        assert np.isfinite(lobe.normal).all() and lobe.slope_in.min() > 0.0
        assert lobe.colour.max() < 10.0
