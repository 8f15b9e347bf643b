"""The terms of the 1982 model against values worked by hand, limits, symmetries and quadrature."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy import integrate, special

from addon.models.cook_torrance import formulas as ct
from addon.models.cook_torrance.albedo import cook_torrance_albedo, directional_albedo
from addon.reflectance import fresnel, masking, slopes
from addon.reflectance.directions import cosines, direction, frame_about, half_vector, in_frame, mirrored

UP = direction(0.0, 0.0)
COPPER = {"index": np.array([0.2, 0.92, 1.1]), "extinction": np.array([3.91, 2.45, 2.14])}
WHITE = {"index": np.full(3, 1e7), "extinction": np.zeros(3)}
FIGURE_6B = [(0.4, 0.4), (0.2, 0.6)]


def random_directions(count, seed):
    """Directions over the upper hemisphere."""
    rng = np.random.default_rng(seed)
    return direction(np.arccos(rng.uniform(0.02, 1.0, count)), rng.uniform(0.0, 2 * np.pi, count))


# --- D ---

def test_beckmann_by_hand():
    """At tan α = m: exp(−1)/(m² cos⁴ α), with cos² α = 1/(1 + m²)."""
    m = 0.5
    assert_allclose(slopes.beckmann(1 / np.sqrt(1.25), m), np.exp(-1.0) / 0.25 * 1.25 ** 2, rtol=1e-12)
    assert slopes.beckmann(-0.9, m) == 0.0
    assert slopes.beckmann(0.0, m) == 0.0


@pytest.mark.parametrize("m", [0.02, 0.1, 0.2, 0.4, 0.6, 1.0])
def test_facets_cover_the_surface_once(m):
    """∫ D cos α dω = π for both distributions."""
    for d, tolerance in ((slopes.beckmann, 1e-8), (lambda c, m: slopes.gaussian(c, m, slopes.gaussian_c(m)), 2e-5)):
        total, _ = integrate.quad(
            lambda a: 2 * np.pi * float(d(np.cos(a), m)) * np.cos(a) * np.sin(a), 0.0, np.pi / 2,
            points=[min(m, 1.0), min(3 * m, 1.5)], limit=200)
        assert_allclose(total, np.pi, rtol=tolerance)


@pytest.mark.parametrize("m", [0.05, 0.1, 0.2])
def test_gaussian_c_is_dawsons_integral_where_the_hemisphere_does_not_cut(m):
    """∫ exp(−(α/m)²) sin 2α dα from 0 to ∞ is m·Dawson(m)."""
    assert_allclose(slopes.gaussian_c(m), 1.0 / (m * special.dawsn(m)), rtol=2e-5)


def test_rms_slope_is_m():
    """The mean of tan² α over the projected area is m² for Beckmann."""
    m = 0.3
    mean, _ = integrate.quad(lambda a: 2 * float(slopes.beckmann(np.cos(a), m)) * np.tan(a) ** 2
                             * np.cos(a) * np.sin(a), 0.0, np.pi / 2)
    assert_allclose(mean, m * m, rtol=1e-8)


def test_several_slopes_add_up():
    c = np.cos(np.linspace(0.0, 1.5, 20))
    assert_allclose(slopes.mixture(slopes.beckmann, c, FIGURE_6B),
                    0.4 * slopes.beckmann(c, 0.4) + 0.6 * slopes.beckmann(c, 0.2), rtol=1e-14)


# --- G ---

def test_v_cavity_by_hand():
    """N·H = 0.9, N·V = 0.2, N·L = 0.8, V·H = 0.6: masking 2·0.9·0.2/0.6 is the smallest."""
    assert_allclose(masking.v_cavity(0.9, 0.2, 0.8, 0.6), 0.6, rtol=1e-12)
    assert_allclose(masking.v_cavity(0.9, 0.8, 0.1, 0.6), 0.3, rtol=1e-12)
    assert masking.v_cavity(0.9, 0.8, 0.8, 0.6) == 1.0
    assert masking.v_cavity(0.9, 0.8, -0.1, 0.6) == 0.0


def test_masking_is_symmetric_in_viewer_and_light():
    v, l = random_directions(500, 1), random_directions(500, 2)
    a, b = cosines(UP, v, l), cosines(UP, l, v)
    assert_allclose(masking.v_cavity(a.n_h, a.n_v, a.n_l, a.v_h), masking.v_cavity(b.n_h, b.n_v, b.n_l, b.v_h))
    assert_allclose(masking.smith_beckmann(a.n_v, a.n_l, 0.4), masking.smith_beckmann(b.n_v, b.n_l, 0.4))


@pytest.mark.parametrize("distribution", [slopes.beckmann, lambda c, m: slopes.gaussian(c, m, slopes.gaussian_c(m))])
@pytest.mark.parametrize("theta", [0.0, 0.7, 1.3, 1.5])
def test_visible_facets_cover_the_view(distribution, theta):
    """∫ G1 (V·H)⁺ D dω = π N·V: what the viewer sees of the facets is the surface he sees (Heitz 2014, eq. 14)."""
    alpha = (np.arange(2000) + 0.5) / 2000 * np.pi / 2
    phi = (np.arange(800) + 0.5) / 800 * 2 * np.pi
    h = direction(alpha[:, None], phi[None, :])
    v = direction(theta, 0.0)
    v_h = h @ v
    seen = masking.v_cavity_one_side(h[..., 2], v[2], v_h) * np.maximum(v_h, 0.0) * distribution(h[..., 2], 0.4)
    total = np.sum(seen * np.sin(alpha)[:, None]) * (np.pi / 2 / 2000) * (2 * np.pi / 800)
    assert_allclose(total, np.pi * v[2], rtol=2e-4)


def test_smith_lambda_against_the_exact_one():
    """Λ = (erf(a) − 1)/2 + exp(−a²)/(2a√π), within the approximation's 0.35 %."""
    theta = np.linspace(0.3, 1.5, 200)
    a = 1.0 / (0.5 * np.tan(theta))
    exact = 0.5 * (special.erf(a) - 1.0) + np.exp(-a * a) / (2.0 * a * np.sqrt(np.pi))
    ours = masking.smith_lambda(np.cos(theta), 0.5)
    assert np.abs(1.0 / (1.0 + ours) - 1.0 / (1.0 + exact)).max() < 0.0035


