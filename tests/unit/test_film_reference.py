"""The Reference of films by quadrature: all facets that it draws at once, so that no noise stands in for its error."""

import numpy as np
import pytest

from addon.bake.colour import delta_e_2000, lab
from addon.bake.film_table import curve_over_angle
from addon.models.cook_torrance import formulas as ct
from addon.models.cook_torrance import sampler
from addon.models.film.exact import looks
from addon.models.film.tables import table_of
from addon.reflectance import sampling
from addon.reflectance.directions import half_vector
from tests.unit.test_cook_torrance_sampler import NEVER_FRESNEL, UP, disc, narrow_lobe, native_reflectance, slopes_about

FILMS = (("TiO2 0-200 nm / Ti", 60.0), ("TiO2 0-200 nm / Ti", 120.0), ("SiO2 0-1000 nm / Si", 300.0),
         ("Fe3O4 0-120 nm / Fe", 40.0), ("soap 5-1000 nm / air", 400.0))
WIDTH = 0.2
ACROSS = 7


def reference(v, l, m, look):
    """What the native lobe and the lobes about all drawn facets reflect from l ``(L, 3)`` to v, times N·L: (L, 3)."""
    a, wide = sampling.narrow_slope(m, WIDTH), sampling.wide_slope(m, WIDTH)
    share, lean = sampler.native_lobe(v[2], m)
    floor = looks(v[2], m, look)[1]
    m2_drawn, _ = sampling.narrowed(m, a)
    h = half_vector(v, l)
    rho = np.hypot(h[:, 0], h[:, 1]) / h[:, 2]
    sx, sy, area = slopes_about(h, a, np.maximum(a, wide * np.minimum(2.5 * rho / m, 1.0)))
    kept = np.exp(-(sx**2 + sy**2) / m2_drawn)
    u_tilt = np.cbrt(kept)  # towards the flanks, at a bias of 1
    x = sampler.facet(UP, v, m, a, wide, sampler.FLANKS, 0.0, u_tilt, np.mod(np.arctan2(-sx, sy) / (2 * np.pi), 1.0),
                      0.0)
    v_h = (sx * v[0] + sy * v[1] + v[2]) / np.sqrt(1 + sx**2 + sy**2)
    other = 2 * v[2] / np.sqrt(1 + sx**2 + sy**2) - v_h
    picked = 2 * np.maximum(v_h, 0) / np.maximum(np.maximum(v_h, 0) + np.maximum(other, 0), 1e-12)
    density = kept / (np.pi * m2_drawn) / (3 * np.maximum(u_tilt, 1e-12) ** 2) * picked
    under = floor * (sampler.HEADROOM * share * sampler.native_over_d(x, m, lean))[..., None]
    left = np.maximum(look(np.clip(x.v_h, 0.0, 1.0)) * sampler.sharpened_v_cavity(x)[..., None] - under, 0.0)
    lobe = narrow_lobe(x, v, l[:, None, None, :], h[:, None, None, :]) * (v_h > 0.0) * x.density
    drawn = np.sum((density * lobe * area)[..., None] * left, axis=(1, 2))
    return drawn + native_reflectance(v, l, m)[:, None] * floor


def over_the_sphere(m, sun, look, film):
    """(Reference, formula, formula of a white film) at points of a sphere under a sun of 5°, each a mean over it."""
    viewer, found = np.array([0.0, 0.0, 1.0]), []
    lights = disc(np.array([np.sin(sun), 0.0, np.cos(sun)]))
    for x in np.linspace(-0.97, 0.97, 2 * ACROSS + 1):
        for y in np.linspace(0.0, 0.97, ACROSS + 1):
            if x * x + y * y > 0.96:
                continue
            normal = np.array([x, y, np.sqrt(1.0 - x * x - y * y)])
            side = np.cross(viewer, normal) if np.hypot(x, y) > 0.0 else np.array([0.0, 1.0, 0.0])
            side = side / np.linalg.norm(side)
            to_local = np.stack([np.cross(side, normal), side, normal])
            v, l = to_local @ viewer, lights @ to_local.T
            l = l[l[:, 2] > 1e-3]
            if len(l):
                f = ct.cook_torrance(UP, v, l, slopes=[(m, 1.0)], index=NEVER_FRESNEL[0], extinction=NEVER_FRESNEL[1])
                white = f[:, 0] * l[:, 2]
                exact = white[:, None] * film(np.clip(np.sum(half_vector(v, l) * v, axis=-1), 0.0, 1.0))
                found.append([part.sum(axis=0) / len(lights) * np.ones(3)
                              for part in (reference(v, l, m, look), exact, white)])
    return np.moveaxis(np.array(found), 1, 0)


def errors(stack, thickness, m):
    """(mean, 99th percentile) of CIEDE2000 where a white lobe has more than 2 % of its peak, the worse sun's mean."""
    table = table_of(stack, {})
    grid = np.linspace(0.0, 1.0, 257)
    curve = curve_over_angle(table.stack, table.viewing, thickness, grid**2)

    def film(c):
        return np.stack([np.interp(np.sqrt(c), grid, channel) for channel in curve.T], axis=-1)
    means, everywhere = [], []
    for sun in np.radians([30.0, 75.0]):
        shown, exact, white = over_the_sphere(m, sun, lambda c: table.at(c, thickness), film)
        lit = white[:, 0] > 0.02 * white.max()
        different = delta_e_2000(lab(exact[lit] / white.max()), lab(shown[lit] / white.max()))
        means.append(different.mean())
        everywhere.append(different)
    return max(means), np.percentile(np.concatenate(everywhere), 99.0)


@pytest.mark.parametrize("stack, thickness", FILMS)
@pytest.mark.parametrize("m", [0.1, 0.2])
def test_reference_is_the_spectrum_at_each_facet(stack, thickness, m):
    mean, high = errors(stack, thickness, m)
    print(f"{stack}, {thickness:g} nm, m {m:g}: mean {mean:.2f}, 99th percentile {high:.2f}")
    assert mean <= 0.5 and high <= 1.5


def test_a_wider_sampling_blurs_more(monkeypatch):
    usual = errors(*FILMS[2], 0.2)
    monkeypatch.setitem(globals(), "WIDTH", 0.35)
    assert errors(*FILMS[2], 0.2)[0] > 1.5 * usual[0]
