"""The door for shells: ``python -m addon list``, ``bake copper`` …  Needs numpy, not Blender.

Inside Blender the same commands are ``blender --command facet_film …``.
"""

import argparse
import json
import sys

from .errors import FacetFilmError

__all__ = ["main"]


def main(argv):
    """Run one command; the exit status: 0, or 2 with one sentence on stderr for input that cannot be used.

    argv  the words after the program's name

    >>> main(["bake", "coper"])
    2
    """
    try:
        options = _parser().parse_args(argv)
    except SystemExit as end:  # argparse has said why
        return end.code or 0
    try:
        print(options.run(options))
    except FacetFilmError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    except BrokenPipeError:  # the reader has had enough, as in `… | head`
        sys.stderr.close()
    return 0


def _parser():
    parser = argparse.ArgumentParser(
        prog="facet_film", description="Measured metals and layered films: colours and parameters for Cycles.")
    commands = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")

    command = _command(commands, "list", _list, "list the presets")
    command.add_argument("--json", action="store_true", help="as JSON")

    command = _command(commands, "bake", _bake, "colours over angle and fitted parameters of a material")
    command.add_argument("material", metavar="PRESET|SHELF/BOOK/PAGE", help="a preset, or a dataset of the database")
    command.add_argument("--json", action="store_true", help="as JSON")
    _add_bake_options(command)
    return parser


def _command(commands, name, run, summary):
    command = commands.add_parser(name, help=summary, description=summary[0].upper() + summary[1:] + ".")
    command.set_defaults(run=run)
    return command


def _add_bake_options(command):
    command.add_argument("--illuminant", default="D65", metavar="NAME", help="A, D50, D65, E, F2, LED-B3, … (D65)")
    command.add_argument("--observer", default="1931", metavar="YEAR", help="1931 (2 degrees) or 1964 (10 degrees)")
    command.add_argument("--space", default="Rec.709", metavar="NAME", help="Rec.709, Rec.2020 or ACEScg")
    command.add_argument("--adapt", action="store_true", help="adapt the eye to the illuminant (Bradford)")
    command.add_argument("--gamut", default="desaturate", metavar="METHOD", help="desaturate, scale, clip or leave")
    command.add_argument("--formula", default="exact", metavar="NAME",
                         help="conductor formula to fit for: exact (Blender 5.0 and later) or blender-4.5")
    command.add_argument("--from-normal-reflectance", action="store_true",
                         help="from the normal reflectance alone, k = 0 (Cook and Torrance 1982)")


def _bake_options(options):
    return {name: getattr(options, name) for name in (
        "illuminant", "observer", "space", "adapt", "gamut", "formula", "from_normal_reflectance")}


def _list(options):
    from .spectra import presets
    found = presets.all_presets().values()
    if options.json:
        return _json([{"name": p.name, "title": p.title, "kind": p.kind, "dataset": p.dataset,
                       "aliases": list(p.aliases)} for p in found])
    return _columns([(p.name, p.title, p.kind, p.dataset) for p in found])


def _bake(options):
    from .bake import bake
    baked = bake(options.material, **_bake_options(options))
    return _json(baked.to_dict()) if options.json else table(baked)


def table(baked):
    """A bake as a table that a person can read.

    baked  a Bake
    """
    low, high = baked.source.wavelength_range_nm
    rows = [
        ("", "red", "green", "blue"),
        ("F0", *_numbers(baked.f0)),
        ("F82 tint", *_numbers(baked.f82_tint)),
        ("n", *_numbers(baked.conductor.n)),
        ("k", *_numbers(baked.conductor.k)),
    ]
    facts = [
        ("dataset", f"{baked.source.dataset}, {low:.0f} to {high:.0f} nm, {baked.source.licence}"),
        ("citation", baked.source.citation),
        ("colour", f"{baked.space}, illuminant {baked.illuminant}, observer {baked.observer}"
                   + (", adapted" if baked.adapted else "")),
        ("fit", f"n and k ({baked.conductor.formula}) within {baked.conductor.delta_e_2000_max:.3f} CIEDE2000 "
                f"from 0 to 89°, F82 within {baked.f82.delta_e_2000_max:.3f}"),
        ("curve", f"{len(baked.fresnel.cos_theta)} points"),
        ("gamut", _gamut(baked.gamut)),
    ]
    return "\n".join([baked.title, _columns(rows, indent="  "), _columns(facts, indent="  ")])


def _gamut(gamut):
    if not gamut.outside:
        return "inside"
    return f"outside: {gamut.method}, channels changed by up to {gamut.largest_change:.3f}"


def _numbers(values):
    return [f"{value:.4f}" for value in values]


def _columns(rows, indent=""):
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]) - 1)]
    return "\n".join(
        indent + "  ".join([*(cell.ljust(width) for cell, width in zip(row, widths)), row[-1]]) for row in rows)


def _json(value):
    return json.dumps(value, ensure_ascii=False, indent=1)
