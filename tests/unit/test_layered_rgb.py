"""The layered RGB reference against an independent evaluation, values worked by hand, and limits."""

import cmath
import math

import numpy as np
import pytest

from addon.models.layered_rgb import formulas as layered

RNG = np.random.default_rng(2003)
UP = np.array([0.0, 0.0, 1.0])


# --- an independent evaluation: one channel, explicit vectors, as the paper's text says it ---

def refract(travel, normal, index):
    """Snell's law for a unit vector that travels against the normal into a medium of this index."""
    across = travel - np.dot(travel, normal) * normal
    sine = across / index
    return sine - normal * math.sqrt(1.0 - np.dot(sine, sine))


def mirror(travel, normal):
    return travel - 2.0 * np.dot(travel, normal) * normal


def paper_lobes(light, view, n0, n1, r1, e0, e1):
    """R, T (eqs. 6, 10) and the refracted directions of one channel, from i = -L and o = V."""
    i, o = -light, view
    ii, io = refract(i, n0, r1), refract(-o, n0, r1)
    ri, rii = mirror(i, n0), mirror(ii, n1)
    f = ((1.0 - r1) / (1.0 + r1)) ** 2
    fresnel = f + (1.0 - f) * (1.0 - np.dot(-i, n0)) ** 5
    transmission = (1.0 - f) * (1.0 - (1.0 + np.dot(io, n0)) ** 5)
    r = fresnel * max(np.dot(ri, o), 0.0) ** e0
    t = 0.0
    if np.dot(ii, n1) < 0 and np.dot(io, n1) < 0 and np.dot(rii, io) < 0:
        t = (1.0 - fresnel) * transmission * np.dot(rii, -io) ** e1
    return r, t, ii, io


def paper_rho(light, view, n0, n1, r1, d, wavelength, e0, e1, energy=True):
    """ρ of eq. 5 as the square of two interfering amplitudes, |√R + √T exp(2iΦ)|² / 2."""
    r, t, ii, io = paper_lobes(light, view, n0, n1, r1, e0, e1)
    if energy:
        r, t = r * (e0 + 2) / (2 * math.pi), t * (e1 + 2) / (2 * math.pi)
    phase = math.pi * r1 * d / wavelength * np.dot(ii + io, -n0)
    return abs(math.sqrt(r) + cmath.exp(2j * phase) * math.sqrt(t)) ** 2 / 2.0


def directions(count):
    """Random unit vectors above the horizon."""
    v = RNG.normal(size=(count, 3))
    v /= np.linalg.norm(v, axis=-1, keepdims=True)
    v[:, 2] = np.abs(v[:, 2])
    return v


def near(axis, spread):
    """Unit vectors scattered about an axis."""
    v = axis + RNG.normal(size=axis.shape) * spread
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


CASES = [
    # r1, d, e0, e1, deviation
    ((1.5, 1.5, 1.5), 92.0, 30.0, 40.0, 0.0),
    ((1.4, 1.45, 1.6), 70.0, 9.0, 17.0, math.radians(10)),
    ((1.5, 1.6, 1.8), 170.0, 13.0, 13.0, math.radians(14)),
    ((1.3, 1.33, 1.36), 400.0, 0.0, 0.0, math.radians(75)),
]


@pytest.mark.parametrize("published", [0.0, 1.0])
@pytest.mark.parametrize("r1, d, e0, e1, deviation", CASES)
def test_specular_is_the_papers(r1, d, e0, e1, deviation, published):
    light, view = directions(200), directions(200)
    n1 = layered.tilted_normal(UP, np.array([1.0, 0, 0]), np.array([0, 1.0, 0]), deviation, 0.7)
    cosines = layered.inner_products(light, view, UP, n1, np.array(r1))
    found = layered.layered_specular(cosines, np.array(r1), d, layered.WAVELENGTHS, e0, e1, published)
    expected = [[paper_rho(l, v, UP, n1, r, d, wavelength, e0, e1, energy=not published)
                 for r, wavelength in zip(r1, (645.0, 525.0, 445.0))] for l, v in zip(light, view)]
    np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-12)


