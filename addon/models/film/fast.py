"""A film by native closures: a tilted Beckmann lobe for each channel, light-sampled on every device.

The table is looked up a spread of V·H above and below its mean over the facets
that V sees: see addon.reflectance.film_facets.  Where there is a native film,
that takes over from the slope on at which it is closer: see .native.
"""

from types import SimpleNamespace

from ...operands import dot, minimum, part, sqrt
from ...reflectance.film_facets import lobes_of, seen_along, two_looks
from .lookup import is_blended, look
from .native import native_film, place_of_track
from .surface import Surface, lobe

__all__ = ["build", "build_eevee"]


def build(builder):
    """Build the group."""
    surface = Surface(builder, "fast")
    s = surface.sockets
    stretching = SimpleNamespace(anisotropy=s.anisotropy, rotation=s.rotation, tangent=surface.tangent)
    track = place_of_track(builder, surface.table.across, s.rows, s.height)
    lobes, reflected = zip(*(
        _closer(builder, surface.n, surface.v, m, roughness, s.tint, stretching, surface.table, track)
        for m, roughness in ((surface.m, s.roughness), (surface.second, sqrt(surface.second)))))
    builder.output("BSDF", surface.closures(surface.mixed(*lobes), reflected[0]))


@part("Film's Lobes", "BSDF", "Reflected")
def _closer(builder, n, v, m, roughness, tint, stretching, table, track):
    """(the closer of the native film and the tilted lobes at a slope m, the colour of the lobes)."""
    native, left, some = native_film(builder, n, m, roughness, tint, stretching, track)
    lobes, reflected = _lobes(builder, n, v, m, roughness, left, stretching, table)
    return builder.add_shaders(builder.scale_shader(some, lobes), native), reflected


@part("Tilted Lobes", "BSDF", "Reflected")
def _lobes(builder, n, v, m, roughness, tint, stretching, table):
    """A lobe for each channel of a slope m, their sum; and the colour that all of them have."""
    n_v = minimum(dot(n, v), 1.0)
    m_v, towards = seen_along(n, v, m, stretching.tangent, stretching.rotation, stretching.anisotropy)
    film = _two_looks(builder, n_v, m_v, table)
    lobes = [lobe(builder, tint * colour, normal, roughness, stretching)
             for colour, normal in lobes_of(n, n_v, m_v, film, towards)]
    return builder.add_shaders(*lobes), film.mean


def _two_looks(builder, n_v, m, table):
    named = part("Two Looks, Blended" if is_blended(table) else "Two Looks")
    return named(_looks)(builder, n_v, m, table)


def _looks(builder, n_v, m, table):
    return two_looks(n_v, m, lambda c: look(builder, c, table))


def build_eevee(builder):
    """Build the group for EEVEE, which draws a lobe at random of several: one lobe, of their mean colour."""
    surface = Surface(builder, "fast", closest=True)
    s = surface.sockets
    m, roughness = _of_both(surface.m, s.roughness, s.ratio2, s.w2)
    colour = _two_looks(builder, surface.n_v, m, surface.table).mean
    stretching = SimpleNamespace(anisotropy=s.anisotropy, rotation=s.rotation, tangent=surface.tangent)
    one = lobe(builder, s.tint * colour, surface.n, roughness, stretching)
    builder.output("BSDF", surface.closures(one, colour))


@part("Slope of Both", "m", "Roughness")
def _of_both(m, roughness, ratio, weight):
    """The slope whose square is the mean of both slopes' squares, and the roughness of that."""
    wider = sqrt(1.0 + weight * (ratio * ratio - 1.0))
    return m * wider, roughness * sqrt(wider)
