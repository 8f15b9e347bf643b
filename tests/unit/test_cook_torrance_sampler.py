"""The sampler of Cook-Torrance Reference: what it draws and weighs against the formula, without a renderer."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy import stats
from scipy.stats import qmc

from addon.models.cook_torrance import formulas as ct
from addon.models.cook_torrance import sampler
from addon.models.cook_torrance.albedo import cook_torrance_albedo, facet_normals
from addon.reflectance import masking, sampling, slopes
from addon.reflectance.directions import direction, facing, half_vector, mirrored
from addon.reflectance.fresnel import conductor, f82, f82_factor
from tests.chi_square import bin_centres, direction_p_value

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
    x = sampler.facet(UP, v, m, 0.0, 0.0, flanks, gaussian, *even_numbers(count))
    weight = sampler.facet_weight(x, 1.0, 0.0, *COPPER, 0.0, 0.0)
    return x, mirrored(v, x.h), weight


# --- Width 0: the formula itself ---

@pytest.mark.parametrize("gaussian", [0.0, 1.0])
@pytest.mark.parametrize("flanks", [0.0, 0.5])
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


@pytest.mark.parametrize("gaussian", [0.0, 1.0])
@pytest.mark.parametrize("theta, m", [(0.0, 0.3), (0.8, 0.1), (0.8, 0.6), (1.3, 0.4), (1.5, 0.6)])
def test_both_sides_of_a_groove_make_the_albedo(theta, m, gaussian):
    """Weighed by how well they are seen, which is 0 for one that is hidden."""
    v, (tilt, azimuth) = direction(theta, 0.0), even_numbers(1 << 15, 2)
    sides = [sampler.facet(UP, v, m, 0.0, 0.0, 0.0, gaussian, tilt, azimuth, None, side=side) for side in (1.0, -1.0)]
    assert all((x.h @ v >= -1e-12)[x.density > 0.0].all() for x in sides)
    found = sum(sampler.facet_weight(x, 1.0, 0.0, *COPPER, 0.0, 0.0).mean(axis=0) for x in sides)
    expected = cook_torrance_albedo(np.cos(theta), slopes=[(m, 1.0)], index=COPPER[0], extinction=COPPER[1],
                                    distribution="gaussian" if gaussian else "beckmann", count=256)
    assert_allclose(found, expected, rtol=1.5e-3)


@pytest.mark.parametrize("gaussian", [0.0, 1.0])
@pytest.mark.parametrize("theta, phi, m, anisotropy", [
    (0.0, 0.0, 0.2, 0.8), (0.9, 0.0, 0.3, 0.6), (0.9, 0.7, 0.2, 0.95), (1.3, 1.5, 0.4, 0.9)])
def test_the_native_lobe_under_stretched_slopes(theta, phi, m, anisotropy, gaussian):
    """D G of a Beckmann lobe as smooth, in both slopes, as a round one under the longest, over D."""
    v, t = direction(theta, phi), direction(0.5 * np.pi, 0.0)
    ellipse = sampler.stretched(UP, t, m, anisotropy)
    x = sampler.facet(UP, v, m, 0.0, 0.0, 0.0, gaussian, *even_numbers(1 << 10), ellipse)
    longest, shortest = slopes.along_across(m, anisotropy)
    along = sampler.native_slope(longest)
    across = along * shortest / longest
    l, tilts = mirrored(v, x.h), (x.h[:, 0], x.h[:, 1], x.h[:, 2])

    def smith(w):
        steep = np.hypot(along * w[..., 0], across * w[..., 1]) / np.maximum(w[..., 2], 1e-6)
        return masking.smith_lambda_of_slope(steep)
    native = slopes.elliptic_beckmann(*tilts, along, across) / (1.0 + smith(v) + smith(l))
    d = slopes.elliptic_gaussian(*tilts, longest, shortest, slopes.elliptic_gaussian_c(longest, shortest)) \
        if gaussian else slopes.elliptic_beckmann(*tilts, longest, shortest)
    seen = (x.n_l > 0.01) & (x.n_h > 0.05)
    assert_allclose(sampler.native_over_d(x, m, 0.0)[seen], (native / d)[seen], rtol=2e-4)


def part_sums(l, values):
    """Sums over 4 bands of height times 6 sectors."""
    sixth = ((np.arctan2(l[:, 1], l[:, 0]) / np.pi + 1) * 3).astype(int) % 6
    part = np.minimum((l[:, 2] * 4).astype(int), 3) * 6 + sixth
    above = l[:, 2] > 0.0
    return np.stack([np.bincount(part[above], v[above], minlength=24) for v in values.T], axis=-1)


@pytest.mark.parametrize("gaussian", [0.0, 1.0])
@pytest.mark.parametrize("theta, phi, m, anisotropy", [
    (0.9, 0.0, 0.3, 0.6), (0.9, 0.6, 0.2, 0.95), (1.3, 1.5, 0.4, 0.8)])
def test_stretched_slopes_send_light_where_the_formula_does(theta, phi, m, anisotropy, gaussian):
    """Along x, seen from the azimuth phi."""
    v, tangent = direction(theta, phi), direction(0.5 * np.pi, 0.0)
    ellipse = sampler.stretched(UP, tangent, m, anisotropy)
    x = sampler.facet(UP, v, m, 0.0, 0.0, 0.0, gaussian, *even_numbers(1 << 17), ellipse)
    weight = sampler.facet_weight(x, 1.0, 0.0, *COPPER, 0.0, 0.0)
    l = mirrored(v, x.h)
    assert_allclose(l[:, 2], x.n_l, atol=1e-3)
    found = part_sums(l, weight / len(l))
    z = (np.arange(600) + 0.5) / 600
    grid = direction(np.arccos(z)[:, None], (np.arange(1200) + 0.5) / 1200 * 2 * np.pi).reshape(-1, 3)
    f = ct.cook_torrance(UP, v, grid, slopes=[(m, 1.0)], index=COPPER[0], extinction=COPPER[1], tangent=tangent,
                         anisotropy=anisotropy, distribution="gaussian" if gaussian else "beckmann")
    expected = part_sums(grid, f * grid[:, 2:] * (2 * np.pi / len(grid)))
    assert_allclose(found, expected, atol=3e-3 * expected.sum(axis=0).max())


def test_stretched_facets_are_drawn_by_their_density():
    """χ² of half a million mirrored directions, with mirrors' weights left out."""
    v, m, anisotropy = direction(0.8, 0.6), 0.25, 0.8
    ellipse = sampler.stretched(UP, direction(0.5 * np.pi, 0.0), m, anisotropy)
    x = sampler.facet(UP, v, m, 0.0, 0.0, 0.0, 0.0, *np.random.default_rng(5).uniform(size=(3, 1 << 19)), ellipse)

    def density(a):
        h = half_vector(v, bin_centres())
        d = slopes.elliptic_beckmann(h[..., 0], h[..., 1], h[..., 2], *slopes.along_across(m, a))
        return d * masking.v_cavity_one_side(h[..., 2], v[2], h @ v) / (4.0 * np.pi * v[2])
    assert direction_p_value(mirrored(v, x.h), density(anisotropy)) > 1e-3
    assert direction_p_value(mirrored(v, x.h), density(0.98 * anisotropy)) < 1e-6


