"""What every group of films by nodes shares: the surface, the table that it looks colours up in, and its closures."""

from types import SimpleNamespace

from ...operands import clip, dot, less, minimum, part, sqrt, where
from ...reflectance.directions import facing
from ..parameters import add_inputs
from .formulas import second_slope, slope
from .lookup import absorbed, body_below, look, place_in_table
from .parameters import TABLE

__all__ = ["Surface", "glossy", "lobe"]


class Surface:
    """A film under its sockets' settings, by name: sockets, n and v, N·V, the rms slopes, the tangent before it is
    turned, the table of its colours.

    realisation  whose sockets it has
    closest      whether each look blends four pixels itself, as :func:`addon.models.film.lookup.look` has it
    """

    def __init__(self, builder, realisation, closest=False):
        self.builder = builder
        s = self.sockets = add_inputs(builder, TABLE, realisation)
        self.n, self.v, self.n_v, self.tangent = _seen(builder, s.normal, s.tangent, s.anisotropy)
        self.m, self.second = _slopes(s.roughness, s.ratio2)
        place = place_in_table(builder, s.d, s.first, s.last, s.columns, s.rows, s.height)
        if closest:  # which sees a body's front alone
            self._refracts, more = less(1.0, s.ior_below), {"columns": s.columns, "height": s.height}
        else:
            below = body_below(builder, s.ior_below, s.roughness)
            self._refracts, more = below.refracts, {"is_below": below.is_below, "index2": below.index2}
        self.table = SimpleNamespace(**vars(place), **more)

    def mixed(self, first, second):
        """The lobes of both slopes by their shares; where there is one, Cycles folds the other away."""
        builder, weight = self.builder, self.sockets.w2
        return builder.add_shaders(builder.scale_shader(1.0 - weight, first), builder.scale_shader(weight, second))

    def look(self, c):
        """Colour of the film at cos θ."""
        return look(self.builder, c, self.table)

    def closures(self, lobes, reflected):
        """The sum of the film's lobes, what passes on where it is seen through, and the diffuse part.

        reflected  share that the lobes reflect, ``(..., 3)``
        """
        builder, s = self.builder, self.sockets
        with builder.frame("1 - R - A"):
            passed = (1.0, 1.0, 1.0) - reflected - absorbed(builder, self.n_v, self.table)
            clear = builder.scale_shader(s.see_through, self._passage(clip(passed, 0.0, 1.0)))
        with builder.frame("R = s Rs + d Rd"):
            share = (1.0 - s.specular) * (1.0 - s.see_through)
            diffuse = builder.node("ShaderNodeBsdfDiffuse", {"Color": s.tint * s.diffuse, "Normal": self.n})
            return builder.add_shaders(builder.scale_shader(s.specular, lobes), builder.scale_shader(share, diffuse),
                                       clear)

    def _passage(self, colour):
        """What passes on: straight, or refracted by the body below."""
        straight = self.builder.node("ShaderNodeBsdfTransparent", {"Color": colour})
        refracted = self.builder.node("ShaderNodeBsdfRefraction", {
            "Color": colour, "IOR": self.sockets.ior_below, "Roughness": self.sockets.roughness, "Normal": self.n},
            distribution="BECKMANN")
        return self.builder.node("ShaderNodeMixShader", {"Fac": self._refracts, "Shader": straight,
                                                         "Shader_001": refracted})


@part("Surface", "N", "V", "N·V", "Tangent")
def _seen(builder, normal, tangent, anisotropy):
    """(N, V, N·V, the tangent before it is turned)."""
    v = builder.incoming()
    n = facing(builder.normal(normal), v)
    with builder.frame("Frame"):
        # The nodes of a tangent that nothing turns on fold away.
        along = where(less(0.0, anisotropy), builder.tangent(tangent), (1.0, 0.0, 0.0))
    return n, v, minimum(dot(n, v), 1.0), along


@part("Slopes", "m1", "m2")
def _slopes(roughness, ratio):
    m = slope(roughness)
    return m, second_slope(m, ratio)


def lobe(builder, dyed, normal, roughness, stretching):
    """A Beckmann lobe, stretched along the tangent.

    dyed        its colour times the tint
    stretching  anisotropy, rotation and tangent by name
    """
    with builder.frame("mt, mb"):
        narrower = sqrt(1.0 - 0.9 * stretching.anisotropy) - 1.0
    return glossy(builder, dyed, normal, roughness, Anisotropy=narrower, Rotation=stretching.rotation,
                  Tangent=stretching.tangent)


def glossy(builder, dyed, normal, roughness, **inputs):
    """A Beckmann lobe of its colour times the tint."""
    return builder.node("ShaderNodeBsdfAnisotropic", {"Color": dyed, "Normal": normal, "Roughness": roughness,
                                                      **inputs}, distribution="BECKMANN")
