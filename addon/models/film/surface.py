"""What every group of films by nodes shares: the surface, and the look-up in the table's image."""

from ...operands import clip, dot, minimum, sqrt, vector, widen
from ...reflectance.directions import facing
from ..parameters import add_inputs
from .formulas import slope
from .parameters import TABLE

__all__ = ["Surface"]


class Surface:
    """A film under its sockets' settings: sockets, n and v, N·V, the rms slope m.

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
        self._closest = closest
        with builder.frame("Column"):
            s = self.sockets
            self._column = (s.d - s.first) * ((s.columns - 1.0) / (s.last - s.first))

    def look(self, c):
        """Colour of the film at cos θ."""
        return self._look(sqrt(clip(c, 0.0, 1.0)) * (self.sockets.rows - 1.0))

    def absorbed(self, c):
        """The share that it absorbs."""
        return self._look(sqrt(clip(c, 0.0, 1.0)) * (self.sockets.rows - 1.0) + self.sockets.rows)

    def closures(self, *lobes, reflected):
        """The sum of the film's lobes, what passes on where it is seen through, and the diffuse part.

        reflected  share that the lobes reflect, ``(..., 3)``
        """
        builder, s = self.builder, self.sockets
        with builder.frame("1 - R - A"):
            passed = (1.0, 1.0, 1.0) - reflected - self.absorbed(self.n_v)
            clear = builder.scale_shader(s.see_through, builder.node("ShaderNodeBsdfTransparent", {
                "Color": clip(passed, 0.0, 1.0)}))
        with builder.frame("R = s Rs + d Rd"):
            share = (1.0 - s.specular) * (1.0 - s.see_through)
            diffuse = builder.node("ShaderNodeBsdfDiffuse", {"Color": s.diffuse, "Normal": self.n})
            film = builder.scale_shader(s.specular, builder.add_shaders(*lobes))
            return builder.add_shaders(film, builder.scale_shader(share, diffuse), clear)

    def glossy(self, colour, normal, roughness, **inputs):
        """A Beckmann lobe."""
        return self.builder.node("ShaderNodeBsdfAnisotropic", {
            "Color": colour, "Normal": normal, "Roughness": roughness, **inputs}, distribution="BECKMANN")

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
