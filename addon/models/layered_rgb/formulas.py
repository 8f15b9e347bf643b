"""The layered RGB BRDF of Granier and Heidrich: interference and colour separation in a thin layer.

A layer (index r1, thickness d) lies between vacuum (r0 = 1) and an object; its
upper boundary has the normal n0, its lower one n1.  The paper's directions:
i travels to the surface and o leaves it, so with L to the light and V to the
viewer i = -L and o = V; ii is i refracted into the layer, io is -o refracted
into the layer (both travel down); ri is i mirrored about n0, rii is ii mirrored
about n1 (it travels up).

The three channels are one operand of shape ``(..., 3)``: indices r1, wavelengths
in nm (645, 525, 445 in the paper), and everything computed from them.  Numbers
(thickness in nm, exponents, cosines) have the shape ``(...)``, directions
``(..., 3)``.  The inner products of ii and io are written out, so that no
direction has to be kept per channel.

The model is not reciprocal: its Fresnel terms see i and o differently.  Two
scales: *energy* (the default, published = 0) and *published* (published = 1).
Even the energy scale can reflect more light than arrives, for the transmitted
lobe is as bright as the reflected one but r1 squared times as wide once it has
left the layer.

X. Granier, W. Heidrich, "A Simple Layered RGB BRDF Model", Graphical Models
65(4), 2003; equation numbers are this paper's.
"""

from types import SimpleNamespace

import numpy as np

from ...operands import (
    cos,
    cross,
    dot,
    less,
    log,
    maximum,
    minimum,
    normalize,
    part,
    power,
    sin,
    sqrt,
    term,
    where,
    widen,
)
from ...reflectance.directions import PI, tangent_of
from .parameters import WAVELENGTHS

__all__ = [
    "WAVELENGTHS", "R0",
    "squared", "fifth_power", "cos_refracted", "inner_products",
    "phase_eq3", "rho_eq5", "rho_of_parts", "reflected_eq6", "fresnel_eq7", "f_eq8", "transmission_eq9",
    "transmitted_eq10", "layer_is_reached",
    "rho_d_eq11", "r_d_eq12", "t_d_eq13", "mean_cosine_eq14", "phase_d_eq15", "rho_d_eq16",
    "lobe_scale", "layered_lobes", "layered_specular", "layered_diffuse", "layered_rgb", "tilt_direction",
    "tilted_normal", "evaluate",
]

R0 = 1.0
"""Refractive index of what surrounds the object."""


def cos_refracted(cos_theta, r1):
    """Cosine inside the layer of a ray that meets n0 at cos_theta outside (Snell's law).

    cos_theta ``(...)``, r1 ``(..., 3)`` at or above 1; returns ``(..., 3)``.

    >>> cos_refracted(1.0, 1.5)
    array([1.])
    """
    sine = widen(1.0 - cos_theta * cos_theta)
    return sqrt(1.0 - sine / squared(r1))


def squared(x):
    """x², as a product: cheaper than a power where nodes are built, and right below 0.

    >>> squared(-3.0)
    9.0
    """
    return x * x


def fifth_power(x):
    """x⁵ by products, for Schlick's term.

    >>> fifth_power(2.0)
    32.0
    """
    return squared(squared(x)) * x


@part("Inner Products")
def inner_products(light, view, n0, n1, r1):
    """The cosines that the model is made of, by name, for the directions to light and viewer.

    light, view, n0, n1 ``(..., 3)`` of length 1; r1 ``(..., 3)``.

    n0_l, n0_v = <n0,L>, <n0,V>;  mirror = <ri,o>, all ``(...)``; and per channel
    ``(..., 3)``: cos_i = <ii,-n0>, cos_o = <io,-n0>, n1_i = <ii,-n1>,
    n1_o = <io,-n1>, lobe = <rii,-io>.

    Along n0 the refracted -ii is cos_i n0, across it L's part shrinks by r1; and
    rii = ii - 2<ii,n1>n1 gives <rii,-io> = 2<ii,n1><io,n1> - <ii,io>.

    >>> up = [0.0, 0.0, 1.0]
    >>> inner_products(up, up, up, up, 1.5).lobe
    array([1.])
    """
    n0_l, n0_v, n0_n1 = dot(n0, light), dot(n0, view), dot(n0, n1)
    cos_i, cos_o = cos_refracted(n0_l, r1), cos_refracted(n0_v, r1)
    across_l, across_v = dot(n1, light) - n0_l * n0_n1, dot(n1, view) - n0_v * n0_n1
    across_l_v = dot(light, view) - n0_l * n0_v
    n1_i = widen(across_l) / r1 + widen(n0_n1) * cos_i
    n1_o = widen(across_v) / r1 + widen(n0_n1) * cos_o
    i_o = widen(across_l_v) / squared(r1) + cos_i * cos_o
    return SimpleNamespace(
        n0_l=n0_l, n0_v=n0_v, mirror=n0_l * n0_v - across_l_v,
        cos_i=cos_i, cos_o=cos_o, n1_i=n1_i, n1_o=n1_o, lobe=2.0 * (n1_i * n1_o) - i_o)


