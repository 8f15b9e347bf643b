"""How far each realisation of a film is from F(V·H) at a slope: quadrature on a sphere and in an even surrounding.

The sphere is seen from far away and lit by a sun of 5° at 30° or 75° from the
viewer; pixels count where the lobe, if it were white, has more than 2 % of its
peak.  D is Beckmann's and G Smith's everywhere: only F differs, as a
realisation draws it: Standard by tilted lobes and, where there is a
FilmTrack, by Blender's native film at V·H from the slope on at which that is
closer.
"""

import functools
from typing import NamedTuple

import numpy as np

from ..errors import number
from ..reflectance.film_facets import native_share, tilted_lobes
from ..reflectance.masking import smith_beckmann
from ..reflectance.sampling import narrow_slope, wide_slope
from ..reflectance.slopes import beckmann
from .colour import delta_e_2000, lab
from .film_track import native_colours

__all__ = ["RealisationErrors", "native_errors", "reference_errors", "realisation_errors", "standard_errors",
           "tilted_means", "worst_of"]

SUNS = (30.0, 75.0)
SUN_DIAMETER = 5.0
FURNACE_DEGREES = np.arange(0.0, 85.0, 12.0)
SPHERE, SUN_RAYS, FACETS = 48, 19, 48
"""Pixels across the sphere, directions of a sun, and roots of the number of half vectors of the furnace."""
COARSE_SPHERE, COARSE_RAYS = 14, 5
GRID = np.linspace(0.0, 1.0, 129)
"""√cos θ of an exact curve."""
FINE = np.linspace(0.0, 1.0, 505)
"""√cos θ of the curve that stands for a table at one thickness; the rows of one of 64 are among them."""
SHOWN = 0.02
LEAST_N_V = 0.1
SAMPLING_WIDTH = 0.2
"""Of the Reference where none is given, as Cook-Torrance Reference's."""
VIEW = np.array([0.0, 0.0, 1.0])


class RealisationErrors(NamedTuple):
    """CIEDE2000 of a realisation from F(V·H).

    sphere_mean, sphere_p99  over a sphere's pixels under either sun
    furnace_mean, furnace_max  over directions from 0 to 84° in an even surrounding

    >>> RealisationErrors(0.2, 0.4, 0.1, 0.3)._asdict()["sphere_p99"]
    0.4
    """

    sphere_mean: float
    sphere_p99: float
    furnace_mean: float
    furnace_max: float


def standard_errors(table, m, thickness_nm, track=None):
    """The :class:`RealisationErrors` of Standard, three tilted lobes of the table's colours, or the native film.

    table         a FilmTable
    m             rms slope, above 0 and at most 1
    thickness_nm  within the table's range
    track         a FilmTrack of the table, where the renderer has a native film
    """
    m = number("slope m", m, high=1.0, above=0.0)
    return _standard(table, m, thickness_nm, _exact(table, thickness_nm), track)


def native_errors(table, m, thickness_nm, track):
    """The :class:`RealisationErrors` of the native film of a track alone, whether Standard has it at the slope or not.

    Arguments as :func:`standard_errors`.
    """
    m = number("slope m", m, high=1.0, above=0.0)
    return _native(table, m, thickness_nm, _exact(table, thickness_nm), track)


def reference_errors(table, m, thickness_nm, width=SAMPLING_WIDTH):
    """The :class:`RealisationErrors` of Reference, a facet drawn for each sample and the table at its V·H.

    width  Sampling Width, [0, 1]: light reaches a drawn facet through a narrow
           lobe, so F is a little blurred over slopes, by a²m²/(m² − a²) with a
           of :func:`addon.reflectance.sampling.narrow_slope` and wide_slope

    What remains once noise is gone; table and others as :func:`standard_errors`.
    """
    m = number("slope m", m, high=1.0, above=0.0)
    width = number("sampling width", width, 0.0, 1.0)
    return _reference(table, m, thickness_nm, _exact(table, thickness_nm), width)


def realisation_errors(table, m, count=5, track=None):
    """{realisation: RealisationErrors} at a slope: the worst over even thicknesses.

    count  thicknesses from end to end of the table's range; one where nothing varies
    track  a FilmTrack of the table, where the renderer has a native film

    "standard" and "reference"; with a track also what Standard takes, thickness by thickness, the closer of: "lobes"
    and "native".
    """
    m = number("slope m", m, high=1.0, above=0.0)
    low, high = table.thickness_range_nm
    thicknesses = np.linspace(low, high, count) if high > low else [low]
    found = [(thickness, _between(curve)) for thickness, curve in zip(thicknesses, table.curves(thicknesses, GRID**2))]

    def worst(errors, *more):
        return worst_of(errors(table, m, thickness, film, *more) for thickness, film in found)
    lobes, reference = worst(_standard, None), worst(_reference, SAMPLING_WIDTH)
    if track is None:
        return {"standard": lobes, "reference": reference}
    return {"standard": worst(_standard, track), "reference": reference, "lobes": lobes,
            "native": worst(_native, track)}


