"""Granier and Heidrich 2003: interference and colour separation in a thin layer whose boundaries need not
be parallel.
"""

from ..model import Form, Group, Model
from .parameters import THICKNESS_GROUP, LayeredRGB

__all__ = ["MODEL"]


def _evaluate(parameters, n, v, l):
    from .formulas import evaluate
    return evaluate(parameters, n, v, l)


def _bake(resolved, viewing, realisation, renderer):
    from .baking import bake_for
    return bake_for(resolved, renderer.space)


def _respaced(parameters, changed, before, after):
    from .spacing import respaced
    return respaced(parameters, changed, before, after)


def _look(parameters, place=None):
    from .baking import look
    return look(parameters, place)


def _feeds(parameters):
    from .baking import feeds
    return feeds(parameters)


def _read_feed(fed):
    from .baking import read_feed
    return read_feed(LayeredRGB.TABLE, fed)


def _write_form(_form, record):
    from ...export import json_text
    return json_text(record.to_dict())


MODEL = Model(
    package=__name__,
    title="Layered RGB",
    summary="Interference and colour separation in a thin layer (Granier and Heidrich)",
    citation='X. Granier, W. Heidrich, "A Simple Layered RGB BRDF Model", Graphical Models 65(4), 2003',
    parameters=LayeredRGB,
    groups=(
        Group("layered_rgb_fast", "Layered RGB Standard", 7, "fast.build",
              "A thin layer after Granier and Heidrich, clean and fast, in Cycles and in EEVEE: the one to take first"),
        Group("layered_rgb_exact", "Layered RGB Reference", 4, "exact.build",
              "The published formula of Granier and Heidrich 2003 itself: slower and noisier, to compare with",
              stand_in="layered_rgb_fast"),
        Group("layered_rgb_osl", "Layered RGB OSL", 3, "osl.build",
              "The published formula of Granier and Heidrich 2003 as an OSL script, to read beside the paper",
              stand_in="layered_rgb_fast", osl=True),
        Group("layered_rgb_osl_fast", "Layered RGB OSL Standard", 3, "osl.build_fast",
              "Layered RGB by four native lobes, as an OSL script",
              stand_in="layered_rgb_fast", osl=True, in_menu=False),
        Group(THICKNESS_GROUP, "Layer Thickness", 2, "thickness.build",
              "Thickness in nanometres that varies over the surface, and the lower normal tilted along it"),
    ),
    realisations={
        "fast": ("layered_rgb_fast",),
        "exact": ("layered_rgb_exact",),
        "osl": ("layered_rgb_osl",),
        "osl_fast": ("layered_rgb_osl_fast",),
    },
    evaluate=_evaluate,
    bake=_bake,
    baked_names=("ior", "wavelengths"),
    respaced=_respaced,
    look=_look,
    feeds=_feeds,
    read_feed=_read_feed,
    forms={"json": Form("JSON", "Every parameter", ".json")},
    write_form=_write_form,
)
