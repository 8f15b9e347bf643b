"""The native Beckmann lobe that comes next to Cook and Torrance's: with Smith's G, but as rough and bright as theirs.

The V-cavity G leaves facets unshadowed up to its kinks and ends rough lobes sooner than Smith's, the more so the
further V leans, and it narrows them in the plane of N and V.  A Beckmann lobe whose slope, weight and anisotropy follow
N·V makes up for most of that.  They were fitted to spheres under suns from 20° to 90° and to the albedo, m from 0.2 to
0.65, that of 60° counting most: first at each N·V by itself, then as polynomials.  On a sphere under a sun at 60°,
where N·V is above 0.2, the rms difference is 0.3 % of the rms at m = 0.2, 0.4 % at 0.3, 1.2 % at 0.4, 2.4 % at 0.5 and
3.5 % at 0.6 (with slope and weight constant 0.0 %, 0.2 %, 1.7 %, 5.2 % and 9.7 %); the albedo is within 1.2 % up to 80°
and m = 0.6.  Where a surface is anisotropic itself, its lobes keep its own anisotropy.
"""

from types import SimpleNamespace

from ...operands import cross, dot, length, less, maximum, minimum, part, rotate, sqrt, where
from ...reflectance.directions import PI, frame_along
from ...reflectance.slopes import along_across

__all__ = ["of_slope", "seen_from", "slope_towards_viewer", "v_cavity_lobe"]

ROUGHEST_FITTED = 0.65
"""Above this slope the fit's factors are those of this slope."""

SMALLEST_SINE = 1e-4

WIDENED = ((0.1421, -0.5789, -0.0254), (-0.926, 6.4518, -5.3599), (-1.6418, -2.2971, 6.5308),
           (1.1834, -6.2481, 0.0065), (2.0976, 1.359, -0.678))
WEIGHT = ((0.0256, 0.088, -1.5541), (0.259, -0.8856, 6.3854), (2.76, -7.0633, -2.0595),
          (-2.2211, 5.9279, -1.4932))
"""What each power of q adds to the factors on the roughness and the weight: a, b and c of m² (a + b m + c m²)."""

LEANING = (0.348, 0.465)
"""The anisotropy is sine (a q³ + b m⁴ (1 − q))."""


@part("Seen From")
def seen_from(n, v, tangent, rotation):
    """How a surface is seen, by name: N×V and its length, the sine between them, and V along and across a tangent.

    n, v      unit normal and direction to the viewer
    tangent   what the slopes are stretched along, turned by `rotation` about n

    >>> from addon.reflectance.directions import direction
    >>> seen = seen_from(direction(0.0, 0.0), direction(0.5, 0.0), direction(0.3, 0.0), 0.25)
    >>> [round(float(x), 4) + 0.0 for x in (seen.sine, seen.v_t, seen.v_b)]
    [0.4794, 0.0, -0.4794]
    """
    t, b = frame_along(n, rotate(tangent, n, (2.0 * PI) * rotation))
    beside = cross(n, v)
    return SimpleNamespace(beside=beside, sine=length(beside), v_t=dot(v, t), v_b=dot(v, b))


@part("Slope towards V")
def slope_towards_viewer(m, seen, anisotropy):
    """Rms slope in the plane of N and V, of facets of rms slope m.

    seen        of :func:`seen_from`
    anisotropy  [0, 1); where it is 0 all that this adds to the nodes folds away

    >>> from addon.reflectance.directions import direction
    >>> seen = seen_from(direction(0.0, 0.0), direction(0.5, 0.0), direction(0.3, 0.0), 0.25)
    >>> slopes = [slope_towards_viewer(m, seen, 0.6) for m in (0.2, 0.2 * 1.4744 / 0.6782)]
    >>> [round(float(slope), 4) for slope in slopes]
    [0.1356, 0.2949]
    """
    along, across = along_across(m, anisotropy)
    x, y = along * seen.v_t, across * seen.v_b
    return where(less(0.0, anisotropy), sqrt(x * x + y * y) / maximum(seen.sine, SMALLEST_SINE), m)


@part("V-cavity Lobe", "roughness", "weight", "anisotropy")
def v_cavity_lobe(sine, m, roughness=1.0):
    """What the lobe's roughness √m becomes, its weight, and its anisotropy across the plane of N and V.

    sine       of the angle from N to V, ``(...)``
    m          rms slope in the direction of V, ``(...)``
    roughness  √m; of 1, what it is multiplied by

    All are polynomials in q = m²/(m² + t), t = (2 tan(h/2))² = 8/(1 + sine) − 4 with V's height h above the horizon:
    q runs from m²/4 or so, where V is straight above, to 1 at the horizon, and is ½ where facets of about the slope m
    mirror V into it.  Straight above there is no anisotropy, as there is no plane.

    >>> [round(float(x), 4) for x in v_cavity_lobe(0.0, 0.1)], [round(float(x), 4) for x in v_cavity_lobe(0.94, 0.5)]
    ([1.0008, 1.0002, 0.0], [0.978, 1.0402, 0.107])
    """
    held, m2 = minimum(m, ROUGHEST_FITTED), m * m
    q = m2 / ((8.0 / (1.0 + sine) - 4.0) + m2)
    # Multiplied into what a material keeps constant, √m costs the renderer nothing.
    widened = roughness * (1.0 + of_slope(held, *WIDENED[0]))
    higher = [roughness * of_slope(held, *factors) for factors in WIDENED[1:]]
    weight = [of_slope(held, *factors) for factors in WEIGHT]
    upright = LEANING[1] * ((held * held) * (held * held))
    return (widened + q * _polynomial(q, higher), (1.0 + weight[0]) + q * _polynomial(q, weight[1:]),
            sine * (upright + q * (LEANING[0] * (q * q) - upright)))


@part("m² (a + b m + c m²)")
def of_slope(m, a, b, c):
    """m² (a + b m + c m²).

    >>> round(float(of_slope(0.5, 1.0, 2.0, 4.0)), 4)
    0.75
    """
    return (m * m) * (a + m * (b + c * m))


def _polynomial(q, factors):
    """Σ factorsᵢ qⁱ by Horner's rule."""
    total = factors[-1]
    for factor in reversed(factors[:-1]):
        total = factor + total * q
    return total
