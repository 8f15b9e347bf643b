"""A film's colour at V·H from the renderer's own lobes: what the Standard realisation of films evaluates.

A native lobe knows one colour.  That of a film changes with V·H over the
facets that the viewer sees, so the table is looked up twice, at the mean of
V·H over them and its spread above and below.  The mean of the two looks is the
lobe's colour.  Their difference is the slope over V·H, and to first order
tilts the lobe: in the plane of slopes D is a Gaussian in which V·H is nearly
linear along V, so D·exp(g V·H) is D moved by g sin θ m²/2 towards V.  Each
channel has its own g: three lobes, one a channel.  From a slope on that depends on the film
a renderer's own film, where it has one, is closer: see addon.bake.film_track.

Unit vectors ``(..., 3)``, numbers ``(...)``; m is the rms slope of Beckmann's
distribution.
"""

from types import SimpleNamespace

from ..operands import (
    clip,
    dot,
    exp,
    less,
    maximum,
    minimum,
    normalize,
    part,
    rotate,
    sqrt,
    vector,
    where,
    widen,
    x_of,
    y_of,
    z_of,
)
from .directions import PI, frame_along
from .slopes import along_across

__all__ = ["mean_v_h", "spread_v_h", "two_looks", "tilts", "seen_along", "tilted_lobes", "lobes_of", "native_share",
           "ROUGHEST_FITTED"]

ROUGHEST_FITTED = 0.6
"""Above this slope mean and spread are those of this slope."""
FADE, CAP, BEND = 2.0, 0.6, 0.2
"""Below N·V = FADE m the tilt fades, it moves slopes by no more than CAP m, and grows by a cube."""
SWITCHED = 5.0
"""How fast the native film takes over, for twice the slope."""
LEAST_SPREAD, LEAST_COLOUR, LEAST_SINE, LEAST_SINE2 = 1e-4, 1e-3, 1e-3, 1e-6
"""Keep denominators away from 0: of an m of nearly 0, of black, and of a view along the normal."""


@part("Mean V·H")
def mean_v_h(n_v, m):
    """Mean of V·H over the facets of a Beckmann surface that send light to V in an even surrounding.

    n_v  N·V, [0, 1]
    m    rms slope, above 0

    Every facet counts by D G V·H/(N·V), G Smith's.  By the size of a facet N·V
    falls with m²; towards grazing only those remain that lean to V.  Least
    squares against quadrature for m to 0.6, off by at most 0.004 to m = 0.2,
    0.008 to 0.6 (tools/fit_film_facets.py).

    >>> round(float(mean_v_h(1.0, 0.2)), 3), round(float(mean_v_h(0.2, 0.2)), 3)
    (0.979, 0.296)
    """
    m = minimum(m, ROUGHEST_FITTED)
    sine, m2 = sqrt(1.0 - n_v * n_v), m * m
    remain = exp((n_v / m) * (-0.5709 - 0.2571 * m))
    leaning = m * (0.9747 - 0.888 * m) * remain + m2 * (0.4065 + n_v * (0.1944 - 0.6401 * n_v))
    return n_v - n_v * m2 * (0.6651 - 0.6513 * m) + sine * leaning


@part("Spread V·H")
def spread_v_h(n_v, m):
    """Standard deviation of V·H over the same facets; off by at most 0.009 to m = 0.2, 0.023 to 0.6.

    n_v, m  as :func:`mean_v_h` has them

    >>> round(float(spread_v_h(0.5, 0.1)), 4)
    0.059
    """
    m = minimum(m, ROUGHEST_FITTED)
    m2 = m * m
    remain = exp((n_v / m) * -0.313)
    across = sqrt(1.0 - n_v * n_v) * m * (0.7706 - (0.242 + 0.3226 * m) * remain) / (1.0 + 0.4712 * m)
    upright = 0.2266 * m2 * n_v
    return sqrt(across * across + upright * upright)


def two_looks(n_v, m, look):
    """Two looks at the film a spread above and below the mean of V·H, by name: mean, half, reach.

    look  function of cos θ -> colour ``(..., 3)``

    mean  colour of the lobe
    half  half the difference of the looks; over the reach it is the slope over V·H
    reach half of what V·H differs by, ``(...)``

    >>> from addon.operands import widen
    >>> found = two_looks(0.5, 0.1, lambda c: widen(c) * (1.0, 0.5, 0.0))
    >>> found.mean.round(3).tolist(), (found.half / widen(found.reach)).round(3).tolist()
    ([0.504, 0.252, 0.0], [1.0, 0.5, 0.0])
    """
    middle, spread = mean_v_h(n_v, m), spread_v_h(n_v, m)
    up, down = clip(middle + spread, 0.0, 1.0), clip(middle - spread, 0.0, 1.0)
    high, low = look(up), look(down)
    reach = maximum(0.5 * (up - down), LEAST_SPREAD)
    return SimpleNamespace(mean=0.5 * (high + low), half=0.5 * (high - low), reach=reach)


