"""The table of the layered RGB model's parameters, by the paper's symbols."""

import dataclasses
import math

from ...errors import FacetFilmError, number, numbers_of
from ..parameters import Choice, Direction, Number, Parameter, Slider, Socket, Triple, checked_class

__all__ = ["LayeredRGB", "TABLE", "THICKNESS_GROUP", "WAVELENGTHS"]

THICKNESS_GROUP = "layer_thickness"
"""The group that feeds a thickness which varies."""

WAVELENGTHS = (645.0, 525.0, 445.0)
"""The paper's wavelengths of red, green and blue in nm."""

THICKEST = 100000.0
RIGHT_ANGLE = math.radians(90.0)


@dataclasses.dataclass(frozen=True, kw_only=True)
class Thickness(Number):
    """A constant thickness; None where it varies.  `usual` is what it is where neither is given."""

    usual: float = 0.0

    def sockets(self):
        """At the usual thickness."""
        return tuple(dataclasses.replace(socket, default=self.usual) for socket in super().sockets())

    def checked(self, value):
        """As a number; the usual one for None."""
        return super().checked(self.usual if value is None else value)

    def written(self, value):
        """Nothing where it varies."""
        return {} if value is None else super().written(value)


class ThicknessRange(Parameter):
    """(least, greatest) thickness; None where it is constant."""

    def sockets(self):
        """One for each end."""
        return tuple(Socket(name, key, "FLOAT", default, f"Thickness in nanometres where the field is {end}",
                            self.low, self.high, self.unit)
                     for name, key, default, end in (("Least Thickness", "least", 66.0, 0),
                                                     ("Greatest Thickness", "greatest", 76.0, 1)))

    def checked(self, value):
        """Two numbers, the smaller one first."""
        least, greatest = numbers_of(self.name, value, 2, self.low, self.high, unit=self.unit)
        if least > greatest:
            raise FacetFilmError(f"thickness_range must be (least, greatest) in nm, not ({least:g}, {greatest:g}).")
        return least, greatest

    def written(self, value):
        """Both ends."""
        return {} if value is None else {socket.name: end for socket, end in zip(self.sockets(), value)}

    def read(self, values):
        """Both ends."""
        return tuple(values[socket.name] for socket in self.sockets())


class Deviation(Number):
    """An angle below 90°, which people give in degrees by mistake."""

    def checked(self, value):
        """A number of radians."""
        valid = number(self.name, value, unit=self.unit)
        if not 0.0 <= valid < RIGHT_ANGLE:
            raise FacetFilmError(f"deviation must be at least 0 and below pi/2 radians (90°), not {valid:g}"
                                 + (f"; {valid:g}° are {math.radians(valid):.3g} radians."
                                    if 2.0 <= valid < 90.0 else "."))
        return valid

    def range_text(self):
        """In degrees too."""
        return "0, below pi/2 (90°)"


class Correlated(Parameter):
    """True or False: a link of the field, and no socket."""

    def checked(self, value):
        """One of the two."""
        if not isinstance(value, bool):
            raise FacetFilmError(f"correlated must be True or False, not {value!r}.")
        return value

    def range_text(self):
        """One of the two."""
        return "True, False"


