"""A film by native closures: a tilted Beckmann lobe for each channel, light-sampled on every device.

The table is looked up a spread of V·H above and below its mean over the facets
that V sees: see addon.reflectance.film_facets.  Where the material has a track
and the Blender a native film, that takes over from the slope on at which it is
closer: see addon.bake.film_track.
"""

from ...operands import less, maximum, sqrt, x_of, y_of, z_of
from ...reflectance.film_facets import seen_along, tilted_lobes, two_looks
from .surface import Surface

__all__ = ["build", "build_eevee"]

LEAST_TINT = 1e-5
"""Of what is left for the tilted lobes: below, the renderer leaves them out."""


def build(builder):
    """Build the group."""
    surface = Surface(builder, "fast")
    m, first = _lobes(surface, surface.m, surface.sockets.roughness)
    with builder.frame("Slope 2"):
        _, second = _lobes(surface, surface.second, sqrt(surface.second))
    reflected = two_looks(surface.n_v, m, surface.look).mean
    builder.output("BSDF", surface.closures(surface.mixed(first, second), reflected=reflected))


def _lobes(surface, m, roughness):
    """(slope towards V, the lobes) of a slope: a lobe for each channel, and the native film."""
    s, builder = surface.sockets, surface.builder
    seen, towards = seen_along(surface.n, surface.v, m, surface.tangent, s.rotation, s.anisotropy)
    part, tint = surface.native_part(m)
    tilted = [surface.lobe(colour, normal, roughness, tint)
              for colour, normal in tilted_lobes(surface.n, surface.v, seen, surface.look, towards)]
    with builder.frame("Native film"):
        some = less(LEAST_TINT, maximum(maximum(x_of(tint), y_of(tint)), z_of(tint)))
        return seen, [builder.scale_shader(some, builder.add_shaders(*tilted)),
                      builder.scale_shader(part, surface.native_film(roughness))]


def build_eevee(builder):
    """Build the group for EEVEE, which draws a lobe at random of several: one lobe, of their mean colour."""
    surface = Surface(builder, "fast", closest=True)
    with builder.frame("Rms slope"):
        ratio = sqrt(surface.mean_square())
        m, roughness = surface.m * ratio, surface.sockets.roughness * sqrt(ratio)
    colour = two_looks(surface.n_v, m, surface.look).mean
    builder.output("BSDF", surface.closures(surface.lobe(colour, surface.n, roughness), reflected=colour))