def test_a_round_lobe_stretched_by_one_stays():
    ellipse = sampler.stretched(UP, direction(0.5 * np.pi, 0.0), 0.3, 0.0)
    ellipse.is_elliptic = 1.0
    numbers = even_numbers(1 << 10)
    v = direction(0.8, 0.6)
    x = sampler.facet(UP, v, 0.3, 0.03, 0.06, 0.0, 0.0, *numbers, ellipse)
    assert_allclose(x.narrow, x.a_across, rtol=1e-9)
    assert_allclose(x.broad, x.a_along, rtol=1e-9)
    assert_allclose(np.abs(np.sum(x.lobe_tangent * x.across, axis=-1)), 1.0, atol=2e-3)
    assert_allclose(x.covariance, 0.0, atol=1e-12)


def test_weights_never_pass_fresnel():
    """No fireflies: at width 0 the weight is F G/G1, at most F."""
    for theta in (0.0, 0.7, 1.4, 1.55):
        for m in (0.1, 0.4, 1.0):
            x, _, weight = drawn(theta, m)
            assert weight.max() < 1.0 + 1e-9


@pytest.mark.parametrize("m", [0.001, 0.01, 0.03, 0.1, 0.2, 0.4, 0.7, 1.0])
def test_shares_are_shares(m):
    """At every angle: a lobe weighed below 0 would be left out, and drawn facets make up for it."""
    share, lean = sampler.native_lobe(np.linspace(0.0, 1.0, 2001), m)
    assert share.min() >= 0.0 and share.max() <= 1.02 / sampler.HEADROOM
    assert lean.min() >= 0.0
    probability = sampler.kept(share)
    assert probability.min() > 0.0 and probability.max() <= 1.0


