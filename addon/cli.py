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

    command = _command(commands, "search", _search, "search presets and datasets by material, author, formula or name")
    command.add_argument("text", nargs="+", help="words, as in: gold babar")
    command.add_argument("--limit", type=int, default=25, metavar="N", help="show at most N (25)")
    command.add_argument("--json", action="store_true", help="as JSON")

    command = _command(commands, "check", _check,
                       "how far n and k, F0 and F82 tint, or a material are from a measured material")
    command.add_argument("material", nargs="?", metavar="PRESET|SHELF/BOOK/PAGE", help="a material to check")
    for name, what in (("--n", "index of refraction"), ("--k", "extinction coefficient"),
                       ("--f0", "reflectance at normal incidence"), ("--tint", "F82 tint")):
        command.add_argument(name, nargs=3, type=float, metavar=("R", "G", "B"), help=f"{what}, RGB")
    command.add_argument("--against", required=True, metavar="PRESET|SHELF/BOOK/PAGE", help="the measured material")
    command.add_argument("--json", action="store_true", help="as JSON")
    _add_viewing_options(command)
    _add_formula_option(command)

    command = _command(commands, "spread", _spread, "all measurements of a material side by side")
    command.add_argument("material", metavar="PRESET|SHELF/BOOK/PAGE|WORD", help="a material")
    command.add_argument("--json", action="store_true", help="as JSON")
    _add_viewing_options(command, gamut=False)

    command = _command(commands, "ways", _ways, "the 1982 paper's ways to a colour over angle beside the exact one")
    command.add_argument("material", metavar="PRESET|SHELF/BOOK/PAGE", help="a material")
    command.add_argument("--json", action="store_true", help="as JSON")
    _add_viewing_options(command, gamut=False)
    return parser


def _command(commands, name, run, summary):
    command = commands.add_parser(name, help=summary, description=summary[0].upper() + summary[1:] + ".")
    command.set_defaults(run=run)
    return command


def _add_viewing_options(command, gamut=True):
    command.add_argument("--illuminant", default="D65", metavar="NAME", help="A, D50, D65, E, F2, LED-B3, … (D65)")
    command.add_argument("--observer", default="1931", metavar="YEAR", help="1931 (2 degrees) or 1964 (10 degrees)")
    command.add_argument("--space", default="Rec.709", metavar="NAME", help="Rec.709, Rec.2020 or ACEScg")
    command.add_argument("--adapt", action="store_true", help="adapt the eye to the illuminant (Bradford)")
    if gamut:
        command.add_argument("--gamut", default="desaturate", metavar="METHOD",
                             help="for colours outside: desaturate, scale, clip or leave")


def _add_formula_option(command):
    command.add_argument("--formula", default="exact", metavar="NAME",
                         help="conductor formula of n and k: exact (Blender 5.0 and later) or blender-4.5")


def _add_bake_options(command):
    _add_viewing_options(command)
    _add_formula_option(command)
    command.add_argument("--from-normal-reflectance", action="store_true",
                         help="from the normal reflectance alone, k = 0 (Cook and Torrance 1982)")


def _given(options, *names):
    """The options of these names that the command has, as keywords."""
    return {name: getattr(options, name) for name in names if hasattr(options, name)}


VIEWING = ("illuminant", "observer", "space", "adapt", "gamut")


def _list(options):
    from .spectra import presets
    found = presets.all_presets().values()
    if options.json:
        return _json([{"name": p.name, "title": p.title, "kind": p.kind, "dataset": p.dataset,
                       "aliases": list(p.aliases)} for p in found])
    return _columns([(p.name, p.title, p.kind, p.dataset) for p in found])


def _bake(options):
    from .bake import bake
    baked = bake(options.material, **_given(options, *VIEWING, "formula", "from_normal_reflectance"))
    return _json(baked.to_dict()) if options.json else table(baked)


def _search(options):
    from .errors import number
    from .spectra.search import search
    number("--limit", options.limit, 1)
    text = " ".join(options.text)
    found = search(text, options.limit)
    if options.json:
        return _json([vars(entry) for entry in found])
    if not found:
        raise FacetFilmError(f"Nothing fits {text!r}; try a material, an author or a formula, such as 'gold babar'.")
    return _columns([(entry.id, entry.title, entry.kind, "" if entry.covers_visible else "part of the visible only")
                     for entry in found])


def _check(options):
    from .bake import check
    checked = check(options.against, preset=options.material,
                    **_given(options, *VIEWING, "formula", "n", "k", "f0", "tint"))
    if options.json:
        return _json(checked.to_dict())
    rows = [("", "red", "green", "blue")]
    for title, ours, theirs in (("F0", checked.f0, checked.against_f0), ("F82", checked.f82, checked.against_f82),
                                ("F82 tint", checked.f82_tint, checked.against_f82_tint)):
        rows += [(title, *_numbers(ours)), ("  measured", *_numbers(theirs))]
    curve = [("cos", "red", "green", "blue")]
    curve += [(f"{c:.3f}", *_numbers(rgb)) for c, rgb in zip(checked.fresnel.cos_theta, checked.fresnel.rgb)]
    return "\n".join([
        f"{checked.given} against {checked.against} ({checked.dataset}), {_colour(checked)}",
        _columns(rows, indent="  "),
        f"  CIEDE2000 {checked.delta_e_2000_normal:.2f} at 0°, at most {checked.delta_e_2000_max:.2f} "
        f"(at {checked.at_degrees:.0f}°)",
        "  curve", _columns(curve, indent="    ")])


def _spread(options):
    from .bake import spread
    found = spread(options.material, **_given(options, *VIEWING))
    if options.json:
        return _json(found.to_dict())
    rows = [("dataset", "F0 red", "green", "blue", "CIEDE2000 at 0°", "at most", "")]
    rows += [(m.dataset, *_numbers(m.f0), f"{m.delta_e_2000_normal:.2f}", f"{m.delta_e_2000_max:.2f}", m.title)
             for m in found.measurements]
    return "\n".join([
        f"{found.material}, {len(found.measurements)} measurements, differences from {found.reference}, {_colour(found)}",
        _columns(rows, indent="  "),
        f"  farthest apart: {found.farthest[0]} and {found.farthest[1]}, "
        f"CIEDE2000 {found.farthest_delta_e_2000:.2f} at 0°"])


def _ways(options):
    from .bake import ways
    found = ways(options.material, **_given(options, *VIEWING))
    if options.json:
        return _json(found.to_dict())
    shown = (0, 30, 60, 75, 80, 85, 89)
    rows = [("", "", *(f"{angle}°" for angle in shown))]
    for way in found.ways:
        for channel, name in enumerate(("red", "green", "blue")):
            rows.append((way.title if channel == 0 else "", name,
                         *(f"{way.rgb[angle][channel]:.3f}" for angle in shown)))
    errors = [(way.title, f"CIEDE2000 at most {way.delta_e_2000_max:.2f} (at {way.at_degrees:.0f}°)")
              for way in found.ways[1:]]
    return "\n".join([f"{found.title} ({found.dataset}), {_colour(found)}", _columns(rows, indent="  "),
                      "  from exact", _columns(errors, indent="    ")])


def _colour(found):
    return f"{found.space}, illuminant {found.illuminant}, observer {found.observer}"


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
        ("dataset", f"{baked.source.dataset}, {low:.0f} to {high:.0f} nm, {baked.source.licence}"
                    + ("" if baked.source.covers_visible else "; held beyond, where the visible goes on")),
        ("citation", baked.source.citation),
        ("colour", _colour(baked) + (", adapted" if baked.adapted else "")),
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
