"""The closed forms of Standard against quadrature, and the errors of the realisations against independent figures."""

import numpy as np
import pytest

from addon.bake import film_errors
from addon.bake.film_errors import RealisationErrors, realisation_errors, reference_errors, standard_errors, worst_of
from addon.bake.film_table import film_table
from addon.bake.stack_notation import parse
from addon.errors import FacetFilmError
from addon.operands import widen
from addon.reflectance.directions import direction
from addon.reflectance.film_facets import ROUGHEST_FITTED, mean_v_h, spread_v_h, tilted_lobes, tilts, two_looks
from addon.reflectance.masking import smith_beckmann
from addon.spectra.optical_constants import load


def visible_facets(n_v, m, count=400, turns=128):
    """(V·H, weight) of facets: an integral over slopes with Smith's shadowing, none of addon's formulas."""
    tan_alpha = m * np.sqrt(-np.log((np.arange(count) + 0.5) / count))[:, None]
    phi = (np.arange(turns) + 0.5) / turns * np.pi
    n_h = 1.0 / np.sqrt(1.0 + tan_alpha**2)
    v_h = np.sqrt(1.0 - n_v**2) * tan_alpha * n_h * np.cos(phi) + n_v * n_h
    n_l = 2.0 * v_h * n_h - n_v

    def shadow(c):
        a = np.minimum(np.maximum(c, 1e-6) / (m * np.sqrt(np.maximum(1.0 - c * c, 1e-12))), 1.6)
        return np.maximum((1.0 - 1.259 * a + 0.396 * a * a) / (3.535 * a + 2.181 * a * a), 0.0)
    weight = np.where((v_h > 0) & (n_l > 0), v_h / n_h / (1.0 + shadow(n_v) + shadow(n_l)), 0.0)
    return v_h, weight / weight.sum()


@pytest.mark.parametrize("m, mean_off, spread_off", [(0.02, 0.001, 0.002), (0.1, 0.003, 0.003), (0.2, 0.004, 0.009),
                                                     (0.4, 0.006, 0.018), (0.6, 0.008, 0.024)])
def test_mean_and_spread_of_v_h_are_those_of_the_visible_facets(m, mean_off, spread_off):
    n_v = np.cos(np.radians(np.arange(0.0, 89.0, 5.5)))
    for c in n_v:
        v_h, weight = visible_facets(c, m)
        mean = (weight * v_h).sum()
        assert mean_v_h(c, m) == pytest.approx(mean, abs=mean_off)
        assert spread_v_h(c, m) == pytest.approx(np.sqrt((weight * (v_h - mean) ** 2).sum()), abs=spread_off)


def test_beyond_the_fitted_slopes_they_stay():
    assert mean_v_h(0.5, 1.0) == mean_v_h(0.5, ROUGHEST_FITTED)
    assert spread_v_h(0.5, 1.0) == spread_v_h(0.5, ROUGHEST_FITTED)


@pytest.mark.parametrize("m", [1e-3, 0.1, 0.5, 1.0])
@pytest.mark.parametrize("n_v", [1.0, 0.5, 0.01])
def test_a_colour_that_does_not_change_stays_where_it_is(m, n_v):
    n, v = direction(0.0, 0.0), direction(np.arccos(n_v), 0.0)
    for channel, (colour, normal) in enumerate(tilted_lobes(n, v, m, lambda c: widen(0.0 * c) + (0.2, 0.0, 1.0))):
        assert np.allclose(normal, n) and np.allclose(colour, np.eye(3)[channel] * (0.2, 0.0, 1.0))


def test_lobes_tilt_towards_the_viewer_where_the_film_is_brighter_face_on():
    n, v = direction(0.0, 0.0), direction(0.8, 0.3)
    up, down, _ = tilted_lobes(n, v, 0.2, lambda c: 0.5 + widen(c - 0.7) * (0.5, -0.5, 0.0))
    assert up[1] @ v > n @ v > down[1] @ v
    side = np.cross(n, v)
    assert abs(up[1] @ side) < 1e-12 and np.allclose(np.linalg.norm(up[1]), 1.0)


