"""The checks of films: spheres against the exact spectrum at V·H, and energy of what is seen through."""

import numpy as np

from ..bake.colour import delta_e_2000, lab
from ..bake.film_table import curve_over_angle
from ..blender import compat
from ..blender.datablocks import materials
from ..models.film.formulas import slope
from ..models.film.tables import table_of
from ..models.making import made
from ..reflectance.masking import smith_beckmann, v_cavity
from ..reflectance.slopes import beckmann
from . import scenes
from .checks import Check, Figure, Outcome, Picture

__all__ = ["checks"]

MODEL = "film"
SUNS = (30.0, 75.0)
DIAMETER = np.radians(5.0)
SIZES = {"fast": (48, 16, 1), "exact": (32, 2048, 4), "osl": (32, 2048, 4)}
"""Pixels of a sphere's side, samples of each, and pixels of a block's side whose mean is compared: noise is none of the
formula's."""
SHOWN, LEAST_N_V = 0.02, 0.15
LIMITS = {("fast", 0.1): (0.7, 2.0), ("fast", 0.2): (1.5, 5.0), ("fast", 0.5): (1.0, 2.0),
          ("exact", 0.1): (0.7, 2.0), ("exact", 0.2): (0.7, 2.0), ("osl", 0.1): (0.7, 2.0), ("osl", 0.2): (0.7, 2.0)}
"""{(realisation, m): largest mean and 99th percentile of CIEDE2000}; most of what Reference and OSL are off by here is
noise: by quadrature it is 0.4 and 1.0 at the most.  Those at 0.5 are for Blenders with a film of their own.
"""
NATIVE = 0.5
ON_METAL = 4
"""How many of the first stacks are one film on metal or silicon."""
STACKS = (("TiO2 0-200 nm / Ti", 120.0), ("SiO2 0-1000 nm / Si", 300.0), ("TiO2 0-200 nm / Ti", 60.0),
          ("Fe3O4 0-120 nm / Fe", 40.0), ("soap 5-1000 nm / 1.0001+0.02i", 400.0))
COUNTS = {"fast": 5, "exact": 2, "osl": 1}
"""How many of them a realisation is held to; noise takes samples away."""
CLEAR = (("soap 5-1000 nm / air", 400.0), ("MgF2 0-200 nm / glass", 100.0))
COATED = ("MgF2 0-200 nm / glass", 100.0)
BALANCE = 1e-3
"""Of R + T from 1."""


def checks(realisations):
    """The checks of these realisations."""
    sphere = ("a sphere under suns of 5° at 30° and 75° against the exact spectrum at V·H: CIEDE2000 where the lobe "
              "has more than 2 % of its peak")
    found = [Check(MODEL, realisation, f"{stack}, {d:g} nm, slope {m:g}", sphere, on_a_sphere,
                   {"stack": stack, "thickness": d, "roughness": m**0.5})
             for realisation in realisations for stack, d in STACKS[:COUNTS[realisation]] for m in (0.1, 0.2)]
    if compat.has_native_film() and "fast" in realisations:
        found += [Check(MODEL, "fast", f"{stack}, {d:g} nm, slope {NATIVE:g}", sphere, on_a_sphere,
                        {"stack": stack, "thickness": d, "roughness": NATIVE**0.5}) for stack, d in STACKS[:ON_METAL]]
    return found + [Check(MODEL, realisation, f"{stack}: R + T", "a sphere in an even white world: difference of "
                          "its mean from the world", balance, {"stack": stack, "thickness": d, "roughness": 0.0,
                                                            "see_through": 1.0})
                    for realisation in realisations for stack, d in CLEAR] + [
        Check(MODEL, realisation, f"{COATED[0]}: R + T, solid", "the same of a coated ball that refracts", balance,
              {"stack": COATED[0], "thickness": COATED[1], "roughness": 0.0, "see_through": 1.0, "ior_below": 1.52})
        for realisation in realisations]