def test_every_null_condition_is_met_and_matters():
    """Each of eq. 10's three conditions is the only one to hold for some of the directions tried."""
    index = 1.1  # wide enough a cone in the layer for ii and io to be more than 90° apart
    r1, deviation, alone = np.full(3, index), math.radians(75), np.zeros(3, int)
    n1 = layered.tilted_normal(UP, np.array([1.0, 0, 0]), np.array([0, 1.0, 0]), deviation, 0.0)
    light, view = directions(4000), directions(4000)
    cosines = layered.inner_products(light, view, UP, n1, r1)
    _, t = layered.layered_lobes(cosines, r1, 0.0, 0.0)
    for k in range(len(light)):
        ii, io = refract(-light[k], UP, index), refract(-view[k], UP, index)
        null = [np.dot(ii, n1) >= 0, np.dot(io, n1) >= 0, np.dot(mirror(ii, n1), io) >= 0]
        assert (t[k] == 0).all() == any(null)
        if sum(null) == 1:
            alone[null.index(True)] += 1
    assert (alone > 10).all()


def test_thickness_of_half_and_quarter_waves():
    """At normal incidence 2Φ = 4π r1 d/λ: λ/(2 r1) adds the amplitudes, λ/(4 r1) subtracts them."""
    r1, f = np.full(3, 1.5), 0.04
    r, t = f, (1 - f) ** 2
    cosines = layered.inner_products(UP, UP, UP, UP, r1)
    for d, sign in ((0.0, 1), (645 / 3.0, 1), (645 / 6.0, -1)):
        red = layered.layered_specular(cosines, r1, d, layered.WAVELENGTHS, 90.0, 170.0, published=1.0)[0]
        assert red == pytest.approx((math.sqrt(r) + sign * math.sqrt(t)) ** 2 / 2)


def test_the_scale_is_that_of_each_lobe():
    """(e+2)/(2π) of R at e0 and of T at e1, and so the geometric mean of the two on the interference."""
    r1 = np.full(3, 1.5)
    cosines = layered.inner_products(UP, UP, UP, UP, r1)
    printed = layered.layered_lobes(cosines, r1, 90.0, 170.0, 1.0)
    energy = layered.layered_lobes(cosines, r1, 90.0, 170.0, 0.0)
    np.testing.assert_allclose(energy[0] / printed[0], 92 / (2 * math.pi))
    np.testing.assert_allclose(energy[1] / printed[1], 172 / (2 * math.pi))


def test_diffuse_parts_are_the_averages_that_the_paper_says():
    """Eq. 12 is the cosine-weighted mean of Schlick's F: 2 ∫ (f + (1-f)(1-c)^5) c dc."""
    nodes, weights = np.polynomial.legendre.leggauss(20)
    c, w = (nodes + 1) / 2, weights / 2
    for r1 in (1.1, 1.3, 1.5, 1.8, 2.4):
        fresnel = layered.fresnel_eq7(c, layered.f_eq8(np.array([r1])))[:, 0]
        assert layered.r_d_eq12(r1) == pytest.approx(np.sum(w * 2 * c * fresnel), abs=1e-12)
        assert layered.t_d_eq13(r1) == pytest.approx(1 - layered.r_d_eq12(r1), abs=1e-12)


def test_mean_refracted_cosine_is_that_over_all_cosines():
    c = np.linspace(0.0, 1.0, 20001)
    for r1 in (1.2, 1.5, 2.0):
        cosine = np.sqrt(1 - (1 - c ** 2) / r1 ** 2)
        mean = np.sum((cosine[1:] + cosine[:-1]) / 2) / (len(c) - 1)
        assert layered.mean_cosine_eq14(r1) == pytest.approx(mean, abs=1e-6)


