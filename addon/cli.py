"""The door for shells: ``python -m addon list``, ``bake copper`` …  Needs numpy, not Blender.

Inside Blender the same commands are ``blender --command facet_film …``.
"""

import argparse
import json
import os
import sys

from . import cli_text
from .errors import FacetFilmError, number

__all__ = ["main"]

MATERIAL = "PRESET|SHELF/BOOK/PAGE|FILE"
VIEWING = ("illuminant", "observer", "space", "adapt", "gamut")


def main(argv):
    """Run one command; the exit status: 0, or 2 with one sentence on stderr for input that cannot be used.

    A verification that is not green ends with 1.

    argv  the words after the program's name

    >>> main(["bake", "coper"])
    2
    """
    try:
        options = _parser().parse_args(argv)
    except SystemExit as end:  # argparse has said why
        return end.code or 0
    try:
        result = options.run(options)
        text, status = result if isinstance(result, tuple) else (result, 0)
        print(text, flush=True)
    except FacetFilmError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    except BrokenPipeError:  # the reader has had enough, as in `… | head`
        sys.stderr.close()
        return 0
    return status


def _parser():
    parser = argparse.ArgumentParser(
        prog="facet_film",
        description="Measured metals and layered films: colours and parameters for Cycles.")
    commands = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")

    command = _command(commands, "list", _list, "list the presets, or the illuminants")
    command.add_argument("what", nargs="?", choices=("presets", "illuminants"), default="presets",
                         help="presets (the default) or illuminants")

    command = _command(commands, "bake", _bake, "colours over angle and fitted parameters of a material",
                       _add_forms)
    command.add_argument("material", metavar=MATERIAL,
                         help="a preset, a dataset of the database, or a file of your own measurements")
    _add_viewing_options(command)
    _add_formula_option(command)
    command.add_argument("--from-normal-reflectance", action="store_true",
                         help="from the normal reflectance alone, k = 0 (Cook and Torrance 1982)")

    command = _command(commands, "search", _search,
                       "search presets and datasets by material, author, formula or name")
    command.add_argument("text", nargs="+", help="words, as in: gold babar")
    command.add_argument("--limit", type=int, default=25, metavar="N", help="show at most N (25)")

    command = _command(commands, "check", _check,
                       "how far n and k, F0 and F82 tint, or a material are from a measured material")
    command.add_argument("material", nargs="?", metavar=MATERIAL, help="a material to check")
    for name, what in (("--n", "index of refraction"), ("--k", "extinction coefficient"),
                       ("--f0", "reflectance at normal incidence"), ("--tint", "F82 tint")):
        command.add_argument(name, nargs=3, type=float, metavar=("R", "G", "B"), help=f"{what}, RGB")
    command.add_argument("--against", required=True, metavar=MATERIAL,
                         help="the measured material")
    _add_viewing_options(command)
    _add_formula_option(command)

    command = _command(commands, "spread", _spread, "all measurements of a material side by side")
    command.add_argument("material", metavar="PRESET|SHELF/BOOK/PAGE|WORD", help="a material")
    _add_viewing_options(command, gamut=False)

    command = _command(commands, "ways", _ways,
                       "the 1982 paper's ways to a colour over angle beside the exact one")
    command.add_argument("material", metavar=MATERIAL, help="a material")
    _add_viewing_options(command, gamut=False)

    command = _command(commands, "verify", _verify, "render every model and realisation in this Blender and hold the "
                       "pixels against the formulas", _add_report)
    command.add_argument("--device", default="CPU", metavar="NAME",
                         help="CPU (the default), or GPU: what the preferences switch on")
    command.add_argument("--only", metavar="GROUP", help="cook_torrance, layered_rgb or data")
    return parser


def _command(commands, name, run, summary, add_forms=None):
    command = commands.add_parser(name, help=summary, description=summary[0].upper() + summary[1:] + ".")
    command.set_defaults(run=run)
    (add_forms or _add_json)(command)
    return command


def _add_json(command):
    command.add_argument("--json", action="store_true", help="as JSON")


def _add_report(command):
    command.add_argument("-o", "--output", default="facet_film_verification.html", metavar="FILE",
                         help="the report, one HTML page (facet_film_verification.html)")
    command.add_argument("--json", metavar="FILE", help="the same as JSON")


