"""Files of measurements with one thing wrong in each: a table made by code, name -> Malformed."""

import dataclasses
import gzip
import io
import zipfile

__all__ = ["Malformed", "MALFORMED", "VALID"]


@dataclasses.dataclass(frozen=True)
class Malformed:
    """A file that has to be refused.

    file     its name
    content  its bytes
    says     what the message has to hold
    """

    file: str
    content: bytes
    says: str


# Five points a format.  A fault replaces the third point, so the line it is in is known.
POINTS_NM = [(400, 1.5, 2.0), (480, 1.4, 2.2), (560, 1.3, 2.4), (640, 1.2, 2.6), (720, 1.1, 2.8)]


def _rows(scale, digits):
    return [[f"{w * scale:.{digits}f}", f"{n:g}", f"{k:g}"] for w, n, k in POINTS_NM]


def _joined(separator, head="", end="\n", comma=False):
    def write(rows):
        lines = [separator.join(cell.replace(".", ",") if comma else cell for cell in row) for row in rows]
        return head + end.join(lines) + end
    return write


def _two_blocks(rows):
    blocks = [["wl,n"] + [f"{row[0]},{row[1]}" for row in rows], [""],
              ["wl,k"] + [f"{row[0]},{','.join(row[2:])}" for row in rows]]
    return "\n".join(line for block in blocks for line in block)


def _yaml(rows):
    data = "\n".join("        " + " ".join(row) for row in rows)
    return f'REFERENCES: "A. Author, a journal"\nDATA:\n  - type: tabulated nk\n    data: |\n{data}\n'


# name of the format: (file, rows, writer, line of the first point)
FORMATS = {
    "comma nm": ("a.csv", _rows(1, 1), _joined(",", "wavelength_nm,n,k\n"), 2),
    "comma nm bare": ("a.csv", _rows(1, 1), _joined(","), 1),
    "comma µm crlf": ("a.csv", _rows(1e-3, 3), _joined(",", "wavelength (µm),n,k\r\n", "\r\n"), 2),
    "semicolon decimal comma": ("a.csv", _rows(1, 1), _joined(";", "nm;n;k\n", comma=True), 2),
    "tab": ("a.txt", _rows(1e-3, 3), _joined("\t", "# gold\nlambda/um\tn\tk\n"), 3),
    "spaces": ("a.dat", _rows(1, 0), _joined("  "), 1),
    "LuxPop": ("a.nk", _rows(10, 1), _joined("  ", "; Ag\n; Angstrom, n, k\n"), 3),
    "YAML": ("a.yml", _rows(1e-3, 3), _yaml, 5),
}
BLOCKS = ("a.csv", _rows(1e-3, 3), _two_blocks, 2)

VALID = {**{name: (file, write(rows)) for name, (file, rows, write, _) in FORMATS.items()},
         "two blocks": (BLOCKS[0], _two_blocks(BLOCKS[1])),
         "SOPRA": ("a.nk", "4 400 720 4\n1.5 2.0\n1.4 2.2\n1.3 2.4\n1.2 2.6\n1.1 2.8\n"),
         "reflectance": ("a.csv", "nm,R\n400,0.5\n560,0.6\n720,0.7\n"),
         "reflectance percent": ("a.csv", "nm,R (%)\n400,50\n560,60\n720,70\n")}

