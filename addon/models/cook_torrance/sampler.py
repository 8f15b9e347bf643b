"""Drawing facets of the Cook-Torrance model, for renderers that cannot evaluate it.

Proposal: the normals that the viewer sees between V-shaped grooves.  A groove
has two sides, H and its mirror image H' about N; draw one from D cos α and keep
the side that V sees, with probability (V·H)⁺/((V·H)⁺ + (V·H')⁺).  The density
is p(L) = G1 D/(4π N·V), so the weight f (N·L)/p(L) is F G/G1: no D in it, never
above F, and 1 on most of the lobe.  E. Heitz and E. d'Eon, "Importance Sampling
Microfacet-Based BSDFs using the Distribution of Visible Normals", EGSR 2014.
Both sides, each weighed by that probability, do the same with half the variance
under a small lamp, which at most one of them lights.

With Sampling Width 0 that is all, and exact.  With a width above 0 a native
Beckmann lobe that lies under f carries most of the light (:func:`native_lobe`),
and lobes about drawn facets only what is left of f above it.  Those are narrow
across the rings about N, over which D falls and G has its kinks, and wide along
them, where neither changes much.

Every node costs, so a difference y − c x with a constant c is written c' x + y,
c' = −c, which is one node.
"""

from types import SimpleNamespace

from ...operands import (
    absolute,
    clip,
    cos,
    cross,
    dot,
    exp,
    inverse_sqrt,
    length,
    less,
    log,
    maximum,
    minimum,
    normalize,
    part,
    rotate,
    sin,
    sqrt,
    where,
    widen,
)
from ...reflectance.directions import PI, frame_along, tangent_of
from ...reflectance.fresnel import COS_THETA_82, conductor, f82_tint_of, f82_unclamped
from ...reflectance.masking import smith_lambda_of_slope
from ...reflectance.sampling import chosen, narrowed, squared_tilt, towards_flanks
from ...reflectance.slopes import along_across, elliptic_gaussian_c, gaussian_c

__all__ = ["native_slope", "native_lobe", "drawn_slope", "kept", "native_fresnel", "scales", "native_scale",
           "stretched", "facet", "native_over_d", "sharpened_v_cavity", "facet_weight", "HEADROOM", "FLANKS"]

SMALLEST = 1e-6
SMALLEST_LEVEL = 1e-3
"""Of V·H over N·H, so that G's derivatives stay finite; light so mirrored goes below the surface."""

STEEPEST = 1.55
"""Largest tilt of a drawn facet in radians; steeper ones carry no light."""

HEADROOM = 0.985
"""Keeps the native lobe under f where its F82 Fresnel term lies above the exact one."""


FLANKS = 1.0
"""How far facets for the light above the native lobe are drawn from its flanks, where most of it is."""


@part("Native Slope")
def native_slope(m):
    """Slope of the native Beckmann lobe under a formula of rms slope m: m (1 − 0.72 m²/(1 + 1.9 m²)).

    A little less than m, for the V-cavity G ends rough lobes sooner than Smith's.

    >>> round(float(native_slope(0.4)), 4)
    0.3647
    """
    m2 = m * m
    return m * (1.0 - 0.72 * m2 / (1.0 + 1.9 * m2))


