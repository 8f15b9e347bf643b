"""The sampler of Cook-Torrance Exact: what it draws and weighs against the formula, without a renderer."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy import stats
from scipy.stats import qmc

from addon.reflectance import cook_torrance as ct
from addon.reflectance import cook_torrance_sampler as sampler
from addon.reflectance import masking, sampling, slopes
from addon.reflectance.albedo import cook_torrance_albedo, facet_normals
from addon.reflectance.directions import direction, half_vector, mirrored
from addon.reflectance.fresnel import conductor, f82

UP = direction(0.0, 0.0)
COPPER = np.array([0.2, 0.92, 1.1]), np.array([3.91, 2.45, 2.14])
NEVER_FRESNEL = np.full(3, 1e7), np.zeros(3)
ONE = np.ones(3)


def even_numbers(count, dimensions=3):
    """Quasi-random numbers in [0, 1)."""
    return qmc.Sobol(dimensions, seed=7).random(count).T


def drawn(theta, m, gaussian=0.0, flanks=0.0, count=1 << 15):
    """Facets drawn for mirrors, their L and the weights f (N·L)/p(L)."""
    v = direction(theta, 0.0)
    x = sampler.facet(UP, v, m, 0.0, 1.0, flanks, gaussian, *even_numbers(count))
    weight = sampler.facet_weight(x, m, 1.0, 1.0, 0.0, *COPPER, 0.0, ONE)
    return x, mirrored(v, x.h), weight


# --- Width 0: the formula itself ---

@pytest.mark.parametrize("gaussian", [0.0, 1.0])
@pytest.mark.parametrize("flanks", [0.0, 0.8])
@pytest.mark.parametrize("m", [0.1, 0.3, 0.6])
@pytest.mark.parametrize("theta", [0.0, 0.8, 1.3])
def test_mean_weight_is_the_albedo(theta, m, flanks, gaussian):
    _, _, weight = drawn(theta, m, gaussian, flanks)
    expected = cook_torrance_albedo(np.cos(theta), slopes=[(m, 1.0)], index=COPPER[0], extinction=COPPER[1],
                                    distribution="gaussian" if gaussian else "beckmann", count=256)
    assert_allclose(weight.mean(axis=0), expected, rtol=1.5e-3)


@pytest.mark.parametrize("gaussian", [0.0, 1.0])
def test_light_goes_where_the_formula_sends_it(gaussian):
    """∫ f (N·L) over each of 24 parts of the hemisphere, by the sampler and by an even grid."""
    theta, m = 0.9, 0.4
    x, l, weight = drawn(theta, m, gaussian, count=1 << 18)
    assert_allclose(l[:, 2], x.n_l, atol=1e-9)
    found = part_sums(l, weight / len(l))
    z = (np.arange(600) + 0.5) / 600
    phi = (np.arange(1200) + 0.5) / 1200 * 2 * np.pi
    grid = direction(np.arccos(z)[:, None], phi).reshape(-1, 3)
    f = ct.cook_torrance(UP, direction(theta, 0.0), grid, slopes=[(m, 1.0)], index=COPPER[0], extinction=COPPER[1],
                         distribution="gaussian" if gaussian else "beckmann")
    expected = part_sums(grid, f * grid[:, 2:] * (2 * np.pi / len(grid)))
    assert_allclose(found, expected, atol=2e-3 * expected.sum(axis=0).max())


def part_sums(l, values):
    """Sums over 4 bands of height times 6 sectors."""
    part = np.minimum((l[:, 2] * 4).astype(int), 3) * 6 + ((np.arctan2(l[:, 1], l[:, 0]) / np.pi + 1) * 3).astype(int) % 6
    above = l[:, 2] > 0.0
    return np.stack([np.bincount(part[above], v[above], minlength=24) for v in values.T], axis=-1)


def test_weights_never_pass_fresnel():
    """No fireflies: at width 0 the weight is F G/G1, at most F."""
    for theta in (0.0, 0.7, 1.4, 1.55):
        for m in (0.1, 0.4, 1.0):
            x, _, weight = drawn(theta, m)
            assert weight.max() < 1.0 + 1e-9


def test_drawn_facets_are_seen():
    x, _, _ = drawn(1.45, 0.6)
    assert (x.h @ direction(1.45, 0.0) >= -1e-12).all()
    assert_allclose(np.linalg.norm(x.h, axis=-1), 1.0)


# --- A width: native lobe, drawn lobes, and together the formula ---

@pytest.mark.parametrize("m", [0.05, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8, 1.0])
def test_native_lobe_lies_under_the_formula(m):
    """What sticks out is at most 0.1 % of the light, and nowhere more than 6 % of the formula that matters."""
    for theta in np.radians([0, 15, 30, 45, 60, 70, 75, 80, 85]):
        v = direction(theta, 0.0)
        h, weight = facet_normals(m, 120)
        v_h, n_h = h @ v, h[:, 2]
        n_l = mirrored(v, h)[:, 2]
        seen = (v_h > 0.0) & (n_l > 0.0)
        share = sampler.native_share(v[2], m)
        whole = slopes.beckmann(n_h, m) * masking.v_cavity(n_h, v[2], n_l, v_h) * seen
        slope = m * np.sqrt(share)
        native = sampler.HEADROOM * share * slopes.beckmann(n_h, slope) * masking.smith_beckmann(v[2], n_l, slope) * seen
        light = weight * np.maximum(v_h, 0.0)
        beyond = np.maximum(native - whole, 0.0)
        assert np.sum(light * beyond) < 1e-3 * np.sum(light * whole)
        matters = (whole * v_h * m * m / v[2] > 0.02) & (n_l > 0.05)
        assert (beyond[matters] < 0.06 * whole[matters]).all()


@pytest.mark.parametrize("n, k", [(1.33, 0.0), (1.5, 0.0), (2.5, 0.0), (0.2, 3.9), (0.9, 2.4), (2.9, 3.1)])
def test_native_fresnel_stays_within_its_headroom(n, k):
    cosine = np.cos(np.radians(np.linspace(0.0, 85.0, 200)))
    f0, tint = sampler.native_fresnel(n, k)
    assert (sampler.HEADROOM * f82(cosine, f0, tint) < 1.01 * conductor(cosine, n, k)).all()


def blurred(v, l, m, width):
    """What native and narrow lobes reflect from l ``(..., 3)`` to v, times N·L: quadrature over the drawn facets.

    Also the noise: the mean square of the narrow lobe's value.
    """
    a = sampling.narrow_slope(m, width)
    share = sampler.native_share(v[2], m)
    m_drawn, _ = sampling.narrowed(m, a)
    h = half_vector(v, l)
    radius, d_radius = np.polynomial.legendre.leggauss(20)
    reach = 4.5 * a / h[:, 2] ** 2
    r, dr = reach[:, None] * (radius + 1) / 2, reach[:, None] * d_radius / 2
    phi = 2 * np.pi * (np.arange(24) + 0.5) / 24
    sx = (h[:, 0] / h[:, 2])[:, None, None] + r[..., None] * np.cos(phi)
    sy = (h[:, 1] / h[:, 2])[:, None, None] + r[..., None] * np.sin(phi)
    area = (r * dr)[..., None] * (2 * np.pi / 24) * np.ones(24)
    # The random numbers that draw the facet of slope (sx, sy), for frame_about's tangents at N = z: (y, -x).
    kept = np.exp(-(sx ** 2 + sy ** 2) / m_drawn ** 2)
    flanks = sampler.FLANKS
    u_tilt = kept * (1 + flanks - flanks * kept)
    u_azimuth = np.mod(np.arctan2(-sx, sy) / (2 * np.pi), 1.0)
    x = sampler.facet(UP, v, m, a, share, flanks, 0.0, u_tilt, u_azimuth, 0.0)
    likely = kept > 1e-6
    assert_allclose(x.h[..., 0][likely], (sx / np.sqrt(1 + sx ** 2 + sy ** 2))[likely], atol=1e-6)
    v_h = x.h @ v
    other = 2 * x.h[..., 2] * v[2] - v_h
    picked = 2 * np.maximum(v_h, 0) / np.maximum(np.maximum(v_h, 0) + np.maximum(other, 0), 1e-12)
    density = kept / (np.pi * m_drawn ** 2) * (1 + flanks - 2 * flanks * kept) * picked
    weight = sampler.facet_weight(x, m, share, 1.0, sampler.HEADROOM * share, *NEVER_FRESNEL, ONE, ONE)[..., 0]
    facing = np.einsum("ijkc,ic->ijk", x.h, h)
    h_l = np.einsum("ijkc,ic->ijk", x.h, l)
    lobe = slopes.beckmann(facing, x.spread) * masking.smith_beckmann(v_h, h_l, x.spread) / (4 * np.pi * np.maximum(v_h, 1e-6))
    value = weight * lobe
    drawn_part = np.sum(density * value * area, axis=(1, 2))
    square = np.sum(density * value ** 2 * area, axis=(1, 2)) / sampler.kept(share)
    slope = m * np.sqrt(share)
    native = sampler.HEADROOM * share * slopes.beckmann(h[:, 2], slope) * masking.smith_beckmann(v[2], l[:, 2], slope) / (
        4 * np.pi * v[2])
    return drawn_part + native, square - drawn_part ** 2


def across_the_sphere(m, sun):
    """Formula, blurred formula and the variances of one sample of width and of mirrors, on a line over a sphere.

    The sun has a diameter of 5° and lies in the line's plane, `sun` radians from the viewer.
    """
    rows = []
    for angle in np.radians(np.linspace(-80, 80, 41)):
        v = np.array([-np.sin(angle), 0.0, np.cos(angle)])
        l = disc(np.array([np.sin(sun - angle), 0.0, np.cos(sun - angle)]))
        lit = l[:, 2] > 0.0
        f = ct.cook_torrance(UP, v, l, slopes=[(m, 1.0)], index=NEVER_FRESNEL[0], extinction=NEVER_FRESNEL[1])
        whole = f[:, 0] * np.maximum(l[:, 2], 0.0)
        found, variance = blurred(v, l, m, 0.2)
        # A mirror hits the disc of solid angle π sin² 2.5° or not, and then sees its radiance.
        mirrors = whole.mean() / (np.pi * np.sin(np.radians(2.5)) ** 2) - whole.mean() ** 2
        rows.append((whole.mean(), (found * lit).mean(), (variance * lit).mean(), mirrors))
    return np.array(rows).T


@pytest.mark.parametrize("m", [0.1, 0.2, 0.3, 0.4, 0.6])
def test_default_width_blurs_by_less_than_two_percent_and_is_quiet(m):
    """Wherever the formula exceeds 2 % of its peak; and at most a sixth of the mirrors' noise."""
    for sun in np.radians([0.0, 45.0, 75.0]):
        whole, found, variance, mirrors = across_the_sphere(m, sun)
        bright = whole > 0.02 * whole.max()
        bias = np.abs(found[bright] / whole[bright] - 1.0).max()
        quieter = np.sqrt(mirrors.mean() / variance.mean())
        print(f"m {m}, sun at {np.degrees(sun):.0f}°: bias {bias:.2%}, noise 1/{quieter:.1f} of mirrors")
        assert bias < 0.02
        assert quieter > 6.0