# name: (what becomes of the third row, the row before it and the number of its line given; what is said)
FAULTS = {
    "n is 0": (lambda row, before: [row[0], "0", row[2]], "n is 0"),
    "n is negative": (lambda row, before: [row[0], "-1.3", row[2]], "n is -1.3"),
    "n is not a number": (lambda row, before: [row[0], "nan", row[2]], "a number"),
    "n is infinite": (lambda row, before: [row[0], "inf", row[2]], "a number"),
    "n is a word": (lambda row, before: [row[0], "abc", row[2]], "a number"),
    "n is beyond floats": (lambda row, before: [row[0], "1e999", row[2]], "too large"),
    "n is no material's": (lambda row, before: [row[0], "1000000", row[2]], "at most"),
    "n has two signs": (lambda row, before: [row[0], "+-1", row[2]], "a number"),
    "k is negative": (lambda row, before: [row[0], row[1], "-1"], "k is -1"),
    "k is not a number": (lambda row, before: [row[0], row[1], "NaN"], "a number"),
    "k is infinite": (lambda row, before: [row[0], row[1], "-Infinity"], "a number"),
    "k is a word": (lambda row, before: [row[0], row[1], "none"], "a number"),
    "k has an underscore": (lambda row, before: [row[0], row[1], "1_0"], "a number"),
    "k is in other digits": (lambda row, before: [row[0], row[1], "١"], "a number"),
    "a wavelength twice": (lambda row, before: [before[0], *row[1:]], "comes again"),
    "a wavelength too low": (lambda row, before: [before[0].replace("8", "2"), *row[1:]], "ascend"),
    "a wavelength of another unit": (lambda row, before: [f"{float(row[0]) * 1e3:.0f}", *row[1:]], "unit"),
    "a wavelength in hexadecimal": (lambda row, before: ["0x230", *row[1:]], "a number"),
    "k is missing": (lambda row, before: row[:2], "number"),
    "a fourth number": (lambda row, before: [*row, "7"], "number"),
}


def _faulty(form, fault, place):
    file, rows, write, first = form
    become, says = FAULTS[fault]
    rows = [list(row) for row in rows]
    rows[place] = become(rows[place], rows[place - 1])
    return Malformed(file, write(rows).encode(), says), first + place


def _all_faults():
    for name, form in FORMATS.items():
        for fault in FAULTS:
            malformed, line = _faulty(form, fault, 2)
            bare = name in {"comma nm bare", "spaces", "LuxPop"} and "another unit" in fault
            says = malformed.says if bare else f"line {line}:"
            yield f"{name}: {fault}", Malformed(malformed.file, malformed.content, says)
    for fault in ("n is 0", "n is a word", "k is negative", "k is not a number", "a wavelength twice",
                  "a wavelength too low", "a fourth number"):
        yield f"two blocks: {fault}", _faulty(BLOCKS, fault, 2)[0]


def _zip():
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w") as archive:
        archive.writestr("a.csv", "400,1.5\n700,1.5\n")
    return content.getvalue()