def tilted_means(table, m, thicknesses_nm):
    """Mean CIEDE2000 of the tilted lobes over the sphere, the worse sun's, at thicknesses ``(D,)``, ``(D,)``.

    A coarse sphere: a quick estimate of what :func:`standard_errors` finds.
    """
    at = np.asarray(thicknesses_nm)[:, None]

    def look(c):
        return table.at(c, at)
    n = _sphere_normals(COARSE_SPHERE)
    tilted = tilted_lobes(n, VIEW, m, look)
    means = []
    for angle in SUNS:
        shown, exact = _lit(n, look, m, angle, COARSE_RAYS, tilted)
        means.append(_difference(shown, exact, table.viewing.space).mean(axis=-1))
    return np.maximum(*means)


def worst_of(errors):
    """The largest of each number of several RealisationErrors, as for the thicknesses of a range."""
    return RealisationErrors(*(float(x) for x in np.max(np.array(list(errors)), axis=0)))


def _standard(table, m, thickness_nm, film, track):
    share, native = 0.0, None
    if track is not None:
        share = float(native_share(m, track.from_slope_at(thickness_nm)))
        native = _drawn_natively(table, thickness_nm, track)

    def lobes(n, v):
        tilted = tilted_lobes(n, v, m, lambda c: table.at(c, thickness_nm))
        return [((1.0 - share) * colour, normal) for colour, normal in tilted]
    return _errors(film, m, table.viewing.space, lobes if share < 1.0 else None,
                   native and (lambda n, h, v: share * native(n, h, v)))


def _native(table, m, thickness_nm, film, track):
    return _errors(film, m, table.viewing.space, blurred=_drawn_natively(table, thickness_nm, track))


def _drawn_natively(table, thickness_nm, track):
    """function of (n, h, v) -> the native film at V·H, ``(..., 3)``."""
    fine = FINE[1:] ** 2
    curve = native_colours(track.at(thickness_nm), fine, table.viewing.space)

    def native(n, h, v):
        return np.stack([np.interp(h @ v, fine, channel) for channel in curve.T], axis=-1)
    return native


def _reference(table, m, thickness_nm, film, width):
    root = np.sqrt(table.at(FINE**2, thickness_nm))

    def look(c):
        y = np.sqrt(c) * (len(FINE) - 1)
        low = np.minimum(y.astype(int), len(FINE) - 2)
        share = (y - low)[..., None]
        found = root[low] + share * (root[low + 1] - root[low])
        return found * found

    def blurred(n, h, v):
        return _blurred(look, n, h, v, m, width)
    return _errors(film, m, table.viewing.space, blurred=blurred)


def _errors(film, m, space, lobes=None, blurred=None):
    spheres = [_difference(*_sphere(film, m, angle, lobes, blurred), space) for angle in SUNS]
    furnace = _difference(*_furnace(film, m, lobes, blurred), space)
    everywhere = np.concatenate(spheres)
    return RealisationErrors(float(max(sphere.mean() for sphere in spheres)),
                             float(np.percentile(everywhere, 99.0)), float(furnace.mean()), float(furnace.max()))


def _difference(shown, exact, space):
    return delta_e_2000(lab(exact, space), lab(shown, space))


def _exact(table, thickness_nm):
    """The exact F, mapped as the table is, as a function of cos θ."""
    return _between(table.curves([thickness_nm], GRID**2)[0])


def _between(rgb):
    """A curve at GRID² as a function of cos θ."""
    return lambda c: np.stack([np.interp(np.sqrt(c), GRID, channel) for channel in rgb.T], axis=-1)


def _sphere(film, m, degrees, lobes, blurred):
    """(shown, exact) colours of the sphere's lit pixels, ``(P, 3)`` each, where white would be 1 at the peak."""
    n = _sphere_normals()
    return _lit(n, film, m, degrees, SUN_RAYS, lobes and lobes(n, VIEW), blurred)


def _lit(n, film, m, degrees, rays, tilted, blurred=None):
    """(shown, exact) colours ``(..., P, 3)`` of those of the normals ``(N, 3)`` that the sun lights."""
    white, exact, shown = 0.0, 0.0, 0.0
    for light in _sun(np.radians(degrees), rays):
        h = (light + VIEW) / np.linalg.norm(light + VIEW)
        facing = n @ light > 0.0
        facets = _lobe(n, h, VIEW, light, m) * facing
        white = white + facets
        exact = exact + facets[:, None] * film(h @ VIEW)
        if tilted:
            shown = shown + _tilted(tilted, h, VIEW, light, m) * facing[:, None]
        if blurred:
            shown = shown + facets[:, None] * blurred(n, h, VIEW)
    lit = white > SHOWN * white.max()
    return shown[..., lit, :] / white.max(), exact[..., lit, :] / white.max()


