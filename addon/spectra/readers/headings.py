"""What headings of columns say, in the words of many: the quantity, its unit.

One more word is one more word in QUANTITIES; a language needs no code.
"""

import dataclasses
import re
import unicodedata

from .units import AXIS_UNITS, UNIT_OF

__all__ = ["Column", "QUANTITIES", "columns_of", "column_of", "names_beyond_ascii", "quantity_of_name", "LONGEST"]

QUANTITIES = {
    "wavelength": (
        "wavelength", "wavelengths", "wave length", "wl", "wvl", "wave", "wavel", "lambda", "lam", "λ", "w",
        "vacuum wavelength", "lambda0", "λ0", "wellenlänge", "wellenlaenge", "longueur d'onde", "longueur d’onde",
        "longueur d onde", "longitud de onda", "lunghezza d'onda", "comprimento de onda", "golflengte", "våglängd",
        "bølgelængde", "bølgelengde", "długość fali", "dlugosc fali", "vlnová délka", "hullámhossz", "aallonpituus",
        "dalga boyu", "длина волны", "довжина хвилі", "μήκος κύματος", "波长", "波長", "파장"),
    "energy": (
        "energy", "photon energy", "photonenergy", "hν", "hv", "h nu", "ħω", "energie", "photonenergie", "énergie",
        "energía", "energia", "энергия", "энергия фотона", "能量", "光子能量", "エネルギー",
        "光子エネルギー", "에너지"),
    "wavenumber": (
        "wavenumber", "wavenumbers", "wave number", "wave numbers", "wellenzahl", "nombre d'onde", "número de onda",
        "numero d'onda", "волновое число", "波数", "파수"),
    "frequency": (
        "frequency", "freq", "frequenz", "fréquence", "frecuencia", "frequenza", "частота", "频率", "周波数",
        "주파수", "ν"),
    "axis": ("x",),
    "n": (
        "n", "nr", "n real", "real n", "re n", "re(n)", "real(n)", "n(λ)", "n'", "n (real)", "index", "index n",
        "re(index)", "real(index)", "index real", "index(real)", "ref. index", "refr. index", "refr index",
        "ref index", "ri", "ior", "eta", "η", "refractive index", "refraction index", "refractive index n",
        "index of refraction", "real index", "real part", "real part of index", "real part of refractive index",
        "real refractive index", "refractive", "refindex", "brechungsindex", "brechzahl", "realteil", "indice",
        "indice de réfraction", "índice de refracción", "índice", "indice di rifrazione", "índice de refração",
        "brekingsindex", "brytningsindex", "współczynnik załamania", "показатель преломления", "показник заломлення",
        "折射率", "屈折率", "굴절률"),
    "k": (
        "k", "κ", "kappa", "ki", "n imag", "imag n", "im n", "im(n)", "imag(n)", "k(λ)", "n''", 'n"', "ni",
        "n (imag)", "index k", "im(index)", "imag(index)", "index imag", "index(imag)", "extinction",
        "extinction coefficient", "extinction coeff", "extinction coefficient k", "extinction index",
        "absorption index", "ext. coeff.", "ext coeff", "ext. coef.", "ext coef", "ext. coefficient",
        "imaginary index", "imaginary part", "imaginary part of refractive index", "imaginary refractive index",
        "extinktion", "extinktionskoeffizient", "extinktionskoeff.", "absorptionsindex", "imaginärteil",
        "coefficient d'extinction", "coeficiente de extinción", "coefficiente di estinzione",
        "coeficiente de extinção", "współczynnik ekstynkcji", "показатель поглощения", "коэффициент экстинкции",
        "коэффициент поглощения k", "消光系数", "消衰係数", "소광계수"),
    "ε1": (
        "e1", "e 1", "eps1", "eps 1", "ε1", "ε 1", "epsilon1", "epsilon 1", "re(eps)", "re(ε)", "re(epsilon)",
        "re eps", "re epsilon", "re ε", "real(eps)", "real(epsilon)", "real eps", "real epsilon", "eps real",
        "epsilon real", "eps re", "eps'", "ε'", "er", "epsr", "eps r", "εr", "real permittivity",
        "real part of permittivity", "permittivity real", "real dielectric", "real part of dielectric function",
        "dielectric real", "ε′"),
    "ε2": (
        "e2", "e 2", "eps2", "eps 2", "ε2", "ε 2", "epsilon2", "epsilon 2", "im(eps)", "im(ε)", "im(epsilon)",
        "im eps", "im epsilon", "im ε", "imag(eps)", "imag(epsilon)", "imag eps", "imag epsilon", "eps imag",
        "epsilon imag", "eps im", "eps''", "ε''", 'ε"', 'eps"', "ei", "epsi", "eps i", "εi",
        "imaginary permittivity", "imaginary part of permittivity", "permittivity imag", "permittivity imaginary",
        "imaginary dielectric", "imaginary part of dielectric function", "dielectric imag", "ε″"),
    "R": (
        "r", "rn", "r0", "f0", "refl", "refl.", "reflectance", "reflectivity", "reflection",
        "reflectance at normal incidence", "normal reflectance", "normal reflectivity", "specular reflectance",
        "specular reflectivity", "specular reflection", "specular refl", "abs reflectance", "absolute reflectance",
        "reflectance factor", "total reflectance", "reflexion", "reflexionsgrad", "reflektion", "reflexionsvermögen",
        "spiegelung", "réflexion", "réflectance", "réflectivité", "reflectancia", "reflectividad", "reflexión",
        "riflettanza", "riflessione", "riflettività", "reflectância", "reflectie", "reflektans", "отражение",
        "коэффициент отражения", "відбиття", "反射率", "镜面反射率", "반사율", "r(th=0)", "r(0)", "r th=0"),
    "T": (
        "t", "trans", "transmittance", "transmission", "transmissivity", "internal transmittance",
        "transmissionsgrad", "tint", "transmittancia", "transmitancia", "пропускание", "коэффициент пропускания",
        "透过率", "透射率", "透過率", "투과율"),
    "A": (
        "a", "abs", "abs.", "absorb", "absorbance", "absorbanz", "absorptance", "absorption", "absorptivity", "od",
        "optical density", "emissivity", "吸光度", "吸收率", "оптическая плотность"),
    "α": (
        "α", "alpha", "absorption coefficient", "absorption coeff", "attenuation coefficient",
        "absorptionskoeffizient", "coefficient d'absorption", "coeficiente de absorción", "коэффициент поглощения",
        "吸收系数", "吸収係数", "흡수계수"),
    "n+ik": (
        "n+ik", "n + ik", "n+jk", "n-ik", "n - ik", "nk", "n k", "ñ", "n complex", "complex n", "complex index",
        "complex refractive index", "index complex", "refractive index complex", "refractive index (complex)"),
    "ε1+iε2": (
        "eps", "ε", "epsilon", "permittivity", "dielectric function", "dielectric constant", "complex permittivity",
        "complex eps", "eps complex", "e1+ie2", "relative permittivity"),
    "number": (
        "", "#", "no", "no.", "nr.", "point", "points", "pt", "id", "idx", "i", "row", "unnamed: 0", "unnamed", "№",
        "number", "n°", "序号", "番号"),
    "other": (
        "std", "sd", "σ", "sigma", "err", "error", "uncertainty", "unc", "dn", "dk", "δn", "δk", "Δn", "Δk", "n err",
        "k err", "n error", "k error", "std n", "std k", "n std", "k std", "σn", "σk", "mse", "thickness", "depth",
        "fwhm", "bandwidth", "resolution", "slit", "temperature", "temp", "source", "reference", "ref", "comment",
        "comments", "note", "notes", "material", "sample", "name", "psi", "delta", "ψ", "δ", "angle", "weight",
        "dn/dt", "rp", "rs", "density", "loss", "tan δ", "tand", "phase", "n group", "ng", "group index", "n_g",
        "vg", "gvd", "dispersion"),
}
"""What people call each quantity; "number" counts rows, "other" is left aside."""