# --- R ---

def test_specular_by_hand():
    """All at the normal: Rs = F·D/π with D = 1/m²; the energy scale is a quarter of the print."""
    index = np.full(3, 1.5)
    printed = ct.cook_torrance(UP, UP, UP, slopes=[(0.5, 1.0)], index=index, extinction=0.0, scale=ct.PUBLISHED)
    assert_allclose(printed, 0.04 * 4.0 / np.pi, rtol=1e-12)
    energy = ct.cook_torrance(UP, UP, UP, slopes=[(0.5, 1.0)], index=index, extinction=0.0)
    assert_allclose(energy, printed / 4.0, rtol=1e-12)


def test_specular_at_an_angle_by_hand():
    """V at 60°, L at 20° on the other side: α = 20°, θ = 40°; every term by its definition."""
    v, l = direction(np.radians(60), 0.0), direction(np.radians(20), np.pi)
    n_v, n_l, n_h, v_h = (np.cos(np.radians(a)) for a in (60, 20, 20, 40))
    d = np.exp(-np.tan(np.radians(20)) ** 2 / 0.16) / (0.16 * n_h ** 4)
    g = min(1.0, 2 * n_h * n_v / v_h, 2 * n_h * n_l / v_h)
    f = fresnel.conductor(v_h, COPPER["index"], COPPER["extinction"])
    expected = 0.7 * f * d * g / (np.pi * n_l * n_v) / 4.0 + 0.3 * 0.5 / np.pi
    got = ct.cook_torrance(UP, v, l, slopes=[(0.4, 1.0)], s=0.7, normal_reflectance=np.full(3, 0.5), **COPPER)
    assert_allclose(got, expected, rtol=1e-12)


@pytest.mark.parametrize("distribution", ["beckmann", "gaussian"])
@pytest.mark.parametrize("scale", [ct.ENERGY, ct.PUBLISHED])
def test_reciprocal(distribution, scale):
    v, l = random_directions(500, 3), random_directions(500, 4)
    options = {"slopes": FIGURE_6B, "distribution": distribution, "scale": scale, "s": 0.4,
               "normal_reflectance": 0.3, **COPPER}
    assert_allclose(ct.cook_torrance(UP, v, l, **options), ct.cook_torrance(UP, l, v, **options), rtol=1e-9)


def test_nothing_from_below_or_to_below():
    below = direction(np.radians(100), 0.3)
    for v, l in ((UP, below), (below, UP), (below, below)):
        r = ct.cook_torrance(UP, v, l, slopes=FIGURE_6B, s=0.5, normal_reflectance=0.5, **COPPER)
        assert np.all(r == 0.0)


def test_published_gaussian_takes_the_printed_c():
    options = {"slopes": [(0.2, 1.0)], "distribution": "gaussian", "scale": ct.PUBLISHED, **COPPER}
    one = ct.cook_torrance(UP, UP, UP, printed_c=1.0, **options)
    assert_allclose(ct.cook_torrance(UP, UP, UP, printed_c=3.0, **options), 3.0 * one)
    assert_allclose(one, fresnel.conductor(1.0, n=COPPER["index"], k=COPPER["extinction"]) / np.pi)


