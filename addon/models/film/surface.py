"""What every group of films by nodes shares: the surface, and the look-up in the table's image."""

from ...operands import clip, dot, less, maximum, minimum, sqrt, vector, where, widen, x_of, y_of, z_of
from ...reflectance.directions import facing
from ...reflectance.film_facets import native_share
from ..parameters import add_inputs
from .formulas import second_slope, slope
from .parameters import TABLE

__all__ = ["TRACK_ROWS", "Surface"]

TRACK_ROWS = 3
"""Of the image above the table's, where there is a track: the native film's index, its thickness and the slope from
which it is closer; n; k."""


class Surface:
    """A film under its sockets' settings: sockets, n and v, N·V, the rms slopes, the tangent before it is turned.

    realisation  whose sockets it has
    closest      whether each look blends four pixels itself, for renderers that blur images where the place
                 that is looked up changes from pixel to pixel, as EEVEE does
    """

    def __init__(self, builder, realisation, closest=False):
        self.builder = builder
        self.sockets = add_inputs(builder, TABLE, realisation)
        self.v = builder.incoming()
        self.n = facing(builder.normal(self.sockets.normal), self.v)
        self.n_v = minimum(dot(self.n, self.v), 1.0)
        with builder.frame("Rms slope"):
            self.m = slope(self.sockets.roughness)
            self.second = second_slope(self.m, self.sockets.ratio2)
        with builder.frame("Frame"):
            # The nodes of a tangent that nothing turns on fold away.
            self.tangent = where(less(0.0, self.sockets.anisotropy), builder.tangent(self.sockets.tangent),
                                 (1.0, 0.0, 0.0))
        self._closest = closest
        with builder.frame("Column"):
            s = self.sockets
            self._column = (s.d - s.first) * ((s.columns - 1.0) / (s.last - s.first))
        with builder.frame("Body below"):
            straight = maximum(*(builder.node("ShaderNodeLightPath", output=f"Is {kind} Ray")
                                 for kind in ("Shadow", "Diffuse")))
            self._refracts = 0.0 if closest else less(1.0, s.ior_below) * (1.0 - straight)
            back = builder.node("ShaderNodeNewGeometry", output="Backfacing")
            self._inside = where(self._refracts * back, s.ior_below, 1.0)

    def mean_square(self):
        """The mean of both slopes' squares over that of the first."""
        ratio, weight = self.sockets.ratio2, self.sockets.w2
        return 1.0 + weight * (ratio * ratio - 1.0)

    def mixed(self, first, second):
        """The lobes of both slopes by their shares; where there is one, Cycles folds the other away."""
        builder, weight = self.builder, self.sockets.w2
        return builder.add_shaders(builder.scale_shader(1.0 - weight, builder.add_shaders(*first)),
                                   builder.scale_shader(weight, builder.add_shaders(*second)))

    def look(self, c):
        """Colour of the film at cos θ; from within a body that refracts at the angle outside, or all of the light."""
        squared = self._squared_outside(c)
        return where(less(squared, 0.0), (1.0, 1.0, 1.0), self._look(self._row(squared)))

    def absorbed(self, c):
        """The share that it absorbs."""
        squared = self._squared_outside(c)
        return where(less(squared, 0.0), (0.0, 0.0, 0.0), self._look(self._row(squared) + self.sockets.rows))

    def _squared_outside(self, c):
        """cos² of the angle outside, by Snell's law; below 0 where the body reflects all."""
        return 1.0 - (1.0 - clip(c, 0.0, 1.0) * clip(c, 0.0, 1.0)) * (self._inside * self._inside)

    def _row(self, squared):
        return sqrt(sqrt(clip(squared, 0.0, 1.0))) * (self.sockets.rows - 1.0)

    def closures(self, *lobes, reflected):
        """The sum of the film's lobes, what passes on where it is seen through, and the diffuse part.

        reflected  share that the lobes reflect, ``(..., 3)``
        """
        builder, s = self.builder, self.sockets
        with builder.frame("1 - R - A"):
            passed = (1.0, 1.0, 1.0) - reflected - self.absorbed(self.n_v)
            clear = builder.scale_shader(s.see_through, self._passage(clip(passed, 0.0, 1.0)))
        with builder.frame("R = s Rs + d Rd"):
            share = (1.0 - s.specular) * (1.0 - s.see_through)
            diffuse = builder.node("ShaderNodeBsdfDiffuse", {"Color": s.tint * s.diffuse, "Normal": self.n})
            film = builder.scale_shader(s.specular, builder.add_shaders(*lobes))
            return builder.add_shaders(film, builder.scale_shader(share, diffuse), clear)

    def _passage(self, colour):
        """What passes on: straight, or refracted by the body below."""
        straight = self.builder.node("ShaderNodeBsdfTransparent", {"Color": colour})
        if self._closest:
            return straight
        refracted = self.builder.node("ShaderNodeBsdfRefraction", {
            "Color": colour, "IOR": self.sockets.ior_below, "Roughness": self.sockets.roughness, "Normal": self.n},
            distribution="BECKMANN")
        return self.builder.node("ShaderNodeMixShader", {"Fac": self._refracts, "Shader": straight,
                                                         "Shader_001": refracted})

    def lobe(self, colour, normal, roughness, tint=None):
        """A dyed Beckmann lobe, stretched along the tangent."""
        s = self.sockets
        with self.builder.frame("mt, mb"):
            narrower = sqrt(1.0 - 0.9 * s.anisotropy) - 1.0
        return self.glossy(colour, normal, roughness, tint, Anisotropy=narrower, Rotation=s.rotation,
                           Tangent=self.tangent)

    def glossy(self, colour, normal, roughness, tint=None, **inputs):
        """A dyed Beckmann lobe."""
        tint = self.sockets.tint if tint is None else tint
        return self.builder.node("ShaderNodeBsdfAnisotropic", {
            "Color": tint * colour, "Normal": normal, "Roughness": roughness, **inputs}, distribution="BECKMANN")

    def native_part(self, m):
        """(what the native film at a slope reflects of what it would undyed, the tint that is left for other lobes).

        A native film cannot be dyed: it is dimmed to the least of the tint's channels.
        """
        with self.builder.frame("Native film"):
            s = self.sockets
            has_track = less(s.rows, s.height) * less(s.height, s.rows + (TRACK_ROWS + 1.0))
            from_slope = z_of(self._track_row(0.0))
            share = self.builder.where_native(has_track) * native_share(m, from_slope)
            part = share * minimum(minimum(x_of(s.tint), y_of(s.tint)), z_of(s.tint))
            return part, s.tint - widen(part)

    def native_film(self, roughness):
        """The Metallic BSDF with the film of the track at this thickness; bare where Blender has none."""
        s, builder = self.sockets, self.builder
        with builder.frame("Native film"):
            first, n, k = (self._track_row(float(row)) for row in range(TRACK_ROWS))
            metal = builder.node("ShaderNodeBsdfMetallic", {
                "IOR": n, "Extinction": k, "Normal": self.n, "Roughness": roughness,
                "Anisotropy": s.anisotropy, "Rotation": s.rotation, "Tangent": self.tangent},
                distribution="BECKMANN", fresnel_type="PHYSICAL_CONDUCTOR")
            builder.feed_where_native(metal, {"Thin Film IOR": x_of(first), "Thin Film Thickness": y_of(first)})
            return metal

    def _track_row(self, row):
        return self._pixel(self._column, self.sockets.rows + row, "Linear")

    def _look(self, row):
        """What the image holds at a row and the thickness's column, squared."""
        with self.builder.frame("Table"):
            root = self._blended(row) if self._closest else self._pixel(self._column, row, "Linear")
            return root * root

    def _blended(self, row):
        """Bilinear, of the four pixels around."""
        s = self.sockets
        column = clip(self._column, 0.0, s.columns - 1.0)
        i, j = self._floor(row), self._floor(column)
        u, v = widen(row - i), widen(column - j)
        a, b, c, d = (self._pixel(j + dj, i + di, "Closest") for di in (0.0, 1.0) for dj in (0.0, 1.0))
        lower, upper = a + v * (b - a), c + v * (d - c)
        return lower + u * (upper - lower)

    def _floor(self, x):
        return self.builder.node("ShaderNodeMath", {"Value": x}, operation="FLOOR")

    def _pixel(self, column, row, interpolation):
        """The image's colour at a column and row, whose middles are whole numbers."""
        s = self.sockets
        at = vector((column + 0.5) / s.columns, (row + 0.5) / s.height, 0.0)
        return self.builder.node("ShaderNodeTexImage", {"Vector": at}, "Color", interpolation=interpolation,
                                 extension="EXTEND")