AXES = ("wavelength", "energy", "wavenumber", "frequency", "axis")
PERCENT = {"%", "percent", "pct", "per cent", "prozent", "pourcent", "процент", "％", "百分比"}
NO_UNIT = {"", "-", "1", "–", "—", "none", "au", "a.u.", "a. u.", "arb", "dimensionless", "unitless", "fraction", "[]",
           "()", "ratio", "0-1", "0..1"}
PER_LENGTH = {
    "1/cm": 1e-07, "cm-1": 1e-07, "cm^-1": 1e-07, "/cm": 1e-07, "1/m": 1e-09, "m-1": 1e-09, "m^-1": 1e-09,
    "1/mm": 1e-06, "mm-1": 1e-06, "1/um": 0.001, "1/μm": 0.001, "um-1": 0.001, "1/nm": 1.0, "nm-1": 1.0,
}
"""1/nm in a unit of absorption coefficients."""
SYMBOLS = {
    "n": "n", "eta": "n", "η": "n", "k": "k", "kappa": "k", "κ": "k", "e1": "ε1", "eps1": "ε1", "ε1": "ε1",
    "e2": "ε2", "eps2": "ε2", "ε2": "ε2", "r": "R", "refl": "R", "reflectance": "R", "reflectivity": "R",
    "reflection": "R", "%r": "R", "wavelength": "wavelength", "wl": "wavelength", "lambda": "wavelength",
    "λ": "wavelength", "energy": "energy", "transmittance": "T", "transmission": "T", "absorbance": "A", "t": "T",
}
"""Words that tell a quantity within a longer heading, such as n_Au."""
OF_FILE_NAMES = {
    "n": ("n", "eta", "ior", "nr"),
    "k": ("k", "kappa"),
    "α": ("alpha",),
    "R": ("r", "refl", "reflectance", "reflectivity", "reflection", "rspec"),
    "T": ("trans", "transmittance", "transmission", "tint"),
    "A": ("abs", "absorb", "absorbance", "absorptance", "absorption", "od", "emissivity", "emission", "emittance"),
}
"""Words in a file's name that tell what is in a table that tells nothing itself."""
UNSPACED = re.compile(r"[\s_]+")
HEADING = re.compile(
    r"(?P<name>.*?)\s*(?:[(\[{<]\s*(?P<bracketed>[^()\[\]{}<>]*?(?:\([^()]*\))?)\s*[)\]}>]\.?"
    r"|(?:/|,|;|\bin\b|\ben\b|_|\s)\s*(?P<plain>[^\s/]\S*?)\.?)\s*")