@part("Tilts")
def tilts(n_v, m, mean, half, reach):
    """What V − (N·V) N is multiplied by to tilt each channel's lobe, ``(..., 3)``.

    mean, half, reach  of :func:`two_looks`

    g m²/2, faded by N·V/2m towards grazing, where facets that lean away from V
    are hidden and there is less to move, and held to 0.6 m/sin θ.  With x =
    half/mean, g = x(1 + x²/5)/reach lies between the line through both looks,
    x/reach, and the exponential, artanh(x)/reach.  All three as six films of
    the verification are closest with.

    >>> tilts(0.8, 0.1, [0.5, 0.5, 0.0], [0.05, -0.05, 0.0], 0.05).round(4).tolist()
    [0.01, -0.01, 0.0]
    """
    x = half / maximum(mean, LEAST_COLOUR)
    strength = 0.5 * m * minimum(m, n_v / FADE) / reach
    most = widen(CAP * m / maximum(sqrt(1.0 - n_v * n_v), LEAST_SINE))
    return clip((x + BEND * (x * x * x)) * widen(strength), -1.0 * most, most)


@part("Native Film's Share")
def native_share(m, from_slope):
    """The native film's share of the lobe, [0, 1]: none below a slope, all above it, and a short way between.

    m           rms slope, ``(...)``
    from_slope  slope from which the native film is closer than the tilted lobes, above 0

    >>> [round(native_share(m, 0.2), 2) for m in (0.1, 0.19, 0.2, 0.21, 0.5)]
    [0.0, 0.25, 0.5, 0.75, 1.0]
    """
    return clip(SWITCHED * (m / from_slope) + (0.5 - SWITCHED), 0.0, 1.0)


@part("Slope towards the Viewer", "m(V)", "along")
def seen_along(n, v, m, tangent, rotation, anisotropy):
    """(slope in the plane of N and V, what a lobe's normal is tilted along) of facets that are stretched.

    n, v        with N·V > 0
    m           rms slope, ``(...)``
    tangent     what the slopes are stretched along, turned by `rotation` about n
    anisotropy  [0, 1); where it is 0 all that this adds to the nodes folds away

    Slopes with the covariance Σ/2 on which exp(g V·H) is laid move by g Σ V/2: towards V no more than their own spread
    there, and aside where they are stretched.  With V's part along the surface, V − (N·V) N, this is Σ V/m(V)², which
    is that part itself where they are round.

    >>> from addon.reflectance.directions import direction
    >>> up, aside = direction(0.0, 0.0), direction(0.5, 0.0)
    >>> seen = seen_along(up, aside, 0.2, direction(1.0, 0.0), 0.0, 0.6)
    >>> round(float(seen[0]), 4), seen[1].round(3).tolist()
    (0.2949, [0.479, 0.0, 0.0])
    """
    n_v = minimum(dot(n, v), 1.0)
    t, b = frame_along(n, rotate(tangent, n, (2.0 * PI) * rotation))
    along, across = along_across(m, anisotropy)
    x, y = along * dot(v, t), across * dot(v, b)
    m2 = (x * x + y * y + LEAST_SINE2 * (m * m)) / (1.0 - n_v * n_v + LEAST_SINE2)
    stretched = widen(along * x / m2) * t + widen(across * y / m2) * b
    is_elliptic = less(0.0, anisotropy)
    return where(is_elliptic, sqrt(m2), m), where(widen(is_elliptic), stretched, v - widen(n_v) * n)


def tilted_lobes(n, v, m, look, towards=None):
    """[(colour, normal), …]: the three Beckmann lobes whose sum is the Standard realisation of a film.

    n, v     with N·V > 0
    m        rms slope of each, in the plane of N and V
    look     function of cos θ -> colour of the film
    towards  what they are tilted along, see :func:`seen_along`; by default V's part along the surface

    >>> from addon.reflectance.directions import direction
    >>> def red_face_on(c):
    ...     return widen(c) * (1.0, 0.0, 0.0)
    >>> red, green, blue = tilted_lobes(direction(0.0, 0.0), direction(0.6, 0.0), 0.2, red_face_on)
    >>> red[0].round(3).tolist(), red[1].round(3).tolist(), green[1].tolist()
    ([0.818, 0.0, 0.0], [0.014, 0.0, 1.0], [0.0, 0.0, 1.0])
    """
    n_v = minimum(dot(n, v), 1.0)
    towards = v - widen(n_v) * n if towards is None else towards
    return lobes_of(n, n_v, m, two_looks(n_v, m, look), towards)


def lobes_of(n, n_v, m, film, towards):
    """The same of the looks of :func:`two_looks`, by name mean, half and reach.

    >>> from types import SimpleNamespace
    >>> from addon.reflectance.directions import direction
    >>> grey = SimpleNamespace(mean=[0.5, 0.5, 0.5], half=[0.0, 0.0, 0.0], reach=0.05)
    >>> lobes = lobes_of(direction(0.0, 0.0), 0.8, 0.1, grey, direction(1.5, 0.0))
    >>> lobes[0][0].tolist(), lobes[0][1].tolist()
    ([0.5, 0.0, 0.0], [0.0, 0.0, 1.0])
    """
    tilt = tilts(n_v, m, film.mean, film.half, film.reach)
    r, g, b = (component(film.mean) for component in (x_of, y_of, z_of))
    colours = (vector(r, 0.0, 0.0), vector(0.0, g, 0.0), vector(0.0, 0.0, b))
    return [(colour, normalize(n + widen(component(tilt)) * towards))
            for colour, component in zip(colours, (x_of, y_of, z_of))]
