"""The words of the shell's commands."""

import argparse

from . import commands as work

__all__ = ["parser"]

MATERIAL = "PRESET|SHELF/BOOK/PAGE|FILE"


def parser():
    """The parser of all commands; each sets `run`, a function of the options that gives text, or (text, status)."""
    parser = argparse.ArgumentParser(
        prog="facet_film",
        description="Measured metals and layered films: colours and parameters for Cycles.")
    commands = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")

    command = _command(commands, "list", work.list_command, "list the presets, finishes or illuminants")
    command.add_argument("what", nargs="?", choices=("presets", "finishes", "illuminants"),
                         default="presets", help="presets (the default), finishes or illuminants")

    command = _command(commands, "bake", work.bake_command, "colours over angle and fitted parameters of a material",
                       _add_forms)
    command.add_argument("material", metavar=MATERIAL,
                         help="a preset, a dataset of the database, or a file of your own measurements")
    _add_viewing_options(command)
    _add_surface_options(command)
    _add_choose_option(command)
    _add_formula_option(command)
    command.add_argument("--from-normal-reflectance", action="store_true",
                         help="from the normal reflectance alone, k = 0 (Cook and Torrance 1982)")

    command = _command(commands, "swatch", work.swatch_command,
                       "colours over the angle, of films over thickness, of clear bodies over depth", _add_picture)
    command.add_argument("material", metavar=MATERIAL, help="a material, or a stack of films in words")
    _add_viewing_options(command)
    _add_choose_option(command)

    command = _command(commands, "search", work.search_command,
                       "search presets and datasets by material, author, formula or name")
    command.add_argument("text", nargs="+", help="words, as in: gold babar")
    command.add_argument("--limit", type=int, default=25, metavar="N", help="show at most N (25)")

    command = _command(commands, "check", work.check_command,
                       "how far n and k, F0 and F82 tint, or a material are from a measured material")
    command.add_argument("material", nargs="?", metavar=MATERIAL, help="a material to check")
    for name, what in (("--n", "index of refraction"), ("--k", "extinction coefficient")):
        command.add_argument(name, nargs=3, type=float, metavar=("R", "G", "B"), help=f"{what}, RGB")
    for name, what in (("--f0", "reflectance at normal incidence"), ("--tint", "F82 tint")):
        command.add_argument(name, nargs="+", metavar="COLOUR",
                             help=f"{what}: three linear numbers, three from 0 to 255 as sRGB has them, or '#ffd98b'")
    command.add_argument("--against", required=True, metavar=MATERIAL,
                         help="the measured material")
    _add_viewing_options(command)
    _add_choose_option(command)
    _add_formula_option(command)

    command = _command(commands, "spread", work.spread_command, "all measurements of a material side by side")
    command.add_argument("material", metavar="PRESET|SHELF/BOOK/PAGE|WORD", help="a material")
    _add_viewing_options(command, gamut=False)

    command = _command(commands, "ways", work.ways_command,
                       "the 1982 paper's ways to a colour over angle beside the exact one")
    command.add_argument("material", metavar=MATERIAL, help="a material")
    _add_viewing_options(command, gamut=False)
    _add_choose_option(command)

    command = _command(commands, "fit", work.fit_command, "fit a model to a measured BRDF, and say how well it does")
    command.add_argument("file", metavar="FILE", help=".bsdf of RGL-EPFL (isotropic, RGB), .binary of MERL, or points "
                         "as text: θi φi θo φo and red green blue")
    command.add_argument("--fresnel", default="best", metavar="NAME",
                         help="best (the default), f0, n_k, or curve, which changes colour with the angle")
    command.add_argument("--slopes", type=int, default=2, metavar="N", help="1 to 3 slopes of facets (2)")
    command.add_argument("--distribution", default="beckmann", metavar="NAME",
                         help="beckmann (the default) or gaussian")
    command.add_argument("--picture", metavar="FILE.png", help="measured and fitted ball, side by side")

    command = _command(commands, "verify", work.verify_command, "render every model and realisation in this Blender "
                       "and hold the pixels against the formulas", _add_report)
    command.add_argument("--device", default="CPU", metavar="NAME",
                         help="CPU (the default); GPU: what the preferences switch on; or CUDA, OPTIX, HIP, METAL, "
                              "ONEAPI")
    command.add_argument("--only", metavar="GROUP", help="one model's name, or data")
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


def _add_picture(command):
    _add_json(command)
    command.add_argument("-o", "--output", metavar="FILE", help="write them as a strip, a PNG file")


def _add_viewing_options(command, gamut=True):
    command.add_argument("--illuminant", default="D65", metavar="NAME",
                         help="A, D50, D65, E, F2, LED-B3, … (D65)")
    command.add_argument("--observer", default="1931", metavar="YEAR",
                         help="1931 (2 degrees) or 1964 (10 degrees)")
    command.add_argument("--space", default="Rec.709", metavar="NAME", help="Rec.709, Rec.2020 or ACEScg")
    command.add_argument("--adapt", action="store_true", help="adapt the eye to the illuminant (Bradford)")
    if gamut:
        command.add_argument("--gamut", default=argparse.SUPPRESS, metavar="METHOD",
                             help="for colours outside: nearest, unless told otherwise; desaturate, scale, clip, leave")
        command.add_argument("--medium", default=argparse.SUPPRESS, metavar="N|NAME",
                             help="what the surface is in: an index such as 1.33, or a clear material such as water")


def _add_surface_options(command):
    """Of the surface, in place of the preset's own."""
    command.add_argument("--finish", default=argparse.SUPPRESS, metavar="NAME",
                         help="what was done to the surface, as brushed: see list finishes")
    for name, what in (("--roughness", "0 to 1, the root of the rms slope m"),
                       ("--anisotropy", "0 to below 1: slopes longer along the tangent than across it"),
                       ("--rotation", "0 to 1 turns of the tangent")):
        command.add_argument(name, type=float, default=argparse.SUPPRESS, metavar="X", help=what)
    command.add_argument("--tint", type=float, nargs=3, default=argparse.SUPPRESS, metavar=("R", "G", "B"),
                         help="dyes what metals and the diffuse part reflect")


def _add_choose_option(command):
    command.add_argument("--choose", action="append", default=[], metavar="NAME",
                         help="of a file that holds or can mean several things: which, as its message names them")


def _add_formula_option(command):
    command.add_argument("--formula", default="exact", metavar="NAME",
                         help="conductor formula of n and k: exact (Blender 5.0 and later) or blender-4.5")
