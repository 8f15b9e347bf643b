"""Fresnel reflectance: the exact equations, what the renderer evaluates, and cheaper ways.

Everything here works element by element on operands that broadcast: with numpy
the caller widens cos θ, ``(...)`` to ``(..., 1)``, where it meets a colour.
n and k are relative to the medium outside, light is unpolarised, reflectances
are shares of the arriving power, in [0, 1].
"""

from ..operands import clip, less, maximum, minimum, part, power, sqrt, term, where

__all__ = [
    "conductor", "conductor_blender_4_5", "dielectric", "index_from_normal", "dielectric_from_normal",
    "conductor_from_normal", "schlick", "f82", "f82_unclamped", "f82_tint_of", "cheap_colour_shift", "tinted",
    "COS_THETA_82", "F82_LOBE",
]

COS_THETA_82 = 1.0 / 7.0
"""cos θ of the angle near 82° at which the F82 model is anchored."""

F82_LOBE = COS_THETA_82 * (1.0 - COS_THETA_82) ** 6
"""The F82 model's c·(1−c)⁶ there, where it is greatest."""

SMALLEST = 1e-20
"""Keeps a denominator away from 0 where there is no surface: n = 1, k = 0 at grazing incidence."""

DYED = 1e20
"""What makes 1 of a k and a darkening that are not 0."""


@part("Fresnel F")
def conductor(cos_theta, n, k):
    """Reflectance of a surface of complex index n + ik, exactly.

    cos_theta  cosine between the direction and the facet's normal, [0, 1]
    n, k       index of refraction and extinction coefficient, n > 0, k ≥ 0

    With s² = 1 − c² and (u + iv)² = (n + ik)² − s², so that a = u² + v² = |(n + ik)² − s²|,
    2cu = √(2c²(a + Re((n + ik)² − s²))),
    Rs = (a − 2cu + c²)/(a + 2cu + c²),
    Rp = Rs·(ac² − 2cus² + s⁴)/(ac² + 2cus² + s⁴),
    F = (Rs + Rp)/2 = Rs·(ac² + s⁴)/(ac² + 2cus² + s⁴).
    Born and Wolf, Principles of Optics, 7th ed., section 14.4.1; the equation
    that Cook and Torrance 1982 mean where n and k are known, and Blender 5.0
    and later evaluate.

    >>> round(float(conductor(1.0, 1.5, 0.0)), 6)
    0.04
    >>> round(float(conductor(0.5, 0.2, 3.0)), 6)
    0.918411
    """
    c2 = maximum(cos_theta * cos_theta, SMALLEST)
    s2 = 1.0 - c2
    nk = n * k
    real = (n * n - k * k - 1.0) + c2
    a = sqrt(real * real + 4.0 * nk * nk)
    s_even, s_odd = a + c2, sqrt(2.0 * c2 * (a + real))
    p_even, p_odd = a * c2 + s2 * s2, s_odd * s2
    return (s_even - s_odd) / (s_even + s_odd) * (p_even / (p_even + p_odd))


@term("F")
def conductor_blender_4_5(cos_theta, n, k):
    """The approximation that Cycles up to Blender 4.5 evaluates for a conductor.

    cos_theta, n, k as in :func:`conductor`.  Good for n² + k² ≫ 1 only: it
    takes the refracted ray to run along the normal.

    >>> round(float(conductor_blender_4_5(1.0, 1.5, 0.0)), 6)
    0.04
    >>> round(float(conductor_blender_4_5(0.19, 1.5, 0.0) - conductor(0.19, 1.5, 0.0)), 2)
    0.1
    """
    c2 = cos_theta * cos_theta
    n2_k2 = n * n + k * k
    two_n_c = 2.0 * n * cos_theta
    r_parallel = (n2_k2 * c2 - two_n_c + 1.0) / (n2_k2 * c2 + two_n_c + 1.0)
    r_perpendicular = (n2_k2 - two_n_c + c2) / maximum(n2_k2 + two_n_c + c2, SMALLEST)
    return 0.5 * (r_parallel + r_perpendicular)


@part("Dielectric F")
def dielectric(cos_theta, n):
    """Reflectance of a surface of index n that absorbs nothing.

    cos_theta  cosine between the direction and the facet's normal, [0, 1]
    n          index of refraction, above 0; below 1 there is total reflection

    F = ½ (g−c)²/(g+c)² { 1 + [c(g+c)−1]²/[c(g−c)+1]² }, g² = n² + c² − 1, and
    F = 1 where g² < 0.  Cook and Torrance 1982, the Fresnel equation for k = 0.

    >>> round(float(dielectric(1.0, 1.5)), 6)
    0.04
    >>> float(dielectric(0.1, 0.5))
    1.0
    """
    g2 = n * n + cos_theta * cos_theta - 1.0
    g = sqrt(g2)
    a = (g - cos_theta) / maximum(g + cos_theta, SMALLEST)
    b = (cos_theta * (g + cos_theta) - 1.0) / maximum(cos_theta * (g - cos_theta) + 1.0, SMALLEST)
    return where(less(g2, 0.0), 1.0, 0.5 * a * a * (1.0 + b * b))