@term("Φ (3)")
def phase_eq3(cos_i, cos_o, r1, d, wavelengths):
    """Phase Φ = π r1 d/λ <ii + io, -n0> between the reflected and the transmitted light, eq. 3.

    cos_i, cos_o, r1, wavelengths (nm) ``(..., 3)``; d in nm ``(...)``; radians ``(..., 3)``.

    >>> phase_eq3(1.0, 1.0, 1.0, 100.0, 400.0).round(4)
    array([1.5708])
    """
    return (cos_i + cos_o) * (r1 * widen(PI * d) / wavelengths)


@term("ρ (5)")
def rho_eq5(r, t, phase):
    """The BRDF ρ = (R + T + 2 cos(2Φ) √(R T)) / 2 of eq. 5, in 1/sr.

    All ``(..., 3)``.

    >>> float(rho_eq5(0.25, 0.25, 0.0))
    0.5
    """
    return rho_of_parts(r, t, sqrt(r * t), phase)


def rho_of_parts(r, t, root, phase):
    """Eq. 5 with √(R T) given as root, all ``(..., 3)``.

    >>> float(rho_of_parts(0.25, 0.25, 0.25, 0.0))
    0.5
    """
    return (r + t + 2.0 * cos(2.0 * phase) * root) * 0.5


@term("R (6)")
def reflected_eq6(fresnel, mirror, e0):
    """Reflected lobe R = F(-i) <ri,o>^e0 of eq. 6, without the scale of :func:`lobe_scale`.

    fresnel ``(..., 3)`` from :func:`fresnel_eq7`, mirror = <ri,o> and exponent e0 ``(...)``.

    >>> reflected_eq6(0.04, 0.5, 2.0)
    array([0.01])
    """
    return fresnel * widen(power(maximum(mirror, 0.0), e0))


@part("F (7)")
def fresnel_eq7(cos_theta, f):
    """Schlick's Fresnel term F = f + (1 - f)(1 - <v,n0>)^5 of eq. 7.

    cos_theta = <v,n0> ``(...)``, f ``(..., 3)`` from :func:`f_eq8`.

    >>> fresnel_eq7(0.0, 0.04), fresnel_eq7(1.0, 0.04)
    (array([1.]), array([0.04]))
    """
    return f + (1.0 - f) * widen(fifth_power(1.0 - cos_theta))


@term("f (8)")
def f_eq8(r1):
    """Normal reflectance f = ((r0 - r1)/(r0 + r1))² of eq. 8, r1 ``(..., 3)``.

    >>> round(float(f_eq8(1.5)), 4)
    0.04
    """
    return squared((r1 - R0) / (r1 + R0))


@part("𝒯 (9)")
def transmission_eq9(cos_o, f):
    """Transmission 𝒯(io) = (1 - f)(1 - (1 + <io,n0>)^5) on the way out, eq. 9.

    cos_o = <io,-n0> ``(..., 3)``.  The paper prints 1 + <v,n>: v points down, so
    it is 1 - cos_o, and n is n0, the boundary that the light passes.

    >>> round(float(transmission_eq9(1.0, 0.04)), 4)
    0.96
    """
    return (1.0 - f) * (1.0 - fifth_power(1.0 - cos_o))


@part("Layer is Reached")
def layer_is_reached(n1_i, n1_o, lobe):
    """1 unless one of eq. 10's null conditions holds: <ii,n1> ≥ 0, <io,n1> ≥ 0, <rii,-io> ≤ 0.

    The third is printed as <rii,io> ≥ 0, which is the same.  All ``(..., 3)``,
    n1_i = <ii,-n1> and n1_o = <io,-n1>.

    >>> float(layer_is_reached(0.5, 0.5, -0.1)), float(layer_is_reached(0.5, 0.5, 0.1))
    (0.0, 1.0)
    """
    return less(0.0, minimum(n1_i, n1_o, lobe))


@term("T (10)")
def transmitted_eq10(fresnel, transmission, lobe, e1, reached):
    """Transmitted lobe T = (1 - F(-i)) 𝒯(io) <rii,-io>^e1 of eq. 10, without :func:`lobe_scale`.

    The paper prints n_ii where r_ii is meant.  lobe = <rii,-io> and the others
    ``(..., 3)``, e1 ``(...)``; reached from :func:`layer_is_reached`.

    >>> transmitted_eq10(0.04, 0.96, 1.0, 100.0, 1.0)
    array([0.9216])
    """
    return (1.0 - fresnel) * transmission * (reached * power(maximum(lobe, 0.0), widen(e1)))


