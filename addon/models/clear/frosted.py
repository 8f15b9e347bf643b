"""Dispersive, frosted: one wavelength a path, a function of the place at which the camera's ray entered the body.

A frosted face scatters a ray, which so hands no number on.  The back face finds the place of entry again, from where
the ray came, and with it the wavelength.  After an inner reflection the place is lost: a channel is drawn, and a
wavelength of its band.  The mirror stays white.
"""

from ...operands import dot, less, normalize, part, vector, where, widen
from ...reflectance.transmission import cauchy
from .bands import colour_of, wavelength_of, wavelength_of_channel
from .formulas import reflectance, relative_index
from .surfaces import absorbed, mixed

__all__ = ["STEEPNESS", "frosted"]

STEEPNESS = 1e5
"""Turns of the random number over a radian: neighbouring samples of a pixel have nothing in common."""
AXIS = (0.36, 0.80, 0.48)
AGAIN = 1e-4
"""Scene units within which a second hit of a face is the first one's."""
CHANNEL, IN_BAND = 5, 6
"""The random numbers that a face draws after an inner reflection."""


@part("Frosted Face")
def frosted(builder, sockets, at):
    """The closure of a frosted face."""
    wavelength, colour = _wavelength(builder, at)
    n = relative_index(cauchy(wavelength, sockets.ior, sockets.dispersion * sockets.cauchy_b,
                              sockets.dispersion * sockets.cauchy_c), sockets.outside)
    return _face(builder, sockets, at, n, colour)


@part("Wavelength", "λ", "colour")
def _wavelength(builder, at):
    """(λ in µm of the path, the colour that it takes on at this face)."""
    direct = _came_straight(builder, at)
    with builder.frame("λ of the place of entry"):
        u = _number(builder, at, direct)
        entered, entered_colour = wavelength_of(u), colour_of(u)
    later, later_colour = _drawn_anew(builder)
    lost, again = at.back - direct, _hit_again(builder, at)
    colour = where(at.back, where(direct, (1.0, 1.0, 1.0), later_colour),
                   where(again, (1.0, 1.0, 1.0), entered_colour))
    return where(lost, later, entered), colour


def _came_straight(builder, at):
    """1.0 at a back face that is the first since the ray entered."""
    return at.back * builder.node("ShaderNodeLightPath", output="Is Transmission Ray")


def _hit_again(builder, at):
    """1.0 where a ray that entered hits the same face once more, beside an edge, which would colour it twice."""
    passed = builder.node("ShaderNodeLightPath", output="Is Transmission Ray")
    return passed * less(at.length, AGAIN)


@part("Number of the Place")
def _number(builder, at, direct):
    """u in [0, 1): a steep function of the direction in which the camera has the place of entry."""
    towards = builder.node("ShaderNodeVectorTransform", {"Vector": builder.incoming()}, vector_type="VECTOR",
                           convert_from="WORLD", convert_to="CAMERA")
    place = builder.node("ShaderNodeTexCoord", output="Camera") + towards * widen(direct * at.length)
    turns = STEEPNESS * dot(normalize(place), AXIS)
    return builder.node("ShaderNodeMath", {"Value": turns}, operation="FRACT")


@part("Wavelength Drawn Anew", "λ", "colour")
def _drawn_anew(builder):
    """(λ, colour) of one channel drawn of three."""
    which, u = 3.0 * builder.random(CHANNEL), builder.random(IN_BAND)
    red, blue = less(which, 1.0), less(2.0, which)
    bands = [wavelength_of_channel(u, channel) for channel in range(3)]
    return (where(red, bands[0], where(blue, bands[2], bands[1])),
            vector(3.0 * red, 3.0 * (1.0 - red - blue), 3.0 * blue))


@part("Dispersive Face")
def _face(builder, sockets, at, n, colour):
    """Refraction in the wavelength's colour and a white mirror, shared by the Fresnel reflectance."""
    left, surface = absorbed(at), {"Roughness": sockets.roughness, "Normal": at.normal}
    through = builder.node("ShaderNodeBsdfRefraction", {"Color": colour * left * sockets.tint, "IOR": n, **surface},
                           distribution="BECKMANN")
    mirror = builder.node("ShaderNodeBsdfAnisotropic", {"Color": left, **surface}, distribution="BECKMANN")
    return mixed(builder, reflectance(at.cos_theta, n, at.back), through, mirror)
