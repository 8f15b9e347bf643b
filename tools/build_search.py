"""Builds addon/spectra/data/search.table, the index that the search reads, from the presets and the database's table.

    python tools/build_search.py [OUTPUT_FOLDER]

To be run whenever presets.json or names.json change; build_tables.py does it too.
"""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from addon.catalogue import presets  # noqa: E402
from addon.catalogue.search import index_line  # noqa: E402
from addon.spectra import names, tables  # noqa: E402

SHELVES = ("main", "other", "organic", "glass", "3d", "popular_glass", "specs")


def build(folder):
    """Write search.table; return how many materials it holds."""
    _, index, values = tables.read("refractiveindex")
    datasets = {record[0]: record for record in index["records"]}
    materials = [of_preset(preset, datasets.get(preset.dataset), index) for preset in presets.all_presets().values()]
    for record in sorted(datasets.values(), key=lambda record: SHELVES.index(record[0].split("/")[0])):
        materials.append(of_dataset(record, index, values))
    about = {"title": "What the search reads: presets, then datasets by shelf",
             "source": "presets.json, names.json, refractiveindex.table",
             "version": tables.about("refractiveindex")["version"], "licence": "CC0-1.0",
             "tool": "tools/build_search.py"}
    found, words = map(list, zip(*materials))
    tables.pack(folder / "search.table", about, {"found": found, "words": words, "presets": {"names": presets.names()}})
    return len(materials)


def of_preset(preset, record, index):
    """(what addon.catalogue.search.Found holds, its words) of a preset with its dataset's record, if it has one."""
    constants = None if record else presets.constants(preset)
    covers = covers_visible(record) if record else constants is None or constants.covers_visible
    found = [preset.name, preset.title, preset.kind, preset.dataset, True, covers]
    named = [preset.name, preset.title, preset.kind, *preset.aliases]
    others = [preset.note, preset.estimated]
    if record is not None:
        named += [*names.material_names(preset.dataset), *preset.dataset.split("/")[1:]]
        others = [record[1], preset.note, index["citations"][record[2]]]
    return found, index_line(named, others, [preset.name, preset.title, *preset.aliases])


def of_dataset(record, index, values):
    """The same of a dataset's record."""
    dataset, title, citation, comment, _, k_model = record
    k = values[k_model[2]:k_model[2] + k_model[3]].mean() if k_model else 0.0
    found = [dataset, names.title_of(dataset, title), names.kind_of(dataset, k), dataset, False, covers_visible(record)]
    named = [*names.material_names(dataset), *dataset.split("/")[1:]]
    return found, index_line(named, [title, comment, index["citations"][citation]])


def covers_visible(record):
    """Whether 400 to 700 nm were measured."""
    ranges = [model[-2:] for model in record[4:6] if model]
    return max(low for low, _ in ranges) <= 400.0 and min(high for _, high in ranges) >= 700.0


if __name__ == "__main__":
    print(f"{build(pathlib.Path(*sys.argv[1:]) if sys.argv[1:] else tables.DIRECTORY)} materials")
