"""The functions of cook_torrance.osl beside the formulas that they repeat, each with the arguments to compare them at.

A row is the function's signature, the formula, and arguments for both.  Tilts, which OSL's sine knows within 2e-8,
start at 0.01, and slopes of drawn facets at 0.2: single precision knows what is divided by their squares.
"""

from types import SimpleNamespace

import numpy as np

from addon.models.cook_torrance import gaussian_lobes, sampler
from addon.models.cook_torrance.v_cavity_lobe import of_slope, v_cavity_lobe
from addon.operands import arccos, rotate
from addon.reflectance import fresnel, masking, sampling, slopes
from addon.reflectance.directions import PI, facing, frame_along
from tests.render.osl_grids import about, column, grid, single, spread, tangent_in_the_scripts

SCRIPT = "cook_torrance.osl"

NOT_COMPARED = {
    "random(point, int)": "random numbers",
    "exact(vector, vector, float[4], float[4], float, vector, vector, vector, float, float, float, float, point)":
        "a closure",
    "beckmann_lobe(vector, float, float, vector, vector, vector)": "a closure",
    "gaussian_lobes(vector, float, float, float, vector, vector, vector)": "a closure",
    "closures(vector, vector, float[4], float[4], float, vector, vector, vector, float, float, float)": "a closure",
}

COSINES = (0.02, 0.1, 0.25, 0.5, 0.8, 0.95, 0.999, 1.0)
SLOPES = (0.05, 0.1, 0.2, 0.34, 0.36, 0.5, 0.8, 1.0)
SHARES = (0.0, 0.3, 0.7, 1.0)
UNIT = (0.0, 1.0)

FIELDS = ("H", "across", "a_across", "a_along", "stretch", "n_h", "n_v", "n_l", "v_h", "tangent", "v_across",
          "v_along", "steepness", "peak", "density", "lobe_tangent", "narrow", "broad", "covariance",
          "is_elliptic", "longest", "even", "seen_v", "seen_l")
OF_STRETCHED = 5
"""How many of them, the last, only the native lobe under stretched slopes needs."""
DIRECTIONS = ("H", "across", "lobe_tangent")


# --- Facets ---

def fields_of(x):
    """A facet as the script keeps it: D's peak in place of its flatness."""
    x.H, x.peak = x.h, np.broadcast_to(1.0 / x.flat ** 2, np.shape(x.n_h))
    x.is_elliptic, x.longest = 1.0 * (x.along != 1.0), x.along
    x.even, x.seen_v, x.seen_l = np.sqrt(x.round_tan2), 1.0 / np.sqrt(x.slope2_v), 1.0 / np.sqrt(x.slope2_l)
    return SimpleNamespace(**{name: np.broadcast_to(getattr(x, name), x.h.shape if name in DIRECTIONS
                                                    else x.n_h.shape) for name in FIELDS})


def ellipse_of(t, along, across):
    """How slopes are stretched, as the sampler has it."""
    return SimpleNamespace(is_elliptic=1.0, t=t, along=along, across=across)


def facet(n, v, m, a, wide, flanks, gaussian, t, along, across, u_tilt, u_azimuth, side, u_side=None):
    """The formula's facet, in the script's order; a side of None is drawn."""
    x = sampler.facet(n, v, m, a, wide, flanks, gaussian, u_tilt, u_azimuth, u_side, ellipse_of(t, along, across), side)
    return list(vars(fields_of(x)).values())


