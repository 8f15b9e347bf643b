"""The functions of layered_rgb.osl beside the formulas that they repeat, each with the arguments to compare them at.

A row is the function's signature, the formula, and arguments for both.  The script works on one channel at a time:
the formulas get colours of one channel.  Exponents end at 40, and at 12 where whole lobes are made of several: single
precision knows the logarithm of a cosine within 2e-7, and so a lobe cos^e within e times as much of itself.
"""

from types import SimpleNamespace

import numpy as np

from addon.models.layered_rgb import formulas as model
from addon.models.layered_rgb import lobes as fast
from addon.models.layered_rgb import sampler
from addon.operands import arccos, dot, normalize, widen
from addon.reflectance.directions import facing, half_vector, in_frame, mirrored
from tests.render.osl_cook_torrance import normals
from tests.render.osl_grids import about, column, grid, single, spread, tangent_in_the_scripts

SCRIPT = "layered_rgb.osl"

NOT_COMPARED = {
    "exact(vector, vector, vector, vector, float, vector, float, float, float, float, point)": "a closure",
    "phong(vector, vector, float, float, color)": "a closure",
    "closures(vector, vector, vector, vector, float, vector, float, float, float)": "a closure",
}

COSINES = (0.02, 0.1, 0.25, 0.5, 0.8, 0.95, 1.0)
INDICES = (1.05, 1.33, 1.5, 2.4)
EXPONENTS = (0.0, 2.0, 10.0, 40.0)
UNIT = (0.0, 1.0)
RGB = np.ones(3)
COUNT = 80


# --- Directions ---

def surfaces(count=COUNT, lowest=0.2, highest=0.99, tilt=0.15):
    """Unit V, n0 and n1, as the viewer sees both boundaries."""
    cosine, azimuth, polar, turn, deviation, towards = spread(
        count, (lowest, highest), (0.0, 6.0), (-1.0, 1.0), (0.0, 6.0), (0.0, tilt), (0.0, 6.0))
    n0 = about(np.broadcast_to([0.0, 0.0, 1.0], (count, 3)), polar, turn)
    return about(n0, cosine, azimuth), n0, about(n0, np.cos(deviation), towards)


def lights(view, n0, spread_out=0.5):
    """Directions of light above the surface, most of them about the mirror direction."""
    x, y, z = spread(len(view), *[(-spread_out, spread_out)] * 3)
    leaving = mirrored(view, n0) + np.stack([x, y, z], axis=-1)
    lifted = leaving + widen(np.maximum(0.15 - dot(leaving, n0), 0.0)) * n0
    return single(normalize(lifted))


def refracted(v, n, r1):
    """v, which travels against n, in the layer."""
    height = -dot(v, n)
    return (v + widen(height) * n) / column(r1) - model.cos_refracted(height, column(r1)) * n


def mirror(v, n):
    """v, mirrored about the boundary with the normal n."""
    return -mirrored(v, n)


# --- The model ---

def transmission(v, n0, f):
    return model.transmission_eq9(column(-dot(v, n0)), column(f))


def reflected(i, o, n0, f, e0, published):
    fresnel = model.fresnel_eq7(-dot(i, n0), column(f))
    return model.reflected_eq6(fresnel, dot(mirror(i, n0), o), e0) * widen(model.lobe_scale(e0, published))


def transmitted(i, io, n0, n1, r1, f, e1, published):
    ii = refracted(i, n0, r1)
    lobe, n1_i, n1_o = (column(x) for x in (dot(mirror(ii, n1), -io), -dot(ii, n1), -dot(io, n1)))
    reached = model.layer_is_reached(n1_i, n1_o, lobe)
    fresnel = model.fresnel_eq7(-dot(i, n0), column(f))
    t = model.transmitted_eq10(fresnel, transmission(io, n0, f), lobe, e1, reached)
    return t * widen(model.lobe_scale(e1, published))


def phase(i, io, n0, r1, d, wavelength):
    cos_i = model.cos_refracted(-dot(i, n0), column(r1))
    return model.phase_eq3(cos_i, column(-dot(io, n0)), column(r1), d, column(wavelength))