def _furnace(film, m, lobes, blurred):
    """(shown, exact) albedos over N·V, ``(F, 3)`` each: sums over half vectors, even in D cos α dω."""
    n = np.array([0.0, 0.0, 1.0])
    shown, exact = [], []
    for angle in np.radians(FURNACE_DEGREES):
        v = np.array([np.sin(angle), 0.0, np.cos(angle)])
        h = _facets(m, n)
        exact.append(np.sum(_carried(n, h, v, m, n)[:, None] * film(np.clip(h @ v, 0.0, 1.0)), axis=0) / len(h))
        total = 0.0
        if lobes:
            total = sum(_carried(normal, _facets(m, normal), v, m, n).mean() * colour for colour, normal in lobes(n, v))
        if blurred:
            total = total + np.sum(_carried(n, h, v, m, n)[:, None] * blurred(n, h, v), axis=0) / len(h)
        shown.append(total)
    return np.array(shown), np.array(exact)


def _lobe(n, h, v, light, m):
    """D G/(4 N·V) of a white lobe about n, 0 where it does not face the light."""
    n_v, n_l = np.maximum(n @ v, 1e-3), n @ light
    return np.where(n_l > 0.0, beckmann(n @ h, m) / np.pi * smith_beckmann(n_v, n_l, m) / (4.0 * n_v), 0.0)


def _tilted(lobes, h, v, light, m):
    return sum(colour * _lobe(normal, h, v, light, m)[..., None] for colour, normal in lobes)


def _carried(normal, h, v, m, true_normal):
    """What each facet h of a lobe about a normal sends to v out of an even surrounding above the true surface."""
    v_h, n_h, n_v = h @ v, h @ normal, max(float(normal @ v), 1e-3)
    light = 2.0 * v_h[:, None] * h - v
    n_l = light @ normal
    seen = (v_h > 0.0) & (n_l > 0.0) & (light @ true_normal > 0.0)
    return np.where(seen, smith_beckmann(n_v, n_l, m) * v_h / (n_v * n_h), 0.0)


def _blurred(look, n, h, v, m, width):
    """The film at V·H with H's slopes blurred along and across the ring about N that it is on, ``(..., 3)``."""
    cos_alpha = np.sum(n * h, axis=-1)
    flat = h / np.maximum(cos_alpha, 1e-3)[..., None] - n  # the facet's slope, as a vector in the surface
    tan_alpha = np.linalg.norm(flat, axis=-1)[..., None]
    outwards = np.where(tan_alpha > 1e-6, flat / np.maximum(tan_alpha, 1e-6), _any_tangent(n))
    along = np.cross(n, outwards)
    spread = [np.sqrt(0.5 * a * a * m * m / (m * m - a * a)) for a in (narrow_slope(m, width), wide_slope(m, width))]
    total = 0.0
    for x, y in ((1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)):  # exact to the third order
        facet = n + flat + spread[0] * x * outwards + spread[1] * y * along
        cosine = facet @ v / np.linalg.norm(facet, axis=-1)
        total = total + 0.25 * look(np.clip(cosine, 0.0, 1.0))
    return total


def _any_tangent(n):
    tangent = np.cross(n, [0.7531, 0.0, 0.6579])
    return tangent / np.linalg.norm(tangent, axis=-1, keepdims=True)


@functools.lru_cache(maxsize=2)
def _sphere_normals(count=SPHERE):
    """Normals of a sphere's pixels, ``(P, 3)``: one half of them, as the sun is in the plane of x and z."""
    x, y = np.meshgrid((np.arange(count) + 0.5) / count * 2.0 - 1.0, (np.arange(count // 2) + 0.5) / count * 2.0)
    z = np.sqrt(np.maximum(1.0 - x * x - y * y, 0.0))
    return np.stack([x, y, z], axis=-1)[z > LEAST_N_V]


def _sun(angle, rays=SUN_RAYS):
    """Directions of a disc of 5° about the one at this angle from the viewer, ``(rays, 3)``."""
    radius = np.radians(SUN_DIAMETER / 2.0) * np.sqrt((np.arange(rays) + 0.5) / rays)
    turn = np.arange(rays) * 2.399963  # the golden angle: even on the disc
    across = np.array([[np.cos(angle), 0.0, -np.sin(angle)], [0.0, 1.0, 0.0]])
    light = np.array([np.sin(angle), 0.0, np.cos(angle)]) + (radius * [np.cos(turn), np.sin(turn)]).T @ across
    return light / np.linalg.norm(light, axis=-1, keepdims=True)


@functools.lru_cache(maxsize=4)
def _slopes(m, count=FACETS):
    """Facets about z that are even in D cos α dω, ``(count², 3)``."""
    tan_alpha = m * np.sqrt(-np.log((np.arange(count) + 0.5) / count))[:, None]
    phi = (np.arange(count) + 0.5) / count * 2.0 * np.pi
    h = np.stack(np.broadcast_arrays(tan_alpha * np.cos(phi), tan_alpha * np.sin(phi), 1.0), axis=-1).reshape(-1, 3)
    return h / np.linalg.norm(h, axis=-1, keepdims=True)


def _facets(m, normal):
    """The same about a normal in the plane of x and z."""
    normal = np.asarray(normal).reshape(3)
    frame = np.array([[normal[2], 0.0, -normal[0]], [0.0, 1.0, 0.0], normal])
    return _slopes(m) @ frame
