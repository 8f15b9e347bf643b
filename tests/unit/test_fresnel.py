"""The Fresnel formulas against complex arithmetic, hand-worked values and limits."""

import numpy as np
import pytest

from addon.reflectance import fresnel

COS_THETA = np.cos(np.radians(np.append(np.arange(0.0, 90.0, 0.5), 89.99)))[:, None]
N = np.array([0.05, 0.2, 0.6, 1.0, 1.5, 2.4, 4.0, 7.0])
K = np.array([0.0, 0.01, 0.5, 1.5, 3.0, 8.0])
N_K = np.array(np.meshgrid(N, K)).reshape(2, -1)
SURFACE = (N_K[0] != 1.0) | (N_K[1] != 0.0)


def by_complex_amplitudes(cos_theta, n, k):
    """Unpolarised reflectance from the amplitude coefficients and Snell's law in complex numbers."""
    index = n + 1j * k
    cos_inside = np.sqrt(1.0 - (1.0 - cos_theta**2) / index**2 + 0j)
    r_s = (cos_theta - index * cos_inside) / (cos_theta + index * cos_inside)
    r_p = (index * cos_theta - cos_inside) / (index * cos_theta + cos_inside)
    return (abs(r_s) ** 2 + abs(r_p) ** 2) / 2.0


def test_conductor_is_the_complex_fresnel_equation():
    n, k = N_K
    assert np.allclose(fresnel.conductor(COS_THETA, n, k), by_complex_amplitudes(COS_THETA, n, k), atol=1e-12)


def test_conductor_in_single_precision():
    n, k = (values.astype(np.float32) for values in N_K[:, SURFACE])
    cos_theta = COS_THETA.astype(np.float32)
    single = fresnel.conductor(cos_theta, n, k)
    assert single.dtype == np.float32
    exact = by_complex_amplitudes(*(a.astype(float) for a in (cos_theta, n, k)))
    assert np.abs(single - exact).max() < 1e-4


def test_conductor_at_the_ends():
    n, k = N_K
    normal = ((n - 1) ** 2 + k**2) / ((n + 1) ** 2 + k**2)
    assert np.allclose(fresnel.conductor(1.0, n, k), normal, atol=1e-14)
    assert np.allclose(fresnel.conductor(0.0, n, k)[SURFACE], 1.0, atol=1e-12)


def test_without_a_surface_nothing_is_reflected():
    assert np.allclose(fresnel.conductor(COS_THETA, 1.0, 0.0), 0.0, atol=1e-12)
    assert fresnel.conductor(0.0, 1.0, 0.0) == 0.0


def test_conductor_without_absorption_is_the_dielectric():
    for n in N:
        assert np.allclose(fresnel.conductor(COS_THETA, n, 0.0), fresnel.dielectric(COS_THETA, n), atol=1e-12)


def test_dielectric_at_brewsters_angle():
    cos_brewster = 1.0 / np.sqrt(1.0 + 1.5**2)
    r_s = ((1.5**2 - 1.0) / (1.5**2 + 1.0)) ** 2
    assert fresnel.dielectric(cos_brewster, 1.5) == pytest.approx(r_s / 2.0, abs=1e-14)


def test_dielectric_reflects_all_beyond_the_critical_angle():
    critical = np.sqrt(1.0 - 0.5**2)
    assert fresnel.dielectric(critical - 1e-6, 0.5) == 1.0
    assert fresnel.dielectric(critical + 1e-3, 0.5) < 0.9
    assert fresnel.dielectric(0.0, 0.5) == 1.0


@pytest.mark.parametrize("f0", [0.0, 0.04, 0.3, 0.8, 0.99])
def test_effective_index_gives_the_normal_reflectance_back(f0):
    assert fresnel.dielectric_from_normal(1.0, f0) == pytest.approx(f0, abs=1e-12)
    assert fresnel.index_from_normal(0.04) == pytest.approx(1.5)


def test_a_perfect_mirror_stays_one_from_its_normal_reflectance():
    assert np.all(fresnel.dielectric_from_normal(COS_THETA[:-1], 1.0) > 0.9998)


def test_blender_4_5_approximation_by_hand():
    # n = 1.5, k = 0, cos θ = 0.2: Rp = (0.09−0.6+1)/(0.09+0.6+1), Rs = (2.25−0.6+0.04)/(2.25+0.6+0.04)
    by_hand = (0.49 / 1.69 + 1.69 / 2.89) / 2.0
    assert fresnel.conductor_blender_4_5(0.2, 1.5, 0.0) == pytest.approx(by_hand, abs=1e-14)
    error = fresnel.conductor_blender_4_5(COS_THETA, 1.5, 0.0) - fresnel.conductor(COS_THETA, 1.5, 0.0)
    assert 0.09 < np.abs(error).max() < 0.11
    assert np.abs(fresnel.conductor_blender_4_5(COS_THETA, 1.0, 8.0)
                  - fresnel.conductor(COS_THETA, 1.0, 8.0)).max() < 0.01


def test_schlick_and_f82_meet_their_anchors():
    f0, tint = np.array([0.1, 0.5, 0.95]), np.array([0.7, 0.9, 1.0])
    c = fresnel.COS_THETA_82
    assert np.allclose(fresnel.schlick(1.0, f0), f0)
    assert np.allclose(fresnel.schlick(0.0, f0), 1.0)
    assert np.allclose(fresnel.f82(1.0, f0, tint), f0)
    assert np.allclose(fresnel.f82(0.0, f0, tint), 1.0)
    assert np.allclose(fresnel.f82(c, f0, tint), tint * (f0 + (1 - f0) * (6 / 7) ** 5))
    assert np.allclose(fresnel.f82(COS_THETA, f0, 1.0), fresnel.schlick(COS_THETA, f0))
    assert np.allclose(fresnel.f82_tint_of(f0, fresnel.f82(c, f0, tint)), tint)


def test_f82_is_held_to_a_reflectance():
    assert fresnel.f82(0.3, 0.02, 0.0) == 0.0
    assert np.all(fresnel.f82(COS_THETA, 1.0, 1.5) == 1.0)


def test_cheap_colour_shift_runs_from_the_metal_to_the_light():
    colour_0, colour_90 = np.array([0.9, 0.6, 0.5]), np.array([1.0, 0.9, 0.8])
    colours = fresnel.cheap_colour_shift(COS_THETA, colour_0, colour_90, 0.6)
    assert np.allclose(colours[0], colour_0)
    assert np.allclose(fresnel.cheap_colour_shift(0.0, colour_0, colour_90, 0.6), colour_90, atol=1e-6)
    # Below its start F dips under F0; the paper's max(0, ·) holds the colour there.
    assert np.all(colours >= colour_0)