def rho(i, o, n0, n1, r1, d, wavelength, e0, e1, published, narrow):
    """Eq. 5 of the parts that the lobe about H blurs back."""
    narrow = SimpleNamespace(
        taken_r=narrow.taken0, taken_t=column(narrow.taken1), power=column(narrow.power), rise=column(narrow.rise),
        e0=sampler.narrowed_exponent(e0, narrow.taken0), e1=column(sampler.narrowed_exponent(e1, narrow.taken1)))
    cosines = model.inner_products(-i, o, n0, n1, column(r1))
    parts = sampler.narrowed_parts(cosines, narrow, column(r1), e0, e1, published)
    return model.rho_of_parts(*parts, model.phase_eq3(cosines.cos_i, cosines.cos_o, column(r1), d, column(wavelength)))


def layers(count=COUNT):
    """r1, d and wavelength in nm, e0, e1 of one channel, and the scale."""
    *numbers, published = spread(count, (1.1, 2.2), (0.0, 180.0), (440.0, 650.0), (2.0, 12.0), (2.0, 12.0), UNIT)
    return [*numbers, np.round(published)]


def reflected_cases():
    view, n0, _n1 = surfaces()
    r1, _d, _wavelength, e0, _e1, published = layers()
    return [-lights(view, n0), view, n0, single(model.f_eq8(r1)), e0, published]


def transmitted_cases():
    view, n0, n1 = surfaces(tilt=1.5)
    r1, _d, _wavelength, _e0, e1, published = layers()
    return [-lights(view, n0), single(refracted(-view, n0, r1)), n0, n1, r1, single(model.f_eq8(r1)), e1, published]


def phase_cases():
    i, io, n0, _n1, r1, *_others = transmitted_cases()
    return [i, io, n0, r1, *layers()[1:3]]


def rho_cases():
    """Every other case is the formula itself, the others are narrowed."""
    view, n0, n1 = surfaces()
    taken0, taken1, power, rise = spread(COUNT, (0.05, 0.3), (0.05, 0.6), (1.0, 2.0), (1.0, 2.0))
    whole = np.arange(COUNT) % 2
    narrow = SimpleNamespace(taken0=taken0 * whole, taken1=taken1 * whole, power=np.where(whole, power, 1.0),
                             rise=np.where(whole, rise, 1.0))
    return [-lights(view, n0), view, n0, n1, *layers(), narrow]


# --- Drawing L ---

def of_proposal(view, n0, n1, indices, e1):
    """Axes and shares of the four lobes, in the script's order."""
    r1 = indices[:, 1:]
    lobes = sampler.proposal(view, n0, n1, r1, 10.0, e1)
    axes = [mirrored(view, n0)]
    for c in range(3):
        w = mirrored(-refracted(-view, n0, r1[:, c]), n1)
        axes.append(lobes.turn[:, c:c + 1] * w + lobes.lift[:, c:c + 1] * n0)
    return [*axes, lobes.share_r, lobes.shares]


def proposal_cases(**options):
    view, n0, n1 = surfaces(**options)
    r, g, b, e1 = spread(COUNT, *[(1.2, 2.2)] * 3, (2.0, 40.0))
    return [view, n0, n1, np.stack([np.ones(COUNT), r, g, b], axis=-1), e1]


def clearance(n0, n0_v, axes, shares, indices, e0, e1):
    return sampler.proposal(*clear_of_the_edge()[:3], indices[:, 1:], e0, e1).clearance


def clear_of_the_edge():
    """Lobes that all leave: at the edge of total reflection rounding takes the root of what is left of their height."""
    return proposal_cases(lowest=0.6, tilt=0.05)


def clearance_cases():
    view, n0, n1, indices, e1 = clear_of_the_edge()
    *axes, share_r, shares = of_proposal(view, n0, n1, indices, e1)
    return [n0, single(dot(n0, view)), single(np.concatenate(axes, axis=1)),
            single(np.concatenate([column(share_r), shares], axis=1)), indices, *spread(COUNT, (0.0, 40.0)), e1]


def lobe_axis(w, n0, r1):
    """The axis of the lobe about w: for the viewer above n0, and the lower boundary that mirrors n0 to w."""
    lobes = sampler.proposal(n0, n0, half_vector(w, n0), column(r1) * RGB, 10.0, 10.0)
    return lobes.turn[:, :1] * w + lobes.lift[:, :1] * n0


def axis_cases():
    _view, n0, _n1 = surfaces()
    cosine, azimuth, r1 = spread(COUNT, (0.05, 0.999), (0.0, 6.0), (1.1, 2.2))
    return [about(n0, cosine, azimuth), n0, r1]


