"""Films that interfere: stacks of measured layers, computed over the spectrum, tabled over angle and thickness."""

from ..model import Form, Group, Model
from .parameters import ANODISING_GROUP, HEAT_TINT_GROUP, THICKNESS_GROUP, Film

__all__ = ["MODEL"]


def _evaluate(parameters, n, v, l, tangent=None):
    from .formulas import evaluate
    return evaluate(parameters, n, v, l, tangent)


def _bake(resolved, viewing, realisation, renderer):
    from .baking import bake_for
    return bake_for(resolved, viewing, renderer)


def _look(parameters, place=None):
    from .baking import look
    return look(parameters, place)


def _work_ahead(resolved, viewing, progress):
    from .tables import table_of, track_of
    stated = resolved.preset.parameters
    table_of(stated["stack"], viewing, own=stated.get("own_layers", ""), progress=progress)
    track_of(stated["stack"], viewing, own=stated.get("own_layers", ""))


def _no_longer(parameters, baked):
    from .baking import no_longer
    return no_longer(parameters, baked)


def _picture(parameters, viewing):
    from .tables import picture
    return picture(parameters, viewing)


def _feeds(parameters):
    from .feeds import feeds
    return feeds(parameters)


def _read_feed(fed):
    from .feeds import read_feed
    return read_feed(fed)


def _write_form(form, record):
    from .forms import write_form
    return write_form(form, record)


def _swatch(record, columns):
    from .swatch import swatch
    return swatch(record, columns)


def _standin(record):
    from .forms import standin
    return standin(record)


MODEL = Model(
    package=__name__,
    title="Film",
    summary="Interference in stacks of measured layers, over the whole spectrum",
    citation="F. Abelès, \"Recherches sur la propagation des ondes électromagnétiques sinusoïdales dans les milieux "
             "stratifiés\", Annales de Physique 12(5), 1950, on the facets of R. L. Cook and K. E. Torrance, 1982",
    parameters=Film,
    groups=(
        Group("film_fast", "Film Standard", 11, "fast.build",
              "Films of measured layers, clean and fast: the one to take first",
              stand_in="film_eevee", pictured=True),
        Group("film_exact", "Film Reference", 13, "exact.build",
              "Films of measured layers, at the angle of every facet: slower and noisier, to compare with",
              stand_in="film_eevee", pictured=True),
        Group("film_osl", "Film OSL", 5, "osl.build",
              "Films of measured layers by an OSL script, to read: the formula at the angle of every facet",
              stand_in="film_eevee", osl=True, pictured=True),
        Group("film_eevee", "Film EEVEE", 8, "fast.build_eevee",
              "Stacks of films by one native closure, for EEVEE", in_menu=False, pictured=True),
        Group(THICKNESS_GROUP, "Film Thickness", 3, "thickness.build",
              "Thickness in nanometres that varies by noise, a gradient or a texture"),
        Group(ANODISING_GROUP, "Film Anodising", 2, "thickness.build_anodising",
              "Thickness in nanometres of the oxide that a voltage grows on a metal"),
        Group(HEAT_TINT_GROUP, "Film Heat Tint", 2, "thickness.build_heat_tint",
              "Thickness in nanometres of the oxide that heat grows on a metal"),
    ),
    realisations={"fast": ("film_fast",), "exact": ("film_exact",), "osl": ("film_osl",)},
    evaluate=_evaluate,
    bake=_bake,
    look=_look,
    baked_names=("stack", "own_layers"),
    feeds=_feeds,
    read_feed=_read_feed,
    forms={
        "json": Form("JSON", "Everything that was baked", ".json"),
        "csv": Form("CSV of the Curve", "Colour over angle: cos_theta, r, g, b", ".csv"),
        "materialx": Form("MaterialX", "open_pbr_surface and a conductor_bsdf with a thin film", ".mtlx"),
    },
    write_form=_write_form,
    swatch=_swatch,
    fits={"curve": "fits.Curve"},
    standin=_standin,
    refracts=lambda parameters: parameters.see_through > 0.0 and parameters.ior_below > 1.0,
    sheet=lambda parameters: parameters.see_through > 0.0 and parameters.ior_below == 1.0,
    made_of="stack",
    own_data="own_layers",
    picture=_picture,
    newcomers=True,
    work_ahead=_work_ahead,
    no_longer=_no_longer,
)
