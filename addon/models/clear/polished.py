"""Dispersive, polished: a wavelength is drawn where a path enters the body, and handed on from face to face.

The number travels in the ray's direction, see handed_on.  So every face refracts by the index of the one wavelength,
whatever was reflected inside before.  What enters takes on the colour; the mirror stays white.
"""

from ...operands import dot, less, part, sqrt, where
from ...reflectance.transmission import cauchy_over_x
from .bands import colour_of, inverse_square_at, place_for
from .formulas import relative_index
from .handed_on import place_of, steered
from .surfaces import absorbed, mixed

__all__ = ["polished"]

AGAIN = 1e-4
"""Scene units within which a second hit of a face is the first one's."""
NUMBER = 5
"""Which random number is the wavelength's."""


def polished(builder, sockets, at):
    """The closure of a polished face."""
    return mixed(builder, at.back, _outside(builder, sockets, at), _inside(builder, sockets, at))


@part("Face From Outside")
def _outside(builder, sockets, at):
    """The closure of a face that is seen from outside: a path that enters draws its wavelength."""
    v, again, u = builder.incoming(), _hit_again(builder, at), builder.random(NUMBER)
    place = where(again, place_of(v), place_for(u))
    n = _index(sockets, place)
    n_v = dot(at.normal, v)
    along_v = 1.0 / n
    facet = steered(v, at.normal, along_v, sqrt(1.0 - along_v * along_v * (1.0 - n_v * n_v)) - along_v * n_v, place)
    colour = where(again, (1.0, 1.0, 1.0), colour_of(u))
    return _closures(builder, sockets, facet, n, colour * sockets.tint, (1.0, 1.0, 1.0))


@part("Face From Inside")
def _inside(builder, sockets, at):
    """The closure of a face that is seen from within, and hands on what it reflects."""
    v, left = builder.incoming(), absorbed(at)
    place = place_of(v)
    n = _index(sockets, place)
    n_v = dot(at.normal, v)
    facet = steered(v, at.normal, 1.0, -2.0 * n_v, place)
    return _closures(builder, sockets, facet, n, left * sockets.tint, left)


def _closures(builder, sockets, facet, n, through, mirrored):
    share = builder.node("ShaderNodeFresnel", {"IOR": n, "Normal": facet})
    surface = {"Roughness": sockets.roughness, "Normal": facet}
    refracted = builder.node("ShaderNodeBsdfRefraction", {"Color": through, "IOR": n, **surface},
                             distribution="BECKMANN")
    mirror = builder.node("ShaderNodeBsdfAnisotropic", {"Color": mirrored, **surface}, distribution="BECKMANN")
    return mixed(builder, share, refracted, mirror)


@part("Index of the Place", "n")
def _index(sockets, place):
    """Index of the wavelength of a place, relative to what is outside."""
    n = cauchy_over_x(inverse_square_at(place), sockets.ior, sockets.dispersion * sockets.cauchy_b,
                      sockets.dispersion * sockets.cauchy_c)
    return relative_index(n, sockets.outside)


def _hit_again(builder, at):
    """1.0 where a ray that entered hits the same face once more, beside an edge, which would colour it twice."""
    passed = builder.node("ShaderNodeLightPath", output="Is Transmission Ray")
    return passed * less(at.length, AGAIN)
