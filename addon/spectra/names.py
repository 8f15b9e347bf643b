"""What people call the materials of the database: chemical, mineral, trade and everyday names."""

import re

__all__ = ["material_names", "title_of", "kind_of", "METALS"]

METALS = {
    "Ag": "silver", "Al": "aluminium aluminum", "Au": "gold", "Ba": "barium", "Be": "beryllium", "Bi": "bismuth",
    "Ca": "calcium", "Cd": "cadmium", "Ce": "cerium", "Co": "cobalt", "Cr": "chromium chrome",
    "Cs": "caesium cesium", "Cu": "copper", "Dy": "dysprosium", "Er": "erbium", "Eu": "europium", "Fe": "iron",
    "Ga": "gallium", "Gd": "gadolinium", "Hf": "hafnium", "Hg": "mercury quicksilver", "In": "indium",
    "Ir": "iridium", "K": "potassium", "La": "lanthanum", "Li": "lithium", "Lu": "lutetium", "Mg": "magnesium",
    "Mn": "manganese", "Mo": "molybdenum", "Na": "sodium", "Nb": "niobium", "Nd": "neodymium", "Ni": "nickel",
    "Os": "osmium", "Pb": "lead", "Pd": "palladium", "Pt": "platinum", "Rb": "rubidium", "Re": "rhenium",
    "Rh": "rhodium", "Ru": "ruthenium", "Sb": "antimony", "Sc": "scandium", "Sn": "tin", "Sr": "strontium",
    "Ta": "tantalum", "Tb": "terbium", "Th": "thorium", "Ti": "titanium", "Tl": "thallium", "Tm": "thulium",
    "V": "vanadium", "W": "tungsten wolfram", "Y": "yttrium", "Yb": "ytterbium", "Zn": "zinc", "Zr": "zirconium",
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

COMMON = {
    # main: minerals, gems, pigments, trade names
    "Ag3AsS3": "silver arsenic sulphide, proustite", "Al2O3": "aluminium oxide, alumina, sapphire, corundum, ruby", "As2S3": "arsenic trisulphide, orpiment",
    "BaB2O4": "barium borate, BBO", "BaTiO3": "barium titanate", "BeAl2O4": "beryllium aluminate, chrysoberyl, alexandrite",
    "Bi4Ge3O12": "bismuth germanate, BGO", "C": "carbon, diamond, graphite, graphene, soot, fullerene", "CaCO3": "calcium carbonate, calcite, lime, chalk",
    "CaF2": "calcium fluoride, fluorite, fluorspar", "CaWO4": "calcium tungstate, scheelite", "CO2": "carbon dioxide", "CS2": "carbon disulphide",
    "CuCl": "copper chloride, nantokite", "D2O": "heavy water", "Fe2O3": "iron oxide, haematite, hematite, rust, ferric oxide",
    "Fe3O4": "magnetite, iron oxide", "Ge2Sb2Te5": "GST, phase change material", "GaAs": "gallium arsenide", "H2O": "water, ice",
    "HgS": "mercury sulphide, cinnabar, vermilion", "InP": "indium phosphide", "KH2PO4": "potassium dihydrogen phosphate, KDP",
    "KCl": "potassium chloride, sylvite", "KTiOPO4": "potassium titanyl phosphate, KTP", "LiB3O5": "lithium triborate, LBO",
    "LiNbO3": "lithium niobate", "MgAl2O4": "spinel", "MgF2": "magnesium fluoride, sellaite",
    "MgO": "magnesium oxide, periclase, magnesia", "MoS2": "molybdenum disulphide, molybdenite", "NaCl": "sodium chloride, salt, halite, table salt", "NH3": "ammonia",
    "NH4H2PO4": "ammonium dihydrogen phosphate, ADP", "PbS": "galena", "SF6": "sulphur hexafluoride",
    "Si3N4": "silicon nitride", "SiC": "silicon carbide, carborundum, moissanite", "SiO2": "silicon dioxide, silica, quartz, fused silica, quartz glass",
    "SnO2": "cassiterite", "SrTiO3": "strontium titanate, tausonite", "Tb3Ga5O12": "terbium gallium garnet, TGG",
    "TeO2": "tellurium dioxide, paratellurite", "TiN": "titanium nitride", "TiO2": "titanium dioxide, titania, rutile, anatase, titanium white",
    "Lu3Al5O12": "lutetium aluminium garnet, LuAG", "Y3Al5O12": "yttrium aluminium garnet, YAG",
    "ZnO": "zinc oxide, zincite, zinc white", "ZnS": "zinc sulphide, sphalerite, zinc blende", "ZrO2": "zirconium dioxide, zirconia, cubic zirconia",
    "BN": "boron nitride", "B4C": "boron carbide", "Te": "tellurium", "VO2": "vanadium dioxide",
    "YVO4": "yttrium orthovanadate", "YLiF4": "yttrium lithium fluoride, YLF",
    # other: alloys, mixtures, tissues, resists
    "Au-Ag": "gold-silver alloy, electrum, white gold, green gold", "Cu-Zn": "brass, copper-zinc alloy",
    "Ni-Fe": "nickel-iron alloy, permalloy, invar", "AuAl2": "purple gold, amethyst gold",
    "PtAl2": "platinum aluminide, yellow platinum", "stainless_steel": "stainless steel, inox",
    "In2O3-SnO2": "indium tin oxide, ITO", "Al-ZnO": "aluminium zinc oxide, AZO", "Si-Ge": "silicon germanium",
    "ZrO2-Y2O3": "yttria stabilised zirconia, YSZ", "Bombyx_mori": "silk, mulberry silk",
    "Antheraea_assamensis": "silk, muga silk", "Antheraea_mylitta": "silk, tussar silk",
    "Samia_ricini": "silk, eri silk", "biodisel": "biodiesel", "Kapton": "polyimide, Kapton",
    "D2O-C3H5_OH_3": "heavy water and glycerol", "H2O-C3H5_OH_3": "water and glycerol",
    "CH3NH3PbBr3": "perovskite, methylammonium lead bromide", "CH3NH3PbCl3": "perovskite, methylammonium lead chloride",
    "CH3NH3PbI3": "perovskite, methylammonium lead iodide", "CsPbBr3": "perovskite, caesium lead bromide",
    "5CB": "liquid crystal, 5CB", "E7": "liquid crystal, E7", "PEDOT-PSS": "conductive polymer, PEDOT:PSS",
    "PBS": "phosphate buffered saline", "DNA": "DNA, deoxyribonucleic acid", "air": "air, atmosphere",
    "C8H8_n-C3H3N_m": "styrene acrylonitrile, SAN", "NAS-21": "styrene methyl methacrylate, NAS-21",
    "ZeonexE48R": "cyclic olefin polymer, COP, Zeonex", "Optorez1330": "acrylic resin, Optorez",
    "EVASKY_S87": "ethylene vinyl acetate, EVA", "EVASKY_S88": "ethylene vinyl acetate, EVA",
    # organic
    "polyvinil_chloride": "polyvinyl chloride, PVC, vinyl",
    "poly_methyl_methacrylate": "poly(methyl methacrylate), PMMA, acrylic, acrylic glass, plexiglass, perspex",
    "polycarbonate": "polycarbonate, PC, lexan, makrolon", "polystyrene": "polystyrene, PS, styrofoam",
    "polydimethylsiloxane": "polydimethylsiloxane, PDMS, silicone, silicone rubber",
    "polyethylene_terephthalate": "polyethylene terephthalate, PET, polyester, mylar",
    "polyetherimide": "polyetherimide, PEI, ultem", "polylactic_acid": "polylactic acid, PLA",
    "polyvinyl_alcohol": "polyvinyl alcohol, PVA", "polyvinylpyrrolidone": "polyvinylpyrrolidone, PVP",
    "cellulose": "cellulose, paper, cotton, cellophane", "ethanol": "ethanol, alcohol", "methanol": "methanol, alcohol",
    "glycerol": "glycerol, glycerine", "toluene": "toluene, solvent", "oleic_acid": "oleic acid, oil",
    "propanol": "propanol, isopropanol, rubbing alcohol",
    "2D_HOIP": "hybrid perovskite, 2D", "rhodamine_6g": "rhodamine 6G, dye",
    # glass
    "BGG": "BGG, barium gallogermanate glass", "fused_silica": "fused silica, quartz glass, glass",
    "soda-lime": "soda-lime glass, window glass", "Pilkington-Optiwhite": "Pilkington Optiwhite, low-iron window glass",
    "ZBLAN": "ZBLAN, fluoride glass", "K108-LZOS": "K108 glass",
    # 3d pages
    "pc": "polycarbonate, PC", "pmma": "PMMA, acrylic", "ps": "polystyrene, PS", "pvp": "polyvinylpyrrolidone, PVP",
    "salt": "salt, sodium chloride, halite", "sapphire": "sapphire, alumina", "quartz": "quartz, silica",
    "brass": "brass, copper-zinc alloy", "ice": "ice, water",
    "aluminium": "aluminium, aluminum", "diamond": "diamond, carbon",
}
"""By formula, book or page: names with the shown one first."""

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
    everyday = COMMON[book].split(", ") if book in COMMON else []
    chemical = chemical_names(book)
    return list(dict.fromkeys(everyday + chemical)) or [book.replace("_", " ")]


def chemical_names(formula):
    """Systematic names of an element or compound, the usual one first; none where it is no formula.

    >>> chemical_names("TiO2"), chemical_names("LiNbO3"), chemical_names("Au-Ag")
    (['titanium dioxide', 'titanium oxide'], ['lithium niobate'], [])
    """
    parts = re.findall(r"([A-Z][a-z]?)(\d*)", formula)
    if "".join(symbol + count for symbol, count in parts) != formula or any(s not in ELEMENTS for s, _ in parts)\
            or len({symbol for symbol, _ in parts}) < len(parts) or formula in NO_FORMULAS:
        return []
    symbols = [symbol for symbol, _ in parts]
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
    """ "titanium dioxide", "titanium oxide"; for two of the first and more: "iron oxide", "diiron trioxide"."""
    first, second = ELEMENTS[symbols[0]].split(), ANIONS[symbols[1]].split()
    plain = [f"{a} {b}" for a in first for b in second]
    if counts == [1, 1] or counts[1] not in PREFIXES or counts[0] not in PREFIXES:
        return plain
    head = "" if counts[0] == 1 else PREFIXES[counts[0]]
    counted = [re.sub("[ao]oxide", "oxide", f"{head}{a} {PREFIXES[counts[1]]}{b}") for a in first for b in second]
    return counted + plain if counts[0] == 1 and symbols[1] in COUNTED else plain + counted


def kind_of(dataset, k):
    """What sort of material: "metal", "glass", "liquid", "organic", "gas", or by its k "conductor", "absorber", "dielectric".

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
