"""The functions of film.osl beside the formulas that they repeat, each with the arguments to compare them at.

Most are those of cook_torrance.osl, by Beckmann's distribution alone; see there.
"""

from types import SimpleNamespace

from addon.models.cook_torrance import sampler
from addon.models.film import exact, formulas
from addon.operands import maximum, x_of, y_of, z_of
from tests.render import osl_cook_torrance as of_cook_torrance
from tests.render.osl_cook_torrance import SHARES, UNIT, colours, drawings, lobes_to_stretch, native_lobes_cases, read
from tests.render.osl_grids import grid, single, spread

SCRIPT = "film.osl"

NOT_COMPARED = {
    "random(point, int)": "random numbers",
    "native_closure(vector, vector, float, color)": "a closure",
}

SHARED = ("along_across(float, float, output float, output float)", "smith_lambda(float, float)",
          "smith(float, float, float)", "native_slope(float)", "native_lobe(float, float, output float, output float)",
          "narrow_slope(float, float)", "wide_slope(float, float)",
          "towards_flanks(float, float, output float, output float)", "sharpened_v_cavity(Facet)",
          "facing(vector, vector)", "unit_tangent(vector, vector, float)")
"""Functions that both scripts have, word for word."""

def drawings_of_sides():
    """The arguments of a facet, but for the distribution and with a number that draws the side."""
    *arguments, side = drawings()
    return [*arguments[:6], *arguments[7:], *spread(len(side), (0.02, 0.98))]


def facet(*arguments):
    """The formula's facet of Beckmann's distribution, in the script's order."""
    *others, u_side = arguments
    return of_cook_torrance.facet(*others[:6], 0.0, *others[6:], None, u_side)[:-of_cook_torrance.OF_STRETCHED]


def stretched(x, n, t, along, across, outwards, cos_drawn):
    """The formula's, in the script's order."""
    lobe = of_cook_torrance.stretched(whole(x), n, t, along, across, outwards, cos_drawn, cos_drawn)
    return lobe[:-of_cook_torrance.OF_STRETCHED]


def here(x):
    """A facet as this script keeps it, which has no native lobe under stretched slopes."""
    return SimpleNamespace(**dict(list(vars(x).items())[:-of_cook_torrance.OF_STRETCHED]))


def whole(x):
    """The same as the other script keeps it, of round slopes."""
    return SimpleNamespace(**vars(x), is_elliptic=0.0, longest=1.0, even=x.tangent, seen_v=x.n_v, seen_l=x.n_l)


def lobes_to_stretch_here():
    """Facets with the lobes that were drawn round, and what these are stretched with."""
    x, *others = lobes_to_stretch()
    return [here(x), *others[:-1]]


def native_lobes_cases_here():
    """Facets of round slopes, slopes, and leans."""
    x, m, lean = native_lobes_cases(longest=1.0)
    return [here(x), m, lean]


def brightest(colour):
    """The greatest of three channels."""
    return maximum(x_of(colour), y_of(colour), z_of(colour))


def looks_and_shares(count=60):
    """What is seen in the middle, the native lobe's share, and what is least."""
    middle, dark = colours(count, UNIT, UNIT)
    return [middle, *spread(count, UNIT), single(middle * dark)]


def weights_cases():
    """Facets, colours of the film and of the native lobe, slopes and leans."""
    x, m, lean = native_lobes_cases_here()
    film, native = colours(len(m), UNIT, UNIT)
    return [x, film, native, m, lean]


FORMULAS = {
    **{key: of_cook_torrance.FORMULAS[key] for key in SHARED},
    "slope(float)": (formulas.slope, grid((0.0, 0.01, *SHARES))),
    "second_slope(float, float)": (formulas.second_slope, grid((0.001, 0.1, 0.6), (0.001, 0.5, 3.0))),
    "stretched(Facet, vector, vector, float, float, float, float)": (stretched, lobes_to_stretch_here()),
    "facet(vector, vector, float, float, float, float, vector, float, float, float, float, float)": (
        facet, drawings_of_sides()),
    "native_over_D(Facet, float, float)": (
        lambda x, m, lean: sampler.native_over_d(read(whole(x)), m, lean), native_lobes_cases_here()),
    "brightest(color)": (brightest, colours(20, UNIT)),
    "kept(color, float, color)": (exact.kept, looks_and_shares()),
    "facet_weight(Facet, color, color, float, float)": (
        lambda x, film, native, m, lean: exact.facet_weight(read(whole(x)), film, native, m, lean), weights_cases()),
}
