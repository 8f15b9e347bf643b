"""A film by native closures: a tilted Beckmann lobe for each channel, light-sampled on every device.

The table is looked up a spread of V·H above and below its mean over the facets
that V sees: see addon.reflectance.film_facets.
"""

from ...operands import sqrt
from ...reflectance.film_facets import seen_along, tilted_lobes, two_looks
from .surface import Surface

__all__ = ["build", "build_eevee"]


def build(builder):
    """Build the group."""
    surface = Surface(builder, "fast")
    m, first = _lobes(surface, surface.m, surface.sockets.roughness)
    with builder.frame("Slope 2"):
        _, second = _lobes(surface, surface.second, sqrt(surface.second))
    reflected = two_looks(surface.n_v, m, surface.look).mean
    builder.output("BSDF", surface.closures(surface.mixed(first, second), reflected=reflected))


def _lobes(surface, m, roughness):
    """(slope towards V, a lobe for each channel) of a slope."""
    s = surface.sockets
    seen, towards = seen_along(surface.n, surface.v, m, surface.tangent, s.rotation, s.anisotropy)
    lobes = tilted_lobes(surface.n, surface.v, seen, surface.look, towards)
    return seen, [surface.lobe(colour, normal, roughness) for colour, normal in lobes]


def build_eevee(builder):
    """Build the group for EEVEE, which draws a lobe at random of several: one lobe, of their mean colour."""
    surface = Surface(builder, "fast", closest=True)
    with builder.frame("Rms slope"):
        ratio = sqrt(surface.mean_square())
        m, roughness = surface.m * ratio, surface.sockets.roughness * sqrt(ratio)
    colour = two_looks(surface.n_v, m, surface.look).mean
    builder.output("BSDF", surface.closures(surface.lobe(colour, surface.n, roughness), reflected=colour))