@part("Native Lobe", "share", "lean")
def native_lobe(n_v, m):
    """Share w and lean of the native Beckmann lobe that carries as much light as it can without passing f.

    n_v  N·V, ``(...)``
    m    rms slope, ``(...)``

    The lobe has the slope of :func:`native_slope` and weighs 0.985 w, about N
    leaned towards V: N + lean·V.  The lean, of a few degrees at most, keeps its
    light from the horizon, where the V-cavity G fades sooner than Smith's.  With
    x = tan(half the angle from V to the horizon)/m, how far in slopes the facets
    are that mirror V into the horizon,
    w = min(1.12 x + min(0.52, 0.65 − 0.073/m), (1.012 + min(0.12 o, 0.03)) slope²/m²,
    max(min(0.895, 0.85 + 0.22 m) − 0.5 o x, 0.47 − 0.3 o + 0.19 x)), o = max(0, m − 0.35), and
    lean = m min((0.084 + 0.21 m²)(x − 0.19 − 0.058/m), (0.028 + 0.22 m)(3.1 − x), 0.21 − 0.19 m),
    both at least 0.  Found by comparing the lobes over all L: up to 85° from the
    normal what sticks out of f, and is lost, is less than 0.2 % of the light.

    >>> [round(float(y), 4) for y in native_lobe(1.0, 0.1)]
    [0.9977, 0.0]
    >>> [round(float(y), 4) for y in native_lobe(0.5, 0.3)]
    [0.895, 0.0157]
    """
    x = n_v / (m * sqrt(1.0 - n_v * n_v) + m)
    return _native_share(x, m), _native_lean(x, m)


@part("Native Share")
def _native_share(x, m):
    """w of :func:`native_lobe`."""
    narrower = native_slope(m) / m
    grazing = 1.12 * x + minimum(0.52, 0.65 - 0.073 / m)
    over = maximum(m - 0.35, 0.0)
    peak = (1.012 + minimum(0.12 * over, 0.03)) * (narrower * narrower)
    middle = maximum((-0.5 * over) * x + minimum(0.895, 0.85 + 0.22 * m), 0.19 * x + (0.47 - 0.3 * over))
    return maximum(minimum(grazing, peak, middle), 0.0)


@part("Native Lean")
def _native_lean(x, m):
    """The lean of :func:`native_lobe`."""
    far, near = m * (0.084 + 0.21 * (m * m)), m * (0.028 + 0.22 * m)
    lean_far = far * x + (-far) * (0.19 + 0.058 / m)
    lean_near = (-near) * x + 3.1 * near
    return clip(minimum(lean_far, lean_near), 0.0, m * (0.21 - 0.19 * m))


@part("Draw by Weight", "m", "weight", "share", "lean", "narrow", "wide")
def drawn_slope(u, has_native, slopes, weights, *values):
    """One of the slopes m of weights w, and what it weighs for all of them; then the entries of the value lists.

    u           even in [0, 1)
    has_native  1 where native lobes carry most of the light: drawn by w m, it weighs Σ w m/m; 0: by w, Σ w

    What the native lobe leaves lies farther out on the rougher lobes, where
    drawn facets are rarer and each shows more.

    >>> m, weight, first = drawn_slope(0.5, 1.0, [0.4, 0.2], [0.4, 0.6], [1.0, 2.0])
    >>> float(m), round(float(weight), 6), float(first)
    (0.4, 0.7, 1.0)
    """
    odds = [w * _more_often(has_native, m) for m, w in zip(slopes, weights)]
    m, *found = chosen(u, odds, slopes, *values)
    return m, sum(odds[1:], odds[0]) / _more_often(has_native, m), *found


@part("How Often")
def _more_often(has_native, m):
    """Over the weight, how often a slope is drawn."""
    return where(has_native, m, 1.0)


@part("Roulette")
def kept(share):
    """Probability of drawing a facet at all: less where the native lobe leaves next to nothing.

    share  of :func:`native_lobe`

    4.6 − 4 share, at most 1.  A drawn facet's weight is divided by it; the nodes
    of a facet that is not drawn are not evaluated.  A small lamp is hit by one
    drawn facet in hundreds, so what drawing more of them takes from the noise is
    worth more than their time, by half on smooth metals.

    >>> [round(float(kept(share)), 6) for share in (0.0, 0.85, 0.9, 0.95, 1.0)]
    [1.0, 1.0, 1.0, 0.8, 0.6]
    """
    return minimum(-4.0 * share + 4.6, 1.0)


@part("Native Fresnel", "F0", "Tint")
def native_fresnel(n, k):
    """F0 and tint of the F82 model for the native lobe, each within [0, 1], ``(..., 3)``.

    F82 and not the conductor formula, which differs between Blender's versions.

    >>> f0, tint = native_fresnel(0.2, 3.91)
    >>> round(float(f0), 4), round(float(tint), 4)
    (0.9522, 0.9783)
    """
    f0 = conductor(1.0, n, k)
    return f0, clip(f82_tint_of(maximum(f0, SMALLEST), conductor(COS_THETA_82, n, k)), 0.0, 1.0)