def test_the_tilt_is_the_first_order_of_a_lobe_times_a_line():
    """A Beckmann lobe moved by g sin θ m²/2 in the plane of slopes is the lobe times exp(g V·H), but for a constant."""
    m, theta, g = 0.05, 0.7, 1.3
    tilt = tilts(np.cos(theta), m, np.full(3, 0.5), np.full(3, 0.5 * g * 0.01), 0.01)[0]
    x = np.linspace(-2.0 * m, 2.0 * m, 9)  # slopes along V
    moved = -((x - tilt * np.sin(theta)) ** 2) / m**2
    weighed = -(x**2) / m**2 + g * (np.cos(theta) + x * np.sin(theta))
    assert np.ptp(moved - weighed) < 0.01 * np.ptp(g * x * np.sin(theta))


def test_the_tilt_is_held_and_fades():
    mean = np.full(3, 0.1)
    steep = np.array([0.1, -0.1, 0.0])
    assert np.allclose(tilts(0.6, 0.2, mean, steep, 1e-3) * 0.8, [0.12, -0.12, 0.0])
    assert np.allclose(tilts(0.1, 0.2, mean, mean / 100, 0.1) / tilts(0.9, 0.2, mean, mean / 100, 0.1), 0.25)


def test_the_tilt_is_between_that_of_a_line_and_that_of_an_exponential():
    x = np.array([0.3, 0.6, 0.9])
    tilt = tilts(0.9, 0.1, np.full(3, 0.5), 0.5 * x, 1.0) / (0.5 * 0.1**2)
    assert np.all(x < tilt) and np.all(tilt < np.arctanh(x))


def test_looks_never_leave_the_film():
    for n_v in (1.0, 0.3, 0.01):
        seen = []
        two_looks(n_v, 1.0, lambda c: seen.append(c) or widen(c) * np.ones(3))
        assert 0.0 <= min(seen) <= max(seen) <= 1.0


@pytest.fixture(scope="module")
def tables():
    return {text: film_table(parse(text, load)) for text in
            ("TiO2 0-500 nm / Ti", "SiO2 0-1000 nm / Si", "Fe3O4 0-200 nm / Fe", "soap 5-1000 nm / air")}


@pytest.mark.parametrize("text, thickness, at_01, at_02", [
    # Within what is asked of them: a mean of at most 0.7 and 1.5.
    ("TiO2 0-500 nm / Ti", 60.0, 0.1, 0.3), ("TiO2 0-500 nm / Ti", 120.0, 0.25, 1.0),
    ("SiO2 0-1000 nm / Si", 300.0, 0.5, 1.5), ("Fe3O4 0-200 nm / Fe", 40.0, 0.2, 0.7),
    ("soap 5-1000 nm / air", 400.0, 0.55, 1.5)])
def test_standard_is_as_close_as_films_need(tables, text, thickness, at_01, at_02):
    smooth, rough = (standard_errors(tables[text], m, thickness) for m in (0.1, 0.2))
    assert 0.5 * at_01 < smooth.sphere_mean + 0.05 and smooth.sphere_mean <= at_01
    assert 0.4 * at_02 < rough.sphere_mean <= at_02
    assert smooth.sphere_mean < smooth.sphere_p99 and rough.furnace_mean <= 0.8 and smooth.furnace_mean <= 0.25


@pytest.mark.parametrize("m", [0.1, 0.2, 0.4])
def test_reference_is_closer_and_a_wider_sampling_blurs_it(tables, m):
    table = tables["TiO2 0-500 nm / Ti"]
    exact, usual, wide = (reference_errors(table, m, 120.0, width) for width in (0.0, 0.2, 0.6))
    assert exact.sphere_p99 <= table.delta_e_2000_max and exact.furnace_mean < 0.05
    assert usual.sphere_mean <= 0.5 and usual.sphere_p99 <= 1.5 and usual.furnace_mean <= 0.8
    assert exact.sphere_mean < usual.sphere_mean < wide.sphere_mean
    assert usual.sphere_mean < standard_errors(table, m, 120.0).sphere_mean


