"""What Beckmann lobes of the default width make of the layered model, by quadrature: rings of a sphere under a sharp
sun.
"""

import math

import numpy as np
import pytest

from addon.models.layered_rgb import formulas as layered
from addon.models.layered_rgb import sampler
from addon.models.layered_rgb.parameters import LayeredRGB

VIEW, EAST = np.array([0.0, 0.0, 1.0]), np.array([1.0, 0.0, 0.0])
DEFAULT_WIDTH = LayeredRGB().sampling_width
WAVELENGTHS = np.array(layered.WAVELENGTHS)
FIGURE_3 = ((1.4, 1.45, 1.6), 90.0, 170.0)
FIGURE_5 = ((1.5, 1.6, 1.8), 130.0, 130.0)
THICKNESSES = (15.0, 70.0, 92.0, 170.0, 400.0)
SUNS = (0.0, 45.0, 60.0, 75.0)
RESOLUTION, RINGS = 24, 6
REACH, STEPS = 4.0, 17
"""Of the quadrature over the facets about the one that mirrors the lamp: in slopes, and points a side."""
BRIGHT = 0.02
LARGEST_BIAS = 0.03


def inner(a, b):
    return np.sum(a * b, axis=-1)


def unit(a):
    return a / np.maximum(np.linalg.norm(a, axis=-1, keepdims=True), 1e-12)


def sphere():
    """Normals of the pixels of a sphere seen along Z, (pixels, 3), and the ring of each, even in area."""
    at = (np.arange(RESOLUTION) + 0.5) / RESOLUTION * 2.0 - 1.0
    y, x = np.meshgrid(at, at, indexing="ij")
    distance2 = x * x + y * y
    normals = np.stack([x, y, np.sqrt(np.maximum(1.0 - distance2, 0.0))], axis=-1)
    inside = distance2 < 0.98
    return normals[inside], (distance2[inside] * RINGS).astype(int)


def beckmann(light, lobe):
    """Cycles' anisotropic Beckmann lobe about H times its cosine."""
    def smith(w):
        slant2 = (lobe.slope_along * inner(w, x)) ** 2 + (lobe.slope_across * inner(w, y)) ** 2
        a = np.abs(inner(w, n)) / np.sqrt(np.maximum(slant2, 1e-20))
        return np.where(a >= 1.6, 0.0, (1 - 1.259 * a + 0.396 * a * a) / (3.535 * a + 2.181 * a * a))

    n = lobe.normal
    y = unit(np.cross(n, lobe.tangent))
    x = np.cross(y, n)
    half = unit(light + VIEW)
    cosine = np.maximum(inner(half, n), 1e-6)
    slope2 = ((inner(half, x) / lobe.slope_along) ** 2 + (inner(half, y) / lobe.slope_across) ** 2) / cosine ** 2
    d = np.exp(-np.minimum(slope2, 80.0)) / (math.pi * lobe.slope_along * lobe.slope_across * cosine ** 4)
    return np.where(inner(n, light) > 0, d / ((1 + smith(light) + smith(VIEW)) * 4 * inner(n, VIEW)), 0.0)


def facets(lamp, normals, slopes, index):
    """L about the lamp, (normals, points, 3), and their solid angles: mirrored by facets on a grid of these slopes."""
    at = (np.arange(STEPS) + 0.5) / STEPS * 2.0 * REACH - REACH
    u, v = (a.ravel()[:, None] for a in np.meshgrid(at, at, indexing="ij"))
    middle = unit(lamp + VIEW)
    across = unit(np.cross(middle, VIEW))
    along = np.cross(middle, across)
    cosine = np.maximum(normals @ lamp, 1e-3)
    stretch = np.minimum(np.sqrt(1.0 - (1.0 - cosine ** 2) / index ** 2) / cosine, 2.5)
    step_u, step_v = slopes * stretch, slopes / (middle @ VIEW)
    half = middle + step_u[:, None, None] * u * along + step_v[:, None, None] * v * across
    size = np.linalg.norm(half, axis=-1)
    half /= size[..., None]
    v_h = half @ VIEW
    cell = (step_u * step_v)[:, None] * (2.0 * REACH / STEPS) ** 2
    return 2.0 * v_h[..., None] * half - VIEW, cell / size ** 3 * 4.0 * v_h


