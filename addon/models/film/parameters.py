"""The table of a film's parameters."""

import dataclasses
import json

from ...errors import FacetFilmError, numbers_of
from ..parameters import Colour, Direction, Number, Parameter, Slider, Socket, Text, checked_class

__all__ = ["ANODISING_GROUP", "COLUMNS", "Film", "HEAT_TINT_GROUP", "ROWS", "TABLE", "THICKNESS_GROUP"]

THICKNESS_GROUP, ANODISING_GROUP, HEAT_TINT_GROUP = "film_thickness", "film_anodising", "film_heat_tint"
THICKEST = 20000.0
ROWS, COLUMNS = 64, 512
ENDS = (("Least Thickness", "least", 0.0, 0), ("Greatest Thickness", "greatest", 200.0, 1))


class ThicknessRange(Parameter):
    """(least, greatest) thickness of a film that varies; None where it is constant."""

    def sockets(self):
        """One for each end."""
        return tuple(Socket(name, key, "FLOAT", default, f"Thickness in nanometres where the field is {end}",
                            self.low, self.high, self.unit) for name, key, default, end in ENDS)

    def checked(self, value):
        """Two numbers, the smaller one first; or None."""
        if value is None:
            return None
        least, greatest = numbers_of(self.name, value, 2, self.low, self.high, unit=self.unit)
        if least > greatest:
            raise FacetFilmError("thickness_range must be (least, greatest) in nm, not ({least:g}, {greatest:g}).",
                                 least=least, greatest=greatest)
        return least, greatest

    def written(self, value):
        """Both ends."""
        return {} if value is None else {socket.name: end for socket, end in zip(self.sockets(), value)}

    def read(self, values):
        """Both ends."""
        return tuple(values[socket.name] for socket in self.sockets())


class Layers(Text):
    """A stack in the notation of addon.bake.stack_notation, or a curve in that of addon.bake.film_curve; both are read
    where they are baked."""

    def checked(self, value):
        """A text with two layers at least."""
        if not isinstance(value, str) or not (" / " in value or "|" in value):
            raise FacetFilmError("stack must be layers from the outside in, such as 'SiO2 0-1000 nm / Si', "
                                 "not {value!r}.", value=value)
        return value.strip()


class OwnData(Text):
    """Measurements of the user's own, as addon.catalogue.resolving.layers_in reads them; "" for none."""

    def checked(self, value):
        """JSON of words and what was measured, or nothing."""
        try:
            held = json.loads(value) if value else {}
        except (TypeError, ValueError):
            held = None
        if not isinstance(value, str) or not isinstance(held, dict):
            raise FacetFilmError("{name} is written by a bake, as JSON; leave it out, or as it is: not {value!r}.",
                                 name=self.name, value=value)
        return value


@dataclasses.dataclass(frozen=True, kw_only=True)
class TableSlider(Slider):
    """What the look-up in the table's image needs; each bake sets it."""

    panel: str = "Table"


