"""The parameters of a layered RGB material, checked: what scripts, panels and presets all go through."""

import math
from dataclasses import dataclass, replace

from .errors import FacetFilmError, choice, number, numbers_of

__all__ = ["LayeredRGB", "layered_rgb_parameters", "DEFAULT_THICKNESS", "DEFAULT_SAMPLING_WIDTH", "SCALES"]

SCALES = ("energy", "published")
DEFAULT_THICKNESS = 70.0
DEFAULT_SAMPLING_WIDTH = 0.3
MOST_DEVIATION = math.radians(90.0)
MOST_WIDTH = 0.9


@dataclass(frozen=True)
class LayeredRGB:
    """One material of Granier and Heidrich's layered RGB model.

    thickness        of the layer in nm, 0 or more; None where thickness_range is given
    thickness_range  (least, greatest) in nm: Perlin noise between them; None for a constant thickness
    noise_scale      features of the noise per unit of the object's coordinates, above 0
    noise_detail     octaves of the noise, 0 to 15
    ior              refractive index r1 of the layer for red, green and blue, each above 1
    wavelengths      of red, green and blue in nm, above 0
    exponent_r       Phong exponent e0 of the reflected lobe, 0 or more
    exponent_t       Phong exponent e1 of the transmitted lobe, 0 or more
    deviation        angle between the boundaries in radians, 0 up to but not 90°
    azimuth          its direction about the normal in radians
    correlated       the lower boundary tilts along the gradient of the thickness, as bump mapping does,
                     by the deviation where the noise climbs through its range within one feature
    specular         weight of ρ, 0 to 1
    diffuse          weight of the diffuse part, 0 to 1
    scale            "energy" or "published"; both may reflect more than arrives
    sampling_width   of the exact realisations, 0 to 0.9; 0 is the formula itself
    """

    thickness: float | None = None
    thickness_range: tuple | None = None
    noise_scale: float = 3.0
    noise_detail: float = 2.0
    ior: tuple = (1.4, 1.45, 1.6)
    wavelengths: tuple = (645.0, 525.0, 445.0)
    exponent_r: float = 90.0
    exponent_t: float = 170.0
    deviation: float = 0.0
    azimuth: float = 0.0
    correlated: bool = False
    specular: float = 1.0
    diffuse: float = 0.5
    scale: str = "energy"
    sampling_width: float = DEFAULT_SAMPLING_WIDTH

    def __post_init__(self):
        checked = {
            **self._thickness(),
            "noise_scale": number("noise_scale", self.noise_scale, high=100000.0, above=0.0),
            "noise_detail": number("noise_detail", self.noise_detail, 0.0, 15.0),
            "ior": numbers_of("ior", self.ior, 3, high=10.0, above=1.0),
            "wavelengths": numbers_of("wavelengths", self.wavelengths, 3, high=10000.0, above=0.0, unit="nm"),
            "exponent_r": number("exponent_r", self.exponent_r, 0.0, 100000.0),
            "exponent_t": number("exponent_t", self.exponent_t, 0.0, 100000.0),
            "deviation": self._deviation(),
            "azimuth": number("azimuth", self.azimuth, unit="radians"),
            "correlated": self._correlated(),
            "specular": number("specular", self.specular, 0.0, 1.0),
            "diffuse": number("diffuse", self.diffuse, 0.0, 1.0),
            "scale": choice("scale", self.scale, SCALES),
            "sampling_width": number("sampling_width", self.sampling_width, 0.0, MOST_WIDTH),
        }
        for name, value in checked.items():
            object.__setattr__(self, name, value)

    def _thickness(self):
        if self.thickness_range is None:
            thickness = DEFAULT_THICKNESS if self.thickness is None else self.thickness
            return {"thickness": number("thickness", thickness, 0.0, 100000.0, unit="nm")}
        if self.thickness is not None:
            raise FacetFilmError("thickness and thickness_range contradict each other: give one of them.")
        least, greatest = numbers_of("thickness_range", self.thickness_range, 2, 0.0, 100000.0, unit="nm")
        if least > greatest:
            raise FacetFilmError("thickness_range must be (least, greatest) in nm, "
                                 f"not ({least:g}, {greatest:g}).")
        return {"thickness_range": (least, greatest)}

    def _deviation(self):
        valid = number("deviation", self.deviation, unit="radians")
        if not 0.0 <= valid < MOST_DEVIATION:
            raise FacetFilmError(f"deviation must be at least 0 and below pi/2 radians (90°), not {valid:g}"
                                 + (f"; {valid:g}° are {math.radians(valid):.3g} radians."
                                    if 2.0 <= valid < 90.0 else "."))
        return valid

    def _correlated(self):
        if not isinstance(self.correlated, bool):
            raise FacetFilmError(f"correlated must be True or False, not {self.correlated!r}.")
        if self.correlated and self.thickness_range is None:
            raise FacetFilmError("correlated tilts along the gradient of the thickness, and a constant "
                                 "thickness has none: give thickness_range, such as (66, 76).")
        return self.correlated

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
        for name in parameters:
            choice("parameter", name, self.__dataclass_fields__)
        if parameters.get("thickness_range") is not None:
            parameters.setdefault("thickness", None)
        elif parameters.get("thickness") is not None:
            parameters.setdefault("thickness_range", None)
            if self.correlated:
                parameters.setdefault("correlated", False)
        return replace(self, **parameters)


def layered_rgb_parameters(**parameters):
    """The checked parameters of a layered RGB material: see :class:`LayeredRGB`.

    Raises FacetFilmError for an unknown name or a value out of range.

    >>> layered_rgb_parameters(thickness=92).exponent_r
    90.0
    >>> layered_rgb_parameters(deviation=14)
    Traceback (most recent call last):
    ...
    addon.errors.FacetFilmError: deviation must be at least 0 and below pi/2 radians (90°), not 14; \
14° are 0.244 radians.
    """
    return LayeredRGB().changed(**parameters)