@part("Scale of a Lobe")
def lobe_scale(exponent, published):
    """Factor of a printed lobe cos^e: (e + 2)/(2π) in the energy scale, 1 in the published one.

    >>> round(float(lobe_scale(0.0, 0.0)), 4), float(lobe_scale(90.0, 1.0))
    (0.3183, 1.0)
    """
    return where(published, 1.0, (exponent + 2.0) / (2.0 * PI))


@term("R_d (12)")
def r_d_eq12(r1):
    """Diffuse reflected part Rd = (21 (r1² + r0²) - 38 r0 r1) / (21 (r1 + r0)²) of eq. 12.

    >>> round(float(r_d_eq12(1.5)), 6)
    0.085714
    """
    return (21.0 * (squared(r1) + R0 * R0) - 38.0 * R0 * r1) / (21.0 * squared(r1 + R0))


@term("T_d (13)")
def t_d_eq13(r1):
    """Diffuse transmitted part Td = 1 - Rd = (80/21) r0 r1/(r1 + r0)² of eq. 13.

    >>> round(float(t_d_eq13(1.5)), 6)
    0.914286
    """
    return (80.0 / 21.0) * R0 * r1 / squared(r1 + R0)


def mean_cosine_eq14(r1):
    """Mean cosine ¼ [ln((r1+r0)/(r1-r0)) (r1²-r0²) + 2 r1 r0] / (r1 r0) in the layer, eq. 14, r1 above 1.

    The paper gives it as .85 for r1 = 1.5; it then uses 1, and so does :func:`phase_d_eq15`.

    >>> round(float(mean_cosine_eq14(1.5)), 3)
    0.835
    """
    spread = log((r1 + R0) / (r1 - R0)) * (r1 * r1 - R0 * R0)
    return (spread + 2.0 * R0 * r1) / (4.0 * R0 * r1)


@term("Φ (15)")
def phase_d_eq15(r1, d, wavelengths):
    """Diffuse phase Φ = 2π r1 d/λ in radians, eq. 15; d in nm ``(...)``, the others ``(..., 3)``.

    >>> phase_d_eq15(1.5, 100.0, 600.0).round(4)
    array([1.5708])
    """
    return r1 * widen(2.0 * PI * d) / wavelengths


@term("ρ_d (11)")
def rho_d_eq11(r_d, t_d, phase):
    """Diffuse albedo ρd = (Rd + Td + 2 cos(2Φ) √(Rd Td)) / 2 of eq. 11, all ``(..., 3)``.

    The right side is garbled in print; this is what eq. 5 makes of it.

    >>> round(float(rho_d_eq11(0.5, 0.5, 0.0)), 6)
    1.0
    """
    return (r_d + t_d + 2.0 * cos(2.0 * phase) * sqrt(r_d * t_d)) * 0.5


@part("Diffuse Albedo ρ_d")
def rho_d_eq16(r1, d, wavelengths, published=0.0):
    """Diffuse albedo ρd = ½ + cos(4π r1 d/λ) √(Td (1 - Td)) of eq. 16.

    Printed without the ½ of eq. 11, so that it reaches 1.56 for r1 = 1.5; that is
    the published scale.  The BRDF is ρd/π.  r1, wavelengths ``(..., 3)``, d in nm ``(...)``.

    >>> rho_d_eq16(1.5, 0.0, WAVELENGTHS, published=1.0).round(4)
    array([1.5599, 1.5599, 1.5599])
    """
    t_d = t_d_eq13(r1)
    as_printed = 1.0 + 2.0 * cos(2.0 * phase_d_eq15(r1, d, wavelengths)) * sqrt(t_d * (1.0 - t_d))
    return as_printed * widen(where(published, 1.0, 0.5))


def layered_specular(cosines, r1, d, wavelengths, e0, e1, published=0.0):
    """The specular BRDF ρ of eq. 5 in 1/sr, ``(..., 3)``; the caller multiplies with N.L.

    cosines from :func:`inner_products`; r1, wavelengths ``(..., 3)``; d in nm,
    exponents e0, e1 ``(...)``.

    >>> up = [0.0, 0.0, 1.0]
    >>> cosines = inner_products(up, up, up, up, 1.5)
    >>> layered_specular(cosines, 1.5, 0.0, WAVELENGTHS, 90.0, 170.0, published=1.0).round(4)
    array([0.6728, 0.6728, 0.6728])
    """
    r, t = layered_lobes(cosines, r1, e0, e1, published)
    return rho_eq5(r, t, phase_eq3(cosines.cos_i, cosines.cos_o, r1, d, wavelengths))


