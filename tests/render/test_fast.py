"""Cook-Torrance Standard: pixels of a sphere against the formula, and against the closures that follow it."""

import numpy as np
import pytest

from addon import api
from addon.blender import compat
from addon.models.cook_torrance import formulas as ct
from addon.models.cook_torrance.albedo import cook_torrance_albedo
from addon.models.cook_torrance.v_cavity_lobe import v_cavity_lobe
from addon.operands import rotate
from addon.reflectance import fresnel, masking
from addon.reflectance.directions import around_z, cosines, half_vector
from addon.reflectance.slopes import along_across, elliptic_beckmann
from tests.bench.bench_cook_torrance import by_hand
from tests.render import cook_torrance_scenes as scenes
from tests.render import probes

RESOLUTION = 64
SUN_ANGLE = np.radians(60.0)
COPPER = {"n": (0.2, 0.92, 1.1), "k": (3.91, 2.45, 2.14)}
BACK_LIGHT = np.radians(110.0)
LARGEST_RMS = 0.01
WHOLE = {0.1: 0.01, 0.2: 0.01, 0.3: 0.01, 0.4: 0.02, 0.5: 0.0275, 0.6: 0.035}
"""Slope -> how far the formula itself, with the V-cavity G, may be."""


def rendered(sun_angle=SUN_ANGLE, realisation="fast", **parameters):
    """The sphere under a sharp sun of irradiance 1, free of noise."""
    scene = probes.empty_scene(RESOLUTION, pixel_centres=True, osl=realisation == "osl_fast")
    probes.add_sphere(api.create_material(realisation=realisation, **parameters))
    towards = probes.add_sun(scene, sun_angle)
    return probes.render(scene), towards


def formula(towards, *, closures=None, slopes=((0.2, 1.0),), specular=1.0, diffuse=(0.0,) * 3, n=COPPER["n"],
            k=COPPER["k"], **options):
    """The same picture by numpy, and the pixels to compare.

    closures  None for the formula; else what :func:`followed` takes, for the closures that follow it
    """
    normals, mask = probes.pixel_normals(RESOLUTION)
    normals = normals[:, :, 0, :]
    options = {"index": np.array(n), "extinction": np.array(k), "fresnel": renderer_fresnel(), **options}
    mixed = {"s": specular, "normal_reflectance": np.array(diffuse)}
    if closures is None:
        brdf = ct.cook_torrance(normals, probes.VIEW, towards, slopes=slopes, **mixed, **options)
    else:
        brdf = followed(normals, towards, slopes, mixed, options, **closures)
    n_l = np.maximum(normals @ towards, 0.0)[..., None]
    mask = mask & (normals[..., 2] > 0.2)  # at the rim a pixel's normal turns by degrees
    return np.nan_to_num(brdf * n_l), mask


def followed(normals, towards, slopes, mixed, options, *, widened=True, weighed=True, leaning=True, masked=True):
    """BRDF of closures with Smith's G, whose slope, weight and anisotropy follow N·V at each pixel."""
    c = cosines(normals, probes.VIEW, towards)
    beside = np.cross(normals, probes.VIEW)
    sine = np.linalg.norm(beside, axis=-1)
    b = beside / np.maximum(sine, 1e-9)[..., None]
    t, h = np.cross(b, normals), half_vector(probes.VIEW, towards)
    f = options["fresnel"](c.v_h[..., None], options["index"], options["extinction"])
    total = 0.0
    for m, w in slopes:
        widening, weight, anisotropy = v_cavity_lobe(sine, m)
        across, along = along_across(m * (widening ** 2 if widened else 1.0), anisotropy * leaning)
        g = 1.0 / (1.0 + sum(_lambda(x, t, b, cosine, along, across)
                             for x, cosine in ((probes.VIEW, c.n_v), (towards, c.n_l)))) if masked else 1.0
        d_g = elliptic_beckmann(t @ h, b @ h, c.n_h, along, across) * g * (w * weight if weighed else w)
        total = total + options.get("scale", ct.ENERGY) * ct.specular(f, d_g, 1.0, c.n_l, c.n_v)
    above = (np.minimum(c.n_l, c.n_v) > 0.0)[..., None]
    return ct.reflectance(mixed["s"], total, above * ct.diffuse(mixed["normal_reflectance"]))