def with_axis(values):
    """Each array of the names with an axis for the points before its last, or as its last."""
    return sampler.SimpleNamespace(**{
        name: value[:, None, :] if value.ndim == 2 else value[:, None] for name, value in vars(values).items()})


def seen(normals, lower, lamp, case, thickness, width):
    """Radiance of each normal under the lamp by all lobes drawn at a width, (normals, 3)."""
    r1, e0, e1 = case
    r1 = np.array(r1)
    views = np.broadcast_to(VIEW, normals.shape)
    lobes = sampler.proposal(views, normals, lower, r1, e0, e1)
    narrow = sampler.narrowed(lobes, r1, e0, e1, sampler.tapered_width(lobes, width))
    lobes, narrow = with_axis(lobes), with_axis(narrow)
    n0, n1 = normals[:, None], lower[:, None]
    total = 0.0
    for picked, index in enumerate((1.0, *r1)):
        slopes = narrow.slope_t if picked else narrow.slope_r
        light, solid_angle = facets(lamp, normals, slopes[:, 0], index)
        cosines = layered.inner_products(light, VIEW, n0, n1, r1)
        phase = layered.phase_eq3(cosines.cos_i, cosines.cos_o, r1, thickness, WAVELENGTHS)
        rho = layered.rho_of_parts(*sampler.narrowed_parts(cosines, narrow, r1, e0, e1), phase)
        only = sampler.SimpleNamespace(**vars(lobes))
        only.share_r, only.shares = lobes.share_r * (picked == 0), lobes.shares * (np.arange(1, 4) == picked)
        density, own = (sampler._density(of, narrow, cosines, r1) for of in (lobes, only))
        visible = (cosines.n0_l > 0.0) & (density > 1e-12)
        drawn = sampler.SimpleNamespace(light=light, index=index, slope=slopes,
                                        light_cos=np.maximum(cosines.n0_l, 1e-9))
        lobe = sampler.kernel(drawn, VIEW, n0)
        share = np.where(visible, own / np.maximum(density, 1e-12), 0.0)
        radiance = np.where(visible, share * beckmann(lamp, lobe) * cosines.n0_l * solid_angle, 0.0)
        total = total + np.sum(radiance[..., None] * np.where(visible[..., None], rho, 0.0), axis=1)
    return total


def ring_biases(case, deviation, thickness, polar, width=DEFAULT_WIDTH):
    """Relative difference from the formula in the mean of each ring and channel that is not dark."""
    lamp = np.array([math.sin(polar), 0.0, math.cos(polar)])
    normals, ring = sphere()
    bitangent = unit(np.cross(normals, EAST))
    lower = layered.tilted_normal(normals, np.cross(bitangent, normals), bitangent, deviation, 0.0)
    r1, e0, e1 = case
    formula = layered.layered_rgb(lamp, VIEW, normals, lower, r1=np.array(r1), d=thickness, e0=e0, e1=e1,
                                  diffuse=0.0) * np.maximum(normals @ lamp, 0.0)[:, None]
    lit = formula.max(axis=-1) > 1e-4 * formula.max()
    blurred = np.zeros_like(formula)
    blurred[lit] = seen(normals[lit], lower[lit], lamp, case, thickness, width)
    expected, found = (np.stack([of[ring == r].mean(axis=0) for r in range(RINGS)]) for of in (formula, blurred))
    bright = expected > BRIGHT * expected.max()
    return (found / np.maximum(expected, 1e-12) - 1.0)[bright]


@pytest.mark.parametrize("deviation", [0.0, 10.0, 14.0])
@pytest.mark.parametrize("case", [FIGURE_3, FIGURE_5])
def test_rings_at_the_default_width(case, deviation):
    """Suns of no size from 0° to 75° off the view light every ring within 3 % of the formula."""
    for thickness in THICKNESSES:
        for sun in SUNS:
            biases = ring_biases(case, math.radians(deviation), thickness, math.radians(sun) + 1e-4)
            assert np.abs(biases).max() < LARGEST_BIAS, (thickness, sun, biases)