QUOTED = re.compile("[\"'“”„«»‘’`]+(.*?)[\"'“”„«»‘’`]+")
WORD_AND_SYMBOL = re.compile(r"([^\x00-\x7f]+)\s*[a-zκη]")
ANGLE = re.compile(r"(\d+(?:\.\d+)?)\s*(?:°|º|deg)")
LARGEST_ANGLE = 15.0
"""Degrees up to which a mirror reflects as at normal incidence, within a percent of a percent."""
LONGEST = 2000
"""Letters of a line that can be headings."""
MOST_WORDS = 14


@dataclasses.dataclass(frozen=True)
class Column:
    """A column's role, a quantity of QUANTITIES or "" where its heading is not known, its unit, and the heading.

    unit   a name of AXIS_UNITS for an axis, "%" or "" for shares, 1/nm a unit for α
    angle  degrees from the normal that the heading names, or 0
    """

    role: str
    unit: str = ""
    name: str = ""
    angle: float = 0.0

    @property
    def is_axis(self):
        """Whether it is what the others are given over."""
        return self.role in AXES


def _key(word):
    return UNSPACED.sub("", unicodedata.normalize("NFKC", word).strip().lower())


BEYOND_ASCII = (
    *(name for names in QUANTITIES.values() for name in names
      if not name.isascii() and len(name) > 1 and name.isalpha()),
    "longueur d’onde", "(µm)", "[µm]", "/µm", " µm", "_µm", "длина волны")
ROLES = {_key(name): role for role, names in QUANTITIES.items() for name in names}


