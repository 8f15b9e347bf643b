"""What people call the materials of the database: chemical, mineral, trade and everyday names."""

import functools
import json
import pathlib
import re

__all__ = ["material_names", "title_of", "kind_of", "METALS"]

FILE = pathlib.Path(__file__).parent / "data" / "names.json"
METALS = {
    "Ag": "silver", "Al": "aluminium aluminum", "Au": "gold", "Ba": "barium", "Be": "beryllium",
    "Bi": "bismuth", "Ca": "calcium", "Cd": "cadmium", "Ce": "cerium", "Co": "cobalt",
    "Cr": "chromium chrome", "Cs": "caesium cesium", "Cu": "copper", "Dy": "dysprosium",
    "Er": "erbium", "Eu": "europium", "Fe": "iron", "Ga": "gallium", "Gd": "gadolinium",
    "Hf": "hafnium", "Hg": "mercury quicksilver", "In": "indium", "Ir": "iridium", "K": "potassium",
    "La": "lanthanum", "Li": "lithium", "Lu": "lutetium", "Mg": "magnesium", "Mn": "manganese",
    "Mo": "molybdenum", "Na": "sodium", "Nb": "niobium", "Nd": "neodymium", "Ni": "nickel",
    "Os": "osmium", "Pb": "lead", "Pd": "palladium", "Pt": "platinum", "Rb": "rubidium",
    "Re": "rhenium", "Rh": "rhodium", "Ru": "ruthenium", "Sb": "antimony", "Sc": "scandium",
    "Sn": "tin", "Sr": "strontium", "Ta": "tantalum", "Tb": "terbium", "Th": "thorium",
    "Ti": "titanium", "Tl": "thallium", "Tm": "thulium", "V": "vanadium", "W": "tungsten wolfram",
    "Y": "yttrium", "Yb": "ytterbium", "Zn": "zinc", "Zr": "zirconium",
}
"""Names of the metallic elements; the first is the one shown."""

OTHER_ELEMENTS = {
    "Ar": "argon", "As": "arsenic", "B": "boron", "Br": "bromine", "C": "carbon", "Cl": "chlorine",
    "D": "deuterium", "F": "fluorine", "Ge": "germanium", "H": "hydrogen", "He": "helium", "I": "iodine",
    "Kr": "krypton", "N": "nitrogen", "Ne": "neon", "O": "oxygen", "P": "phosphorus", "S": "sulphur sulfur",
    "Se": "selenium", "Si": "silicon", "Te": "tellurium", "Xe": "xenon",
}
ELEMENTS = {**METALS, **OTHER_ELEMENTS}
GASES = {"Ar", "D2", "H2", "He", "Kr", "N2", "Ne", "O2", "Xe", "CO2", "NH3", "SF6", "air",
         "methane", "ethane", "ethylene", "acetylene"}

ANIONS = {
    "As": "arsenide", "B": "boride", "Br": "bromide", "C": "carbide", "Cl": "chloride", "F": "fluoride",
    "H": "hydride", "I": "iodide", "N": "nitride", "O": "oxide", "P": "phosphide", "S": "sulphide sulfide",
    "Sb": "antimonide", "Se": "selenide", "Te": "telluride",
}
COUNTED = {"O", "S", "Se", "Te"}
"""Anions that people count: titanium dioxide, but calcium fluoride."""
NO_FORMULAS = {"PBS"}
PREFIXES = {1: "mono", 2: "di", 3: "tri", 4: "tetra", 5: "penta", 6: "hexa", 8: "octa"}
OXYANIONS = {
    "Al": "aluminate", "B": "borate", "C": "carbonate", "Ge": "germanate", "I": "iodate", "Mo": "molybdate",
    "Nb": "niobate", "P": "phosphate", "Si": "silicate", "Ta": "tantalate", "Ti": "titanate", "V": "vanadate",
    "W": "tungstate",
}

RAYS = {"o": "ordinary ray", "e": "extraordinary ray"}
ALLOYS = {"Au-Ag", "Cu-Zn", "Ni-Fe", "AuAl2", "PtAl2", "stainless_steel", "Pd-H", "V-Ga", "V-H", "Zr-H"}


def material_names(dataset):
    """Names of a dataset's material, ``shelf/book/page``; the first is the one to show.

    >>> material_names("main/TiO2/Devore-o")
    ('Titanium dioxide', 'titania', 'rutile', 'anatase', 'titanium white', 'titanium oxide')
    >>> material_names("main/Cu/Johnson")
    ('Copper',)
    """
    shelf, book, page = dataset.split("/", 2)
    if shelf == "3d":
        found = common_names(page)
    elif shelf == "specs":
        maker, _, use = book.partition("-")
        sort = "index liquid" if maker == "Cargille" else "glass" if use == "misc" else f"{use} glass"
        found = [f"{maker} {page.replace('_', ' ').replace(maker + '-', '')} {sort}"]
    elif shelf == "popular_glass":
        found = [f"{page} {book} glass"]
    else:
        found = common_names(book)
        if shelf == "glass" and "glass" not in found[0]:
            found.append("glass")
    unique = dict.fromkeys(name for name in found if name)
    first, *rest = unique
    return (first[0].upper() + first[1:], *rest)


