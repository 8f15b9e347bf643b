"""Cook and Torrance 1982: facets with a rms slope, the Fresnel reflectance of a measured material, a diffuse part."""

from ..model import Form, Group, Model
from .parameters import CookTorrance

__all__ = ["MODEL"]


def _evaluate(parameters, n, v, l, tangent=None):
    from .formulas import evaluate
    return evaluate(parameters, n, v, l, tangent)


def _bake(resolved, viewing, realisation, renderer):
    from .baking import bake_for
    return bake_for(resolved, viewing, realisation, renderer)


def _facts(resolved, baked):
    from .baking import facts
    return facts(resolved, baked)


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


def _respaced(parameters, changed, before, after):
    from .baking import respaced
    return respaced(parameters, changed, before, after)


def _as_baked(parameters, facts):
    """Whether n and k are still those that were fitted, under whatever tint."""
    found, baked = (*parameters.n, *parameters.k), (*facts["conductor"]["n"], *facts["conductor"]["k"])
    return all(abs(a - b) <= 1e-5 * max(1.0, abs(b)) for a, b in zip(found, baked))


MODEL = Model(
    package=__name__,
    title="Cook–Torrance",
    summary="Facets with rms slope m, conductor Fresnel, diffuse part (1982)",
    citation='R. L. Cook, K. E. Torrance, "A Reflectance Model for Computer Graphics", ACM Transactions on Graphics '
             "1(1), 1982",
    parameters=CookTorrance,
    groups=(
        Group("cook_torrance_fast", "Cook-Torrance Standard", 11, "fast.build",
              "Metals, plastics and stone, clean and fast, in Cycles and in EEVEE: the one to take first"),
        Group("cook_torrance_fast_f82", "Cook-Torrance Standard F82", 11, "fast.build_f82",
              "Cook-Torrance Standard for plastics and stone in Blender 4.5, whose own formula for metals misses them",
              in_menu=False),
        Group("cook_torrance_exact", "Cook-Torrance Reference", 10, "exact.build",
              "The published formula of Cook and Torrance 1982 itself: slower and noisier, to compare with",
              stand_in="cook_torrance_fast"),
        Group("cook_torrance_osl", "Cook-Torrance OSL", 12, "osl.build",
              "The published formula of Cook and Torrance 1982 as an OSL script, to read beside the paper",
              stand_in="cook_torrance_fast", osl=True),
        Group("cook_torrance_osl_fast", "Cook-Torrance OSL Standard", 12, "osl.build_fast",
              "Cook-Torrance Standard as an OSL script", stand_in="cook_torrance_fast", osl=True, in_menu=False),
    ),
    realisations={
        "fast": ("cook_torrance_fast", "cook_torrance_fast_f82"),
        "exact": ("cook_torrance_exact",),
        "osl": ("cook_torrance_osl",),
        "osl_fast": ("cook_torrance_osl_fast",),
    },
    evaluate=_evaluate,
    facts=_facts,
    bake=_bake,
    look=_look,
    as_baked=_as_baked,
    baked_names=("n", "k", "diffuse"),
    respaced=_respaced,
    forms={
        "json": Form("JSON", "Everything that was baked", ".json"),
        "csv": Form("CSV of the Curve", "Colour over angle: cos_theta, r, g, b", ".csv"),
        "spectrum_csv": Form("CSV of the Spectrum", "The measured points: wavelength_nm, n, k", ".csv"),
        "materialx": Form("MaterialX", "conductor_bsdf, generalized_schlick_bsdf and open_pbr_surface", ".mtlx"),
    },
    write_form=_write_form,
    swatch=_swatch,
    fits={"f0": "fits.NormalReflectance", "n_k": "fits.IndexAndExtinction"},
    standin=_standin,
    measured=True,
)
