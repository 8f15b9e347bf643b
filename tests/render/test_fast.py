"""Cook-Torrance Fast: pixels of a sphere against the formula with the closure's own Smith G."""

import numpy as np
import pytest

from addon import api
from addon.blender import compat
from addon.models.cook_torrance import formulas as ct
from addon.models.cook_torrance.albedo import cook_torrance_albedo
from addon.reflectance import fresnel, masking
from tests.render import probes

RESOLUTION = 64
SUN_ANGLE = np.radians(60.0)
COPPER = {"n": (0.2, 0.92, 1.1), "k": (3.91, 2.45, 2.14)}
BACK_LIGHT = np.radians(110.0)
LARGEST_RMS = 0.01


def rendered(sun_angle=SUN_ANGLE, realisation="fast", **parameters):
    """The sphere under a sharp sun of irradiance 1, free of noise."""
    scene = probes.empty_scene(RESOLUTION, pixel_centres=True, osl=realisation == "osl_fast")
    probes.add_sphere(api.create_material(realisation=realisation, **parameters))
    towards = probes.add_sun(scene, sun_angle)
    return probes.render(scene), towards


def formula(towards, *, smith=True, slopes=((0.2, 1.0),), specular=1.0, diffuse=(0.0,) * 3, n=COPPER["n"],
            k=COPPER["k"], **options):
    """The same picture by numpy, and the pixels to compare."""
    normals, mask = probes.pixel_normals(RESOLUTION)
    normals = normals[:, :, 0, :]
    options.setdefault("masking", _smith if smith else None)
    options.setdefault("fresnel", renderer_fresnel())
    brdf = ct.cook_torrance(normals, probes.VIEW, towards, slopes=slopes, index=np.array(n),
                            extinction=np.array(k), s=specular, normal_reflectance=np.array(diffuse), **options)
    n_l = np.maximum(normals @ towards, 0.0)[..., None]
    mask = mask & (normals[..., 2] > 0.1)  # at the rim a pixel's normal turns by degrees
    return np.nan_to_num(brdf * n_l), mask


def renderer_fresnel():
    """The conductor Fresnel that this Blender evaluates."""
    return {"exact": fresnel.conductor, "blender-4.5": fresnel.conductor_blender_4_5}[compat.conductor_formula()]


def _smith(cosines, m):
    return masking.smith_beckmann(cosines.n_v, cosines.n_l, m)


def relative_rms(picture, reference, mask):
    return np.sqrt(np.mean((picture[mask] - reference[mask]) ** 2) / np.mean(reference[mask] ** 2))


def agrees(picture, reference, mask):
    return relative_rms(picture, reference, mask) <= LARGEST_RMS


@pytest.mark.parametrize("m", [0.15, 0.2, 0.4, 0.5])
def test_sphere_is_the_formula_with_smith_g(m, record_property):
    picture, towards = rendered(slopes=[(m, 1.0)], **COPPER)
    reference, mask = formula(towards, slopes=[(m, 1.0)])
    v_cavity, _ = formula(towards, slopes=[(m, 1.0)], smith=False)
    print(f"m {m}: rms from the formula with Smith G {relative_rms(picture, reference, mask):.4%}, "
          f"with the V-cavity G {relative_rms(picture, v_cavity, mask):.4%}")
    assert agrees(picture, reference, mask), probes.save_failure(f"fast_{m}", reference, picture)


def test_two_slopes_and_a_diffuse_part():
    parameters = {"slopes": [(0.4, 0.4), (0.2, 0.6)], "specular": 0.3, "diffuse": (0.9, 0.6, 0.5)}
    picture, towards = rendered(**parameters, **COPPER)
    reference, mask = formula(towards, **parameters)
    assert agrees(picture, reference, mask), probes.save_failure("fast_two_slopes", reference, picture)


def test_four_slopes():
    slopes = [(0.1, 0.1), (0.2, 0.2), (0.3, 0.3), (0.5, 0.4)]
    picture, towards = rendered(slopes=slopes, **COPPER)
    reference, mask = formula(towards, slopes=slopes)
    assert agrees(picture, reference, mask), probes.save_failure("fast_four_slopes", reference, picture)


@pytest.mark.parametrize("realisation", ["fast", "osl_fast"])
@pytest.mark.parametrize("m", [0.2, 0.4])
def test_gaussian_is_three_beckmann_lobes(m, realisation):
    picture, towards = rendered(slopes=[(m, 1.0)], distribution="gaussian", realisation=realisation, **COPPER)
    reference, mask = formula(towards, slopes=[(m, 1.0)], distribution="gaussian")
    assert agrees(picture, reference, mask), probes.save_failure(f"fast_gaussian_{m}", reference, picture)


def test_published_scale_is_four_times_as_bright():
    picture, towards = rendered(slopes=[(0.3, 1.0)], scale="published", **COPPER)
    reference, mask = formula(towards, slopes=[(0.3, 1.0)], scale=ct.PUBLISHED)
    assert agrees(picture, reference, mask), probes.save_failure("fast_published", reference, picture)


def test_published_gaussian_has_the_printed_c():
    parameters = {"slopes": [(0.3, 1.0)], "distribution": "gaussian"}
    picture, towards = rendered(**parameters, scale="published", gaussian_c=2.0, **COPPER)
    reference, mask = formula(towards, **parameters, scale=ct.PUBLISHED, printed_c=2.0)
    assert agrees(picture, reference, mask), probes.save_failure("fast_published_gaussian", reference, picture)


BROKEN = {
    "no masking": {"masking": lambda c, m: 1.0},
    "F at normal incidence": {"fresnel": lambda cos_theta, n, k: fresnel.conductor(1.0 + 0.0 * cos_theta, n, k)},
    "another slope": {"slopes": ((0.41, 1.0),)},
    "another weight": {"slopes": ((0.4, 0.97),)},
    "Gaussian D": {"distribution": "gaussian"},
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
    whole, mask = formula(towards, slopes=((0.4, 1.0),))
    broken, _ = formula(towards, **{"slopes": ((0.4, 1.0),), **BROKEN[term]})
    assert agrees(picture, whole, mask)
    assert not agrees(picture, broken, mask)


@pytest.mark.parametrize("m", [0.2, 0.5])
def test_white_furnace(m):
    """In an even white world every pixel shows the albedo of the formula for its angle, never above 1."""
    scene = probes.empty_scene(16, samples=256)
    mirror = {"n": (1e-3,) * 3, "k": (100.0,) * 3}
    probes.add_sphere(api.create_material(slopes=[(m, 1.0)], **mirror))
    probes.set_world(scene, 1.0)
    pictures = probes.render_seeds(scene, 6)
    normals, mask = probes.pixel_normals(16, subsamples=4)
    knots = np.linspace(0.04, 1.0, 33)
    albedo = [cook_torrance_albedo(c, slopes=[(m, 1.0)], index=np.array(mirror["n"]),
                                   extinction=np.array(mirror["k"]), masking=_smith, count=128) for c in knots]
    reference = np.interp(normals[..., 2], knots, np.array(albedo)[:, 0]).mean(axis=2)
    mask &= normals[..., 2].min(axis=2) > 0.1
    test = probes.z_test(pictures[..., 0], reference, mask, systematic=1e-3)
    assert test.passed, test
    assert pictures.mean(axis=0)[mask].max() <= 1.0
