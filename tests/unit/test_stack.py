"""Stacks of films against the tmm package, Airy's closed form, energy, limits and reciprocity."""

import numpy as np
import pytest
import tmm

from addon.errors import FacetFilmError
from addon.reflectance import fresnel, stack

COS_THETA = np.cos(np.radians([0.0, 20.0, 45.0, 70.0, 85.0, 89.9]))
WAVELENGTH_NM = np.array([380.0, 480.0, 589.0, 780.0])[:, None]


def random_stack(rng):
    """(indices, thicknesses) of one to five films, some of them and of the substrates absorbing, some in glass."""
    films = rng.integers(1, 6)
    index = rng.uniform(1.2, 3.5, films) + 1j * rng.choice([0.0, 1.0], films) * 10.0 ** rng.uniform(-3.0, 0.6, films)
    substrate = rng.uniform(0.2, 4.0) + 1j * rng.choice([0.0, rng.uniform(0.0, 5.0)])
    ambient = rng.choice([1.0, rng.uniform(1.0, 1.6)])
    return [ambient + 0j, *index, substrate], list(rng.uniform(0.0, 600.0, films))


def test_three_hundred_random_stacks_as_tmm_has_them():
    rng = np.random.default_rng(0)
    for _ in range(300):
        indices, thicknesses = random_stack(rng)
        c, wavelength = rng.uniform(0.02, 1.0), rng.uniform(380.0, 780.0)
        angle, thick = np.arccos(c), [np.inf, *thicknesses, np.inf]
        theirs = [tmm.coh_tmm(p, indices, thick, angle, wavelength) for p in "sp"]
        ours = stack.powers(indices, thicknesses, c, wavelength)
        assert ours.r_s == pytest.approx(theirs[0]["R"], abs=1e-10)
        assert ours.r_p == pytest.approx(theirs[1]["R"], abs=1e-10)
        assert ours.t_s == pytest.approx(theirs[0]["T"], abs=1e-10)
        assert ours.t_p == pytest.approx(theirs[1]["T"], abs=1e-10)


def by_s(n, c, m, c_m):
    """Fresnel's r and t of E between indices n and m."""
    return (n * c - m * c_m) / (n * c + m * c_m), 2.0 * n * c / (n * c + m * c_m)


def by_p(n, c, m, c_m):
    return (m * c - n * c_m) / (m * c + n * c_m), 2.0 * n * c / (m * c + n * c_m)


def airy(n_0, n_1, n_2, thickness, c, wavelength):
    """(R, T) of one film by Airy's formulas."""
    c_1, c_2 = (np.sqrt(1.0 - (n_0 / n) ** 2 * (1.0 - c * c) + 0j) for n in (n_1, n_2))
    once = np.exp(2j * np.pi * n_1 * thickness * c_1 / wavelength)
    reflected = transmitted = 0.0
    for fresnel_of, carried in ((by_s, (n_2 * c_2).real), (by_p, (n_2 * np.conj(c_2)).real)):
        (r_1, t_1), (r_2, t_2) = fresnel_of(n_0, c, n_1, c_1), fresnel_of(n_1, c_1, n_2, c_2)
        many = 1.0 + r_1 * r_2 * once**2
        reflected = reflected + 0.5 * abs((r_1 + r_2 * once**2) / many) ** 2
        transmitted = transmitted + 0.5 * carried / (n_0 * c) * abs(t_1 * t_2 * once / many) ** 2
    return reflected, transmitted


@pytest.mark.parametrize("film, substrate", [(1.33, 1.0), (1.38, 1.52), (2.4 + 0.05j, 2.0 + 2.8j), (0.2 + 3.0j, 1.5)])
def test_one_film_is_airys_closed_form(film, substrate):
    thickness = np.array([0.0, 3.0, 80.0, 550.0])
    c, wavelength = COS_THETA[:, None], WAVELENGTH_NM[..., None]
    ours = stack.powers([1.0, film, substrate], [thickness], c, wavelength)
    theirs = airy(1.0, film, substrate, thickness, c, wavelength)
    assert ours.reflected.shape == (4, 6, 4)
    assert np.allclose(ours.reflected, theirs[0], atol=1e-12)
    assert np.allclose(ours.transmitted, theirs[1], atol=1e-12)


def test_what_does_not_absorb_loses_nothing():
    ours = stack.powers([1.0, 1.38, 2.3, 1.46, 1.52], [97.0, 41.0, 210.0], COS_THETA, WAVELENGTH_NM)
    assert np.allclose(ours.r_s + ours.t_s, 1.0, atol=1e-12)
    assert np.allclose(ours.r_p + ours.t_p, 1.0, atol=1e-12)


