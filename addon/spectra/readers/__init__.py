"""A user's own measurements, from a file or pasted as text: a pipeline whose rules each have one place.

text.py      bytes -> numbered lines; the one way to refuse, to ask and to say what was assumed
rows.py      lines -> tables of cells: what parts columns, how numbers are written, remarks
wide.py      the same for tables that lie on their side, one spectrum a row
headings.py  words -> quantities and units, in many languages
units.py     units of the axis, and which of them numbers can be
columns.py   cells -> quantities over wavelength
pairs.py     the other half of n and k, in a file beside
quantities.py  ε, complex numbers, R, absorption -> n and k
points.py    what has to hold for points -> OpticalConstants
Formats of their own: database.py (refractiveindex.info), address.py (its pages), glass.py (Zemax),
sopra.py, structured.py (JSON, HTML, CGATS, scenes).
A new word, unit, mark or separator is one more entry in a table; a new format one more file with a
function from a Text to OpticalConstants, and a line in reading.py's list.
"""

from importlib import import_module

__all__ = ["FORMATS", "SUFFIXES", "Ambiguous", "format_of", "read", "read_file", "read_text"]

SUFFIXES = (".csv", ".tsv", ".txt", ".dat", ".nk", ".yml", ".yaml", ".mat", ".agf", ".spd", ".sp", ".json", ".html",
            ".htm", ".asc", ".ti3", ".cgats", ".lnk", ".ri", ".gmat", ".pbrt", ".xml", ".prn", ".dpt", ".xy",
            ".coating")
"""What files of measurements are usually called."""

PLACES = {"Ambiguous": "text", **dict.fromkeys(("FORMATS", "format_of", "read", "read_file", "read_text"), "reading")}
"""Name -> module, loaded with its first use: a word that is no file waits for none of the formats."""


def __getattr__(name):
    if name not in PLACES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f".{PLACES[name]}", __name__), name)