@pytest.mark.parametrize("m", [0.03, 0.1, 0.4, 1.0])
@pytest.mark.parametrize("width", [0.0, 0.2, 1.0])
def test_weights_are_bounded_wherever_the_normal_points(m, width):
    """From below the surface too, as a Normal socket brings it; before the roulette."""
    even = even_numbers(1 << 16, 4)
    v = direction(np.arccos(2.0 * even[3] - 1.0), 0.0)
    n = facing(UP, v)
    a, wide = sampling.narrow_slope(m, width), sampling.wide_slope(m, width)
    x = sampler.facet(n, v, m, a, wide, sampler.FLANKS * (width > 0.0), 0.0, *even[:3])
    share, lean = sampler.native_lobe(x.n_v, m)
    f0, tint = sampler.native_fresnel(*COPPER)
    native = (width > 0.0) * sampler.HEADROOM * share * sampler.native_over_d(x, m, lean)
    weight = sampler.facet_weight(x, 1.0, native, *COPPER, f0, f82_factor(f0, tint))
    assert np.isfinite(weight).all() and weight.min() >= 0.0
    assert weight.max() < 4.0


def test_facets_shown_for_some_samples_weigh_more():
    x, _, weight = drawn(0.5, 0.3)
    assert_allclose(sampler.facet_weight(x, 1.0, 0.0, *COPPER, 0.0, 0.0, 0.5, 0.2), 2.5 * weight)


def test_drawn_facets_are_seen():
    x, _, _ = drawn(1.45, 0.6)
    assert (x.h @ direction(1.45, 0.0) >= -1e-12).all()
    assert_allclose(np.linalg.norm(x.h, axis=-1), 1.0)


# --- A width: native lobe, drawn lobes, and together the formula ---

def native_reflectance(v, l, m):
    """BRDF times N·L of the native Beckmann lobe with a white F, as the closure evaluates it about its own normal."""
    share, lean = sampler.native_lobe(v[2], m)
    normal = UP + lean * v
    normal = normal / np.linalg.norm(normal)
    n_v, slope = normal @ v, sampler.native_slope(m)
    g = masking.smith_beckmann(n_v, l @ normal, slope) * (l[..., 2] > 0.0)
    return sampler.HEADROOM * share * slopes.beckmann(half_vector(v, l) @ normal, slope) * g / (4 * np.pi * n_v)


@pytest.mark.parametrize("m", [0.05, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8, 1.0])
def test_native_lobe_lies_under_the_formula(m):
    """What sticks out is at most 0.2 % of the light, and nowhere more than 6 % of the formula that matters."""
    for theta in np.radians([0, 15, 30, 45, 60, 70, 75, 80, 85]):
        v = direction(theta, 0.0)
        h, weight = facet_normals(m, 120)
        v_h, n_h = h @ v, h[:, 2]
        n_l = mirrored(v, h)[:, 2]
        seen = (v_h > 0.0) & (n_l > 0.0)
        whole = slopes.beckmann(n_h, m) * masking.v_cavity(n_h, v[2], n_l, v_h) * seen
        native = 4 * np.pi * v[2] * native_reflectance(v, mirrored(v, h), m) * seen
        light = weight * np.maximum(v_h, 0.0)
        beyond = np.maximum(native - whole, 0.0)
        assert np.sum(light * beyond) < 2e-3 * np.sum(light * whole)
        matters = (whole * v_h * m * m / v[2] > 0.02) & (n_l > 0.05)
        assert (beyond[matters] < 0.06 * whole[matters]).all()


