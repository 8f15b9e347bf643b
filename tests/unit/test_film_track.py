"""Blender's native film as a formula, the track that it is fitted to a stack by, and how close both come."""

import numpy as np
import pytest

from addon.bake import film_errors
from addon.bake.colour import delta_e_2000, lab, rgb_to_xyz
from addon.bake.film_choice import NEVER, SLOPES, film_track, slopes_where_closer
from addon.bake.film_table import smallest_table
from addon.bake.film_track import NativeFilm, native_colours
from addon.bake.stack_notation import parse
from addon.models.film import known
from addon.models.film.tables import table_of
from addon.reflectance import fresnel, stack
from addon.reflectance.film_facets import native_share
from addon.spectra.observers import WAVELENGTH_NM, colour_matching_functions
from addon.spectra.optical_constants import load

COSINES = np.cos(np.radians([0.0, 15.0, 37.5, 60.0, 80.0]))
FILMS = (("TiO2 0-200 nm / Ti", 60.0), ("TiO2 0-200 nm / Ti", 120.0), ("SiO2 0-1000 nm / Si", 300.0),
         ("Fe3O4 0-120 nm / Fe", 40.0), ("2.7+0.15i 0-160 nm / Cu", 40.0))
ROUGH = (0.15, 0.2, 0.3, 0.5, 0.7, 1.0)


@pytest.mark.parametrize("thickness", [0.0, 100.0, 300.0])
def test_the_native_film_is_a_film_of_constant_indices_in_even_light(thickness):
    """By the whole series of the transfer matrix, of which three orders leave out most near grazing."""
    index, metal = 1.6, 2.0 + 2.5j
    shown = native_colours(NativeFilm(np.array(index), np.array(thickness), np.full(3, metal.real),
                                      np.full(3, metal.imag)), COSINES, "Rec.709")
    spectra = stack.reflectance([1.0, index, metal], [thickness], COSINES[:, None], WAVELENGTH_NM)
    weights = colour_matching_functions() @ np.linalg.inv(rgb_to_xyz("Rec.709")).T
    exact = spectra @ (weights / weights.sum(axis=0))
    off = np.abs(shown - exact).max(axis=-1)
    assert off[:4].max() < 0.005 and off[4] < 0.06
    if thickness == 0.0:
        bare = fresnel.conductor(COSINES, metal.real, metal.imag)
        np.testing.assert_allclose(shown, np.repeat(bare[:, None], 3, axis=-1), atol=1e-9)


@pytest.mark.parametrize("text, thickness", FILMS)
def test_standard_follows_one_film_on_metal_at_any_slope(text, thickness):
    table, track = table_of(text, {}), known.tracks()[text]
    for m in (0.05, 0.1):
        assert film_errors.standard_errors(table, m, thickness, track).sphere_mean <= 0.7
    found = {m: film_errors.standard_errors(table, m, thickness, track) for m in ROUGH}
    assert max(errors.sphere_mean for errors in found.values()) <= 1.0, found
    assert found[0.2].furnace_mean <= 0.8, found
    assert film_errors.standard_errors(table, 1.0, thickness).sphere_mean > 1.5  # by the lobes alone


def test_standard_takes_the_closer_of_both():
    """Whatever the thickness: half-way between two knots the track was fitted, too."""
    table, track = table_of(FILMS[0][0], {}), known.tracks()[FILMS[0][0]]
    for thickness in (33.0, 87.5, 162.5):
        for m in (0.1, 0.5):
            lobes, native = (film_errors.standard_errors(table, m, thickness),
                             film_errors.native_errors(table, m, thickness, track))
            standard = film_errors.standard_errors(table, m, thickness, track)
            assert standard.sphere_mean <= min(lobes.sphere_mean, native.sphere_mean) + 0.15


def test_a_track_shows_no_step_over_thickness():
    """Largest CIEDE2000 from one of 400 thicknesses to the next, against that of the exact colours."""
    table, track = table_of(FILMS[0][0], {}), known.tracks()[FILMS[0][0]]
    thicknesses = np.linspace(*table.thickness_range_nm, 400)
    shown = lab(native_colours(track.at(thicknesses), COSINES[1:3], "Rec.709"))
    exact = lab(table.at(COSINES[1:3], thicknesses[:, None]).astype(float))
    steps, wanted = (delta_e_2000(colours[1:], colours[:-1]) for colours in (shown, exact))
    assert (steps - wanted).max() < 0.5


def test_a_fit_from_scratch_is_as_close_as_the_one_that_is_kept():
    table, kept = table_of(FILMS[3][0], {}), known.tracks()[FILMS[3][0]]
    fitted, thicknesses = film_track(table), np.linspace(0.0, 120.0, 61)
    exact = lab(table.at(COSINES[:4], thicknesses[:, None]).astype(float))
    off = [delta_e_2000(exact, lab(native_colours(track.at(thicknesses), COSINES[:4], "Rec.709"))).mean()
           for track in (kept, fitted)]
    assert max(off) < 0.5 and off[1] == pytest.approx(off[0], abs=0.1)


def test_the_native_film_is_left_out_where_it_is_never_closer():
    table = smallest_table(parse("TiO2 60 nm / Ti", load))
    track = film_track(table)
    assert SLOPES[0] < track.from_slope[0] < 0.4
    spoilt = film_errors.native_errors(table, 0.3, 60.0, _with_index(track, 4.4))
    assert spoilt.sphere_mean > 5.0
    assert slopes_where_closer(table, _with_index(track, 4.4)).tolist() == [NEVER]
    assert native_share(1.0, NEVER) == 0.0


def _with_index(track, index):
    knots = track.knots.copy()
    knots[:, 0] = index
    return type(track)(track.thicknesses_nm, knots, track.from_slope)
