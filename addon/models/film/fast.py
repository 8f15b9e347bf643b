"""A film by native closures: a tilted Beckmann lobe for each channel, light-sampled on every device.

The table is looked up a spread of V·H above and below its mean over the facets
that V sees: see addon.reflectance.film_facets.
"""

from ...reflectance.film_facets import seen_along, tilted_lobes, two_looks
from .surface import Surface

__all__ = ["build", "build_eevee"]


def build(builder):
    """Build the group."""
    surface = Surface(builder, "fast")
    s = surface.sockets
    m, towards = seen_along(surface.n, surface.v, surface.m, surface.tangent, s.rotation, s.anisotropy)
    closures = [surface.lobe(*lobe) for lobe in tilted_lobes(surface.n, surface.v, m, surface.look, towards)]
    reflected = two_looks(surface.n_v, m, surface.look).mean
    builder.output("BSDF", surface.closures(*closures, reflected=reflected))


def build_eevee(builder):
    """Build the group for EEVEE, which draws a lobe at random of several: one lobe, of their mean colour."""
    surface = Surface(builder, "fast", closest=True)
    colour = two_looks(surface.n_v, surface.m, surface.look).mean
    builder.output("BSDF", surface.closures(surface.lobe(colour, surface.n), reflected=colour))