def test_the_colour_at_n_v_is_what_standard_is_better_than(tables, monkeypatch):
    table = tables["TiO2 0-500 nm / Ti"]
    ours = standard_errors(table, 0.2, 120.0)

    def at_n_v(n, v, m, look):
        colour = look(np.sum(n * v, axis=-1))
        return [(colour * np.eye(3)[channel], n) for channel in range(3)]
    monkeypatch.setattr(film_errors, "tilted_lobes", at_n_v)
    theirs = standard_errors(table, 0.2, 120.0)
    assert 1.9 < theirs.sphere_mean < 4.5 and theirs.furnace_mean > 0.5  # films.md: 1.9 to 3.8 and 1.4
    assert ours.sphere_mean < 0.4 * theirs.sphere_mean


def test_a_record_has_the_worst_of_the_range(tables):
    table = film_table(parse("TiO2 60-120 nm / Ti", load), rows=32, columns=64)
    both = realisation_errors(table, 0.1, 2)
    ends = [standard_errors(table, 0.1, thickness) for thickness in (60.0, 120.0)]
    assert both["standard"] == pytest.approx(worst_of(ends), abs=5e-3)  # whose spectra are at every nm
    assert both["reference"].sphere_mean < both["standard"].sphere_mean
    one = film_table(table.stack.at(60.0))
    assert realisation_errors(one, 0.1)["standard"] == pytest.approx(standard_errors(one, 0.1, 60.0))


def test_the_sun_is_a_disc_of_five_degrees():
    sun = film_errors._sun(np.radians(30.0))
    centre = np.array([0.5, 0.0, np.sqrt(0.75)])
    away = np.degrees(np.arccos(sun @ centre))
    assert 2.3 < away.max() < 2.5 and np.allclose(np.linalg.norm(sun, axis=-1), 1.0)
    assert np.sqrt((away**2).mean()) == pytest.approx(2.5 / np.sqrt(2.0), rel=0.02)  # of an even disc
    assert np.allclose(sun.mean(axis=0), centre, atol=2e-3)


@pytest.mark.parametrize("degrees, tilt", [(0.0, 0.0), (60.0, 0.0), (50.0, 0.1)])
def test_the_furnace_is_the_lobe_over_all_lights(degrees, tilt):
    """Sums over half vectors, against a plain sum over light directions above the surface."""
    m, n = 0.4, np.array([0.0, 0.0, 1.0])
    v = np.array([np.sin(np.radians(degrees)), 0.0, np.cos(np.radians(degrees))])
    normal = np.array([np.sin(tilt), 0.0, np.cos(tilt)])
    theta, phi = np.meshgrid((np.arange(400) + 0.5) / 400 * np.pi / 2, (np.arange(400) + 0.5) / 400 * 2.0 * np.pi)
    light = direction(theta, phi)
    h = light + v
    h = h / np.linalg.norm(h, axis=-1, keepdims=True)
    n_h, n_l, n_v = h @ normal, light @ normal, normal @ v
    d = np.where(n_h > 0, np.exp((1.0 - 1.0 / np.maximum(n_h, 1e-3) ** 2) / m**2) / (np.pi * m**2 * n_h**4), 0.0)
    lobe = np.where(n_l > 0, d * smith_beckmann(n_v, n_l, m) / (4.0 * n_v), 0.0)
    plain = (lobe * np.sin(theta)).sum() * (np.pi / 2 / 400) * (2.0 * np.pi / 400)
    carried = film_errors._carried(normal, film_errors._facets(m, normal), v, m, n)
    assert carried.mean() == pytest.approx(plain, abs=3e-3)


def test_the_worst_of_several():
    errors = [RealisationErrors(1.0, 2.0, 3.0, 4.0), RealisationErrors(2.0, 1.0, 0.0, 5.0)]
    assert worst_of(errors) == (2.0, 2.0, 3.0, 5.0)


@pytest.mark.parametrize("m", [0.0, 1.5, float("nan")])
def test_slopes_that_no_lobe_has(tables, m):
    with pytest.raises(FacetFilmError, match="slope m must be a number above 0 and at most 1"):
        standard_errors(tables["TiO2 0-500 nm / Ti"], m, 120.0)