@term("n")
def index_from_normal(f0):
    """The index n, with k = 0, that reflects f0 at normal incidence.

    f0  reflectance at normal incidence, [0, 1]; 1, which no finite index
        reaches, is held 2e-6 below.

    n = (1 + √F0)/(1 − √F0).  Cook and Torrance 1982.

    >>> round(float(index_from_normal(0.04)), 6)
    1.5
    """
    root = minimum(sqrt(f0), 1.0 - 1e-6)
    return (1.0 + root) / (1.0 - root)


@term("F")
def dielectric_from_normal(cos_theta, f0):
    """Reflectance at any angle where only the normal reflectance is known.

    cos_theta  cosine between the direction and the facet's normal, [0, 1]
    f0         reflectance at normal incidence, [0, 1]

    The paper's way: k = 0 and the effective index of :func:`index_from_normal`.
    Cook and Torrance 1982.

    >>> round(float(dielectric_from_normal(1.0, 0.6)), 6)
    0.6
    >>> round(float(dielectric_from_normal(0.0, 0.6)), 6)
    1.0
    """
    return dielectric(cos_theta, index_from_normal(f0))


@term("n, k")
def conductor_from_normal(f0, edge):
    """n and k of a body that reflects f0 at normal incidence, and towards grazing the more the larger `edge` is.

    f0    reflectance at normal incidence, above 0 and below 1
    edge  [0, 1]: at 0 k is 0, as of a dielectric; at 1 n² + k² is 1, which is where F rises soonest

    n = g n_least + (1 − g) n_greatest, n_least = (1 − F0)/(1 + F0), n_greatest = (1 + √F0)/(1 − √F0), and k of
    4n/(1 − F0) = (n + 1)² + k².  O. Gulbrandsen, "Artist Friendly Metallic Fresnel", Journal of Computer Graphics
    Techniques 3(4), 2014, equations 13 and 14 with g turned round.

    >>> [round(float(x), 6) for x in conductor_from_normal(0.04, 0.0)]
    [1.5, 0.0]
    >>> n, k = conductor_from_normal(0.5, 1.0)
    >>> round(float(n * n + k * k), 6), round(float(conductor(1.0, n, k)), 6)
    (1.0, 0.5)
    """
    lost = 1.0 - f0
    least, most = _indices(lost)
    n = most + edge * (least - most)
    n_1 = n + 1.0
    return n, sqrt(maximum(4.0 * n / lost - n_1 * n_1, 0.0))


@term("F Schlick")
def schlick(cos_theta, f0):
    """Schlick's approximation F0 + (1 − F0)(1 − c)⁵.

    cos_theta  cosine between the direction and the facet's normal, [0, 1]
    f0         reflectance at normal incidence

    Schlick, "An Inexpensive BRDF Model for Physically-based Rendering",
    Computer Graphics Forum 13(3), 1994, equation 15.

    >>> round(float(schlick(0.5, 0.04)), 6)
    0.07
    """
    return f0 + (1.0 - f0) * power(1.0 - cos_theta, 5.0)


@term("F82")
def f82(cos_theta, f0, tint):
    """The F82-tint model: Schlick's curve, tinted near 82°.

    cos_theta  cosine between the direction and the facet's normal, [0, 1]
    f0         reflectance at normal incidence, [0, 1]
    tint       F82 tint: reflectance at cos θ = 1/7 over Schlick's there

    F = F0 + (1−F0)(1−c)⁵ − b·c·(1−c)⁶, held to [0, 1], with b such that
    F(1/7) = tint·Schlick(1/7).  Kutz, Hašan and Edmondson, "Novel aspects of
    the Adobe Standard Material", 2021, as Cycles evaluates it.

    >>> round(float(f82(1.0, 0.9, 0.8)), 6)
    0.9
    >>> round(float(f82(1 / 7, 0.9, 0.8) / schlick(1 / 7, 0.9)), 6)
    0.8
    """
    return clip(f82_unclamped(cos_theta, f0, f82_factor(f0, tint)), 0.0, 1.0)


