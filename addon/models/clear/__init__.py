"""Glass, liquids, gems and clear polymers: refraction by a measured index, absorption through the body."""

from ..model import Form, Group, Model
from .parameters import Clear

__all__ = ["MODEL"]


def _evaluate(parameters, n, v, l):
    from .formulas import evaluate
    return evaluate(parameters, n, v, l)


def _bake(resolved, viewing, realisation, renderer):
    from .baking import bake_for
    return bake_for(resolved, viewing)


def _look(parameters, place=None):
    from .baking import look
    return look(parameters)


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
    title="Clear",
    summary="Glass, liquids, gems: refraction and absorption as measured",
    citation="M. Born, E. Wolf, Principles of Optics, 7th edition, 1999",
    parameters=Clear,
    groups=(
        Group("clear_fast", "Clear Standard", 7, "fast.build",
              "Glass, liquids and gems of one index of refraction, coloured by the way through them",
              stand_in="clear_eevee"),
        Group("clear_dispersive", "Clear Dispersive", 8, "dispersive.build",
              "Glass and gems with the colours of the rainbow, each refracted by its own index",
              stand_in="clear_eevee"),
        Group("clear_eevee", "Clear EEVEE", 4, "fast.build_eevee", "What EEVEE shows of clear materials",
              in_menu=False),
    ),
    realisations={"fast": ("clear_fast",), "dispersive": ("clear_dispersive",)},
    evaluate=_evaluate,
    bake=_bake,
    look=_look,
    baked_names=("ior", "cauchy_b", "cauchy_c", "absorption"),
    follows={"outside": "medium"},
    forms={"json": Form("JSON", "Everything that was baked", ".json"),
           "materialx": Form("MaterialX", "open_pbr_surface", ".mtlx")},
    write_form=_write_form,
    swatch=_swatch,
    standin=_standin,
    measured=True,
    refracts=lambda parameters: True,
    index="ior",
    index_outside="outside",
    sheet=lambda parameters: parameters.walls == "thin",
)