def _lambda(direction, t, b, cosine, along, across):
    """Smith's Λ of a direction, whose slope is that along it."""
    steep = np.hypot(along * (t @ direction), across * (b @ direction))
    return masking.smith_lambda_of_slope(steep / np.maximum(cosine, masking.SMALLEST))


def renderer_fresnel():
    """The conductor Fresnel that this Blender evaluates."""
    return {"exact": fresnel.conductor, "blender-4.5": fresnel.conductor_blender_4_5}[compat.conductor_formula()]


def relative_rms(picture, reference, mask):
    return np.sqrt(np.mean((picture[mask] - reference[mask]) ** 2) / np.mean(reference[mask] ** 2))


def agrees(picture, reference, mask):
    return relative_rms(picture, reference, mask) <= LARGEST_RMS


def holds(name, picture, towards, limit=LARGEST_RMS, **parameters):
    """Whether the picture is the formula's; prints how far it is off, keeps pictures that are too far."""
    reference, mask = formula(towards, **parameters)
    off = relative_rms(picture, reference, mask)
    print(f"{name}: rms {off:.2%} of at most {limit:.1%}")
    return off <= limit or probes.save_failure(name, reference, picture) is None


@pytest.mark.parametrize("m", WHOLE)
def test_sphere_is_the_formula(m):
    picture, towards = rendered(slopes=[(m, 1.0)], **COPPER)
    assert holds(f"fast_{m}_closures", picture, towards, closures={}, slopes=[(m, 1.0)])
    assert holds(f"fast_{m}", picture, towards, WHOLE[m], slopes=[(m, 1.0)])


def test_two_slopes_and_a_diffuse_part():
    parameters = {"slopes": [(0.4, 0.4), (0.2, 0.6)], "specular": 0.3, "diffuse": (0.9, 0.6, 0.5)}
    picture, towards = rendered(**parameters, **COPPER)
    assert holds("fast_two_slopes", picture, towards, **parameters)


def test_four_slopes():
    slopes = [(0.1, 0.1), (0.2, 0.2), (0.3, 0.3), (0.5, 0.4)]
    picture, towards = rendered(slopes=slopes, **COPPER)
    assert holds("fast_four_slopes", picture, towards, slopes=slopes)


@pytest.mark.parametrize("realisation", ["fast", "osl_fast"])
@pytest.mark.parametrize("m", [0.2, 0.4])
def test_gaussian_is_three_beckmann_lobes(m, realisation):
    parameters = {"slopes": [(m, 1.0)], "distribution": "gaussian"}
    picture, towards = rendered(realisation=realisation, **parameters, **COPPER)
    assert holds(f"{realisation}_gaussian_{m}", picture, towards, WHOLE[m], **parameters)


def test_published_scale_is_four_times_as_bright():
    picture, towards = rendered(slopes=[(0.3, 1.0)], scale="published", **COPPER)
    assert holds("fast_published", picture, towards, slopes=[(0.3, 1.0)], scale=ct.PUBLISHED)


def test_published_gaussian_has_the_printed_c():
    parameters = {"slopes": [(0.3, 1.0)], "distribution": "gaussian"}
    picture, towards = rendered(**parameters, scale="published", gaussian_c=2.0, **COPPER)
    assert holds("fast_published_gaussian", picture, towards, **parameters, scale=ct.PUBLISHED, printed_c=2.0)


@pytest.mark.parametrize("realisation", ["fast", "osl_fast"])
@pytest.mark.parametrize("m, anisotropy, rotation", [(0.1, 0.9, 0.0), (0.2, 0.5, 0.1), (0.2, 0.9, 0.3)])
def test_anisotropic(m, anisotropy, rotation, realisation):
    """Along the tangent that a ball has, turned."""
    picture, towards = rendered(realisation=realisation, slopes=[(m, 1.0)], anisotropy=anisotropy, rotation=rotation,
                                **COPPER)
    normals = probes.pixel_normals(RESOLUTION)[0][:, :, 0, :]
    tangent = rotate(around_z(normals), normals, 2.0 * np.pi * rotation)
    along = WHOLE[min(WHOLE, key=lambda known: abs(known - along_across(m, anisotropy)[0]))]
    assert holds(f"{realisation}_anisotropic_{m}_{anisotropy}", picture, towards, along, slopes=[(m, 1.0)],
                 anisotropy=anisotropy, tangent=tangent)