def title_of(dataset, database_title):
    """What to show for a dataset: its material, who measured it, and what tells it from others of theirs.

    >>> title_of("main/Fe2O3/Querry-o", "Querry 1985: α-Fe2O3 (Hematite); n,k(o) 0.21–55.6 µm")
    'Iron oxide, Querry 1985, α-Fe2O3 (Hematite), ordinary ray'
    """
    author, colon, rest = database_title.partition(": ")
    if not colon:
        return material_names(dataset)[0]
    details = [piece.strip() for piece in rest.split(";") if not re.match(r"\s*(n|k|n,\s*k)\b[^;]*µm", piece)]
    ray = re.search(r"\((o|e|α|β|γ)\)", rest)
    if ray:
        details.append(RAYS.get(ray[1], f"{ray[1]} axis"))
    return ", ".join([material_names(dataset)[0], author, *filter(None, details)])


def common_names(book):
    """Names of a book of the database: what people say, then what chemists say, then the book's own.

    >>> common_names("Fe2O3")
    ['iron oxide', 'haematite', 'hematite', 'rust', 'ferric oxide', 'diiron trioxide']
    """
    names = list(dict.fromkeys(_everyday_names().get(book, []) + chemical_names(book)))
    return names or [book.replace("_", " ")]


@functools.lru_cache(maxsize=1)
def _everyday_names():
    """Mineral, trade and everyday names by formula, book or page, the one to show first."""
    return json.loads(FILE.read_text(encoding="utf-8"))


def chemical_names(formula):
    """Systematic names of an element or compound, the usual one first; none where it is no formula.

    >>> chemical_names("TiO2"), chemical_names("LiNbO3"), chemical_names("Au-Ag")
    (['titanium dioxide', 'titanium oxide'], ['lithium niobate'], [])
    """
    parts = re.findall(r"([A-Z][a-z]?)(\d*)", formula)
    symbols = [symbol for symbol, _ in parts]
    known = all(symbol in ELEMENTS for symbol in symbols) and len(set(symbols)) == len(symbols)
    if not known or formula in NO_FORMULAS or "".join(map("".join, parts)) != formula:
        return []
    counts = [int(count or 1) for _, count in parts]
    if len(parts) == 1:
        return ELEMENTS[symbols[0]].split()
    if len(parts) == 2 and symbols[1] in ANIONS:
        return _binary(symbols, counts)
    if symbols[-1] == "O" and symbols[-2] in OXYANIONS:
        metals = " ".join(ELEMENTS[symbol].split()[0] for symbol in symbols[:-2])
        return [f"{metals} {OXYANIONS[symbols[-2]]}"]
    head = " ".join(ELEMENTS[symbol].split()[0] for symbol in symbols[:-1])
    last = ANIONS.get(symbols[-1], ELEMENTS[symbols[-1]]).split()
    return [f"{head} {name}" for name in last]


def _binary(symbols, counts):
    """Names of two elements: "titanium dioxide", "titanium oxide"; "iron oxide", "diiron trioxide"."""
    first, second = ELEMENTS[symbols[0]].split(), ANIONS[symbols[1]].split()
    plain = [f"{a} {b}" for a in first for b in second]
    if counts == [1, 1] or counts[1] not in PREFIXES or counts[0] not in PREFIXES:
        return plain
    head = "" if counts[0] == 1 else PREFIXES[counts[0]]
    counted = [f"{head}{a} {PREFIXES[counts[1]]}{b}" for a in first for b in second]
    counted = [re.sub("[ao]oxide", "oxide", name) for name in counted]
    return counted + plain if counts[0] == 1 and symbols[1] in COUNTED else plain + counted


def kind_of(dataset, k):
    """What sort of material: "metal", "gas", "glass", "liquid", "organic", else by k.

    k makes it a "conductor" from 1, an "absorber" from 0.01, below a "dielectric".

    dataset  "shelf/book/page"
    k        mean extinction coefficient in the visible

    >>> kind_of("main/Cu/Johnson", 2.6), kind_of("main/SiO2/Malitson", 0.0)
    ('metal', 'dielectric')
    """
    shelf, book, page = (dataset.split("/", 2) + ["", ""])[:3]
    if book in METALS or book in ALLOYS or (shelf == "3d" and book == "metals"):
        return "metal"
    if book in GASES:
        return "gas"
    if book == "Cargille":
        return "liquid"
    if shelf in {"specs", "glass", "popular_glass"} or book == "glass":
        return "glass"
    if shelf == "organic":
        return "organic"
    return "conductor" if k >= 1.0 else "absorber" if k >= 0.01 else "dielectric"