TABLE = (
    Layers(name="stack", default="TiO2 0-200 nm / Ti",
         tip="Layers from the outside in, as 'SiO2 0-1000 nm / Si'; see docs/films.md"),
    OwnData(name="own_layers", default="",
            tip="Measurements of your own that the stack names, kept so that it can be baked where their files are "
                "not; each bake sets it"),
    Number(name="thickness", symbol="d", socket="Thickness", key="d", default=60.0, low=0.0, high=THICKEST, unit="nm",
           tip="Thickness d in nanometres of what varies in the stack; beyond the table it is the table's end"),
    Number(name="roughness", symbol="√m", socket="Roughness", default=0.3, low=0.0, high=1.0, subtype="FACTOR",
           never_zero=True,
           tip="Its square is the rms slope m of the facets: 0.3 is polished, 0.45 satin, 0.7 rough"),
    Colour(name="tint", socket="Tint", default=(1.0, 1.0, 1.0), low=0.0, high=1.0,
           tip="Dyes what the film reflects, and the diffuse part; what passes through stays as it is"),
    Number(name="anisotropy", symbol="a", socket="Anisotropy", default=0.0, low=0.0, below=1.0, slider=(0.0, 0.999),
           subtype="FACTOR",
           tip="Above 0 the slopes are m/√(1 - 0.9 a) along the tangent, where they end at 1, and m √(1 - 0.9 a) "
               "across it"),
    Number(name="rotation", socket="Rotation", default=0.0, low=0.0, high=1.0, subtype="FACTOR",
           tip="Turns the tangent about the normal; 1 is a whole turn"),
    Number(name="specular", symbol="s", socket="Specular", default=1.0, low=0.0, high=1.0, subtype="FACTOR",
           tip="Share s of the light that the facets reflect; the rest is diffuse"),
    Colour(name="diffuse", symbol="π Rd", socket="Diffuse Color", default=(0.5, 0.5, 0.5), low=0.0, high=1.0,
           tip="Reflectance of the diffuse part"),
    Number(name="see_through", socket="See-through", default=0.0, low=0.0, high=1.0, subtype="FACTOR",
           tip="Share that passes on of what the film does not reflect or absorb: 1 for soap films and panes, which "
               "are then single-walled. Bake again after changing it from 0"),
    Number(name="ior_below", symbol="n", socket="IOR Below", default=1.0, low=1.0, high=10.0, slider=(1.0, 4.0),
           tip="Index of the clear body that the film coats, which refracts what is seen through it: 1.52 for a lens "
               "of glass; 1: the mesh is one sheet, and light goes straight on"),
    Direction(name="normal", symbol="N", socket="Normal",
              tip="Shading normal; the surface's own where nothing is plugged in"),
    Direction(name="tangent", socket="Tangent",
              tip="Direction that anisotropy is along; around the object's Z axis where nothing is plugged in"),
    Number(name="sampling_width", socket="Sampling Width", key="width", default=0.2, low=0.0, high=1.0,
           subtype="FACTOR", realisations=("exact", "osl"),
           tip="0: the formula itself, by mirrors, lit only by what they happen to hit; above: narrow lobes, "
               "as a share of the slope, which lamps of any size light and which blur the formula a little"),
    Number(name="second_ratio", symbol="m₂/m₁", socket="Slope Ratio 2", key="ratio2", default=3.0, low=0.001,
           high=1000.0, panel="Slopes", never_zero=True,
           tip="Rms slope m2 of this roughness over that of the first, m2/m1"),
    Number(name="second_weight", symbol="w₂", socket="Weight 2", key="w2", default=0.0, low=0.0, high=1.0,
           subtype="FACTOR", panel="Slopes", tip="Share w2 of this slope; the shares of all slopes sum to 1"),
    TableSlider(name="first", socket="First Thickness", default=0.0, low=0.0, high=THICKEST, unit="nm",
                tip="Thickness of the table's first column"),
    TableSlider(name="last", socket="Last Thickness", default=200.0, low=0.0, high=THICKEST, unit="nm",
                tip="Thickness of the table's last column"),
    TableSlider(name="columns", socket="Columns", default=float(COLUMNS), low=1.0, high=65536.0, never_zero=True,
                tip="Columns of the table, even in thickness"),
    TableSlider(name="rows", socket="Rows", default=float(ROWS), low=1.0, high=4096.0, never_zero=True,
                tip="Rows of the table, even in the root of the angle's cosine"),
    TableSlider(name="height", socket="Image Rows", default=float(ROWS), low=1.0, high=8192.0, never_zero=True,
                tip="Rows of the image: the table's, and as many again for what is absorbed of what is seen through"),
    # What follows is of the group that feeds a thickness which varies.
    ThicknessRange(name="thickness_range", low=0.0, high=THICKEST, unit="nm", group=THICKNESS_GROUP,
                   tip="(least, greatest) thickness over the surface; None where it is constant"),
    Number(name="gradient", socket="Gradient", default=0.0, low=0.0, high=1.0, subtype="FACTOR", group=THICKNESS_GROUP,
           tip="0: Perlin noise; 1: from the greatest thickness at the object's bottom to the least at its top"),
    Number(name="drained", socket="Drained", default=0.0, low=0.0, high=1.0, subtype="FACTOR", group=THICKNESS_GROUP,
           tip="1: the square of the thickness is even over the field, as in a soap film that drains (Mysels, Shinoda "
               "and Frankel 1959, from memory); 0: the thickness is"),
    Number(name="noise_scale", socket="Noise Scale", default=1.5, above=0.0, high=100000.0, slider=(0.001, 100000.0),
           group=THICKNESS_GROUP, tip="Features of the noise per unit of its coordinates"),
    Number(name="noise_detail", socket="Noise Detail", default=2.0, low=0.0, high=15.0, group=THICKNESS_GROUP,
           tip="Octaves of the Perlin noise"),
    Slider(name="texture", socket="Texture", default=0.5, low=0.0, high=1.0, subtype="FACTOR", group=THICKNESS_GROUP,
           tip="A field of your own between 0 and 1, a texture's for instance"),
    Slider(name="texture_share", socket="Texture Share", default=0.0, low=0.0, high=1.0, subtype="FACTOR",
           group=THICKNESS_GROUP, tip="0: noise or gradient alone; 1: the texture alone"),
    Direction(name="coordinates", socket="Vector", group=THICKNESS_GROUP,
              tip="Coordinates of the noise and, in their Z, of the gradient; the object's bounding box, 0 to 1, where "
                  "nothing is plugged in"),
    Slider(name="volts", socket="Voltage", default=30.0, low=0.0, high=500.0, unit="V", group=ANODISING_GROUP,
           tip="Volts that the metal was anodised with"),
    Slider(name="celsius", socket="Temperature", default=280.0, low=20.0, high=560.0, unit="°C", group=HEAT_TINT_GROUP,
           tip="Degrees Celsius that the metal was heated to in air"),
    Slider(name="hours", socket="Time", default=1.0, low=0.0, high=1000.0, group=HEAT_TINT_GROUP,
           tip="Time at that temperature, as a multiple of the charts': an hour for steels, half an hour for titanium; "
               "the thickness grows with its root"),
)


class Film(checked_class("Film", TABLE)):
    """A stack of films on facets; a field a row of TABLE.

    >>> Film(thickness=120).changed(roughness=0.4).roughness
    0.4
    >>> Film(thickness_range=(200, 100))
    Traceback (most recent call last):
    ...
    addon.errors.FacetFilmError: thickness_range must be (least, greatest) in nm, not (200, 100).
    """

    def changed(self, **parameters):
        """The same with other values for the named parameters; a thickness takes the place of a thickness_range.

        >>> Film(thickness_range=(66, 76)).changed(thickness=92).thickness_range is None
        True
        """
        if parameters.get("thickness") is not None:
            parameters.setdefault("thickness_range", None)
        return super().changed(**parameters)