def test_diffuse_albedo():
    """Eq. 16 worked by hand for r1 = 1.5: Td = 32/35, √(Td (1-Td)) = √96/35."""
    swing = math.sqrt(96.0) / 35.0
    for d in (0.0, 15.0, 70.0, 170.0, 400.0):
        phase = [4 * math.pi * 1.5 * d / wavelength for wavelength in (645, 525, 445)]
        energy = layered.rho_d_eq16(np.full(3, 1.5), d, layered.WAVELENGTHS)
        np.testing.assert_allclose(energy, [0.5 + swing * math.cos(p) for p in phase], atol=1e-12)
        printed = layered.rho_d_eq16(np.full(3, 1.5), d, layered.WAVELENGTHS, published=1.0)
        np.testing.assert_allclose(printed, 2 * energy, atol=1e-12)
        eq11 = layered.rho_d_eq11(layered.r_d_eq12(1.5), layered.t_d_eq13(1.5), np.array(phase) / 2)
        np.testing.assert_allclose(energy, eq11, atol=1e-12)


def test_complete_material_mixes_and_ends_at_the_horizon():
    light, view = directions(50), directions(50)
    light[:10, 2] *= -1
    view[10:20, 2] *= -1
    options = dict(r1=np.array([1.4, 1.45, 1.6]), d=70.0, e0=9.0, e1=17.0)
    both = layered.layered_rgb(light, view, UP, UP, specular=1.0, diffuse=0.7, **options)
    phong = layered.layered_rgb(light, view, UP, UP, specular=1.0, diffuse=0.0, **options)
    diffuse = layered.layered_rgb(light, view, UP, UP, specular=0.0, diffuse=0.7, **options)
    np.testing.assert_allclose(both, phong + diffuse)
    assert (both[:20] == 0).all() and (both[20:] > 0).all()
    albedo = layered.rho_d_eq16(options["r1"], 70.0, layered.WAVELENGTHS)
    np.testing.assert_allclose(diffuse[20:], np.broadcast_to(0.7 * albedo / math.pi, (30, 3)))


def test_never_negative_and_bounded_by_both_lobes():
    view = directions(5000)
    light = near(view * [-1, -1, 1], 0.1)
    light[:, 2] = np.abs(light[:, 2])
    r1 = np.array([1.4, 1.45, 1.6])
    cosines = layered.inner_products(light, view, UP, UP, r1)
    r, t = layered.layered_lobes(cosines, r1, 90.0, 170.0)
    rho = layered.layered_specular(cosines, r1, RNG.uniform(0, 500, 5000), layered.WAVELENGTHS, 90.0, 170.0)
    assert (rho >= (np.sqrt(r) - np.sqrt(t)) ** 2 / 2 - 1e-9).all()
    assert (rho <= r + t + 1e-9).all()


def test_not_reciprocal():
    light, view = directions(100), directions(100)
    r1 = np.full(3, 1.5)
    there = layered.layered_specular(layered.inner_products(light, view, UP, UP, r1), r1, 92.0,
                                     layered.WAVELENGTHS, 2.0, 2.0)
    back = layered.layered_specular(layered.inner_products(view, light, UP, UP, r1), r1, 92.0,
                                    layered.WAVELENGTHS, 2.0, 2.0)
    assert np.abs(there - back).max() > 0.01


def test_shapes_broadcast_and_nan_stays_nan():
    light, view = directions(4).reshape(4, 1, 3), directions(5)
    full = layered.layered_rgb(light, view, UP, UP, r1=1.5, d=70.0, e0=3.0, e1=4.0)
    assert full.shape == (4, 5, 3)
    unknown = layered.layered_rgb(light, view, UP, UP, r1=1.5, d=np.full((4, 5), np.nan), e0=3.0, e1=4.0)
    assert np.isnan(unknown).all()


def test_tilted_normal_has_the_deviation_and_the_azimuth():
    for deviation, azimuth in ((0.0, 0.0), (0.2, 0.0), (0.24, 2.5)):
        n1 = layered.tilted_normal(UP, np.array([1.0, 0, 0]), np.array([0, 1.0, 0]), deviation, azimuth)
        assert math.acos(min(n1 @ UP, 1.0)) == pytest.approx(deviation, abs=1e-7)
        if deviation:
            assert math.atan2(n1[1], n1[0]) == pytest.approx(azimuth)