@part("F82 Factor")
def f82_factor(f0, tint):
    """The F82 model's b: how much of c·(1−c)⁶ Schlick's curve lacks.

    f0    reflectance at normal incidence, [0, 1]
    tint  F82 tint, as in :func:`f82`

    >>> float(f82_factor(0.9, 1.0))
    0.0
    """
    return schlick(COS_THETA_82, f0) * (1.0 - tint) * (1.0 / F82_LOBE)


@part("Fresnel F82")
def f82_unclamped(cos_theta, f0, b):
    """The F82 model by its factor b, not held to [0, 1]: linear in F0 and b.

    cos_theta  cosine between the direction and the facet's normal, [0, 1]
    f0         reflectance at normal incidence
    b          how much of c·(1−c)⁶ Schlick's curve lacks

    >>> round(float(f82_unclamped(0.5, 0.04, 1.0)), 6)
    0.062188
    """
    q = 1.0 - cos_theta
    q2 = q * q
    q5 = q2 * q2 * q
    return f0 + (1.0 - f0) * q5 - b * (cos_theta * q * q5)


def f82_tint_of(f0, reflectance_82):
    """The F82 tint of a surface: its reflectance at cos θ = 1/7 over Schlick's there.

    f0              reflectance at normal incidence
    reflectance_82  reflectance at cos θ = 1/7

    >>> round(float(f82_tint_of(0.9, f82(1 / 7, 0.9, 0.8))), 6)
    0.8
    """
    return reflectance_82 / schlick(COS_THETA_82, f0)


@term("C")
def cheap_colour_shift(cos_theta, colour_0, colour_90, average_f0):
    """Colour of the reflected light over angle, by the paper's interpolation.

    cos_theta   cosine between the direction and the facet's normal, [0, 1]
    colour_0    colour at normal incidence
    colour_90   colour at grazing incidence: the light's
    average_f0  average normal reflectance of the material, [0, 1]

    C = C0 + (C90 − C0)·max(0, F − F0)/(F90 − F0), F for the index that belongs
    to the average normal reflectance, F90 = 1.  Cook and Torrance 1982,
    section "Color".

    >>> round(float(cheap_colour_shift(1.0, 0.3, 1.0, 0.5)), 6)
    0.3
    >>> round(float(cheap_colour_shift(0.0, 0.3, 1.0, 0.5)), 6)
    1.0
    """
    f = dielectric_from_normal(cos_theta, average_f0)
    share = maximum(f - average_f0, 0.0) / maximum(1.0 - average_f0, 1e-6)
    return colour_0 + (colour_90 - colour_0) * share


@part("Tinted Index", "n", "k")
def tinted(n, k, tint):
    """n and k of a metal whose reflectance at normal incidence is tint times that of n + ik; as they are where k is 0.

    tint  [0, 1], as n and k, which broadcast with it

    By the two handles of O. Gulbrandsen, "Artist Friendly Metallic Fresnel", Journal of Computer Graphics Techniques
    3(4), 2014: the normal reflectance r, and where n stands between the least, (1 − r)/(1 + r), and the greatest,
    (1 + √r)/(1 − √r), that a material of this r can have. The first is tinted and the second kept, so that the edge
    stays white, as a metal's is. All is said by 1 − r = 4n/((n + 1)² + k²), of which no digits are lost.

    >>> n, k = tinted(0.2, 3.91, 0.5)
    >>> round(float(conductor(1.0, n, k) / conductor(1.0, 0.2, 3.91)), 6)
    0.5
    >>> [float(x) for x in tinted(1.5, 0.0, 0.5)], [float(x) for x in tinted(0.2, 3.91, 1.0)]
    ([1.5, 0.0], [0.2, 3.91])
    """
    n_1 = n + 1.0
    lost = 4.0 * n / (n_1 * n_1 + k * k)
    least, most = _indices(lost)
    place = (n - least) / maximum(most - least, SMALLEST)
    paler = 1.0 - tint
    lost_tinted = lost + paler * (1.0 - lost)
    least, most = _indices(lost_tinted)
    n_tinted = least + place * (most - least)
    n_1 = n_tinted + 1.0
    k_tinted = sqrt(maximum(4.0 * n_tinted / lost_tinted - n_1 * n_1, 0.0))
    dyes = clip(DYED * (k * paler), 0.0, 1.0)
    return where(dyes, n_tinted, n), where(dyes, k_tinted, k)


@part("Range of n", "least", "most")
def _indices(lost):
    """The least and the greatest n of a material that takes in this much at normal incidence."""
    root = 1.0 + sqrt(1.0 - lost)
    return lost / (2.0 - lost), root * root / lost