def column_of(heading):
    """The Column that one heading names; its role is "" where that is not known.

    >>> column_of("Wavelength (nm)"), column_of("n_Au").role, column_of("%R").unit, column_of("gold").role
    (Column(role='wavelength', unit='nm', name='Wavelength (nm)', angle=0.0), 'n', '%', '')
    """
    plain = unicodedata.normalize("NFKC", heading).strip()
    quoted = QUOTED.fullmatch(plain)
    plain = (quoted[1] if quoted else plain.strip("“”„«»` ")).strip().lower()
    plain = plain.replace("micro meter", "micrometer").replace("\\", "")
    name = " ".join(heading.strip().strip("\"'“”„«»` ").split())
    angle = ANGLE.search(plain)
    degrees = float(angle[1]) if angle else 0.0
    if plain in UNIT_OF and plain not in {"a", "m", "j"}:
        return Column(AXIS_UNITS[UNIT_OF[plain]].kind, UNIT_OF[plain], name)
    bare_unit = plain.strip("()[]{}<> ")
    if bare_unit in UNIT_OF and bare_unit != plain:
        return Column(AXIS_UNITS[UNIT_OF[bare_unit]].kind, UNIT_OF[bare_unit], name)
    whole = ROLES.get(_key(plain))
    if whole and whole != "number":
        return Column(whole, "", name)
    native = WORD_AND_SYMBOL.fullmatch(plain)
    if native and native[1] in ROLES:
        return Column(ROLES[native[1]], "", name)
    if "%" in plain:
        bare = plain.replace("%", " ").replace("()", " ").replace("[]", " ")
        rest = column_of(bare) if bare.strip("()[] ") else None
        if rest is not None and rest.role in {"R", "T", "A"}:
            return Column(rest.role, "%", name, degrees)
        return Column("", "%", name)
    found = HEADING.fullmatch(plain)
    if found:
        unit = (found["bracketed"] if found["bracketed"] is not None else found["plain"] or "").strip().rstrip(".")
        column = _with_unit(found["name"].strip(" _-:,/"), unit, name, degrees)
        if column:
            return column
    return Column(whole or _by_symbol(plain), "", name, degrees)


def _with_unit(stem, unit, name, degrees):
    """The Column of a heading whose stem and unit are both known, or None."""
    role = ROLES.get(_key(stem))
    if unit in UNIT_OF and role not in {"other", "number"}:
        axis = AXIS_UNITS[UNIT_OF[unit]]
        named = any(letter.isalpha() for letter in stem) and not any(letter.isdigit() for letter in stem)
        if role in AXES or (role is None or stem in {"e", "f", "ω", "w"}) and not _by_symbol(stem) and named:
            return Column(axis.kind, UNIT_OF[unit], name)
    if role == "α" and unit in PER_LENGTH:
        return Column("α", unit, name)
    if role in {"R", "T", "A"} and (unit in PERCENT or unit in NO_UNIT or ANGLE.search(unit) or unit == "th=0"):
        return Column(role, "%" if unit in PERCENT else "", name, degrees)
    if role and role not in AXES and unit in NO_UNIT:
        return Column(role, "", name)
    foreign = unit in UNIT_OF or unit in PERCENT or unit in {"db", "deg"}
    if foreign and role in {"n", "k", "ε1", "ε2", "R", "T", "A", "α"}:
        return Column(role, f"?{unit}", name)
    if role in AXES and unit:
        return Column(role, f"?{unit}" if len(unit) < 12 and " " not in unit else "", name)
    return None


def _by_symbol(plain):
    """The quantity that the words of a longer heading tell, or ""."""
    words = [word for word in re.split(r"[\s_\-.,:;/()\[\]{}=]+", plain) if word]
    if not 1 <= len(words) <= 6:
        return ""
    found = {SYMBOLS[word] for word in words if word in SYMBOLS}
    short = {SYMBOLS[word] for word in (words[0], words[-1]) if word in SYMBOLS and len(word) <= 3}
    if len(short) == 1:
        return short.pop()
    return found.pop() if len(found) == 1 and len(words) <= 4 else ""