def lobe_density(light, n0, n_l, axis, r1, e):
    """The mixture's density with one lobe in it: R's where the index is 1, else T's, about the axis itself."""
    is_r = (r1 == 1.0).astype(float)
    inside = -refracted(-light, n0, r1)
    lobes = SimpleNamespace(share_r=is_r, shares=column(1.0 - is_r) * [1.0, 0.0, 0.0], turn=1.0, lift=0.0)
    cosines = SimpleNamespace(mirror=dot(light, axis), lobe=column(dot(inside, axis)),
                              cos_i=column(dot(inside, n0)), n0_l=n_l)
    narrow = SimpleNamespace(e0=e, e1=column(e))
    return sampler._density(lobes, narrow, cosines, column(r1) * RGB)


def density_cases():
    view, n0, _n1 = surfaces()
    light = lights(view, n0)
    r1, e = spread(COUNT, (0.7, 2.2), (0.0, 40.0))
    r1 = np.maximum(r1, 1.0)
    cosine, azimuth = spread(COUNT, (0.7, 1.0), (0.0, 6.0))
    return [light, n0, single(dot(n0, light)), about(single(-refracted(-light, n0, r1)), cosine, azimuth), r1, e]


def around(axis, cos_alpha, phi):
    """The direction in the frame that the script takes."""
    t = tangent_in_the_scripts(axis)
    sine = np.sqrt(1.0 - cos_alpha * cos_alpha)
    return in_frame(sine * np.cos(phi), sine * np.sin(phi), cos_alpha, t, np.cross(axis, t), axis)


def narrowed(between_lobes, r1, e0, e1, share, variance):
    """The first channel's narrowing in a layer whose other channels have the indices of other cases."""
    of_t = sampler.narrowed(SimpleNamespace(apart=column(between_lobes)), rolled(r1), e0, e1, np.sqrt(share))
    return of_t.taken_r, of_t.taken_t[:, 0], of_t.power[:, 0], of_t.rise[:, 0]


def rolled(r1):
    """Indices of three channels, (cases, 3): each case's own and those of its neighbours."""
    return np.stack([r1, np.roll(r1, 1), np.roll(r1, 2)], axis=-1)


def variance_taken(r1, e1, share):
    """Twice the square of the slope that T's lobe is given."""
    of_t = sampler.narrowed(SimpleNamespace(apart=0.0), r1, 10.0, e1, np.sqrt(share))
    return 2.0 * of_t.slope_t ** 2


def narrowed_cases():
    between_lobes, r1, e0, e1, share = spread(COUNT, (0.0, 0.1), (1.1, 2.2), (2.0, 40.0), (2.0, 40.0), (0.0, 0.5))
    return [between_lobes, r1, e0, e1, share, single(variance_taken(rolled(r1), e1, share))]


def picked(shares, u):
    """The number of the lobe that u picks."""
    is_r, channel = sampler._picked(SimpleNamespace(share_r=shares[:, 0], shares=shares[:, 1:]), u)
    return (1.0 - is_r) * (channel @ [1.0, 2.0, 3.0])


def picked_cases():
    *shares, u = spread(COUNT, *[(0.01, 1.0)] * 4, (0.0, 0.999))
    return [single(np.stack(shares, axis=-1) / np.sum(shares, axis=0)[:, None]), u]


def leaves(inside, n0, index):
    """Whether it leaves, L and N.L, by drawing from a lobe in the layer right on its axis."""
    lobes = SimpleNamespace(share_r=0.0, shares=np.tile([1.0, 0.0, 0.0], (len(index), 1)), turn=RGB, lift=0.0 * RGB,
                            cos_o=column(dot(n0, inside)) * RGB)
    narrow = SimpleNamespace(e0=0.0, e1=0.0 * RGB, slope_r=0.0, slope_t=0.0)
    view = widen(index) * mirrored(inside, n0)
    drawn = sampler.draw(lobes, narrow, view, n0, n0, column(index) * RGB, 0.5, 1.0, 0.0)
    return drawn.valid, drawn.light, drawn.light_cos


def leaving_cases():
    _view, n0, _n1 = surfaces()
    cosine, azimuth, index = spread(COUNT, (-0.3, 1.0), (0.0, 6.0), (0.7, 2.2))
    return [about(n0, cosine, azimuth), n0, np.maximum(index, 1.0)]


def lobe_about_h(light, view, n0, n_l, index, slope):
    drawn = SimpleNamespace(light=light, light_cos=n_l, index=index, slope=slope)
    lobe = sampler.kernel(drawn, view, n0)
    return lobe.tangent, lobe.slope_along, lobe.slope_across