def test_masking_can_be_exchanged():
    """With Smith's G the lobes of several slopes differ in G, each by its own m."""
    v, l = direction(1.3, 0.0), direction(1.2, np.pi)
    c = cosines(UP, v, l)
    got = ct.cook_torrance(UP, v, l, slopes=FIGURE_6B, masking=lambda c, m: masking.smith_beckmann(c.n_v, c.n_l, m),
                           **WHITE)
    d_g = sum(w * slopes.beckmann(c.n_h, m) * masking.smith_beckmann(c.n_v, c.n_l, m) for m, w in FIGURE_6B)
    assert_allclose(got, d_g / (4 * np.pi * c.n_v * c.n_l), rtol=1e-5)


def test_reflected_light_is_ambient_plus_lights():
    """f·Iia·Ra + Σ Ii (N·L) dω R, with half the hemisphere unblocked."""
    l = direction(np.radians(60), 0.0)
    lights = [(UP, np.full(3, 2.0), 1e-4), (l, np.full(3, 4.0), 2e-4)]
    got = ct.reflected(lights, UP, UP, lambda n, v, l: np.full(3, 0.25), ambient=0.02,
                       ambient_reflectance=np.full(3, 0.5), unblocked=0.5)
    assert_allclose(got, 0.5 * 0.02 * 0.5 + 0.25 * (2.0 * 1e-4 + 4.0 * 0.5 * 2e-4), rtol=1e-12)


def test_a_light_below_the_horizon_adds_nothing():
    lights = [(direction(2.0, 0.0), np.ones(3), 1.0)]
    assert np.all(ct.reflected(lights, UP, UP, lambda n, v, l: np.ones(3)) == 0.0)


# --- albedo ---

@pytest.mark.parametrize("theta", [0.0, 0.9, 1.4])
@pytest.mark.parametrize("distribution", ["beckmann", "gaussian"])
def test_albedo_against_integration_over_the_light(theta, distribution):
    """The same integral taken over L on an even grid instead of over H."""
    options = {"slopes": FIGURE_6B, "distribution": distribution, "s": 0.8, "normal_reflectance": 0.3, **COPPER}
    z = (np.arange(1200) + 0.5) / 1200
    phi = (np.arange(720) + 0.5) / 720 * 2 * np.pi
    l = direction(np.arccos(z)[:, None], phi[None, :])
    r = ct.cook_torrance(UP, direction(theta, 0.0), l, **options)
    expected = np.sum(r * z[:, None, None], axis=(0, 1)) * 2 * np.pi / (1200 * 720)
    assert_allclose(cook_torrance_albedo(np.cos(theta), **options), expected, atol=1.5e-4)


def test_albedo_of_an_almost_smooth_surface_is_fresnel():
    assert_allclose(cook_torrance_albedo(0.8, slopes=[(0.01, 1.0)], **COPPER)[()],
                    fresnel.conductor(0.8, COPPER["index"], COPPER["extinction"]), rtol=1e-3)


def test_energy_scale_never_reflects_more_than_arrives_and_published_does():
    cosine = np.cos(np.radians([0.0, 30.0, 60.0, 80.0, 88.0]))
    for m in (0.1, 0.3, 0.6, 1.0):
        for distribution in ("beckmann", "gaussian"):
            albedo = cook_torrance_albedo(cosine, slopes=[(m, 1.0)], distribution=distribution, count=96, **WHITE)
            assert albedo.max() < 1.0 + 2e-3
    assert cook_torrance_albedo(1.0, slopes=[(0.1, 1.0)], scale=ct.PUBLISHED, **WHITE).max() > 3.9


def test_albedo_shapes():
    assert cook_torrance_albedo(0.5, slopes=[(0.3, 1.0)], count=32, **COPPER).shape == (3,)
    assert cook_torrance_albedo([[0.5, 0.6]], slopes=[(0.3, 1.0)], count=32, **COPPER).shape == (1, 2, 3)


def test_directional_albedo_of_an_even_reflector():
    assert_allclose(directional_albedo(lambda n, v, l: 0.5 / np.pi * (l[..., 2:] > 0.0), 0.7, 1.0), 0.5, rtol=3e-3)


# --- directions ---

def test_mirrored_and_half_vector_undo_each_other():
    v, l = random_directions(200, 5), random_directions(200, 6)
    assert_allclose(mirrored(v, half_vector(v, l)), l, atol=1e-12)


def test_frames_are_orthonormal_everywhere():
    n = np.concatenate([random_directions(300, 7), -random_directions(300, 8), np.eye(3), -np.eye(3)])
    t, b = frame_about(n)
    for axis in (t, b):
        assert_allclose(np.linalg.norm(axis, axis=-1), 1.0, atol=1e-12)
    assert_allclose(np.cross(t, b), n, atol=1e-12)
    assert_allclose(in_frame(0.0, 0.0, 1.0, t, b, n), n)
