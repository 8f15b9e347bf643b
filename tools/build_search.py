"""Builds the tables that lists and the search read: addon/spectra/data/catalogue.table and search.table.

    python tools/build_search.py [OUTPUT_FOLDER]

Of presets.json, names.json and the database's table; to be run whenever one of these changes: build_tables.py does it
too.
"""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from addon.catalogue import presets  # noqa: E402
from addon.catalogue.entries import size_of, stated  # noqa: E402
from addon.catalogue.search import line_of, notes_of, tags_of, words_of  # noqa: E402
from addon.models import names as models  # noqa: E402
from addon.spectra import names, tables  # noqa: E402

OF_MAKERS = {"glass", "popular_glass", "specs", "3d"}
"""Shelves whose pages are products, not authors."""
SHELVES = ("main", "other", "organic", "glass", "3d", "popular_glass", "specs")


def build(folder):
    """Write both tables; return how many materials and datasets they hold."""
    _, index, values = tables.read("refractiveindex")
    version = {"version": tables.about("refractiveindex")["version"], "licence": "CC0-1.0",
               "tool": "tools/build_search.py"}
    records = sorted(index["records"], key=lambda record: SHELVES.index(record[0].split("/")[0]))
    citations = {record[0]: (record[1], index["citations"][record[2]]) for record in records}
    everything = presets.all_presets().values()
    about = {"title": "What lists show and search of all presets",
             "source": "presets.json, names.json, refractiveindex.table"}
    tables.pack(folder / "catalogue.table", about | version, {
        "models": {model: size_of(model) for model in models()},
        "entries": {"rows": [stated(preset) for preset in everything]},
        "lines": {"texts": [line_of(preset.title, preset.aliases, tags_of(preset)) for preset in everything]},
        "notes": {"texts": [notes_of(preset, cited(preset.dataset, citations)) for preset in everything]}})
    about = {"title": "What the search reads of datasets, by shelf", "source": "names.json, refractiveindex.table"}
    found, called, rest = map(list, zip(*(of_dataset(record, index, values) for record in records)))
    tables.pack(folder / "search.table", about | version, {
        "ids": {"ids": [record[0] for record in records]}, "found": found, "names": called, "rest": rest})
    return len(everything), len(records)


def cited(dataset, citations):
    """The words of a dataset: its id, title and citation; () without one."""
    return (" ".join(dataset.split("/")[1:]), *citations[dataset]) if dataset else ()


def of_dataset(record, index, values):
    """What is shown of a dataset's record, the words of its material's names, and all others."""
    dataset, title, citation, comment, _, k_model = record
    k = values[k_model[2]:k_model[2] + k_model[3]].mean() if k_model else 0.0
    found = [names.title_of(dataset, title), names.kind_of(dataset, k), covers_visible(record)]
    shelf, book, page = dataset.split("/", 2)
    called = words([*names.material_names(dataset), page if shelf in OF_MAKERS else "", book])
    others = words([page, title, comment, index["citations"][citation]])
    return found, f" {' '.join(called)} ", f" {' '.join(word for word in others if word not in called)} "


def words(texts):
    """The words of some texts, each once."""
    return dict.fromkeys(word for text in texts for word in words_of(text))


def covers_visible(record):
    """Whether 400 to 700 nm were measured."""
    ranges = [model[-2:] for model in record[4:6] if model]
    return max(low for low, _ in ranges) <= 400.0 and min(high for _, high in ranges) >= 700.0


if __name__ == "__main__":
    print("{} materials, {} datasets".format(*build(pathlib.Path(*sys.argv[1:]) if sys.argv[1:] else tables.DIRECTORY)))