WHOLE = {
    "nothing": ("a.csv", b"", "empty"),
    "blanks": ("a.csv", b"  \n\t\n \r\n", "empty"),
    "only a byte order mark": ("a.csv", b"\xef\xbb\xbf", "empty"),
    "only a byte order mark of UTF-16": ("a.csv", b"\xff\xfe", "empty"),
    "picture": ("a.csv", b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR", "binary"),
    "archive": ("a.csv", _zip(), "binary"),
    "compressed": ("a.csv", gzip.compress(b"400,1.5\n700,1.5\n", mtime=0), "binary"),
    "program": ("a.csv", b"\x7fELF\x02\x01\x01\x00", "line 1: is binary"),
    "a zero byte": ("a.csv", b"400,1.5\n500,1\x00.5\n700,1.5\n", "line 2: is binary"),
    "control characters": ("a.csv", b"400,1.5\n\x02\x03\n", "line 2: is binary"),
    "UTF-16 without its mark": ("a.csv", "400,1.5\n700,1.5\n".encode("utf-16-le"), "binary"),
    "UTF-16 cut off": ("a.csv", "400,1.5\n700,1.5\n".encode("utf-16")[:-1], "damaged"),
    "UTF-8 that breaks its promise": ("a.csv", b"\xef\xbb\xbf400,\xff\n", "damaged"),
    "a lone surrogate": ("a.csv", b"\xff\xfe\x00\xd8\x00\xd8", "damaged"),
    "a million lines": ("a.csv", b"1,1\n" * 1_000_000, "1000001 lines"),
    "8 MB and a byte": ("a.csv", b"0" * 8_000_001, "too large"),
    "prose": ("a.txt", b"Gold is a chemical element with the symbol Au.", "no numbers"),
    "web page": ("a.csv", b"<html>\n<body>404</body>\n</html>\n", "no numbers"),
    "JSON without names": ("a.json", b'{"a": [400, 700], "b": [1.5, 1.5]}', "no numbers to read"),
    "JSON cut off": ("a.json", b'{"wavelength": [400, 700], "n": [1.5', "begins as JSON"),
    "JSON of one number": ("a.json", b"[1.5]", "JSON without lists"),
    "only headings": ("a.csv", b"wavelength_nm,n,k\n", "no numbers"),
    "only comments": ("a.csv", b"# 400 1.5\n# 700 1.5\n", "no numbers"),
    "one point": ("a.csv", b"550,1.5,0\n", "only point"),
    "one point below headings": ("a.csv", b"wavelength_nm,n\n550,1.5\n", "line 2: is the only point"),
    "one column": ("a.csv", b"1.5\n1.5\n1.4\n", "has 1 number"),
    "four columns": ("a.csv", b"400,1.5,0.0,1\n700,1.5,0.0,1\n", "4 numbers"),
    "rows of other lengths": ("a.csv", b"400,1.5\n500,1.5,0.1\n700,1.4\n", "line 2: has 3"),
    "whole numbers between commas": ("a.csv", b"400,1,5\n500,1,4\n700,1,3\n", "decimal comma"),
    "decimal commas between commas": ("a.csv", b"400,0,1,5,0,2\n700,0,1,4,0,2\n", "decimal comma"),
    "decimal comma and point": ("a.csv", b"400;1,5\n500;1.5\n700;1,4\n", "line 2"),
    "thousands": ("a.csv", b"4.000,0;1,5\n7.000,0;1,4\n", "line 1"),
    "an empty cell": ("a.csv", b"400,1.5,0\n500,,0\n700,1.4,0\n", "line 2: n is missing at 500 nm"),
    "an empty first cell": ("a.csv", b"400,1.5\n,1.5\n700,1.4\n", "line 2: the wavelength is missing"),
    "an open quote": ("a.csv", b'400,1.5\n"500,1.5\n700,1.4\n', "line 2"),
    "colons": ("a.csv", b"400:1.5\n700:1.4\n", "line 1"),
    "mixed units": ("a.csv", b"0.4,1.5\n0.5,1.5\n600,1.4\n700,1.4\n", "nm or"),
    "mixed units below a heading": ("a.csv", b"nm,n\n0.4,1.5\n500,1.5\n600,1.4\n", "line 3"),
    "mixed units of two blocks": ("a.csv", b"wl,n\n0.4,1.5\n0.7,1.5\n\nwl,k\n400,1.4\n700,1.2\n", "unit"),
    "metres": ("a.csv", b"4e-7,1.5\n7e-7,1.5\n", "not visible"),
    "infrared": ("a.csv", b"1000,1.5\n2000,1.5\n", "not visible"),
    "infrared in µm": ("a.csv", b"um,n\n1.0,1.5\n2.0,1.5\n", "visible"),
    "ultraviolet": ("a.csv", b"nm,n\n100,1.5\n300,1.5\n", "visible"),
    "X-rays": ("a.nk", b"; Ag\n1.0 1.0 0.0\n10.0 1.0 0.0\n", "not visible"),
    "a little of the visible": ("a.csv", b"nm,n\n300,1.5\n430,1.5\n", "less than 50 nm"),
    "nm that say µm": ("a.csv", b"um,n\n400,1.5\n700,1.5\n", "visible"),
    "µm that say nm": ("a.csv", b"nm,n\n0.4,1.5\n0.7,1.5\n", "visible"),
    "wavelength 0": ("a.csv", b"nm,n\n0,1.5\n500,1.5\n700,1.5\n", "line 2: the wavelength is 0"),
    "a negative wavelength": ("a.csv", b"nm,n\n-400,1.5\n500,1.5\n700,1.5\n", "line 2"),
    "Å or nm": ("a.txt", b"; silver\n300 1.5 0.1\n10000 1.5 0.1\n", "nm or"),
    "n or R": ("a.csv", b"400,0.9\n700,1.2\n", "n or R"),
    "n of a semiconductor or percent of a glass": ("a.csv", b"400,4.2\n700,4.1\n", "n or R"),
    "a heading without end": ("a.csv", b"w" * 9999 + b"\n400,1.5\n700,1.5\n", "line 1: has 9999 letters"),
    "n or percent": ("a.csv", b"400,4.2\n700,9.2\n", "n or R"),
    "half an exponent": ("a.csv", b"400,1.5e\n700,1.5\n", "line 1"),
    "spreadsheet error": ("a.csv", b"400,1.5\n500,#DIV/0!\n700,1.5\n", "line 2"),
    "commas for spaces": ("a.txt", b"400 1,5 0\n500 1.5 0\n700 1,5 0\n", "line"),
}

HEADINGS = {
    "no such quantity": (b"wavelength,epsilon", "epsilon"),
    "no such unit": (b"wavelength (eV),n", "say eV, in which 400 to 700 are not visible"),
    "wave numbers": (b"wavelength (cm-1),n", "say 1/cm, in which"),
    "an energy": (b"energy,n", "the energies, 400 to 700, are not visible in eV"),
    "n has a unit": (b"wavelength,n (nm)", "unit 'nm' of n"),
    "n first": (b"n,wavelength", "the wavelengths, 1.5 to 1.5, are not visible"),
    "n twice": (b"wavelength,n,n", "has 2 numbers"),
    "wavelength twice": (b"wavelength,wavelength", "name only"),
    "R beside n": (b"wavelength,n,R", "has 2 numbers"),
    "R beside k": (b"wavelength,R,k", "has 2 numbers"),
    "k alone": (b"wavelength,k", "n, n and k, or R"),
    "three headings, two columns": (b"wavelength,n,k", "has 2 numbers"),
    "an empty heading": (b"wavelength,,n", "has 2 numbers"),
    "transmittance": (b"wavelength,T", "transmittance alone"),
}

REFLECTANCES = {
    "above 1": (b"nm,R\n400,0.5\n500,1.2\n700,0.5\n", "line 3: R is 1.2"),
    "above 100 %": (b"nm,R (%)\n400,50\n500,120\n700,50\n", "line 3"),
    "above 100 without a sign": (b"nm,R\n400,50\n500,120\n700,50\n", "line 3"),
    "negative": (b"nm,R\n400,0.5\n500,-0.1\n700,0.5\n", "line 3: R is -0.1"),
    "negative percent": (b"nm,R %\n400,50\n500,-1\n700,50\n", "line 3"),
    "not a number": (b"nm,R\n400,0.5\n500,nan\n700,0.5\n", "line 3"),
    "infinite": (b"nm,R\n400,0.5\n500,inf\n700,0.5\n", "line 3"),
    "a word": (b"nm,R\n400,0.5\n500,high\n700,0.5\n", "line 3"),
    "share and percent": (b"nm,R\n400,0.5\n500,50\n700,50\n", "line 3"),
    "one point": (b"nm,R\n550,0.5\n", "only point"),
    "no such unit": (b"nm,R (dB)\n400,0.5\n700,0.5\n", "line 1: the unit 'db'"),
    "two blocks": (b"nm,R\n400,0.5\n700,0.5\nnm,R\n400,0.5\n700,0.5\n", "second time"),
    "beside k": (b"nm,R\n400,0.5\n700,0.5\nnm,k\n400,0.5\n700,0.5\n", "has R and k"),
}

BLOCK_FAULTS = {
    "n twice": (b"wl,n\n.4,1\n.7,1\nwl,n\n.4,1\n.7,1\n", "n comes a second time"),
    "k twice": (b"wl,n\n.4,1\n.7,1\nwl,k\n.4,1\n.7,1\nwl,k\n.4,1\n.7,1\n", "k comes a second time"),
    "no n": (b"wl,k\n.4,1\n.7,1\n", "n, n and k, or R"),
    "nothing in the first": (b"wl,n\nwl,k\n.4,1\n.7,1\n", "without numbers"),
    "nothing in the second": (b"wl,n\n.4,1\n.7,1\nwl,k\n", "without numbers"),
    "one point in the second": (b"wl,n\n.4,1\n.7,1\nwl,k\n.4,1\n", "line 5: is the only point"),
    "no range in common": (b"wl,n\n.3,1\n.5,1\nwl,k\n.6,1\n.9,1\n", "less than 50 nm"),
    "no range in common with the visible": (b"wl,n\n.4,1\n.7,1\nwl,k\n.69,1\n.9,1\n", "less than 50 nm"),
}

SOPRAS = {
    "no numbers": (b"1 .6 6.6 120\n", "0 numbers"),
    "too few": (b"4 400 700 3\n1.5 0\n1.5 0\n1.5 0\n", "line 4: 6 numbers"),
    "too many": (b"4 400 700 1\n1.5 0\n1.5 0\n1.5 0\n", "6 numbers"),
    "an odd count": (b"4 400 700 1\n1.5 0\n1.5\n", "3 numbers"),
    "no intervals": (b"4 400 700 0\n1.5 0\n", "0 intervals"),
    "negative intervals": (b"4 400 700 -3\n1.5 0\n", "-3 intervals"),
    "a great many intervals": (b"4 400 700 1e300\n1.5 0\n", "2 numbers"),
    "the range upside down": (b"4 700 400 1\n1.5 0\n1.5 0\n", "the lower first"),
    "no range": (b"4 400 400 1\n1.5 0\n1.5 0\n", "the lower first"),
    "a range from 0": (b"1 0 6.6 1\n1.5 0\n1.5 0\n", "above 0"),
    "no such unit": (b"5 400 700 1\n1.5 0\n1.5 0\n", "line 1"),
    "half an interval": (b"4 400 700 1.5\n1.5 0\n1.5 0\n", "line 1"),
    "n is 0": (b"4 400 700 1\n0 0\n1.5 0\n", "line 2: n is 0"),
    "n is negative": (b"4 400 700 1\n1.5 0\n-1.5 0\n", "line 3: n is -1.5"),
    "k is negative": (b"4 400 700 1\n1.5 0\n1.5 -0.1\n", "line 3: k is -0.1"),
    "n is not a number": (b"4 400 700 1\nnan 0\n1.5 0\n", "line 2"),
    "k is infinite": (b"4 400 700 1\n1.5 inf\n1.5 0\n", "line 2"),
    "a word": (b"4 400 700 1\n1.5 0\n1.5 zero\n", "line 3"),
    "infrared": (b"1 .1 .6 1\n1.5 0\n1.5 0\n", "visible"),
    "ultraviolet in 1/cm": (b"3 50000 90000 1\n1.5 0\n1.5 0\n", "visible"),
}

ENTRY = "DATA:\n  - type: {}\n"
YAMLS = {
    "no DATA": ("REFERENCES: x\n", "no DATA"),
    "no YAML": ("400 1.5\n700 1.5\n", "no DATA"),
    "nothing below DATA": ("DATA:\n", "line 1: DATA is empty"),
    "DATA twice": ("DATA:\n  - type: tabulated n\nDATA:\n", "line 3"),
    "DATA in a line": ("DATA: [1, 2]\n", "line 1"),
    "no list": ("DATA:\n  type: tabulated n\n", "line 2"),
    "no type": ("DATA:\n  - data: |\n        0.4 1.5\n", "line 2: the entry has no type"),
    "type empty": ("DATA:\n  - type:\n", "line 2: type is empty"),
    "type unknown": (ENTRY.format("tabulated eps"), "line 2: the type is"),
    "type twice": (ENTRY.format("tabulated n") + "    type: tabulated k\n", "line 3"),
    "type goes on": (ENTRY.format("tabulated n") + "      or so\n", "line 3"),
    "formula 0": (ENTRY.format("formula 0"), "formula 1"),
    "formula 10": (ENTRY.format("formula 10"), "formula 9"),
    "no data": (ENTRY.format("tabulated n"), "the entry has no data"),
    "data empty": (ENTRY.format("tabulated n") + "    data: |\n", "line 3: data is empty"),
    "one point": (ENTRY.format("tabulated n") + "    data: |\n        0.5 1\n", "line 4: is the only point"),
    "n with three columns": (ENTRY.format("tabulated n") + "    data: |\n        0.5 1 1\n", "line 4: has 3"),
    "nk with two columns": (ENTRY.format("tabulated nk") + "    data: |\n        0.5 1.5\n", "line 4: has 2"),
    "commas": (ENTRY.format("tabulated n") + "    data: |\n        0.5, 1.5\n", "line 4"),
    "k alone": (ENTRY.format("tabulated k") + "    data: |\n        .4 1\n        .7 1\n", "has k"),
    "n twice": ("".join(f"  - type: tabulated n\n    data: |\n        .4 {n}\n        .7 {n}\n" for n in (1, 1.5)),
                "second time"),
    "infrared": (ENTRY.format("tabulated n") + "    data: |\n        4 1\n        7 1\n", "visible"),
    "no coefficients": (ENTRY.format("formula 1") + "    wavelength_range: .4 .7\n", "no coefficients"),
    "coefficients empty": (ENTRY.format("formula 1") + "    coefficients:\n", "line 3: coefficients"),
    "no range": (ENTRY.format("formula 5") + "    coefficients: 1.5\n", "no wavelength_range"),
}
YAMLS["n twice"] = ("DATA:\n" + YAMLS["n twice"][0], "second time")
FORMULAS = {
    "a coefficient that is a word": (1, ".4 .7", "0 a", "line 4"),
    "a coefficient that is not a number": (1, ".4 .7", "nan", "line 4"),
    "too few for formula 8": (8, ".4 .7", "1 2 3", "4 to 40"),
    "too few for formula 9": (9, ".4 .7", "1 2 3 4 5", "6 to 40"),
    "too many": (3, ".4 .7", "1 " * 41, "1 to 40"),
    "a root of a negative number": (1, ".4 .7", "-5", "no real value"),
    "n is 0": (5, ".4 .7", "0", "n is 0"),
    "n is negative": (5, ".4 .7", "-1.5", "n is -1.5"),
    "a pole": (2, ".4 .7", "0 1 0.25", "no real value"),
    "a power of a negative number": (4, ".4 .7", "1 1 1 -1 .5", "no real value"),
    "a power beyond floats": (4, ".4 .7", "1 1 1 1e9 1e9", "no real value"),
    "a division by zero": (4, ".4 .7", "1 1 1 0 -1", "no real value"),
    "a range of one": (5, ".4", "1.5", "two wavelengths"),
    "a range of three": (5, ".4 .5 .7", "1.5", "two wavelengths"),
    "a range upside down": (5, ".7 .4", "1.5", "two wavelengths"),
    "a range from 0": (5, "0 .7", "1.5", "two wavelengths"),
    "a range of words": (5, "low high", "1.5", "line 3"),
    "a range in nm": (5, "400 700", "1.5", "visible"),
    "a range in the ultraviolet": (5, ".1 .3", "1.5", "visible"),
    "a little of the visible": (5, ".3 .42", "1.5", "less than 50 nm"),
}


def _table():
    table = dict(_all_faults())
    table |= {f"whole: {name}": Malformed(*malformed) for name, malformed in WHOLE.items()}
    table |= {f"heading: {name}": Malformed("a.csv", heading + b"\n400,1.5\n700,1.5\n", says)
              for name, (heading, says) in HEADINGS.items()}
    for group, file, faults in (("reflectance", "a.csv", REFLECTANCES), ("blocks", "a.csv", BLOCK_FAULTS),
                                ("SOPRA", "a.nk", SOPRAS)):
        table |= {f"{group}: {name}": Malformed(file, *fault) for name, fault in faults.items()}
    table |= {f"YAML: {name}": Malformed("a.yml", content.encode(), says)
              for name, (content, says) in YAMLS.items()}
    table |= {f"formula: {name}": Malformed("a.yml", (ENTRY.format(f"formula {formula}") +
              f"    wavelength_range: {span}\n    coefficients: {coefficients}\n").encode(), says)
              for name, (formula, span, coefficients, says) in FORMULAS.items()}
    return table


MALFORMED = _table()