@pytest.mark.parametrize("n, k", [(1.33, 0.0), (1.5, 0.0), (2.5, 0.0), (0.2, 3.9), (0.9, 2.4), (2.9, 3.1)])
def test_native_fresnel_stays_within_its_headroom(n, k):
    cosine = np.cos(np.radians(np.linspace(0.0, 85.0, 200)))
    f0, tint = sampler.native_fresnel(n, k)
    assert (sampler.HEADROOM * f82(cosine, f0, tint) < 1.01 * conductor(cosine, n, k)).all()


def slopes_about(h, a, along):
    """Quadrature over the drawn slopes whose lobes reach facets h ``(..., 3)``: slopes x and y, and areas.

    A lobe lies along a tangent of its ring about N, so that it comes from further in.
    """
    sx, sy = h[:, 0] / h[:, 2], h[:, 1] / h[:, 2]
    rho = np.maximum(np.hypot(sx, sy), 1e-9)
    out = np.stack([sx / rho, sy / rho])[:, :, None, None]
    x, dx = np.polynomial.legendre.leggauss(40)
    y, dy = np.polynomial.legendre.leggauss(24)
    reach = 3.3 * along / h[:, 2]
    t = (reach[:, None] * y)[:, None, :]
    bend = np.minimum(t * t / (2.0 * np.maximum(rho, 0.05))[:, None, None], 0.9 * np.abs(t))
    across = (4.2 * a / h[:, 2] ** 2)[:, None, None]
    low, high = -across - 1.3 * bend, across + 0.2 * bend
    r = 0.5 * (low + high) + 0.5 * (high - low) * x[None, :, None]
    area = 0.5 * (high - low) * dx[None, :, None] * (reach[:, None] * dy)[:, None, :]
    return sx[:, None, None] + r * out[0] - t * out[1], sy[:, None, None] + r * out[1] + t * out[0], area


def narrow_lobe(x, v, l, h):
    """BRDF times L·H of the Beckmann lobes about x.h, which are wider along the ring than across, from l to v."""
    tangent = x.across - np.sum(x.across * x.h, axis=-1, keepdims=True) * x.h
    tangent /= np.linalg.norm(tangent, axis=-1, keepdims=True)
    other = np.cross(x.h, tangent)

    def in_frame(w):
        across, along = np.sum(w * tangent, axis=-1) * x.a_across, np.sum(w * other, axis=-1) * x.a_along
        return across, along, np.sum(w * x.h, axis=-1)

    def smith_lambda(w):
        p, q, z = in_frame(w)
        a = np.maximum(z, 1e-9) / np.maximum(np.hypot(p, q), 1e-12)
        rational = (1.0 - 1.259 * a + 0.396 * a * a) / (3.535 * a + 2.181 * a * a)
        return np.where(z > 0.0, np.where(a < 1.6, rational, 0.0), 1e9)

    p, q, z = in_frame(h)
    z = np.maximum(z, 1e-3)
    tan2 = (p / x.a_across ** 2 / z) ** 2 + (q / x.a_along ** 2 / z) ** 2
    d = np.exp(-tan2) / (np.pi * x.a_across * x.a_along * z ** 4)
    return d / (1.0 + smith_lambda(v) + smith_lambda(l)) / (4.0 * np.maximum(np.sum(v * x.h, axis=-1), 1e-6))