def drawings(longest=3.0, count=160):
    """What facets are drawn with, by either distribution; some of them exactly, some stretched."""
    cosine, azimuth, polar, turn, m, width, stretch, *numbers = spread(
        count, (0.05, 1.0), (0.0, 6.0), (-1.0, 1.0), (0.0, 6.0), (0.2, 0.9), (0.0, 0.8), (1.0, longest),
        (0.02, 0.98), UNIT)
    n = about(np.broadcast_to([0.0, 0.0, 1.0], (count, 3)), polar, turn)
    every_third_exact = width * (np.arange(count) % 3 > 0)
    gaussian = (np.arange(count) // 3 % 2).astype(float)
    along = single(np.where(np.arange(count) % 2 > 0, np.minimum(stretch, 1.0 / m), 1.0))
    a, wide = single(sampling.narrow_slope(m * along, every_third_exact) / along,
                     sampling.wide_slope(m * along, every_third_exact) / along)
    return [n, about(n, cosine, azimuth), m, a, wide, single(1.0 * (a > 0.0)), gaussian,
            single(tangent_in_the_scripts(n)), along, single(1.0 / along), *numbers,
            np.where(np.arange(count) // 2 % 2 > 0, 1.0, -1.0)]


def seen_facets(longest=3.0):
    """Facets that mirror V above the horizon as the script keeps them, and the slopes m that they were drawn with."""
    *first, t, along, across, u_tilt, u_azimuth, side = drawings(longest)
    x = sampler.facet(*first, u_tilt, u_azimuth, None, ellipse_of(t, along, across), side)
    above = (x.n_l > 0.01) & (x.density > 0.0)
    kept = {name: values[above] for name, values in vars(fields_of(x)).items()}
    return single(SimpleNamespace(**kept)), first[2][above]


def read(x):
    """A facet of the script as the formulas know it."""
    return SimpleNamespace(**vars(x), level=x.v_h / x.n_h, flat=1.0 / np.sqrt(x.peak), along=x.longest,
                           round_tan2=x.even ** 2, slope2_v=1.0 / x.seen_v ** 2, slope2_l=1.0 / x.seen_l ** 2)


def lobes_to_stretch():
    """Facets with the lobes that were drawn round, and what these are stretched with."""
    x, _ = seen_facets()
    count = len(x.n_h)
    turn, along, across, outwards, cosine, x.a_across, x.a_along, askew = spread(
        count, (0.0, 6.0), (1.0, 3.0), (0.3, 1.0), (0.5, 2.0), (0.3, 1.0), (0.05, 0.2), (0.2, 0.5), (0.0, 6.0))
    x.across, t = (single(np.stack([np.cos(angle), np.sin(angle), 0.0 * angle], axis=-1)) for angle in (askew, turn))
    n = np.broadcast_to([0.0, 0.0, 1.0], (count, 3))
    return [x, single(n), t, along, across, outwards, cosine, cosine]


def stretched(x, n, t, along, across, outwards, cos_drawn, to_angle):
    """The formula's, in the script's order."""
    lobe = sampler._stretched_lobe(x.across, x.a_across, x.a_along, n, outwards, cos_drawn, to_angle,
                                   ellipse_of(t, along, across))
    x = SimpleNamespace(**{**vars(x), **vars(lobe)})
    return [getattr(x, name) for name in FIELDS]


def unit_tangent(n, towards, turns):
    """The unit tangent next to a direction, turned."""
    return rotate(frame_along(n, towards)[0], n, 2.0 * PI * turns)


def towards_and_turns(count=60):
    """Normals, directions that are not along them, and turns."""
    cosine, azimuth, height, turn, turns = spread(count, (-0.6, 0.6), (0.0, 6.0), (-1.0, 1.0), (0.0, 6.0), UNIT)
    n = about(np.broadcast_to([0.0, 0.0, 1.0], (count, 3)), height, turn)
    return [n, about(n, cosine, azimuth), turns]


def scale_of(slope_t, slope_b, is_gaussian, published, printed_c):
    """As the script has it, of both slopes."""
    m, stretch = np.sqrt(slope_t * slope_b), np.sqrt(slope_t / slope_b)
    return sampler.scales(m, is_gaussian, published, printed_c, ellipse_of(None, stretch, 1.0 / stretch))[0]


M_OF_TILTED = 0.3


def tilted(drawn, weighed, c_m2, is_gaussian):
    """Tilt and density of drawn facets, of either distribution, in the script's order."""
    of_beckmann = sampler._beckmann(drawn * drawn, drawn, weighed * weighed)
    of_gaussian = sampler._gaussian(drawn, weighed * weighed, c_m2)
    chosen = [np.where(is_gaussian > 0.5, g, b) for g, b in zip(of_gaussian, of_beckmann)]
    tangent_drawn, cos_drawn, tangent, n_h, flat, density, _to_angle = chosen
    return tangent_drawn, cos_drawn, tangent, n_h, 1.0 / flat ** 2, density


def facet_weight(x, scale, native, n, k, f0, tint):
    """The formula's, for the F82 model's tint in place of its factor b."""
    return sampler.facet_weight(read(x), scale, native, n, k, f0, fresnel.f82_factor(f0, tint))


# --- Colours and lists ---

def colours(count, *ranges):
    """Colours spread over the ranges of a channel, (count, 3) a range."""
    numbers = spread(count, *[of_channel for of_channel in ranges for _ in "rgb"])
    return [np.stack(numbers[j:j + 3], axis=-1) for j in range(0, len(numbers), 3)]


def metals(count):
    """n and k of three channels, (count, 3) each, dielectrics among them."""
    n, k = colours(count, (0.1, 3.0), (-0.5, 5.0))
    return [n, np.maximum(k, 0.0)]


def drawn_slope(of_slopes, weights, has_native, u):
    """The slope that u draws, of four, and its weight."""
    return sampler.drawn_slope(u, has_native, list(of_slopes.T), list(weights.T))


def lists_of_four(count=60):
    """Slopes and weights, some of the weights 0, whether there are native lobes, and a number even in [0, 1)."""
    numbers = spread(count, *[(0.05, 1.0)] * 4, *[(-0.3, 1.0)] * 4, (0.0, 0.999))
    weights = np.maximum(np.stack(numbers[4:8], axis=-1), 0.0)
    some = weights.sum(axis=-1) > 0.0
    return [np.stack(numbers[:4], axis=-1)[some], weights[some], np.arange(some.sum()) % 2, numbers[8][some]]


def normals(count=60):
    """Normals towards and away from V, and V."""
    cosine, azimuth, height, turn = spread(count, (-0.6, 1.0), (0.0, 6.0), (-1.0, 1.0), (0.0, 6.0))
    v = about(np.broadcast_to([0.0, 0.0, 1.0], (count, 3)), height, turn)
    return [about(v, cosine, azimuth), v]


def cosine_over_longest(cosine, along, shorter):
    """Of the square of the slope."""
    return 1.0 / np.sqrt(sampler._slope2_over_longest(cosine, along, shorter, 1.0 - shorter * shorter))


def native_lobes_cases(longest=3.0):
    """Facets, slopes, and leans that are 0 where slopes are stretched."""
    x, m = seen_facets(longest)
    return [x, m, single(sampler.native_lobe(x.n_v, m)[1] * (1.0 - x.is_elliptic))]


def with_mirrors():
    """The same, and on surfaces so smooth that single precision does not tell their facets' cosines from 1."""
    count = 60
    n, v, _, _, _, flanks, gaussian, t, _, _, *numbers = drawings(longest=1.0, count=count)
    m = single(MIRROR * (1.0 + np.arange(count) / count))
    x = sampler.facet(n, v, m, 0.0 * m, 0.0 * m, 0.0 * flanks, 0.0 * gaussian, *numbers, ellipse_of(t, 1.0, 1.0))
    smooth = [single(fields_of(x)), m, single(sampler.native_lobe(x.n_v, m)[1])]
    above = x.n_l > 0.01
    return [joined_cases(a, b, above) for a, b in zip(native_lobes_cases(), smooth)]


def joined_cases(first, second, chosen):
    """Both, the second where chosen; of a SimpleNamespace, member by member."""
    if isinstance(first, SimpleNamespace):
        return SimpleNamespace(**{name: joined_cases(value, getattr(second, name), chosen)
                                  for name, value in vars(first).items()})
    return np.concatenate([first, second[chosen]])


MIRROR = 1e-3


def weights_cases():
    x, m = seen_facets()
    n, k = metals(len(m))
    f0, tint = single(*sampler.native_fresnel(n, k))
    scale, carried = spread(len(m), (1.0, 4.0), (0.0, 0.9))
    return [x, scale, carried, n, k, f0, tint]


def metals_and_f0():
    n, k = metals(60)
    return [single(fresnel.conductor(1.0, n, k)), n, k]


FORMULAS = {
    "angle_of(float)": (arccos, grid((-1.0, -0.7, -0.1, 0.0, 0.001, 0.3, *COSINES))),
    "beckmann(float, float)": (slopes.beckmann, grid(COSINES, SLOPES)),
    "gaussian(float, float, float)": (slopes.gaussian, grid(COSINES, SLOPES, (0.5, 3.0, 25.0))),
    "v_cavity(float, float, float, float)": (
        masking.v_cavity, grid((0.1, 0.6, 0.9, 1.0), (0.05, 0.3, 0.9), (-0.2, 0.05, 0.3, 0.9), (0.2, 0.6, 1.0))),
    "fresnel(float, float, float)": (
        fresnel.conductor, grid(COSINES, (0.15, 1.0001, 1.5, 3.0), (0.0, 0.7, 2.0, 4.0))),
    "fresnel(float, vector, vector)": (
        lambda c, n, k: fresnel.conductor(column(c), n, k), [*spread(60, UNIT), *metals(60)]),
    "along_across(float, float, output float, output float)": (slopes.along_across, grid(SLOPES, (0.0, 0.5, 0.95))),
    "gaussian_c(float, float)": (slopes.elliptic_gaussian_c, grid(SLOPES, (0.05, 0.1, 0.5))),
    "tinted(float, float, float, output float, output float)": (
        fresnel.tinted, grid((0.2, 0.9, 1.5, 3.0), (0.0, 1.0, 2.0, 4.0), (0.0, 0.3, 0.9, 1.0))),
    "of_slope(float, float, float, float)": (
        of_slope, grid(SLOPES, (-2.0, 0.5), (-3.0, 1.0), (0.0, 2.0))),
    "v_cavity_lobe(float, float, float, output float, output float, output float)": (
        lambda sine, m, steepest: v_cavity_lobe(sine, m, steepest=steepest),
        grid((0.0, 0.3, 0.7, 0.9, 1.0), SLOPES, (0.05, 0.15, 0.3, 0.5))),
    "unit_tangent(vector, vector, float)": (unit_tangent, towards_and_turns()),
    "scale_of(float, float, int, float, float)": (
        scale_of, grid(SLOPES, (0.2, 0.5), UNIT, (0.0, 0.5, 1.0), (1.0, 3.0))),
    "smith_lambda(float, float)": (masking.smith_lambda, grid(COSINES, SLOPES)),
    "smith(float, float, float)": (masking.smith_beckmann, grid(COSINES, COSINES, (0.1, 0.4, 0.9))),
    "native_slope(float)": (sampler.native_slope, grid(SLOPES)),
    "native_lobe(float, float, output float, output float)": (sampler.native_lobe, grid(COSINES, SLOPES)),
    "fifth_power(float)": (lambda x: np.power(x, 5.0), grid((0.0, 0.3, 0.9, 1.0, 2.0))),
    "schlick(float, color)": (
        lambda c, f0: fresnel.schlick(column(c), f0), [*spread(60, UNIT), *colours(60, UNIT)]),
    "f82(float, color, color)": (
        lambda c, f0, tint: fresnel.f82(column(c), f0, tint), [*spread(60, UNIT), *colours(60, UNIT, UNIT)]),
    "f82_tint(color, vector, vector)": (lambda f0, n, k: sampler.native_fresnel(n, k)[1], metals_and_f0()),
    "drawn_slope(float[4], float[4], int, float, output float, output float)": (drawn_slope, lists_of_four()),
    "narrow_slope(float, float)": (sampling.narrow_slope, grid(SLOPES, SHARES)),
    "wide_slope(float, float)": (sampling.wide_slope, grid(SLOPES, SHARES)),
    "towards_flanks(float, float, output float, output float)": (
        sampling.towards_flanks, grid((0.001, 0.1, 0.5, 0.9, 0.99), (0.0, 0.5, 1.0))),
    "tilted(float, float, float, int, output float, output float, output float, output float, output float, "
    "output float)": (tilted, grid((0.001, 0.1, 0.5, 1.2), (0.01, 0.15, 0.6, 1.4),
                                   (slopes.gaussian_c(M_OF_TILTED) * M_OF_TILTED ** 2,), UNIT)),
    "stretched(Facet, vector, vector, float, float, float, float, float)": (stretched, lobes_to_stretch()),
    "facet(vector, vector, float, float, float, float, int, vector, float, float, float, float, float)": (
        facet, drawings()),
    "cosine_over_longest(float, float, float)": (cosine_over_longest, grid((0.1, 0.4, 0.7), (0.0, 0.3, 0.7), UNIT)),
    "sharpened_v_cavity(Facet)": (lambda x: sampler.sharpened_v_cavity(read(x)), seen_facets()[:1]),
    "native_over_D(Facet, float, float)": (
        lambda x, m, lean: sampler.native_over_d(read(x), m, lean), with_mirrors()),
    "facet_weight(Facet, float, float, vector, vector, color, color)": (facet_weight, weights_cases()),
    "gaussian_shares(float, output float, output float, output float)": (
        lambda m: [share for share, _widening in gaussian_lobes.gaussian_lobes(m)], grid(SLOPES)),
    "gaussian_slopes(float, output float, output float, output float)": (
        lambda m: [m * widening ** 2 for _share, widening in gaussian_lobes.gaussian_lobes(m)], grid(SLOPES)),
    "facing(vector, vector)": (facing, normals()),
}