@part("Scale", "scale", "native scale")
def scales(m, gaussian, published, printed_c, ellipse=None):
    """Factors on the energy-conserving lobe of slope m: of f, and of the native lobe, at most four.

    gaussian   0 for Beckmann's D, 1 for the Gaussian
    published  0 for the energy scale, 1 for the printed one: four times as
               bright, with printed_c in place of the c that normalises
    ellipse    of :func:`stretched`

    Between its peak and its foot the Gaussian lies a little below Beckmann's D,
    and the native lobe with it.

    >>> scales(0.2, 0.0, 0.0, 1.0), scales(0.2, 0.0, 1.0, 1.0)
    ((1.0, 1.0), (4.0, 4.0))
    """
    return _scales(m, gaussian, published, printed_c, ellipse)


@part("Native Scale")
def native_scale(m, gaussian, published, printed_c, ellipse):
    """The native lobe's factor of :func:`scales`, where gaussian is a share of both distributions.

    >>> native_scale(0.2, 0.5, 0.0, 1.0, None)
    0.985
    """
    return _scales(m, gaussian, published, printed_c, ellipse)[1]


def _scales(m, gaussian, published, printed_c, ellipse):
    """As :func:`scales` has it."""
    printed = 4.0 * (1.0 + gaussian * (printed_c / _c(m, ellipse) - 1.0))
    scale = 1.0 + published * (printed - 1.0)
    return scale, minimum(scale, 1.0 + 3.0 * published) * (1.0 - 0.03 * gaussian)


@part("Ellipse")
def stretched(n, tangent, m, anisotropy):
    """How the facets' slopes are stretched: what :func:`facet` takes as its ellipse.

    n, tangent  the unit normal and what the slopes are stretched along, ``(..., 3)``
    m           rms slope, ``(...)``
    anisotropy  [0, 1); where it is 0 all that this adds to the nodes folds away

    By name: is_elliptic; t, the unit tangent; along and across, slopes over m.

    >>> from addon.reflectance.directions import direction
    >>> ellipse = stretched(direction(0.0, 0.0), direction(1.0, 0.0), 0.2, 0.6)
    >>> round(float(ellipse.along), 4), round(float(ellipse.across), 4)
    (1.4744, 0.6782)
    """
    along, across = along_across(m, anisotropy)
    t, _ = frame_along(n, tangent)
    return SimpleNamespace(is_elliptic=less(0.0, anisotropy), t=t, along=along / m, across=across / m)


def facet(n, v, m, a, wide, flanks, gaussian, u_tilt, u_azimuth, u_side, ellipse=None, side=None):
    """A facet of rms slope m drawn as the viewer sees it, for a lobe about it.

    n, v       unit directions, ``(..., 3)``
    m          rms slope, ``(...)``
    a, wide    slopes of the lobe across and, at most, along the ring about n; 0 draws exactly
    flanks     [0, 1], how far the drawing keeps to the flanks of the lobe; 0 draws as D
    gaussian   0 for Beckmann's D, 1 for the Gaussian
    u_...      independent and even in [0, 1)
    ellipse    of :func:`stretched`: slopes are drawn as if they were round, and stretched with their lobe
    side       1 or −1: this side of the groove in place of one that is drawn, weighed by how well V sees it, 0 where
               not at all; both together are worth twice as many grooves

    Returns by name: h, the facet's normal ``(..., 3)``; across, the unit
    direction at right angles to n in which it is tilted, ``(..., 3)``; the lobe in its
    own frame, by lobe_tangent ``(..., 3)`` and its slopes narrow along that and broad
    across it; a_across and a_along, its slopes across and along the ring about n; with an
    ellipse also covariance, of both, v_along, and what :func:`native_over_d` needs; stretch, see
    :func:`addon.reflectance.sampling.narrowed`.  And at the mean of what the
    lobe covers, where it is weighed: the cosines n_h, v_h, n_v, n_l; the tilt's
    tangent; v_across; level, V·H over N·H; D as exp(−steepness/m²)/(m·flat)²; and
    density, D over the drawn density's part that depends on the distribution and
    the side.

    >>> from addon.reflectance.directions import direction
    >>> up = direction(0.0, 0.0)
    >>> x = facet(up, up, 0.5, 0.0, 0.0, 0.0, 0.0, 0.36787944, 0.0, 0.0)
    >>> round(float(x.n_h), 4), round(float(x.v_h), 4), round(float(x.density), 6)     # tan α = m
    (0.8944, 0.8944, 1.0)
    """
    named = part("Drawn Facet" if side is None else "Facet on a Side")
    return named(_facet)(n, v, m, a, wide, flanks, gaussian, u_tilt, u_azimuth, u_side, ellipse, side)