def disc(towards):
    """Directions over a sun's disc of 5° diameter."""
    side = np.array([towards[2], 0.0, -towards[0]])
    up = np.cross(towards, side)
    r = np.sin(np.radians(2.5)) * np.sqrt((np.arange(3) + 0.5) / 3)[:, None]
    phi = 2 * np.pi * (np.arange(8) + 0.5) / 8
    l = towards + (r * np.cos(phi)).reshape(-1, 1) * side + (r * np.sin(phi)).reshape(-1, 1) * up
    return l / np.linalg.norm(l, axis=-1, keepdims=True)


# --- What the samplers share ---

def test_towards_flanks_draws_its_density():
    u = even_numbers(1 << 14, 1)[0]
    x, density = sampling.towards_flanks(u, 0.8)
    counts, edges = np.histogram(x, 20, (0.0, 1.0))
    middle = 0.5 * (edges[1:] + edges[:-1])
    assert_allclose(counts / len(u) * 20, 1.8 - 1.6 * middle, rtol=0.02)
    assert_allclose(density, 1.8 - 1.6 * x)


def test_slopes_are_drawn_by_weight():
    u = np.random.default_rng(3).uniform(size=40000)
    m, = sampling.chosen(u, [0.1, 0.0, 0.3, 0.2], [1.0, 2.0, 3.0, 4.0])
    counts = [np.sum(m == value) for value in (1.0, 3.0, 4.0)]
    assert sum(counts) == len(u)
    assert stats.chisquare(counts, np.array([1 / 6, 3 / 6, 2 / 6]) * len(u)).pvalue > 1e-3


def test_widths():
    assert sampling.narrow_slope(0.3, 0.0) == 0.0
    m_drawn, stretch = sampling.narrowed(0.3, 0.0)
    assert_allclose(m_drawn, 0.3)
    assert stretch == 1.0
    assert sampling.narrow_slope(1.0, 1.0) < 0.32


def test_scales():
    assert sampler.scales(0.3, 0.0, 0.0, 5.0) == (1.0, 1.0)
    assert sampler.scales(0.3, 1.0, 0.0, 5.0) == (1.0, 1.0)
    scale, native = sampler.scales(0.2, 1.0, 1.0, 1.0)
    assert_allclose(scale, 4.0 / slopes.gaussian_c(0.2))
    assert_allclose(native, scale)
    assert sampler.scales(0.2, 1.0, 1.0, 1000.0)[1] == 4.0