def columns_of(line, count=None):
    """The Columns of a line of headings, or None where it is no such line.

    count  how many columns the rows below have, where that is known

    >>> [(column.role, column.unit) for column in columns_of("Wavelength, µm, n, k", 3)]
    [('wavelength', 'µm'), ('n', ''), ('k', '')]
    >>> columns_of("Gold by Babar and Weaver") is None
    True
    """
    if len(line) > LONGEST or not line.strip():
        return None
    best = None
    for cells in _splits(line, count):
        columns = _joined([column_of(cell) for cell in cells])
        if count is not None and len(columns) != count:
            # A first column without a heading counts the rows; what is empty at the end is none.
            while len(columns) > count and columns[-1].role == "number" and not columns[-1].name:
                columns.pop()
            if len(columns) != count:
                columns = columns if _is_heading(columns, True) else []
        if _is_heading(columns, False):
            known = sum(column.role != "" for column in columns)
            score = (count is None or len(columns) == count, known, -len(columns))
            if best is None or score > best[0]:
                best = score, columns
    return best[1] if best else None


def _is_heading(columns, whole):
    roles = [column.role for column in columns]
    known = [role for role in roles if role and role not in {"number", "other"}]
    if not known or len(columns) < 2:
        return False
    if any(column.is_axis for column in columns):
        return not whole or len(known) >= 2
    return len(known) >= 2 and len(known) == len([role for role in roles if role != "number"])


def _splits(line, count):
    """The ways to part a line of headings into cells: at what separates columns, else at spaces."""
    plain = unicodedata.normalize("NFKC", line).strip("\r\n ").replace("âµ", "µ").replace("Âµ", "µ")
    for separator in ("\t", ";", "|", ","):
        if separator in plain:
            cells = (plain.strip("| ") if separator == "|" else plain).split(separator)
            while len(cells) > 1 and not cells[-1].strip():
                cells.pop()
            yield cells
            if separator == "\t":
                yield [cell for cell in cells if cell.strip()]
    wide = re.split(r"\s{2,}|\t", plain.strip())
    if len(wide) > 1:
        yield wide
    words = plain.split()
    if len(words) <= MOST_WORDS:
        yield re.sub(r"\s+(?=[(\[%])|(?<=[(\[])\s+|\s+(?=[)\]])", "", plain).split()
        if count is not None and len(words) > count:
            yield from _grouped(re.sub(r"\s+(?=[(\[])", "", plain).replace(",", " ").split(), count)


def _grouped(words, count):
    """Words put together to as many headings as there are columns, where all of them are known."""
    def group(start, left):
        if left == 0:
            return [] if start == len(words) else None
        for end in range(min(len(words) - left + 1, start + 5), start, -1):
            cell = " ".join(words[start:end])
            if column_of(cell).role:
                rest = group(end, left - 1)
                if rest is not None:
                    return [cell, *rest]
        return None
    found = group(0, count) if count <= 8 else None
    if found:
        yield found


def _joined(columns):
    """Columns without cells that are only the unit of the one before: "Wavelength, µm, n, k"."""
    joined = []
    for column in columns:
        alone = column.name.lower().strip("()[] ")
        before = joined[-1] if joined else None
        if before and column.is_axis and alone in UNIT_OF and before.is_axis and not before.unit:
            joined[-1] = dataclasses.replace(before, role=column.role, unit=column.unit)
        elif before and alone in PERCENT and before.role in {"R", "T", "A"} and not before.unit:
            joined[-1] = dataclasses.replace(before, unit="%")
        else:
            joined.append(column)
    return joined


def names_beyond_ascii(sample):
    """Whether a text has a word of the headings with letters beyond ASCII, of more than one letter.

    >>> names_beyond_ascii("波长(nm),n,k"), names_beyond_ascii("wavelength")
    (True, False)
    """
    lowered = sample.lower()
    return any(name in lowered for name in BEYOND_ASCII)


def quantity_of_name(stem):
    """The quantity that a file's name tells, "" where it tells none or several.

    >>> quantity_of_name("W.eta"), quantity_of_name("23_pbrt_k"), quantity_of_name("gold")
    ('n', 'k', '')
    """
    words = [word for word in re.split(r"[^a-zµα-ω]+", stem.lower()) if word]
    found = [role for word in words for role, names in OF_FILE_NAMES.items() if word in names]
    return found[-1] if found and (len(set(found)) == 1 or words[-1] in OF_FILE_NAMES[found[-1]]) else ""