def _facet(n, v, m, a, wide, flanks, gaussian, u_tilt, u_azimuth, u_side, ellipse, side):
    """As :func:`facet` has it."""
    if ellipse is None:
        across, out = rotate(tangent_of(n), n, (2.0 * PI) * u_azimuth), 1.0
    else:
        across, out = _stretched_direction(n, u_azimuth, ellipse)
    tilt = _tilt(m, a, wide, flanks, u_tilt)
    drawn = _of_distribution(gaussian, tilt.drawn, tilt.weighed2, out, _c_m2(m, ellipse))
    groove = _drawn_side(n, v, across, drawn.tangent_drawn, u_side) if side is None else \
        _given_side(n, v, across, drawn.tangent_drawn, side)
    x = _weighed(n, across, a, tilt, drawn, groove)
    if ellipse is None:
        return SimpleNamespace(**vars(x), lobe_tangent=across, narrow=x.a_across, broad=x.a_along)
    lobe = _stretched_lobe(across, x.a_across, x.a_along, n, out, drawn.cos_drawn, drawn.to_angle, ellipse)
    slopes = _slopes_over_longest(x, v, groove.side, out, ellipse)
    return SimpleNamespace(**{**vars(x), **vars(lobe), **vars(slopes)}, is_elliptic=ellipse.is_elliptic,
                           along=ellipse.along, v_along=groove.side * dot(cross(n, across), v))


@part("Tilt")
def _tilt(m, a, wide, flanks, u_tilt):
    """How far a facet is tilted: as it is drawn, and as it is weighed, by name; see :func:`facet`."""
    m2 = m * m
    m2_drawn, stretch = narrowed(m, a)
    kept_u, rarity = towards_flanks(u_tilt, flanks)
    drawn2 = squared_tilt(kept_u, m2_drawn)
    drawn = sqrt(drawn2)
    along = maximum(a, minimum((2.5 * wide / m) * drawn, wide))
    # Along a tangent the tilt only grows, its square by half the lobe's; and D with it, but for a factor.
    grown = along * along + (-(a * a))
    return SimpleNamespace(drawn=drawn, weighed2=(stretch * stretch) * drawn2 + 0.5 * grown, stretch=stretch,
                           along=along, density=sqrt((-1.0 / m2) * grown + 1.0) * rarity)


@part("Tilt of D")
def _of_distribution(gaussian, drawn, weighed2, out, c_m2):
    """The same of the distribution, stretched `out` times, by name."""
    drawn, weighed2 = out * drawn, (out * out) * weighed2
    found = [where(gaussian, g, b)
             for g, b in zip(_gaussian(drawn, weighed2, c_m2), _beckmann(drawn * drawn, drawn, weighed2))]
    names = ("tangent_drawn", "cos_drawn", "tangent", "n_h", "flat", "density", "to_angle")
    return SimpleNamespace(**dict(zip(names, found)), weighed2=weighed2)


