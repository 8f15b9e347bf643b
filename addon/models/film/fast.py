"""A film by native closures: a tilted Beckmann lobe for each channel, light-sampled on every device.

The table is looked up a spread of V·H above and below its mean over the facets
that V sees: see addon.reflectance.film_facets.
"""

from ...operands import sqrt
from ...reflectance.film_facets import tilted_lobes, two_looks
from .surface import Surface

__all__ = ["build", "build_eevee"]


def build(builder):
    """Build the group."""
    surface = Surface(builder, "fast")
    with builder.frame("Slope 2"):
        second = _lobes(surface, surface.second, sqrt(surface.second))
    film = surface.mixed(_lobes(surface, surface.m, surface.sockets.roughness), second)
    reflected = two_looks(surface.n_v, surface.m, surface.look).mean
    builder.output("BSDF", surface.closures(film, reflected=reflected))


def _lobes(surface, m, roughness):
    """A lobe for each channel."""
    return [surface.glossy(colour, normal, roughness)
            for colour, normal in tilted_lobes(surface.n, surface.v, m, surface.look)]


def build_eevee(builder):
    """Build the group for EEVEE, which draws a lobe at random of several: one lobe, of their mean colour."""
    surface = Surface(builder, "fast", closest=True)
    with builder.frame("Rms slope"):
        both = surface.sockets.roughness * sqrt(sqrt(surface.mean_square()))
        m = surface.m * sqrt(surface.mean_square())
    colour = two_looks(surface.n_v, m, surface.look).mean
    builder.output("BSDF", surface.closures(surface.glossy(colour, surface.n, both), reflected=colour))