TABLE = (
    Number(name="specular", socket="Specular", default=1.0, low=0.0, high=1.0, subtype="FACTOR",
           tip="Weight of the specular part with its interference and colour separation"),
    Number(name="diffuse", socket="Diffuse", default=0.5, low=0.0, high=1.0, subtype="FACTOR",
           tip="Weight of the diffuse part, whose colour the thickness makes"),
    Thickness(name="thickness", symbol="d", socket="Thickness", key="d", usual=70.0, low=0.0, high=THICKEST, unit="nm",
              never_zero=True,
              tip="Thickness d of the layer in nanometres: low ones are reddish, more adds blue and green"),
    Triple(name="ior", symbol="r1", socket="Refractive Index", key="r1", default=(1.4, 1.45, 1.6), above=1.0,
           high=10.0, slider=(1.001, 10.0), never_zero=True,
           tip="Refractive index r1 of the layer for red, green and blue; different ones make rainbows "
               "where the boundaries deviate"),
    Number(name="exponent_r", symbol="e0", socket="Exponent R", key="e0", default=90.0, low=0.0, high=100000.0,
           tip="Phong exponent e0 of the reflected lobe: 10 is dull, 100 satin, 1000 polished"),
    Number(name="exponent_t", symbol="e1", socket="Exponent T", key="e1", default=170.0, low=0.0, high=100000.0,
           tip="Phong exponent e1 of the lobe that has passed the layer"),
    Deviation(name="deviation", socket="Deviation", default=0.0, low=0.0, slider=(0.0, math.radians(89.9)),
              unit="radians", subtype="ANGLE",
              tip="Angle between the boundaries: splits each highlight in two, one with a rainbow edge"),
    Number(name="azimuth", socket="Azimuth", default=0.0, slider=(-2.0 * math.pi, 2.0 * math.pi), unit="radians",
           subtype="ANGLE", tip="Direction of the deviation about the normal, counted from the tangent"),
    Triple(name="wavelengths", symbol="λ", socket="Wavelengths", default=WAVELENGTHS, above=0.0,
           high=10000.0, slider=(1.0, 10000.0), unit="nm", panel="Model", never_zero=True,
           tip="Wavelengths of red, green and blue in nanometres"),
    Choice(name="scale", socket="Published Scale", key="published", default="energy", options=("energy", "published"),
           panel="Model", tip="0: lobes scaled by (e + 2)/(2 pi), diffuse part with its factor of a half; "
                              "1: as printed. Both can reflect more light than arrives"),
    Direction(name="normal", symbol="n0", socket="Normal",
              tip="Normal n0 of the upper boundary; the surface's own where nothing is plugged in"),
    Direction(name="lower_normal", symbol="n1", socket="Lower Normal", key="lower",
              tip="Normal n1 of the lower boundary, a Bump node's for instance; "
                  "takes the place of Deviation and Azimuth"),
    Direction(name="tangent", socket="Tangent",
              tip="Direction that the azimuth is counted from; around the object's Z axis where nothing is plugged in"),
    Number(name="sampling_width", socket="Sampling Width", key="width", default=0.3, low=0.0, high=0.9,
           subtype="FACTOR", realisations=("exact", "osl"),
           tip="0: the formula itself, by mirrors that only light which they happen to hit can reach; "
               "above: narrow lobes of this share of each lobe's width, which lamps of any size light"),
    # What follows is of the group that feeds a thickness which varies.
    ThicknessRange(name="thickness_range", low=0.0, high=THICKEST, unit="nm", group=THICKNESS_GROUP,
                   tip="(least, greatest) thickness: Perlin noise between them"),
    Number(name="noise_scale", socket="Noise Scale", default=3.0, above=0.0, high=100000.0, slider=(0.001, 100000.0),
           group=THICKNESS_GROUP, tip="Features of the field per unit of its coordinates"),
    Number(name="noise_detail", socket="Noise Detail", default=2.0, low=0.0, high=15.0, group=THICKNESS_GROUP,
           tip="Octaves of the Perlin noise"),
    Correlated(name="correlated", default=False, group=THICKNESS_GROUP,
               tip="The lower boundary tilts along the gradient of the thickness, as bump mapping does, by the "
                   "deviation where the noise climbs through its range within one feature"),
    Slider(name="texture", socket="Texture", default=0.5, low=0.0, high=1.0, subtype="FACTOR", group=THICKNESS_GROUP,
           tip="A field of your own between 0 and 1, a texture's for instance"),
    Slider(name="texture_share", socket="Texture Share", default=0.0, low=0.0, high=1.0, subtype="FACTOR",
           group=THICKNESS_GROUP, tip="0: Perlin noise alone; 1: the texture alone"),
    Slider(name="field_deviation", socket="Deviation", default=0.0, low=0.0, high=1.5, subtype="ANGLE",
           group=THICKNESS_GROUP, tip="Tilt of Lower Normal where the field climbs from 0 to 1 within one feature"),
    Direction(name="coordinates", socket="Vector", group=THICKNESS_GROUP,
              tip="Coordinates of the noise; the object's where nothing is plugged in"),
    Direction(name="field_normal", socket="Normal", group=THICKNESS_GROUP,
              tip="Normal of the upper boundary; the surface's own where nothing is plugged in"),
)


class LayeredRGB(checked_class("LayeredRGB", TABLE)):
    """One material of Granier and Heidrich's layered RGB model; a field a row of TABLE.

    A thickness and a thickness_range exclude each other; correlated needs a range.

    >>> LayeredRGB(thickness=92).exponent_r
    90.0
    >>> LayeredRGB(deviation=14)
    Traceback (most recent call last):
    ...
    addon.errors.FacetFilmError: deviation must be at least 0 and below pi/2 radians (90°), not 14; \
14° are 0.244 radians.
    """

    def check(self, row, value):
        """As the rows do, but for what depends on the thickness being constant or not."""
        varies = self.thickness_range is not None
        if row.name == "thickness" and varies:
            if value is not None:
                raise FacetFilmError("thickness and thickness_range contradict each other: give one of them.")
            return None
        if row.name == "thickness_range" and not varies:
            return None
        checked = super().check(row, value)
        if row.name == "correlated" and checked and not varies:
            raise FacetFilmError("correlated tilts along the gradient of the thickness, and a constant "
                                 "thickness has none: give thickness_range, such as (66, 76).")
        return checked

    def changed(self, **parameters):
        """The same material with other values for the named parameters.

        A thickness takes the place of a thickness_range, and the other way round.

        >>> LayeredRGB(thickness_range=(66, 76)).changed(thickness=92).thickness_range is None
        True
        >>> LayeredRGB().changed(ior=(1.5, 1.5, 1.0))
        Traceback (most recent call last):
        ...
        addon.errors.FacetFilmError: ior[2] must be a number above 1 and at most 10, not 1.0.
        """
        if parameters.get("thickness_range") is not None:
            parameters.setdefault("thickness", None)
        elif parameters.get("thickness") is not None:
            parameters.setdefault("thickness_range", None)
            if self.correlated:
                parameters.setdefault("correlated", False)
        return super().changed(**parameters)
