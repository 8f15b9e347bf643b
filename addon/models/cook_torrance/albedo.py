"""Directional albedo: the share of the light from one direction that a surface reflects into the hemisphere."""

import numpy as np

from ...reflectance.directions import direction, mirrored
from . import formulas as ct

__all__ = ["facet_normals", "directional_albedo", "cook_torrance_albedo"]


def facet_normals(m, count=384):
    """Facet normals H for integrals over a lobe of rms slope m, and the solid angle dω of each, in sr.

    Gauss-Legendre in the angle α up to six times m, where every slope
    distribution has ended, evenly about the normal; shapes (count², 3) and (count²,).

    >>> h, weight = facet_normals(0.3)
    >>> from addon.reflectance.slopes import beckmann
    >>> round(float(np.sum(weight * beckmann(h[:, 2], 0.3) * h[:, 2]) / np.pi), 9)
    1.0
    """
    x, w = np.polynomial.legendre.leggauss(count)
    half = 0.5 * min(0.5 * np.pi, 6.0 * m)
    alpha = half * (x + 1.0)
    phi = 2.0 * np.pi * (np.arange(count) + 0.5) / count
    h = direction(alpha[:, None], phi[None, :])
    weight = np.broadcast_to((half * w * np.sin(alpha))[:, None] * (2.0 * np.pi / count), h.shape[:2])
    return h.reshape(-1, 3), weight.reshape(-1)


def directional_albedo(brdf, cos_view, m, count=384):
    """∫ R(V, L) (N·L) dω over the hemisphere, by quadrature over the facets' normals: dω_L = 4 (V·H) dω_H.

    brdf      function of (N, V, L), ``(..., 3)``, that looks like a lobe of rms slope m
    cos_view  N·V, one number
    m         rms slope that the points are spread for

    Returns what brdf has in its last axis, 3 channels as a rule.

    >>> def even(n, v, l):
    ...     return ct.diffuse(0.5) * (l[..., 2:] > 0.0)
    >>> bool(abs(directional_albedo(even, 1.0, 1.0) - 0.5).max() < 1e-3)
    True
    """
    h, weight = facet_normals(m, count)
    n = np.array([0.0, 0.0, 1.0])
    v = np.array([np.sqrt(max(1.0 - cos_view * cos_view, 0.0)), 0.0, cos_view])
    v_h = h @ v
    l = mirrored(v, h)
    jacobian = 4.0 * np.maximum(v_h, 0.0) * np.maximum(l[:, 2], 0.0) * weight
    return np.sum(brdf(n, v, l) * jacobian[:, None], axis=0)


def cook_torrance_albedo(cos_view, *, slopes, count=384, **parameters):
    """Directional albedo of the Cook-Torrance BRDF, diffuse part included; accurate to 1e-4.

    cos_view    N·V, ``(...)``
    parameters  as :func:`addon.models.cook_torrance.formulas.cook_torrance` has them

    Returns ``(..., 3)``.  The specular part is a sum over the slopes, each
    integrated with points spread for it; the diffuse part reflects the same
    into all directions.

    >>> cook_torrance_albedo(1.0, slopes=[(0.1, 1.0)], index=(1.5,) * 3, extinction=(0.0,) * 3).round(4)
    array([0.04, 0.04, 0.04])
    """
    s = parameters.pop("s", 1.0)
    rd = np.asarray(parameters.pop("normal_reflectance", 0.0), float)
    for name in ("index", "extinction"):
        parameters[name] = np.asarray(parameters[name], float)
    flat = np.atleast_1d(np.asarray(cos_view, float)).ravel()
    total = [_specular_albedo(c, slopes, count, parameters) for c in flat]
    albedo = s * np.array(total) + (1.0 - s) * rd
    return albedo.reshape(np.shape(cos_view) + albedo.shape[-1:])


def _specular_albedo(cos_view, slopes, count, parameters):
    return sum(directional_albedo(
        lambda n, v, l, one=(m, w): ct.cook_torrance(n, v, l, slopes=[one], **parameters), cos_view, m, count)
        for m, w in slopes)