def blurred(v, l, m, width=0.2):
    """What native and narrow lobes reflect from l ``(..., 3)`` to v, times N·L: quadrature over the drawn facets.

    Also the noise: the mean square of the narrow lobe's value.
    """
    a, wide = sampling.narrow_slope(m, width), sampling.wide_slope(m, width)
    share, lean = sampler.native_lobe(v[2], m)
    m2_drawn, _ = sampling.narrowed(m, a)
    h = half_vector(v, l)
    rho = np.hypot(h[:, 0], h[:, 1]) / h[:, 2]
    sx, sy, area = slopes_about(h, a, np.maximum(a, wide * np.minimum(2.5 * rho / m, 1.0)))
    # The random numbers that draw the facet of slope (sx, sy), for frame_about's tangents at N = z: (y, -x).
    kept = np.exp(-(sx ** 2 + sy ** 2) / m2_drawn)
    flanks = sampler.FLANKS
    assert flanks == 1.0
    u_tilt = np.cbrt(kept)
    u_azimuth = np.mod(np.arctan2(-sx, sy) / (2 * np.pi), 1.0)
    x = sampler.facet(UP, v, m, a, wide, flanks, 0.0, u_tilt, u_azimuth, 0.0)
    wanted = np.stack([sx, sy, np.ones_like(sx)], axis=-1) / np.sqrt(1 + sx ** 2 + sy ** 2)[..., None]
    v_h = wanted @ v
    drawn_as_wanted = (kept > 1e-6) & (v_h > 0.0)  # of a hidden facet the other side of the groove is drawn
    assert_allclose(x.h[drawn_as_wanted], wanted[drawn_as_wanted], atol=1e-6)
    other = 2 * wanted[..., 2] * v[2] - v_h
    picked = 2 * np.maximum(v_h, 0) / np.maximum(np.maximum(v_h, 0) + np.maximum(other, 0), 1e-12)
    density = kept / (np.pi * m2_drawn) / (3 * np.maximum(u_tilt, 1e-12) ** 2) * picked
    native = sampler.HEADROOM * share * sampler.native_over_d(x, m, lean)
    weight = sampler.facet_weight(x, 1.0, native, *NEVER_FRESNEL, ONE, 0.0)[..., 0]
    value = weight * narrow_lobe(x, v, l[:, None, None, :], h[:, None, None, :]) * (v_h > 0.0)
    drawn_part = np.sum(density * value * area, axis=(1, 2))
    square = np.sum(density * value ** 2 * area, axis=(1, 2)) / sampler.kept(share)
    return drawn_part + native_reflectance(v, l, m), square - drawn_part ** 2


def over_the_sphere(m, sun, count=5):
    """Formula, blurred formula and the variances of one sample of width and of mirrors, at points of a sphere.

    The sun has a diameter of 5° and lies `sun` radians from the viewer.
    """
    viewer = np.array([0.0, 0.0, 1.0])
    lights = disc(np.array([np.sin(sun), 0.0, np.cos(sun)]))
    rows = []
    for x in np.linspace(-0.97, 0.97, 2 * count + 1):
        for y in np.linspace(0.0, 0.97, count + 1):
            z2 = 1.0 - x * x - y * y
            if z2 < 0.04:
                continue
            normal = np.array([x, y, np.sqrt(z2)])
            side = np.cross(viewer, normal) if np.hypot(x, y) > 0.0 else np.array([0.0, 1.0, 0.0])
            side = side / np.linalg.norm(side)
            to_local = np.stack([np.cross(side, normal), side, normal])
            v, l = to_local @ viewer, lights @ to_local.T
            lit = l[:, 2] > 1e-3
            if not lit.any():
                continue
            rows.append(np.array(at_a_point(m, v, l[lit])) * lit.mean())
    return np.array(rows).T


def at_a_point(m, v, l):
    """Means over l of what over_the_sphere gives."""
    f = ct.cook_torrance(UP, v, l, slopes=[(m, 1.0)], index=NEVER_FRESNEL[0], extinction=NEVER_FRESNEL[1])
    whole = (f[:, 0] * l[:, 2]).mean()
    found, variance = blurred(v, l, m)
    # A mirror hits the disc of solid angle π sin² 2.5° or not, and then sees its radiance.
    mirrors = whole / (np.pi * np.sin(np.radians(2.5)) ** 2) - whole ** 2
    return whole, found.mean(), variance.mean(), mirrors


