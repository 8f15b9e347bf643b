"""Colour differences of a rendered ball from a fit's: pixels of any renderer that shows it in the held-out light."""

import numpy as np

from addon.bake.colour import delta_e_2000, lab
from addon.measured.ball import ball, displayed
from addon.measured.forms import form_of
from addon.measured.lights import HELD_OUT, LIGHTS
from addon.measured.picture import seen_at

RIM = 0.95
SUBSAMPLES = 6


def surrounding(width=512):
    """The held-out light as a picture, rows from the bottom, ``(width/2, width)``, and its pixels' directions.

    Blender's equirectangular mapping: φ = π − 2π u, θ = π − π v from the z axis.
    """
    u, v = np.meshgrid((np.arange(width) + 0.5) / width, (np.arange(width // 2) + 0.5) / (width // 2))
    phi, theta = np.pi - 2.0 * np.pi * u, np.pi - np.pi * v
    d = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=-1)
    return LIGHTS[HELD_OUT](d), d


def pixels_of(polar, resolution):
    """A ball's rings as (rows from the bottom, columns, 3), means over each pixel, and the mask of those well inside.
    """
    step = 2.0 / resolution
    at = -1.0 + step * (np.arange(resolution)[:, None] + (np.arange(SUBSAMPLES) + 0.5) / SUBSAMPLES).ravel()
    y, x = np.meshgrid(at, at, indexing="ij")
    shape = (resolution, SUBSAMPLES, resolution, SUBSAMPLES)
    means = seen_at(polar, x, y).reshape(*shape, 3).mean(axis=(1, 3))
    inside = (np.hypot(x, y) < RIM).reshape(shape).all(axis=(1, 3))
    return means, inside


def images_of(fit, brdf):
    """The rings of the measured and the fitted ball, in the light's own units: (measured, fitted)."""
    shown = ball(20, 48, 48, 48)
    measured = shown.image(HELD_OUT, shown.of_brdf(brdf))
    scale = fit.images[0].sum() / measured.sum()
    return measured, fit.images[1] / scale, scale


def standard_of(fit, formula):
    """The rings of the fitted ball as Standard renders it by a conductor Fresnel, as :func:`images_of` has them."""
    shown = ball(20, 48, 48, 48)
    return shown.image(HELD_OUT, form_of(fit.fresnel).standard(fit.parameters, shown.v, shown.l, formula))


def difference(first, second, inside, exposure):
    """Mean CIEDE2000 of displayed pixels."""
    return float(delta_e_2000(*(lab(displayed(image[inside], exposure)) for image in (first, second))).mean())