def _add_forms(command):
    """The forms that a bake is written in; one at a time."""
    forms = command.add_mutually_exclusive_group()
    _add_json(forms)
    for name, what in (("--csv", "the colour over angle as CSV: cos_theta, r, g, b"),
                       ("--spectrum-csv", "the measured spectrum as CSV: wavelength_nm, n, k"),
                       ("--materialx", "as MaterialX: conductor_bsdf, generalized_schlick_bsdf")):
        forms.add_argument(name, action="store_true", help=what)
    command.add_argument("-o", "--output", metavar="FILE", help="write into a file, in place of showing it")


def _add_viewing_options(command, gamut=True):
    command.add_argument("--illuminant", default="D65", metavar="NAME",
                         help="A, D50, D65, E, F2, LED-B3, … (D65)")
    command.add_argument("--observer", default="1931", metavar="YEAR",
                         help="1931 (2 degrees) or 1964 (10 degrees)")
    command.add_argument("--space", default="Rec.709", metavar="NAME", help="Rec.709, Rec.2020 or ACEScg")
    command.add_argument("--adapt", action="store_true", help="adapt the eye to the illuminant (Bradford)")
    if gamut:
        command.add_argument("--gamut", default="desaturate", metavar="METHOD",
                             help="for colours outside: desaturate, scale, clip or leave")


def _add_formula_option(command):
    command.add_argument("--formula", default="exact", metavar="NAME",
                         help="conductor formula of n and k: exact (Blender 5.0 and later) or blender-4.5")


def _given(options, *names):
    """The options of these names that the command has, as keywords."""
    return {name: getattr(options, name) for name in names if hasattr(options, name)}


def _list(options):
    if options.what == "illuminants":
        from .spectra import illuminants
        titles = {name: illuminants.title(name) for name in illuminants.names()}
        return _json(titles) if options.json else cli_text.illuminants(titles)
    from .spectra import presets
    found = presets.all_presets().values()
    if options.json:
        return _json([{"name": p.name, "title": p.title, "kind": p.kind, "dataset": p.dataset,
                       "aliases": p.aliases, "estimated": p.estimated} for p in found])
    return cli_text.presets(found)


def _bake(options):
    from .bake import bake
    from .export import write_text
    what = _material(options.material)
    baked = bake(what, **_given(options, *VIEWING, "formula", "from_normal_reflectance"))
    text = _form(options, what, baked)
    if options.output is None:
        return text
    return "Wrote " + write_text(options.output, text + "\n")


def _form(options, what, baked):
    """A bake in the form that was asked for."""
    from . import export
    from .bake.reflected import material
    if options.json:
        return export.bake_json(baked).rstrip()
    if options.csv:
        return export.curve_csv(baked).rstrip()
    if options.spectrum_csv:
        return export.spectrum_csv(material(what)[1]).rstrip()
    if options.materialx:
        return export.materialx(baked).rstrip()
    return cli_text.baked(baked)


def _material(word):
    """A preset's name or a dataset's id as it is; the OpticalConstants in a file of that name."""
    from .bake.reflected import material
    from .spectra import readers
    if word is None:
        return None
    if word.lower().endswith(readers.SUFFIXES):
        return readers.read_file(word)
    if not os.path.isfile(word):
        return word
    try:
        material(word)  # what has a material's name is that material, whatever lies in the folder
        return word
    except FacetFilmError:
        return readers.read_file(word)


def _search(options):
    from .spectra.search import search
    number("--limit", options.limit, 1)
    text = " ".join(options.text)
    found = search(text, options.limit)
    if options.json:
        return _json([vars(entry) for entry in found])
    if not found:
        raise FacetFilmError(
            f"Nothing fits {text!r}; try a material, an author or a formula, such as 'gold babar'.")
    return cli_text.found(found)


def _check(options):
    from .bake import check
    checked = check(_material(options.against), preset=_material(options.material),
                    **_given(options, *VIEWING, "formula", "n", "k", "f0", "tint"))
    return _json(checked.to_dict()) if options.json else cli_text.checked(checked)


def _spread(options):
    from .bake import spread
    found = spread(options.material, **_given(options, *VIEWING))
    return _json(found.to_dict()) if options.json else cli_text.spread(found)


def _ways(options):
    from .bake import ways
    found = ways(_material(options.material), **_given(options, *VIEWING))
    return _json(found.to_dict()) if options.json else cli_text.ways(found)


def _verify(options):
    from .verify import verify
    green, text = verify(options.output, device=options.device, only=options.only, record=options.json,
                         say=lambda line: print(line, flush=True))
    return text, 0 if green else 1


def _json(value):
    return json.dumps(value, ensure_ascii=False, indent=1)