@pytest.mark.parametrize("m", [0.1, 0.2, 0.3, 0.4, 0.6])
def test_default_width_blurs_by_less_than_two_percent_and_is_quiet(m):
    """Wherever the formula exceeds 2 % of its peak; and at most a sixth of the mirrors' noise."""
    for sun in np.radians([0.0, 45.0, 75.0]):
        whole, found, variance, mirrors = over_the_sphere(m, sun)
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
    r = np.sin(np.radians(2.5)) * np.sqrt((np.arange(2) + 0.5) / 2)[:, None]
    phi = 2 * np.pi * (np.arange(6) + 0.5) / 6
    l = towards + (r * np.cos(phi)).reshape(-1, 1) * side + (r * np.sin(phi)).reshape(-1, 1) * up
    return l / np.linalg.norm(l, axis=-1, keepdims=True)


# --- What the samplers share ---

@pytest.mark.parametrize("bias", [0.0, 0.5, 1.0])
def test_towards_flanks_weighs_what_it_draws(bias):
    """Even in all; and at bias 1 a tenth of the draws lies below a thousandth of D's peak."""
    u = even_numbers(1 << 14, 1)[0]
    x, weight = sampling.towards_flanks(u, bias)
    sums, _ = np.histogram(x, 20, (0.0, 1.0), weights=weight)
    assert_allclose(sums / len(u) * 20, 1.0, rtol=0.02)
    if bias == 1.0:
        assert_allclose(np.mean(x < 0.001), 0.1, rtol=0.01)


def test_slopes_are_drawn_by_weight():
    u = np.random.default_rng(3).uniform(size=40000)
    m, = sampling.chosen(u, [0.1, 0.0, 0.3, 0.2], [1.0, 2.0, 3.0, 4.0])
    counts = [np.sum(m == value) for value in (1.0, 3.0, 4.0)]
    assert sum(counts) == len(u)
    assert stats.chisquare(counts, np.array([1 / 6, 3 / 6, 2 / 6]) * len(u)).pvalue > 1e-3


@pytest.mark.parametrize("has_native", [0.0, 1.0])
def test_a_drawn_slope_weighs_what_it_is_drawn_too_seldom(has_native):
    slopes, weights = [0.1, 0.3, 0.4, 0.2], [0.5, 0.0, 0.3, 0.2]
    u = (np.arange(40000) + 0.5) / 40000
    m, weight = sampler.drawn_slope(u, has_native, slopes, weights)
    assert_allclose([np.sum(weight[m == slope]) / len(u) for slope in slopes], weights, atol=1e-4)
    assert (np.mean(m == 0.4) > np.mean(m == 0.1)) == bool(has_native)


def test_widths():
    assert sampling.narrow_slope(0.3, 0.0) == 0.0
    m2_drawn, stretch = sampling.narrowed(0.3, 0.0)
    assert_allclose(m2_drawn, 0.09)
    assert stretch == 1.0
    assert sampling.narrow_slope(1.0, 1.0) < 0.34
    assert sampling.wide_slope(0.3, 0.0) == 0.0
    assert sampling.wide_slope(1.0, 1.0) < sampling.WIDEST


def test_scales():
    assert sampler.scales(0.3, 0.0, 0.0, 5.0) == (1.0, 1.0)
    assert sampler.scales(0.3, 1.0, 0.0, 5.0) == (1.0, 0.97)
    scale, native = sampler.scales(0.2, 1.0, 1.0, 1.0)
    assert_allclose(scale, 4.0 / slopes.gaussian_c(0.2))
    assert_allclose(native, 0.97 * scale)
    assert_allclose(sampler.scales(0.2, 1.0, 1.0, 1000.0)[1], 0.97 * 4.0)
