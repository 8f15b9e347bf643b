"""A film for other programs: what its node holds now, in the light that it was baked in."""

import numpy as np

from ... import export
from ...bake import bake
from ...bake.colour import delta_e_2000, lab
from ...bake.film_colours import exact_colours
from ...bake.reflected import Viewing
from ...bake.stack_notation import parse
from ...bake.standin_fit import COS_THETA, fit_metal, fit_mirror
from ...catalogue.resolving import layers_in
from ...export import json_text
from ...export.standin import LOST, Standin
from ..moving import moved
from ..standins import standin_of
from .formulas import slope
from .tables import ABSORBING, stack_of, table_of

__all__ = ["standin", "write_form"]


ANGLES = 91


def write_form(form, record):
    """The text of a form: "json", "materialx", or "csv" of the exact curve over angle at the material's thickness."""
    if form == "materialx":
        here = moved(record)
        said = f"{record.title}; {record.parameters.stack}"
        return export.materialx_of_standin(record.baked["name"], said, standin_of(record), film=_film_on_a_metal(here))
    if form == "json":
        return json_text(record.to_dict())
    cosines, rgb = _curve(record)
    rows = [f"{c:.6f}," + ",".join(f"{x:.6f}" for x in colour) for c, colour in zip(cosines, rgb)]
    return "\n".join(["cos_theta,r,g,b", *rows]) + "\n"


def standin(record):
    """The Standin: a metal with the film's colours over the angle; what is seen through as one sheet of one film."""
    p = record.parameters
    if p.see_through > 0.5:
        film = _one_film(record)
        film = film if film and film[1] >= 1.0 else None
        ior = max(float(_index(stack_of(p.stack, p.own_layers).below_constants)), 1.0)
        return Standin((1.0, 1.0, 1.0), roughness=p.roughness, ior=ior, transmission=1.0, thin_walled=True, film=film,
                       delta_e=(_off(record, film, ior),) * 2, lost=(LOST["field"],) if p.thickness_range else ())
    table = table_of(p.stack, record.viewing, own=p.own_layers)
    mirror, tint = np.clip(table.at(COS_THETA, _thickness(p)), 0.0, 1.0), np.array(p.tint)
    seen = tint * (p.specular * mirror + (1.0 - p.specular) * np.array(p.diffuse))
    lost = (LOST["film"], LOST["field"]) if p.thickness_range else (LOST["film"],)
    surface = {"roughness": p.roughness, "anisotropy": p.anisotropy, "rotation": p.rotation, "lost": lost}
    if p.specular < 1.0:
        fit = fit_metal(seen, p.specular)
        return Standin(fit.base, fit.beside[0], specular=0.0, delta_e=(fit.delta_e_mean,) * 2, **surface)
    fit, alone = fit_mirror(seen), fit_mirror(seen, with_edge=False)
    return Standin(fit.base, 1.0, edge=fit.beside, base_alone=alone.base,
                   delta_e=(fit.delta_e_mean, alone.delta_e_mean), **surface)


def _film_on_a_metal(record):
    """(n, k, m, thickness in nm, index) of one film on what absorbs, or None for other stacks."""
    p, below = record.parameters, stack_of(record.parameters.stack, record.parameters.own_layers).below_constants
    film = _one_film(record)
    if film is None or p.see_through > 0.0 or float(np.asarray(below.at(550.0)[1]).ravel()[0]) < ABSORBING:
        return None
    metal = bake(below, **record.viewing).conductor
    return metal.n, metal.k, float(slope(p.roughness)), *film


def _one_film(record):
    """(thickness in nm, n at the d line) of a stack of one film, or None."""
    films = stack_of(record.parameters.stack, record.parameters.own_layers).films
    if len(films) != 1:
        return None
    return float(_thickness(record.parameters)), float(_index(films[0].constants))


def _index(constants):
    """n at the d line."""
    return np.asarray(constants.at(587.56)[0]).ravel()[0]


def _off(record, film, ior):
    """Mean CIEDE2000 over a ball's angles of what a clear sheet of one film reflects, its indices constant."""
    p, light = record.parameters, Viewing(**record.viewing)
    stack = parse(f"{film[1]:.6g} {film[0]:.6g} nm / {ior:.6g}" if film else f"{ior:.6g}", layers_in(""))
    shown = exact_colours(stack, light, COS_THETA, stack.thickness_range_nm[0])
    exact = table_of(p.stack, record.viewing, own=p.own_layers).at(COS_THETA, _thickness(p))
    return float(delta_e_2000(lab(exact, light.space), lab(np.clip(shown, 0.0, 1.0), light.space)).mean())


def _curve(record):
    p, cosines = record.parameters, np.cos(np.radians(np.linspace(90.0, 0.0, ANGLES)))
    return cosines, table_of(p.stack, record.viewing, own=p.own_layers).at(cosines, _thickness(p))


def _thickness(parameters):
    """The middle of what varies."""
    return parameters.thickness if parameters.thickness_range is None else sum(parameters.thickness_range) / 2.0