@pytest.mark.parametrize("realisation", ["fast", "osl_fast"])
def test_tint(realisation):
    """Of the metal, not of the dielectric channel."""
    metal, tint = {"n": (0.2, 0.92, 1.5), "k": (3.91, 2.45, 0.0)}, (0.5, 1.0, 0.3)
    picture, towards = rendered(realisation=realisation, slopes=[(0.2, 1.0)], specular=0.8, diffuse=(0.5, 0.5, 0.5),
                                tint=tint, **metal)
    n, k = fresnel.tinted(*map(np.array, metal.values()), np.array(tint))
    assert holds(f"{realisation}_tint", picture, towards, slopes=[(0.2, 1.0)], specular=0.8,
                 diffuse=0.5 * np.array(tint), n=n, k=k)
    assert np.allclose(k[1:], metal["k"][1:]) and k[0] < 2.0


BROKEN = {
    "no masking": {"closures": {"masked": False}},
    "F at normal incidence": {"fresnel": lambda cos_theta, n, k: fresnel.conductor(1.0 + 0.0 * cos_theta, n, k)},
    "another slope": {"slopes": ((0.41, 1.0),)},
    "another weight": {"slopes": ((0.4, 0.97),)},
    "a slope that is everywhere the same": {"closures": {"widened": False}},
    "a weight that is everywhere the same": {"closures": {"weighed": False}},
    "no anisotropy": {"closures": {"leaning": False}},
    "published scale": {"scale": ct.PUBLISHED},
    "a diffuse part": {"specular": 0.97, "diffuse": (0.9, 0.6, 0.5)},
    "another n": {"n": (0.25, 1.2, 1.4)},
}


@pytest.fixture(scope="module")
def rough_copper():
    """Lit from behind, where masking and the Fresnel term tell most."""
    return rendered(BACK_LIGHT, slopes=[(0.4, 1.0)], **COPPER)


@pytest.mark.parametrize("term", BROKEN)
def test_the_check_fails_when_a_term_is_broken(rough_copper, term):
    picture, towards = rough_copper
    whole, mask = formula(towards, closures={}, slopes=((0.4, 1.0),))
    broken, _ = formula(towards, **{"closures": {}, "slopes": ((0.4, 1.0),), **BROKEN[term]})
    assert agrees(picture, whole, mask)
    assert not agrees(picture, broken, mask)


def test_a_smooth_metal_is_the_native_closure_alone():
    """Up to m = 0.1 nothing follows N·V; above it something does."""
    def largest_difference(m):
        ours, _ = rendered(slopes=((m, 1.0),), **scenes.COPPER)
        scene = probes.empty_scene(RESOLUTION, pixel_centres=True)
        probes.add_sphere(by_hand(((m, 1.0),)))
        probes.add_sun(scene, SUN_ANGLE)
        return np.abs(ours - probes.render(scene)).max()
    assert largest_difference(0.1) < 1e-6 < 1e-4 < largest_difference(0.16)


@pytest.mark.parametrize("m", [0.05, 0.2, 0.4, 0.6])
def test_white_furnace(m):
    """In an even white world tiles at angles up to 80° show the albedo of the formula, and never more than arrives."""
    mirror = {"n": (1e-3,) * 3, "k": (100.0,) * 3}
    scene = scenes.furnace(lambda: api.create_material(slopes=[(m, 1.0)], **mirror), samples=256)
    means = scenes.tile_means(probes.render_seeds(scene, 4)).mean(axis=0)
    expected = cook_torrance_albedo(np.cos(scenes.FURNACE_ANGLES), slopes=[(m, 1.0)], index=np.array(mirror["n"]),
                                    extinction=np.array(mirror["k"]), count=256)
    print(f"m {m}: {np.abs(means / expected - 1.0).max():.2%} off")
    assert np.abs(means / expected - 1.0).max() < 0.015
    assert means.max() < 1.001
