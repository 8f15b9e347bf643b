"""The same layer in another scene-linear space: the model is of three channels, and knows none.

Channels of wider primaries make more vivid colours of the same numbers.  What a space can be told by are the indices
and wavelengths of the channels: those are fitted, so that colours over the thickness and gloss stay as near as they
can; the model's thickness, widths and tilts stay.
"""

import numpy as np

from ...bake.colour import space_to_space
from ...bake.standin_fit import fit_curve
from .formulas import inner_products, layered_lobes, phase_eq3, rho_d_eq16, rho_of_parts

__all__ = ["bake_in", "respaced", "spaced"]

THICKNESSES = 9
COSINES = (0.91, 0.71, 0.41)
"""At which the mirrored light is compared: even shares of a ball's disc."""
SEEN = 0.02
"""A weight of the diffuse or the specular part below which it is not compared."""
RANGE = 1.0
"""What a logarithm of an index or wavelength may change by: half of this either way."""
LEAST_INDEX = 1.001


def bake_in(space, parameters, checked):
    """(parameters, mean CIEDE2000) of a preset, which is stated for Rec.709, in a space; checked is a LayeredRGB."""
    if space == "Rec.709":
        return parameters, 0.0
    found, apart = spaced(checked.changed(**parameters), "Rec.709", space)
    return {**parameters, **found}, apart


def respaced(parameters, changed, before, after):
    """{name: value} of what the user changed of indices and wavelengths, in another space."""
    return spaced(parameters, before, after)[0] if changed else {}


def spaced(parameters, before, after):
    """({"ior": …, "wavelengths": …} of a LayeredRGB in another space, mean CIEDE2000 that is left).

    >>> from .parameters import LayeredRGB
    >>> found, apart = spaced(LayeredRGB(thickness=60.0), "Rec.709", "ACEScg")
    >>> bool(apart < 3.0), len(found["wavelengths"])
    (True, 3)
    """
    start = np.concatenate([parameters.ior, parameters.wavelengths])
    here, there = (space_to_space(space, "Rec.709").T for space in (before, after))

    def values(x):
        moved = start * np.exp(RANGE * (x - 0.5))
        return np.maximum(moved[:3], LEAST_INDEX), moved[3:]
    colours = _colours(parameters)
    target = colours(*values(np.full(6, 0.5)))
    fit = fit_curve(lambda x: colours(*values(x)) @ there, np.full(6, 0.5), target @ here)
    ior, wavelengths = values(np.array(fit.base + fit.beside))
    return {"ior": tuple(ior.tolist()), "wavelengths": tuple(wavelengths.tolist())}, fit.delta_e_mean


def _colours(parameters):
    """The function of indices and wavelengths that gives the colours to compare, ``(A, 3)``: the diffuse part's over
    the thickness, and the lobes' under an even sky, brightest at 1.
    """
    p, up = parameters, np.array([0.0, 0.0, 1.0])
    d = np.linspace(*(p.thickness_range or (p.thickness, p.thickness)), THICKNESSES)
    views = [np.array([(1.0 - c * c) ** 0.5, 0.0, c]) for c in COSINES]

    def mirrored(view, ior, wavelengths):
        cosines = inner_products(view * [-1.0, 1.0, 1.0], view, up, up, ior)
        r, t = layered_lobes(cosines, ior, p.exponent_r, p.exponent_t, 0.0)
        out = p.exponent_t / ior**2  # the transmitted lobe is that much wider outside
        r, t, both = r / (p.exponent_r + 1.0), t / (out + 1.0), np.sqrt(r * t) / (0.5 * (p.exponent_r + out) + 1.0)
        return rho_of_parts(r, t, both, phase_eq3(cosines.cos_i, cosines.cos_o, ior, d, wavelengths))
    brightest = mirrored(views[0], np.array(p.ior), np.array(p.wavelengths)).max()

    def found(ior, wavelengths):
        parts = [rho_d_eq16(ior, d, wavelengths)] if p.diffuse > SEEN or p.specular <= SEEN else []
        if p.specular > SEEN:
            parts += [mirrored(view, ior, wavelengths) / brightest for view in views]
        return np.concatenate(parts)
    return found
