"""Builds catalogue.json: every preset as numbers that any renderer can use, with its error and its source.

    python tools/build_data.py [--out dist] [--only NAME ...]

Its form is docs/catalogue.schema.json.  The same presets and tables give the same bytes.  Needs no Blender.
"""

import argparse
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from addon.bake.srgb import hex_of  # noqa: E402
from addon.catalogue import presets  # noqa: E402
from addon.export import json_text  # noqa: E402
from addon.export.swatch_picture import swatch_hex  # noqa: E402
from addon.models import named  # noqa: E402
from addon.models.making import made  # noqa: E402

FORMAT = 1
"""Of the JSON; raised where a reader of the old one would be misled."""
SPACES = ("Rec.709", "ACEScg")
COLOURS = 32
"""Of a swatch."""
NUMBERS = ("f0", "f82_tint", "conductor", "ior", "abbe", "attenuation", "stack", "table")
"""What a bake may have found that other renderers take."""
LICENCE = "CC0-1.0"


def catalogue(names=()):
    """The whole of it, ready for JSON.

    names  of presets; all where there are none
    """
    manifest = tomllib.loads((ROOT / "blender_manifest.toml").read_text(encoding="utf-8"))
    return {"format": FORMAT, "version": manifest["version"], "licence": LICENCE,
            "viewing": {"illuminant": "D65", "observer": "1931"},
            "materials": [entry(preset) for preset in presets.all_presets().values()
                          if not names or preset.name in names]}


def entry(preset):
    """One material, ready for JSON.

    >>> found = entry(presets.find("copper"))
    >>> found["category"], found["srgb"], [round(x, 3) for x in found["spaces"]["Rec.709"]["f0"]]
    ('metal', '#f7cfbf', [0.932, 0.623, 0.522])
    """
    records = {space: made(preset=preset.name, viewing={"space": space}) for space in SPACES}
    record = records["Rec.709"]
    model = named(record.model)
    swatch = model.swatch and model.swatch(record, COLOURS)
    return {
        "name": preset.name, "title": preset.title, "category": preset.category, "model": record.model,
        "aliases": list(preset.aliases), "variant_of": preset.variant_of,
        "note": preset.note, "estimated": preset.estimated, "sources": _sources(record),
        "srgb": hex_of(model.look(record.parameters, None).colour),
        "parameters": record.parameters.to_dict(),
        "spaces": {space: {name: one.baked[name] for name in NUMBERS if name in one.baked}
                   for space, one in records.items() if record.measured},
        "swatch": swatch and {"over": swatch.over, "unit": swatch.unit, "first": float(swatch.places[0]),
                              "last": float(swatch.places[-1]), "srgb": swatch_hex(swatch)},
        "delta_e_2000_max": largest_error(record.baked)}


def largest_error(baked):
    """The largest CIEDE2000 of what was baked from the spectrum, or None where there is no spectrum.

    >>> largest_error({"conductor": {"delta_e_2000_max": 0.1}}), largest_error({"table": {"size": [64, 1]}})
    (0.1, None)
    """
    return next((baked[name]["delta_e_2000_max"] for name in ("conductor", "attenuation", "table")
                 if "delta_e_2000_max" in baked.get(name, ())), None)


def _sources(record):
    """What it was measured by: dataset, citation and licence each."""
    baked = record.baked
    found = [baked["source"]] if "source" in baked else baked.get("layers", ())
    return [{key: source[key] for key in ("dataset", "citation", "licence")} for source in found
            if "/" in source["dataset"]]


def main():
    """Write the file."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=ROOT / "dist", help="folder (dist)")
    parser.add_argument("--only", nargs="+", default=(), metavar="NAME", help="these presets")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    path = options.out / "catalogue.json"
    found = catalogue(options.only)
    path.write_text(json_text(found), encoding="utf-8")
    print(f"{path}: {len(found['materials'])} materials, {path.stat().st_size / 1024:.0f} KiB")


if __name__ == "__main__":
    main()