@part("Side of the Groove")
def _drawn_side(n, v, across, tangent_drawn, u_side):
    """Which side of the groove is drawn, 1 or −1, and what it weighs, by name."""
    n_v, across_v = dot(n, v), dot(across, v)
    # V·H/cos α is n_v + aside on the one side of the groove, and n_v - aside on the other; one of them may be hidden.
    aside = tangent_drawn * across_v
    twice = 2.0 * n_v
    side = 1.0 - 2.0 * less(n_v + aside, twice * u_side)
    return SimpleNamespace(n_v=n_v, side=side, v_across=side * across_v,
                           weight=1.0 / minimum(twice / (side * aside + n_v), 1.0))


@part("Given Side of the Groove")
def _given_side(n, v, across, tangent_drawn, side):
    """The same of a given side: what it weighs where it is drawn, times how often."""
    n_v, v_across = dot(n, v), side * dot(across, v)
    return SimpleNamespace(n_v=n_v, side=side, v_across=v_across,
                           weight=maximum(tangent_drawn * v_across / (2.0 * n_v) + 0.5, 0.0))


@part("Facet")
def _weighed(n, across, a, tilt, drawn, groove):
    """What :func:`facet` gives of a facet before its lobe is stretched."""
    level = maximum(drawn.tangent * groove.v_across + groove.n_v, SMALLEST_LEVEL)
    return SimpleNamespace(
        h=normalize(n + widen(groove.side * drawn.tangent_drawn) * across), across=across,
        a_across=a * (drawn.to_angle * drawn.to_angle), a_along=tilt.along * drawn.to_angle, stretch=tilt.stretch,
        n_h=drawn.n_h, n_v=groove.n_v, n_l=(2.0 * level) * (drawn.n_h * drawn.n_h) - groove.n_v,
        v_h=drawn.n_h * level, tangent=drawn.tangent, v_across=groove.v_across, level=level, steepness=tilt.weighed2,
        flat=drawn.flat, density=drawn.density * tilt.density * groove.weight)


@part("Stretched Direction", "direction", "length")
def _stretched_direction(n, u_azimuth, ellipse):
    """The unit direction that a facet is tilted in, and how far the stretching takes its tilt out."""
    t, is_elliptic = ellipse.t, ellipse.is_elliptic
    even = rotate(where(widen(is_elliptic), t, tangent_of(n)), n, (2.0 * PI) * u_azimuth)
    slope = widen(ellipse.across) * even + widen((ellipse.along - ellipse.across) * dot(even, t)) * t
    return where(widen(is_elliptic), normalize(slope), even), where(is_elliptic, length(slope), 1.0)


def _c(m, ellipse):
    """The c of the Gaussian that normalises."""
    return gaussian_c(m) if ellipse is None else _elliptic_c(m, ellipse)


@part("Normalising c")
def _elliptic_c(m, ellipse):
    """The same where slopes may be stretched."""
    return where(ellipse.is_elliptic, elliptic_gaussian_c(ellipse.along * m, ellipse.across * m), gaussian_c(m))


def _c_m2(m, ellipse):
    """c mt mb."""
    product = 1.0 if ellipse is None else where(ellipse.is_elliptic, ellipse.along * ellipse.across, 1.0)
    return _c(m, ellipse) * (m * m) * product


@part("Stretched Lobe")
def _stretched_lobe(across, a_across, a_along, n, out, cos_drawn, to_angle, ellipse):
    """The lobe that a facet's round one becomes: what is e in even slopes is M e, M stretching along t.

    Of the round lobe's axes the one across the ring comes to lie along the tilt again, `out` times as long; the other
    one, along the ring, comes to lie askew.
    """
    is_elliptic, product = ellipse.is_elliptic, ellipse.along * ellipse.across
    # Where the tilt is along (c, s) from t, the ring's axis has these components along the tilt and across it.
    c, s = dot(across, ellipse.t), dot(cross(ellipse.t, across), n)
    squares = ellipse.across * ellipse.across - ellipse.along * ellipse.along
    askew, aside = out * (squares / product) * (c * s), product / out
    narrow, along = a_across * out, a_along
    skew = along * (askew * to_angle)
    across2, along2 = narrow * narrow + skew * skew, (along * aside) * (along * aside)
    covariance = skew * (along * aside)
    broad, u, w = _axes(across2, along2, covariance)
    tangent = widen(u / cos_drawn) * across + widen(w) * cross(n, across)
    return SimpleNamespace(
        lobe_tangent=where(widen(is_elliptic), normalize(tangent), across),
        narrow=where(is_elliptic, narrow * (along * aside) / maximum(broad, SMALLEST), a_across),
        broad=where(is_elliptic, broad, a_along),
        a_across=where(is_elliptic, sqrt(across2), a_across), a_along=where(is_elliptic, along * aside, a_along),
        covariance=is_elliptic * covariance)