def on_a_sphere(realisation, rendered, parameters):
    """CIEDE2000 of what is rendered, at the peak of a white lobe scaled to 1, over both suns."""
    m = float(slope(parameters["roughness"]))
    means, all_of_them = [], []
    for angle in SUNS:
        found, exact, white = _sphere(realisation, rendered, parameters, np.radians(angle), m)
        found, exact, white = (_blocks(one, SIZES[realisation][2]) for one in (found, exact, white))
        lit = white > SHOWN * white.max()
        difference = delta_e_2000(lab(exact[lit] / white.max(), "Rec.709"), lab(found[lit] / white.max(), "Rec.709"))
        means.append(difference.mean())
        all_of_them.append(difference)
    mean, high = LIMITS[realisation, round(m, 2)]
    return Outcome((Figure("mean CIEDE2000", float(max(means)), mean),
                    Figure("99th percentile", float(np.percentile(np.concatenate(all_of_them), 99.0)), high)),
                   Picture(exact / white.max(), found / white.max()))


def balance(realisation, rendered, parameters):
    """What a closed, clear film lets through and reflects of an even world is all of it."""
    scene = scenes.empty_scene(16, samples=4096, osl=realisation == "osl")
    for kind in ("max", "transparent_max", "transmission", "glossy"):
        setattr(scene.cycles, f"{kind}_bounces", 64)
    scene.cycles.min_light_bounces = 64  # no roulette
    scenes.add_sphere(materials.create(made(MODEL, realisation=realisation, **rendered)))
    scenes.set_world(scene, 1.0)
    picture = scenes.render(scene)
    _, mask = scenes.pixel_normals(16)
    off = float(np.abs(picture[mask].mean(axis=0) - 1.0).max())
    return Outcome((Figure("|1 - R - T|, mean of the sphere", off, BALANCE),))


def _sphere(realisation, rendered, parameters, angle, m):
    """(rendered, exact, white): pictures of one sun, the last of a lobe that reflects everything."""
    size, samples, _ = SIZES[realisation]
    scene = scenes.empty_scene(size, samples=samples, osl=realisation == "osl")
    scenes.add_sphere(materials.create(made(MODEL, realisation=realisation, **rendered)))
    towards = scenes.add_sun(scene, angle, diameter=DIAMETER)
    picture = scenes.render(scene)
    white, exact = np.zeros((size, size)), np.zeros((size, size, 3))
    normals, mask = scenes.pixel_normals(size, subsamples=3)
    n = normals[mask]
    whole = (n[..., 2] > LEAST_N_V).all(axis=-1)
    film = _film(parameters)
    for light, irradiance in zip(*scenes.sun_directions(towards, DIAMETER, rings=3)):
        h = (light + scenes.VIEW) / np.linalg.norm(light + scenes.VIEW)
        lobe = irradiance * _lobe(realisation, n, h, light, m).mean(axis=1) * whole
        white[mask] += lobe
        exact[mask] += lobe[:, None] * film(float(h @ scenes.VIEW))
    picture[white == 0.0] = 0.0
    return picture, exact, white


def _blocks(picture, side):
    """Means of square blocks."""
    count = len(picture) // side
    return picture.reshape(count, side, count, side, *picture.shape[2:]).mean(axis=(1, 3))


def _film(parameters):
    table = table_of(parameters["stack"], {})
    grid = np.linspace(0.0, 1.0, 257)
    curve = curve_over_angle(table.stack, table.viewing, parameters["thickness"], grid**2)
    return lambda c: np.array([np.interp(np.sqrt(c), grid, channel) for channel in curve.T])


def _lobe(realisation, n, h, light, m):
    """D G/(4 N·V): Smith's G of closures, that of grooves of the formula."""
    n_h, n_v, n_l, v_h = n @ h, np.maximum(n @ scenes.VIEW, 1e-3), n @ light, float(h @ scenes.VIEW)
    lit = n_l > 0.0
    n_l = np.where(lit, n_l, 1.0)
    masking = smith_beckmann(n_v, n_l, m) if realisation == "fast" else v_cavity(n_h, n_v, n_l, v_h)
    return np.where(lit, beckmann(n_h, m) / np.pi * masking / (4.0 * n_v), 0.0)