def layered_lobes(cosines, r1, e0, e1, published=0.0):
    """The lobes R and T of eqs. 6 and 10 in the scale asked for, each ``(..., 3)``.

    >>> up = [0.0, 0.0, 1.0]
    >>> r, t = layered_lobes(inner_products(up, up, up, up, 1.5), 1.5, 90.0, 170.0, published=1.0)
    >>> r.round(4), t.round(4)
    (array([0.04]), array([0.9216]))
    """
    f = f_eq8(r1)
    fresnel = fresnel_eq7(cosines.n0_l, f)
    reached = layer_is_reached(cosines.n1_i, cosines.n1_o, cosines.lobe)
    r = reflected_eq6(fresnel, cosines.mirror, e0) * widen(lobe_scale(e0, published))
    t = transmitted_eq10(fresnel, transmission_eq9(cosines.cos_o, f), cosines.lobe, e1, reached)
    return r, t * widen(lobe_scale(e1, published))


def layered_diffuse(r1, d, wavelengths, published=0.0):
    """The diffuse BRDF ρd/π in 1/sr, ``(..., 3)``.

    >>> layered_diffuse(1.5, 0.0, WAVELENGTHS).round(4)
    array([0.2483, 0.2483, 0.2483])
    """
    return rho_d_eq16(r1, d, wavelengths, published) / PI


def layered_rgb(light, view, n0, n1, *, r1, d, e0, e1, specular=1.0, diffuse=1.0,
                wavelengths=WAVELENGTHS, published=0.0):
    """The whole BRDF specular·ρ + diffuse·ρd/π in 1/sr, ``(..., 3)``, 0 at and below the horizon.

    >>> up = [0.0, 0.0, 1.0]
    >>> layered_rgb(up, up, up, up, r1=1.5, d=0.0, e0=90.0, e1=170.0, specular=0.0).round(4)
    array([0.2483, 0.2483, 0.2483])
    """
    cosines = inner_products(light, view, n0, n1, r1)
    total = (widen(specular) * layered_specular(cosines, r1, d, wavelengths, e0, e1, published)
             + widen(diffuse) * layered_diffuse(r1, d, wavelengths, published))
    return total * widen(less(0.0, minimum(cosines.n0_l, cosines.n0_v)))


def tilt_direction(tangent, bitangent, azimuth):
    """The direction across n0 that the lower normal is tilted to, ``(..., 3)``, for an azimuth in radians ``(...)``.

    >>> tilt_direction(np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0]), 0.0)
    array([1., 0., 0.])
    """
    return widen(cos(azimuth)) * tangent + widen(sin(azimuth)) * bitangent


@term("n1")
def tilted_normal(n0, tangent, bitangent, deviation, azimuth):
    """The lower normal n1: n0 tilted by the deviation towards the tangent direction at the azimuth.

    Directions ``(..., 3)``, orthonormal; deviation and azimuth in radians ``(...)``,
    the azimuth counted from the tangent to the bitangent.

    >>> tilted_normal([0, 0, 1.0], [1.0, 0, 0], [0, 1.0, 0], 0.1, 0.0).round(3)
    array([0.1  , 0.   , 0.995])
    """
    towards = tilt_direction(tangent, bitangent, azimuth)
    return widen(cos(deviation)) * n0 + widen(sin(deviation)) * towards


def evaluate(parameters, n, v, l, tangent=None):
    """The whole BRDF of a LayeredRGB, ``(..., 3)`` in 1/sr: what its materials render.

    n, v, l  unit normal of the upper boundary and directions to the viewer and to the light, ``(..., 3)``
    tangent  unit direction that the azimuth is counted from, ``(..., 3)``; by default some one in the surface

    A thickness that varies counts as its middle.

    >>> from .parameters import LayeredRGB
    >>> up = np.array([0.0, 0.0, 1.0])
    >>> evaluate(LayeredRGB(thickness=0.0, ior=(1.5, 1.5, 1.5), specular=0.0, diffuse=1.0), up, up, up).round(4)
    array([0.2483, 0.2483, 0.2483])
    """
    p = parameters
    n, v, l = (np.asarray(direction, float) for direction in (n, v, l))
    bitangent = normalize(cross(n, tangent_of(n) if tangent is None else tangent))
    n1 = tilted_normal(n, cross(bitangent, n), bitangent, p.deviation, p.azimuth)
    thickness = p.thickness if p.thickness_range is None else sum(p.thickness_range) / 2.0
    return layered_rgb(l, v, n, n1, r1=np.array(p.ior), d=thickness, e0=p.exponent_r, e1=p.exponent_t,
                       specular=p.specular, diffuse=p.diffuse, wavelengths=np.array(p.wavelengths),
                       published=float(p.scale == "published"))