@part("Axes of the Lobe", "broad", "u", "w")
def _axes(across2, along2, covariance):
    """The longer axis of an ellipse of these variances, and how far the shorter lies across and along."""
    mean, half = 0.5 * (across2 + along2), 0.5 * (across2 - along2)
    apart = sqrt(half * half + covariance * covariance)
    broad = sqrt(mean + apart)
    # Of what is a circle but for rounding, and has no axes, they are those of the round lobe.
    nearly = 1e-3 * mean
    lies_across = less(half, nearly)
    u = where(lies_across, (apart - half) + nearly, -covariance)
    w = where(lies_across, -covariance, apart + half)
    return broad, u, w


@part("Facet of Beckmann", "tangent drawn", "cosine drawn", "tangent", "N·H", "flat", "density", "to angle")
def _beckmann(drawn2, drawn, weighed2):
    """What :func:`facet` needs of a facet with tan² α = drawn2, weighed at another, in its order.

    In the plane of slopes dω = cos³ α d²slope, which D cos α leaves a 1/cos α
    of; an angle is cos² α of its slope across the rings, and cos α along them.
    """
    cos_drawn, n_h = inverse_sqrt(1.0 + drawn2), inverse_sqrt(1.0 + weighed2)
    return drawn, cos_drawn, sqrt(weighed2), n_h, n_h * n_h, cos_drawn / n_h, cos_drawn


@part("Facet of Gauss", "tangent drawn", "cosine drawn", "tangent", "N·H", "flat", "density", "to angle")
def _gaussian(drawn, weighed2, c_m2):
    """What :func:`facet` needs of a facet with α = drawn, weighed at another, in its order.

    c_m2  of :func:`_c_m2`

    In the plane of (α cos φ, α sin φ) dω = sin α/α d²α.
    """
    alpha_drawn, weighed = minimum(drawn, STEEPEST), sqrt(weighed2)
    alpha = maximum(minimum(weighed, STEEPEST), 1e-4)
    sine, n_h, cos_drawn = sin(alpha), cos(alpha), cos(alpha_drawn)
    return (sin(alpha_drawn) / cos_drawn, cos_drawn, sine / n_h, n_h, inverse_sqrt(c_m2),
            less(weighed, STEEPEST) * c_m2 * sine * cos_drawn / alpha, 1.0)


def native_over_d(x, m, lean):
    """D G of the native lobe over D, and N·V over its own: what it reflects in units of the formula's F D/(4π N·V).

    x     from :func:`facet`
    m     rms slope
    lean  of :func:`native_lobe`; 0 where the facets' slopes are stretched

    Evaluated so that blurring it gives this: the blur makes exp(−κy) to
    exp(−κy/(1 + κb))/(1 + κb), with κ + 1 the square of m over the lobe's slope
    and b = stretch − 1 the relative variance of stretched slopes, so a narrower
    and higher curve is blurred.  A stretched lobe has as much of both slopes as a
    round one has of the longer.

    >>> from addon.reflectance.directions import direction
    >>> up = direction(0.0, 0.0)
    >>> x = facet(up, up, 0.5, 0.0, 0.0, 0.0, 0.0, 0.36787944, 0.0, 0.0)
    >>> round(float(native_over_d(x, 0.5, 0.0)), 4)
    0.9637
    """
    return part("D native / D" if _is_stretched(x) else "Round D native / D")(_native_over_d)(x, m, lean)


