"""The reflectance model of Cook and Torrance: R = s Rs + d Rd.

R. L. Cook, K. E. Torrance, "A Reflectance Model for Computer Graphics", ACM
Transactions on Graphics 1(1), 1982.  Its equations carry no numbers; they are
named here by their symbols.

Cosines are numbers ``(...)``, directions and colours ``(..., 3)``; BRDFs in 1/sr.
Two scales: *energy*, in which no more light leaves than arrives, and
*published*, as printed: four times as bright, and with the paper's own c in
the Gaussian distribution.
"""

import numpy as np

from ...operands import dot, less, maximum, minimum, rotate, term, where, widen
from ...reflectance.directions import PI, around_z, cosines, frame_along, half_vector
from ...reflectance.fresnel import conductor, tinted
from ...reflectance.masking import v_cavity
from ...reflectance.slopes import (
    along_across,
    beckmann,
    elliptic_beckmann,
    elliptic_gaussian,
    elliptic_gaussian_c,
    gaussian,
    gaussian_c,
    mixture,
)

__all__ = ["ENERGY", "PUBLISHED", "specular", "diffuse", "reflectance", "slope_distribution",
           "elliptic_distribution", "cook_torrance", "dyed", "evaluate", "reflected"]

PUBLISHED = 1.0
"""Factor on Rs as printed."""

ENERGY = 0.25
"""Factor on the printed Rs that makes it the microfacet BRDF F (D/π) G/(4 (N·L)(N·V))."""

SMALLEST = 1e-7


@term("Rs")
def specular(f, d, g, n_l, n_v):
    """Rs = F D G/(π (N·L)(N·V)), as printed.

    f       Fresnel reflectance at V·H, ``(..., 3)``
    d, g    slope distribution and geometrical attenuation, ``(...)``
    n_l, n_v  cosines, ``(...)``; Rs is 0 where one is not above 0

    >>> specular(1.0, 4.0, 1.0, 0.5, 0.5).round(4)
    array([5.093])
    """
    above = less(0.0, minimum(n_l, n_v))
    return f * widen(where(above, d * g / (PI * maximum(n_l * n_v, SMALLEST)), 0.0))


@term("Rd")
def diffuse(normal_reflectance):
    """Rd, the reflectance at normal incidence over π.

    >>> round(float(diffuse(0.5)), 6)
    0.159155
    """
    return normal_reflectance / PI


@term("R = s Rs + d Rd")
def reflectance(s, r_s, r_d):
    """R = s Rs + d Rd with d = 1 − s; s ``(...)``, Rs and Rd ``(..., 3)``.

    >>> reflectance(0.1, 1.0, 0.5).round(6)
    array([0.55])
    """
    return widen(s) * r_s + widen(1.0 - s) * r_d


def slope_distribution(distribution="beckmann", scale=ENERGY, printed_c=1.0):
    """D as a function of cos α and m.

    distribution  "beckmann" or "gaussian"
    scale         ENERGY normalises the Gaussian; PUBLISHED takes printed_c as its c

    >>> float(slope_distribution("gaussian", PUBLISHED, 3.0)(1.0, 0.2))
    3.0
    """
    if distribution == "beckmann":
        return beckmann
    if scale == PUBLISHED:
        return lambda cos_alpha, m: gaussian(cos_alpha, m, printed_c)
    return lambda cos_alpha, m: gaussian(cos_alpha, m, gaussian_c(m))


def elliptic_distribution(h_t, h_b, anisotropy, distribution="beckmann", scale=ENERGY, printed_c=1.0):
    """The same, stretched along a tangent T by an anisotropy.

    h_t, h_b  H·T and H·B, ``(...)``
    the rest  as :func:`slope_distribution` and :func:`addon.reflectance.slopes.along_across` have it

    >>> float(elliptic_distribution(0.0, 0.0, 0.5, "gaussian", PUBLISHED, 3.0)(1.0, 0.2))
    3.0
    """
    if distribution == "beckmann":
        return lambda n_h, m: elliptic_beckmann(h_t, h_b, n_h, *along_across(m, anisotropy))

    def stretched(n_h, m):
        along, across = along_across(m, anisotropy)
        c = printed_c if scale == PUBLISHED else elliptic_gaussian_c(along, across)
        return elliptic_gaussian(h_t, h_b, n_h, along, across, c)
    return stretched


