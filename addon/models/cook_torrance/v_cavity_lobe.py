"""The native Beckmann lobe that comes next to Cook and Torrance's: with Smith's G, but as rough and bright as theirs.

The V-cavity G leaves facets unshadowed up to its kinks and ends rough lobes sooner than Smith's, the more so the
further V leans.  A Beckmann lobe whose slope and weight follow N·V makes up for most of that.  Both were fitted by
least squares to spheres under suns from 20° to 75° and to the albedo, m from 0.1 to 0.85; leaning the lobe's normal
towards V as well gains little, and costs as much again.  On a sphere under a sun at 60°, where N·V is above 0.2, the
rms difference is 0.07 % of the rms at m = 0.2, 0.3 % at 0.3, 1.2 % at 0.4, 2.8 % at 0.5 and 4.9 % at 0.6 (with slope
and weight constant 0.3 %, 0.2 %, 1.7 %, 5.2 % and 9.7 %); the albedo is within 1.4 % up to 80° and m = 0.6.
"""

from types import SimpleNamespace

from ...operands import cross, dot, length, less, maximum, minimum, part, rotate, sqrt, where
from ...reflectance.directions import PI, frame_along
from ...reflectance.slopes import along_across

__all__ = ["seen_from", "slope_towards_viewer", "v_cavity_lobe"]

ROUGHEST_FITTED = 0.65
"""Above this slope the fit's factors are those of this slope."""

SMALLEST_SINE = 1e-4


@part("Seen From")
def seen_from(n, v, tangent, rotation):
    """How a surface is seen: the sine of the angle from N to V, and where V is along and across a tangent, by name.

    n, v      unit normal and direction to the viewer
    tangent   what the slopes are stretched along, turned by `rotation` about n

    >>> from addon.reflectance.directions import direction
    >>> seen = seen_from(direction(0.0, 0.0), direction(0.5, 0.0), direction(0.3, 0.0), 0.25)
    >>> [round(float(x), 4) + 0.0 for x in (seen.sine, seen.v_t, seen.v_b)]
    [0.4794, 0.0, -0.4794]
    """
    t, b = frame_along(n, rotate(tangent, n, (2.0 * PI) * rotation))
    return SimpleNamespace(sine=length(cross(n, v)), v_t=dot(v, t), v_b=dot(v, b))


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


@part("V-cavity Lobe", "roughness", "weight")
def v_cavity_lobe(sine, m, roughness=1.0):
    """What the lobe's roughness √m becomes, and its weight.

    sine       of the angle from N to V, ``(...)``
    m          rms slope in the direction of V, ``(...)``
    roughness  √m; of 1, what it is multiplied by

    Both are polynomials in q = m²/(m² + t), t = (2 tan(h/2))² = 8/(1 + sine) − 4 with V's height h above the horizon:
    q runs from m²/4 or so, where V is straight above, to 1 at the horizon, and is ½ where facets of about the slope m
    mirror V into it.

    >>> [round(float(x), 4) for x in v_cavity_lobe(0.0, 0.1)], [round(float(x), 4) for x in v_cavity_lobe(0.94, 0.5)]
    ([1.0, 0.9999], [0.9468, 1.0382])
    """
    held = minimum(m, ROUGHEST_FITTED)
    m2, held2 = m * m, held * held
    q = m2 / (8.0 / (1.0 + sine) + (m2 - 4.0))
    held4 = held2 * held2
    # Multiplied into what a material keeps constant, √m costs the renderer nothing.
    widened = roughness * (1.0 - 0.3671 * held4) + q * (roughness * (held2 * (0.2753 + 0.6128 * held))
                                                        + (roughness * (held2 * (2.1661 * held - 2.2227))) * q)
    weight = (1.0 + held4 * (0.5674 * held - 1.3629)) + q * (held2 * (0.8887 + 0.3361 * held)
                                                            + (held2 * (-0.3769 * held - 0.4467)) * q)
    return widened, weight