def lobe_about_h_cases():
    view, n0, _n1 = surfaces()
    light = lights(view, n0, 0.8)
    index, slope = spread(COUNT, (0.7, 2.2), (0.01, 0.3))
    return [light, view, n0, single(dot(n0, light)), np.maximum(index, 1.0), slope]


# --- Closures ---

PLANE = ("n0_v", "mirror_side", "cos_w", "sin_w", "cos_o", "r1", "f", "out", "path", "e0", "e1", "theta", "within", "u")


def layer_cases():
    """Viewer, boundaries and one channel's layer; D close to n0 would leave their plane open."""
    return [*surfaces(lowest=0.2, highest=0.5, tilt=0.2), *layers()[:5]]


def plane_of(view, n0, n1, r1, d, wavelength, e0, e1):
    """The plane of n0 and D as the script keeps it, and in its order."""
    f, exits = model.f_eq8(column(r1)), fast.exit_directions(view, n0, n1, column(r1))
    plane = fast.exit_plane(exits, column(r1), d, column(wavelength), f, e0, e1)
    leaving = exits.on_v * view + exits.on_n0 * n0 + exits.on_n1 * n1
    u = (leaving - exits.cos_1 * n0) / plane.sin_1
    found = {**vars(exits), **vars(plane), "r1": r1, "f": f, "e0": e0, "e1": e1, "u": u,
             "within": plane.sigma_t ** -2.0}
    return SimpleNamespace(**{name: u if name == "u" else found[name].reshape(len(u)) for name in PLANE})


def planes():
    return single(plane_of(*layer_cases()))


def known(plane):
    """The script's plane as the formulas know it: exits, plane, r1, f, e0 and e1."""
    height, n0_v = np.cos(plane.theta), plane.n0_v
    exits = SimpleNamespace(n0_v=n0_v, cos_o=column(plane.cos_o), cos_w=column(plane.cos_w), cos_1=column(height),
                            between=column(plane.mirror_side * np.sin(plane.theta) + height * n0_v))
    r1, f = column(plane.r1), column(plane.f)
    found = fast.exit_plane(exits, r1, 1.0, 1.0, f, plane.e0, plane.e1)
    found.path, found.out, found.sin_w = column(plane.path), column(plane.out), column(plane.sin_w)
    return exits, found, r1, f, plane.e0, plane.e1


def in_plane(plane, theta):
    exits, found, *layer = known(plane)
    return fast.in_plane(exits, found, column(theta), *layer)


def transmitted_albedo(plane):
    exits, _found, r1, f, _e0, e1 = known(plane)
    return fast.transmitted_albedo(exits, r1, f, e1)


def r_peak(view, n0, mean_f, e0):
    """The direction that the normal of R's lobe mirrors V to."""
    exits = SimpleNamespace(n0_v=dot(n0, view))
    lobe = fast._r_lobe(view, n0, exits, column(mean_f) * RGB, e0, RGB)
    return mirrored(view, lobe.normal)


def r_peak_cases():
    view, n0, _n1 = surfaces()
    return [view, n0, *spread(COUNT, (0.01, 0.3), (0.0, 40.0))]


def tilted_cases():
    n0 = surfaces()[1]
    tangent = single(tangent_in_the_scripts(n0))
    return [n0, tangent, single(np.cross(n0, tangent)), *spread(COUNT, (0.0, 0.5), (0.0, 6.2))]