def cook_torrance(n, v, l, *, slopes, index, extinction, s=1.0, normal_reflectance=0.0,
                  distribution="beckmann", scale=ENERGY, printed_c=1.0, anisotropy=0.0, tangent=None, masking=None,
                  fresnel=conductor):
    """The whole BRDF R(V, L) at every wavelength or channel, ``(..., 3)`` in 1/sr.

    n, v, l               unit directions, ``(..., 3)``
    slopes                (m, w) pairs
    index, extinction     n and k, ``(..., 3)``
    s                     specular share, ``(...)``; the diffuse share is 1 − s
    normal_reflectance    π Rd, ``(..., 3)``
    distribution          "beckmann" or "gaussian"
    scale, printed_c      ENERGY or PUBLISHED; c of the Gaussian in the latter
    anisotropy, tangent   of the facets' slopes, [0, 1), and what it is along, ``(..., 3)``; around z where None
    masking               function of (cosines, m) in place of the V-cavity G, such
                          as ``lambda c, m: smith_beckmann(c.n_v, c.n_l, m)``
    fresnel               function of (cos θ, n, k)

    >>> from addon.reflectance.directions import direction
    >>> up = direction(0.0, 0.0)
    >>> r = cook_torrance(up, up, up, slopes=[(0.5, 1.0)], index=1.5, extinction=0.0)
    >>> r.round(6)                                                # 0.04 * 4 / (4 π)
    array([0.012732])
    """
    c = cosines(n, v, l)
    f = fresnel(widen(c.v_h), index, extinction)
    d_of = slope_distribution(distribution, scale, printed_c)
    if anisotropy > 0.0:
        t, b = frame_along(n, around_z(n) if tangent is None else tangent)
        h = half_vector(v, l)
        d_of = elliptic_distribution(dot(h, t), dot(h, b), anisotropy, distribution, scale, printed_c)
    if masking is None:
        d_g = mixture(d_of, c.n_h, slopes) * v_cavity(c.n_h, c.n_v, c.n_l, c.v_h)
    else:
        d_g = mixture(lambda n_h, m: d_of(n_h, m) * masking(c, m), c.n_h, slopes)
    r_s = scale * specular(f, d_g, 1.0, c.n_l, c.n_v)
    above = widen(less(0.0, minimum(c.n_l, c.n_v)))
    return reflectance(s, r_s, above * diffuse(normal_reflectance))


def dyed(parameters):
    """(n, k, π Rd) of a CookTorrance under its tint, ``(3,)`` each.

    >>> from .parameters import CookTorrance
    >>> [channel.tolist() for channel in dyed(CookTorrance(k=(0.0,) * 3, n=(1.5,) * 3, tint=(0.5,) * 3))]
    [[1.5, 1.5, 1.5], [0.0, 0.0, 0.0], [0.4, 0.4, 0.4]]
    """
    tint = np.array(parameters.tint)
    return (*tinted(np.array(parameters.n), np.array(parameters.k), tint), tint * np.array(parameters.diffuse))


def evaluate(parameters, n, v, l, tangent=None, fresnel=conductor):
    """The whole BRDF of a CookTorrance, ``(..., 3)`` in 1/sr: what its materials render.

    n, v, l  unit normal and directions to the viewer and to the light, ``(..., 3)``
    tangent  what anisotropy is along before it is rotated, ``(..., 3)``; by default around the z axis, as on a ball
    fresnel  function of (cos θ, n, k)

    >>> from .parameters import CookTorrance
    >>> up = np.array([0.0, 0.0, 1.0])
    >>> evaluate(CookTorrance(n=(1.5,) * 3, k=(0.0,) * 3, slopes=[(0.5, 1.0)]), up, up, up).round(6)
    array([0.012732, 0.012732, 0.012732])
    """
    p = parameters
    index, extinction, normal_reflectance = dyed(p)
    if p.anisotropy > 0.0:
        tangent = rotate(around_z(n) if tangent is None else tangent, n, 2.0 * PI * p.rotation)
    return cook_torrance(n, v, l, slopes=p.slopes, index=index, extinction=extinction, s=p.specular,
                         normal_reflectance=normal_reflectance, distribution=p.distribution,
                         scale=PUBLISHED if p.scale == "published" else ENERGY, printed_c=p.gaussian_c,
                         anisotropy=p.anisotropy, tangent=tangent, fresnel=fresnel)


def reflected(lights, n, v, brdf, *, ambient=0.0, ambient_reflectance=0.0, unblocked=1.0):
    """Ir = f Iia Ra + Σ Ii (N·L) dωi R: light reflected to the viewer, ``(..., 3)``.

    lights               (L, Ii, dωi) of each: direction ``(..., 3)``, intensity
                         ``(..., 3)``, solid angle in sr
    n, v                 unit directions, ``(..., 3)``
    brdf                 function of (N, V, L), in 1/sr
    ambient              Iia, ``(..., 3)``; the paper's figures take 0.01 Ii
    ambient_reflectance  Ra, ``(..., 3)``; the figures take π Rd
    unblocked            f, the unblocked fraction of the hemisphere, ``(...)``

    >>> from addon.reflectance.directions import direction
    >>> up = direction(0.0, 0.0)
    >>> reflected([(up, 2.0, 0.1)], up, up, lambda n, v, l: 0.5, ambient=1.0, ambient_reflectance=0.2).round(6)
    array([0.3])
    """
    total = widen(unblocked) * (ambient * ambient_reflectance)
    for l, intensity, solid_angle in lights:
        total = total + widen(maximum(dot(n, l), 0.0) * solid_angle) * intensity * brdf(n, v, l)
    return total