def test_an_absorber_takes_some_and_never_gives():
    ours = stack.powers([1.0, 1.46, 2.0 + 1.5j, 1.5], [100.0, 30.0], COS_THETA, WAVELENGTH_NM)
    lost = 1.0 - ours.reflected - ours.transmitted
    assert 0.0 < lost.min() and lost.max() < 1.0


def test_beyond_the_critical_angle_light_tunnels_through_a_thin_film_only():
    thin, thick = (stack.powers([1.5, 1.0, 1.5], [d], 0.5, 550.0) for d in (20.0, 5000.0))
    assert 0.3 < thin.transmitted < 1.0
    assert thick.transmitted < 1e-12 and thick.reflected == pytest.approx(1.0, abs=1e-12)


def test_without_films_it_is_the_fresnel_equation():
    c = COS_THETA[:, None]
    index = np.array([1.5, 2.4, 0.2 + 3.0j, 3.9 + 0.02j])
    bare = stack.reflectance([1.0, index], [], c, 550.0)
    assert np.allclose(bare, fresnel.conductor(c, index.real, index.imag), atol=1e-12)
    nothing_on_it = stack.reflectance([1.0, 2.4, 1.46, index], [0.0, 0.0], c, 550.0)
    assert np.allclose(nothing_on_it, bare, atol=1e-12)


def test_a_thick_absorber_hides_what_is_below():
    hidden = stack.powers([1.0, 2.0 + 3.0j, 1.5], [1e6], COS_THETA, WAVELENGTH_NM)
    assert np.all(np.isfinite(hidden.reflected)) and np.all(hidden.transmitted == 0.0)
    assert np.allclose(hidden.reflected, fresnel.conductor(COS_THETA, 2.0, 3.0), atol=1e-12)


def test_a_quarter_wave_by_hand():
    # R = ((n0 ns − n1²)/(n0 ns + n1²))² where n1 d is a quarter of the wavelength
    by_hand = ((1.52 - 1.38**2) / (1.52 + 1.38**2)) ** 2
    assert stack.reflectance([1.0, 1.38, 1.52], [550.0 / 4 / 1.38], 1.0, 550.0) == pytest.approx(by_hand, abs=1e-14)
    ten_pairs = [1.0, *[2.3, 1.38] * 10, 1.52]
    quarters = [550.0 / 4 / n for n in ten_pairs[1:-1]]
    y = 1.52 * (2.3 / 1.38) ** 20  # admittance of ten pairs of quarter waves
    assert stack.reflectance(ten_pairs, quarters, 1.0, 550.0) == pytest.approx(((1 - y) / (1 + y)) ** 2, abs=1e-12)


def test_as_much_light_goes_through_from_below():
    """T is the same either way, also with absorption; R is not."""
    c = COS_THETA[:-1, None]
    down = stack.powers([1.0, 1.46, 2.3 + 0.4j, 1.52], [90.0, 35.0], c, WAVELENGTH_NM[..., None])
    c_below = np.sqrt(1.0 - (1.0 - c * c) / 1.52**2)
    up = stack.powers([1.52, 2.3 + 0.4j, 1.46, 1.0], [35.0, 90.0], c_below, WAVELENGTH_NM[..., None])
    assert np.allclose(down.t_s, up.t_s, atol=1e-12) and np.allclose(down.t_p, up.t_p, atol=1e-12)
    assert abs(down.reflected - up.reflected).max() > 0.05


def test_grazing_and_critical_angles_are_finite():
    at_the_edge = stack.powers([1.5, 1.0, 1.5], [100.0], np.array([0.0, np.sqrt(1.0 - 1.0 / 1.5**2)]), 550.0)
    assert np.all(np.isfinite(at_the_edge)) and at_the_edge.reflected[0] == pytest.approx(1.0, abs=1e-6)
    assert at_the_edge.reflected[1] + at_the_edge.transmitted[1] == pytest.approx(1.0, abs=1e-6)


@pytest.mark.parametrize("indices, thicknesses, said", [
    ([1.0 + 1e-9j, 1.5], [], "must not absorb"),
    ([1.0, 1.4, 1.5], [], "2 indices"),
    ([1.0, 1.4, 1.5], [-1.0], "at least 0 nm; that of layer 1 is -1"),
    ([1.0, 1.4, 1.5], [np.nan], "at least 0 nm"),
    ([1.0, 1.4 - 0.1j, 1.5], [10.0], "Layer 1 of a stack"),
    ([1.0, 0.0, 1.5], [10.0], "Layer 1 of a stack"),
    ([1.0, np.nan], [], "Layer 1 of a stack")])
def test_what_is_no_stack_is_refused(indices, thicknesses, said):
    with pytest.raises(FacetFilmError, match=said):
        stack.powers(indices, thicknesses, 1.0, 550.0)
