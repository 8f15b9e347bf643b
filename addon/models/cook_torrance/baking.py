"""From a measured material to the parameters of Cook and Torrance's model."""

import numpy as np

from ...bake import bake
from ...bake.baking import FORMULAS, conductor_of_curve
from ...bake.colour import lab, rgb_to_xyz, space_to_space
from ...bake.fit import largest_delta_e
from ...bake.gamut import map_colours
from ...bake.reflected import ANGLES, AT_NORMAL, COMPARED, Viewing, reflect
from ...reflectance import fresnel
from ..model import Baked, Look
from ..realisations import REALISATIONS
from .formulas import dyed
from .parameters import CookTorrance

__all__ = ["bake_for", "diffuse_colour", "facts", "look", "native_fresnel", "respaced"]

FAR_OFF = 1.0
"""CIEDE2000 from which a conductor's fit is given up where F82 comes closer."""

BY_CONDUCTOR, BY_F82 = 0, 1
"""Variants of a realisation: which closure evaluates F."""

SPECULAR = "specular"
"""Of a preset's diffuse colour: it is the normal reflectance of the specular part."""


def bake_for(resolved, viewing, realisation, renderer):
    """The Baked of a measured material for one realisation.

    resolved     an addon.catalogue.resolving.Resolved; without constants its parameters are all there is
    viewing      options of :func:`addon.bake.bake`: illuminant, observer, space, adapt, gamut
    realisation  a name of addon.models.realisations.REALISATIONS
    renderer     a Renderer: whose conductor Fresnel n and k are fitted for

    The formulas take the exact equation.  So does F82, which native closures
    take for a dielectric where Blender 4.5's conductor misses it by several
    CIEDE2000.
    """
    if resolved.constants is None:
        return _as_stated(resolved.preset, realisation, renderer)
    baked, variant = _fitted(resolved, viewing, realisation, renderer)
    found = facts(resolved, baked)
    diffuse = tuple(min(max(channel, 0.0), 1.0) for channel in found["diffuse_rgb"])
    parameters = {**_own(resolved), "n": baked.conductor.n, "k": baked.conductor.k, "diffuse": diffuse}
    return Baked(parameters, found, variant)


def _as_stated(preset, realisation, renderer):
    """The Baked of a preset whose n, k and diffuse colour are given, for linear Rec.709; here in another space.

    n and k stay what they are, whatever the renderer evaluates: its conductor or F82, which comes closer.
    """
    stated = dict(preset.parameters)
    surface = CookTorrance(**stated)
    if renderer.space != "Rec.709":
        diffuse = space_to_space("Rec.709", renderer.space) @ surface.diffuse
        stated["diffuse"] = tuple(np.clip(diffuse, 0.0, 1.0).tolist())
        stated.update(respaced(surface, {"n", "k"}, "Rec.709", renderer.space))
        surface = CookTorrance(**stated)
    variant = BY_CONDUCTOR
    if REALISATIONS[realisation].native and renderer.formula != "exact":
        variant, _ = native_fresnel(np.array(surface.n), np.array(surface.k), renderer)
    facts_ = {"name": preset.name, "title": preset.title, "kind": preset.kind, "note": preset.note}
    return Baked(stated, facts_, variant)


def native_fresnel(n, k, renderer):
    """(variant, function of (cos θ, n, k)): the closure whose curve is closer to the exact one of n and k."""
    c = ANGLES[COMPARED, None]
    exact = lab(fresnel.conductor(c, n, k), renderer.space)
    curves = {BY_CONDUCTOR: FORMULAS[renderer.formula], BY_F82: _by_f82}
    off = {variant: largest_delta_e(curve(c, n, k), exact, renderer.space) for variant, curve in curves.items()}
    variant = BY_CONDUCTOR if off[BY_CONDUCTOR] <= off[BY_F82] else BY_F82
    return variant, curves[variant]


def _by_f82(cos_theta, n, k):
    f0 = fresnel.conductor(1.0, n, k)
    tint = fresnel.f82_tint_of(f0, fresnel.conductor(fresnel.COS_THETA_82, n, k))
    return fresnel.f82(cos_theta, np.clip(f0, 0.0, 1.0), np.clip(tint, 0.0, 1.0))


def facts(resolved, baked):
    """All that was baked: the Bake, and what the preset says of the surface, ready for JSON."""
    stated = _own(resolved)
    surface = CookTorrance(**{name: value for name, value in stated.items() if name != "diffuse"}).to_dict()
    return {**baked.to_dict(), "diffuse_rgb": list(diffuse_colour(stated.get("diffuse", SPECULAR), baked)),
            **{name: surface[name] for name in ("specular", "slopes", "distribution")}}


def _own(resolved):
    """The preset's parameters that are this model's: it may have moved to another since a file was saved."""
    known = CookTorrance.__dataclass_fields__
    return {name: value for name, value in resolved.preset.parameters.items() if name in known}


def _fitted(resolved, viewing, realisation, renderer):
    """(Bake, variant) of the closure that comes closest."""
    exact = bake(resolved, **viewing, formula="exact")
    if not REALISATIONS[realisation].native:
        return exact, BY_CONDUCTOR
    native = exact if renderer.formula == "exact" else bake(resolved, **viewing, formula=renderer.formula)
    by_f82 = native.best == "f82" and native.conductor.delta_e_2000_max > FAR_OFF
    return (exact, BY_F82) if by_f82 else (native, BY_CONDUCTOR)


def diffuse_colour(source, baked):
    """π·Rd in the space of a Bake, ``(3,)``.

    source  "specular", the normal reflectance of the Bake; the id of a dataset whose normal reflectance it is;
            or three linear Rec.709 numbers

    Cook and Torrance 1982, section "The reflectance model".

    >>> [round(x, 3) for x in diffuse_colour("main/Cu/Johnson", bake("vinyl"))]
    [0.932, 0.623, 0.522]
    """
    if source == SPECULAR:
        return baked.normal_rgb
    viewing = Viewing(baked.illuminant, baked.observer, baked.space, baked.adapted, baked.gamut.method,
                      baked.medium)
    if isinstance(source, str):
        rgb = reflect(source, viewing).colours[AT_NORMAL]
    else:
        rgb = np.linalg.solve(rgb_to_xyz(viewing.space), rgb_to_xyz("Rec.709") @ np.array(source, float))
    return tuple(viewing.map(rgb)[0].tolist())


def respaced(parameters, changed, before, after):
    """{"n": …, "k": …} in another space, where someone changed either: the pair whose curve looks most like theirs.

    parameters  a CookTorrance
    changed     names of what was changed
    """
    if not {"n", "k"} & changed:
        return {}
    n, k = np.array(parameters.n), np.array(parameters.k)
    rgb = fresnel.conductor(ANGLES[:, None], n, k) @ space_to_space(before, after).T
    new = conductor_of_curve(map_colours(rgb, "nearest", after)[0], n, k, after)
    return {"n": new.n, "k": new.k}


def look(parameters):
    """The Look of a CookTorrance: normal reflectance and diffuse colour, by their shares."""
    p, s = parameters, parameters.specular
    n, k, normal_reflectance = dyed(p)
    f0 = fresnel.conductor(1.0, n, k)
    diffuse = (1.0 - s) * normal_reflectance
    return Look(s * f0 + diffuse, f0, s, p.slopes[0][0], diffuse)