def _native_over_d(x, m, lean):
    """As :func:`native_over_d` has it."""
    tan2_h = _steepness_about(x.n_v, x.v_across, x.tangent, x.level, lean)
    slope2_v, slope2_l = _slopes_about(x.n_v, x.n_l, x.v_h, lean)
    longest, steepness, of_v, of_l = m, tan2_h, slope2_v, slope2_l
    if _is_stretched(x):
        longest, steepness, of_v, of_l = _as_if_longest(x, m, tan2_h, slope2_v, slope2_l)
    m2, m_native = m * m, native_slope(longest)
    m2_native = m_native * m_native
    narrower = (longest * longest) / m2_native
    masked, shadowed = (
        smith_lambda_of_slope(sqrt(m2_native * slope2 + (-m2_native))) for slope2 in (of_v, of_l))
    sharper = 1.0 / (1.0 - minimum((narrower - 1.0) * (x.stretch - 1.0), 0.5))
    ratio = exp((sharper / m2) * (x.steepness - narrower * steepness) + log(sharper * narrower))
    peaks = (tan2_h + 1.0) * x.flat
    return (peaks * peaks) * ratio * (x.n_v * sqrt(slope2_v)) / (masked + shadowed + 1.0)


@part("Round or Stretched", "longest", "tan²", "of V", "of L")
def _as_if_longest(x, m, tan2_h, slope2_v, slope2_l):
    """The longest slope, and the steepness of H and the squares of the slopes of V and L as if all were the longest."""
    return (m * where(x.is_elliptic, x.along, 1.0), where(x.is_elliptic, x.round_tan2, tan2_h),
            where(x.is_elliptic, x.slope2_v, slope2_v), where(x.is_elliptic, x.slope2_l, slope2_l))


@part("Slopes over the Longest")
def _slopes_over_longest(x, v, side, out, ellipse):
    """tan² of H before it was stretched, and the squares of the slopes of V and L over the longest of D, and 1.

    A direction's slope along the short axis counts for as much less as that axis is shorter.
    """
    shorter = ellipse.across / ellipse.along
    saved = 1.0 - shorter * shorter  # of the square of a slope along the short axis
    v_t = dot(v, ellipse.t)
    h_t = (x.n_h * x.tangent) * (side * dot(x.across, ellipse.t))
    l_t = (2.0 * x.v_h) * h_t - v_t
    return SimpleNamespace(round_tan2=(x.tangent / out) * (x.tangent / out),
                           slope2_v=_slope2_over_longest(x.n_v, v_t, shorter, saved),
                           slope2_l=_slope2_over_longest(maximum(x.n_l, SMALLEST), l_t, shorter, saved))


def _slope2_over_longest(cosine, along, shorter, saved):
    """The square of a direction's slope over the longest, and 1; of its cosine and its component along the tangent."""
    cosine2 = cosine * cosine
    flat2 = (shorter * shorter) * (1.0 - cosine2) + saved * (along * along)
    return flat2 / cosine2 + 1.0


@part("Steepness about the Native Lobe")
def _steepness_about(n_v, v_across, tangent, level, lean):
    """tan² of the angle from H to N + lean V: |H × (N + lean V)|² over the square of their product, by components.

    Not 1/cos² - 1: single precision knows a cosine near 1 no better than the squared slope of a mirror.
    """
    n = lean * n_v + 1.0
    along, product = lean * v_across - n * tangent, lean * level + 1.0
    askew2 = (lean * lean) * ((1.0 - n_v * n_v) - v_across * v_across)
    return (askew2 * (tangent * tangent + 1.0) + along * along) / (product * product)


@part("Slopes about the Native Lobe", "of V", "of L")
def _slopes_about(n_v, n_l, v_h, lean):
    """The squares of the slopes of V and L about N + lean V, and 1."""
    # Cosines to N + lean V, which is 1/shorter times as long as N.
    shorter2 = lean * (2.0 * n_v + lean) + 1.0
    y_v, y_l = lean + n_v, maximum((2.0 * (v_h * v_h) - 1.0) * lean + n_l, SMALLEST)
    return shorter2 / (y_v * y_v), shorter2 / (y_l * y_l)