FORMULAS = {
    "refract_into(vector, vector, float)": (
        refracted, [-surfaces()[0], surfaces()[1], spread(COUNT, (1.0, 2.4))[0]]),
    "mirror(vector, vector)": (mirror, surfaces()[:2]),
    "fifth_power(float)": (model.fifth_power, grid((0.0, 0.3, 0.9, 1.0, 2.0))),
    "lobe(float, float)": (lambda x, e: np.power(np.maximum(x, 0.0), e), grid((-0.3, *COSINES), EXPONENTS)),
    "f_normal(float)": (model.f_eq8, grid(INDICES)),
    "fresnel(float, float)": (lambda c, f: model.fresnel_eq7(c, column(f)), grid(COSINES, (0.0, 0.04, 0.3))),
    "transmission(vector, vector, float)": (
        transmission, [-surfaces()[0], surfaces()[1], spread(COUNT, (0.0, 0.3))[0]]),
    "lobe_scale(float, float)": (model.lobe_scale, grid(EXPONENTS, UNIT)),
    "reflected(vector, vector, vector, float, float, float)": (reflected, reflected_cases()),
    "transmitted(vector, vector, vector, vector, float, float, float, float)": (transmitted, transmitted_cases()),
    "phase(vector, vector, vector, float, float, float)": (phase, phase_cases()),
    "narrowed_exponent(float, float)": (sampler.narrowed_exponent, grid(EXPONENTS, (0.0, 0.1, 0.5, 0.8))),
    "rho(vector, vector, vector, vector, float, float, float, float, float, float, Narrow)": (rho, rho_cases()),
    "rho_d(float, float, float, float)": (
        lambda r1, d, wavelength, published: model.rho_d_eq16(column(r1), d, column(wavelength), published),
        grid(INDICES, (0.0, 70.0, 180.0), (445.0, 645.0), UNIT)),
    "lobe_axis(vector, vector, float)": (lobe_axis, axis_cases()),
    "lobe_density(vector, vector, float, vector, float, float)": (lobe_density, density_cases()),
    "around(vector, float, float)": (around, [surfaces()[1], *spread(COUNT, (0.0, 0.999), (0.0, 6.2))]),
    "proposal(vector, vector, vector, float[4], float, output vector[4], output float[4])": (
        of_proposal, proposal_cases()),
    "clearance(vector, float, vector[4], float[4], float[4], float, float)": (clearance, clearance_cases()),
    "tapered_width(float, float)": (
        lambda clearance, width: sampler.tapered_width(SimpleNamespace(clearance=clearance), width),
        grid((0.0, 0.5, 2.0, 7.0), (0.0, 0.3, 0.9))),
    "variance_taken(vector, float, float)": (
        variance_taken, [proposal_cases()[3][:, 1:], *spread(COUNT, (0.0, 40.0), (0.0, 0.8))]),
    "apart(vector, vector, vector, float)": (
        lambda view, n0, n1, r1: sampler.proposal(view, n0, n1, column(r1) * RGB, 10.0, 10.0).apart[:, 0],
        [*surfaces(), spread(COUNT, (1.1, 2.2))[0]]),
    "narrowed(float, float, float, float, float, float)": (narrowed, narrowed_cases()),
    "picked_lobe(float[4], float)": (picked, picked_cases()),
    "leaves(vector, vector, float, output vector, output float)": (leaves, leaving_cases()),
    "lobe_about_H(vector, vector, vector, float, float, float, output vector, output float, output float)": (
        lobe_about_h, lobe_about_h_cases()),
    "angle_of(float)": (arccos, grid((-1.0, -0.7, -0.1, 0.0, 0.001, 0.3, *COSINES))),
    "above(float)": (fast.above, grid(np.linspace(-4.0, 4.0, 17))),
    "bell(float)": (fast.bell, grid(np.linspace(-4.0, 4.0, 17))),
    "mean_cosine(float, float, float)": (
        lambda cos_w, r1, e1: fast._mean_cosine(column(cos_w), column(r1), e1), grid(COSINES, INDICES, EXPONENTS)),
    "grazing(float)": (fast._schlick, grid((-0.5, *COSINES, 1.3))),
    "reflected_albedo(float, float, float)": (
        lambda n0_v, f, e0: fast.reflected_albedo(n0_v, column(f), e0), grid(COSINES, (0.0, 0.04, 0.3), EXPONENTS)),
    "plane_of(vector, vector, vector, float, float, float, float, float)": (
        lambda *arguments: list(vars(plane_of(*arguments)).values()), layer_cases()),
    "in_plane(Plane, float)": (in_plane, [planes(), *spread(COUNT, (-1.7, 1.7))]),
    "dealt_to_t(float, float)": (fast._dealt_to_t, grid((0.0, 0.2, 1.0), (-1.5, -0.5, 0.0, 0.7))),
    "interference_albedo(Plane)": (lambda plane: fast.interference_albedo(*known(plane)), [planes()]),
    "transmitted_albedo(Plane)": (transmitted_albedo, [planes()]),
    "lobe_albedos(Plane, float, output float, output float)": (
        lambda plane, published: fast.lobe_colours(*known(plane), published),
        [planes(), np.arange(COUNT) % 2.0]),
    "r_peak(vector, vector, float, float)": (r_peak, r_peak_cases()),
    "peak_of(Plane, output float, output float)": (lambda plane: fast.peaks(*known(plane)), [planes()]),
    "facing(vector, vector)": (facing, normals()),
    "tilted(vector, vector, vector, float, float)": (model.tilted_normal, tilted_cases()),
}