def sharpened_v_cavity(x):
    """The V-cavity G at a facet x of :func:`facet`, its kinks raised so that blurred by the lobe it comes out as G.

    At its kinks, where masking or shadowing sets in, the blur lowers G by about
    0.4 times its change across the blur, which follows from the derivatives of
    2 (N·H)(N·V)/(V·H) and 2 (N·H)(N·L)/(V·H) across and along the ring about N.
    The constants are the best of those tried, on spheres under suns.

    >>> from addon.reflectance.directions import direction
    >>> up = direction(0.0, 0.0)
    >>> mirror, lobe = (facet(up, up, 0.5, a, 2 * a, 0.0, 0.0, 0.27, 0.0, 0.0) for a in (0.0, 0.1))
    >>> round(float(sharpened_v_cavity(mirror)), 4), round(float(sharpened_v_cavity(lobe)), 4)
    (1.0, 1.0137)
    """
    return part("Sharpened G" if _is_stretched(x) else "Sharpened Round G")(_sharpened)(x)


def _is_stretched(x):
    """Whether a facet's lobe may lie askew."""
    return hasattr(x, "covariance")


def _sharpened(x):
    """As :func:`sharpened_v_cavity` has it."""
    reach = part("Reach" if _is_stretched(x) else "Round Reach")(_reach)(x)
    uncut = minimum(x.n_l, x.n_v) * (2.0 / x.level)
    near = maximum(reach - absolute(uncut - 1.0), 0.0)
    return near * (0.25 * (near / maximum(reach, SMALLEST))) + clip(uncut, 0.0, 1.0)


def _reach(x):
    """How far G changes across the lobe, at most 1."""
    steep = (2.0 * x.n_v) / (x.v_h * x.v_h)
    shadowed = less(x.n_l, x.n_v)
    fall = -8.0 * (shadowed * ((x.n_h * x.n_h) * x.tangent)) + steep * x.v_across
    across = x.a_across * fall
    turn = steep * x.n_h
    along = x.a_along * turn
    v_along2 = (1.0 - x.n_v * x.n_v) - x.v_across * x.v_across
    squared = 1.69 * (across * across) + (along * along) * v_along2
    if _is_stretched(x):
        squared = squared + x.covariance * (2.6 * (fall * (turn * x.v_along)))
    return minimum(sqrt(squared), 1.0)


@part("f cos/p")
def facet_weight(x, scale, native, n, k, f0, b, weight=1.0, probability=1.0):
    """Colour of the lobe about a drawn facet: F G less the native lobe, over the density, ``(..., 3)``.

    x            from :func:`facet`
    scale        of f, see :func:`scales`
    native       weight of the native lobe times :func:`native_over_d`; 0 where there is none
    n, k         complex refractive index, ``(..., 3)``
    f0, b        F82 Fresnel term of the native lobe, as :func:`addon.reflectance.fresnel.f82_unclamped` has it
    weight       of both
    probability  with which the facet is shown at all, see :func:`kept`

    With native 0 and a facet drawn with a = 0 it is f (N·L)/p(L).

    >>> from addon.reflectance.directions import direction
    >>> up = direction(0.0, 0.0)
    >>> x = facet(up, up, 0.5, 0.0, 0.0, 0.0, 0.0, 0.36787944, 0.0, 0.0)
    >>> facet_weight(x, 1.0, 0.0, 1.5, 0.0, 0.04, 0.0).round(4)
    array([0.0409])
    """
    v_h = widen(x.v_h)
    whole = conductor(v_h, n, k) * widen(scale * sharpened_v_cavity(x))
    left = maximum(whole - maximum(f82_unclamped(v_h, f0, b), 0.0) * widen(native), 0.0)
    return left * widen(weight * x.density / probability)
