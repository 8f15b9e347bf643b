"""Takes a file or a text to the reader of its format."""

import os

from ...errors import FacetFilmError
from .address import is_address, is_one_wavelength, read_address, refuse_one_wavelength
from .columns import read_columns
from .database import is_database, read_database
from .glass import is_coating, is_glass_catalogue, read_coating, read_glass_catalogue
from .sopra import is_sopra, is_sopra_mat, read_sopra, read_sopra_mat
from .structured import is_cgats, is_html, is_json, is_scene, read_cgats, read_html, read_json, read_scene
from .text import Text, text_of_file

__all__ = ["FORMATS", "read", "read_file", "read_text", "format_of"]

FORMATS = (
    (
        is_address,
        read_address,
        "the address of a page of refractiveindex.info",
        "`https://refractiveindex.info/?shelf=…`, pasted",
    ),
    (
        is_database,
        read_database,
        "YAML of refractiveindex.info: tabulated n, k, nk, formulas 1 to 9",
        "`.yml`, `.yaml`, or a line `DATA:`",
    ),
    (
        is_glass_catalogue,
        read_glass_catalogue,
        "a glass catalogue of Ansys Zemax, dispersion formulas 1 to 13",
        "lines `NM …` and `CD …`; choose a glass",
    ),
    (is_coating, read_coating, "a coating file of Ansys Zemax", "lines `MATE …`, numbers below; choose a material"),
    (is_sopra_mat, read_sopra_mat, "a .MAT of SOPRA", "lines `DATA1*…`"),
    (
        is_sopra,
        read_sopra,
        "a .nk of SOPRA",
        "four numbers first: unit (1 eV, 2 µm, 3 1/cm, 4 nm), low, high, intervals",
    ),
    (
        is_cgats,
        read_cgats,
        "a CGATS file of reflectances, such as Argyll's",
        "`BEGIN_DATA_FORMAT` with fields `SPEC_400` …; choose a set",
    ),
    (is_json, read_json, "JSON", "lists named as headings are, records, or rows; choose a material"),
    (is_scene, read_scene, "a scene of pbrt or Mitsuba", '`"spectrum eta" [ … ]`, `<spectrum name="eta" …>`'),
    (is_html, read_html, "a table of a web page", "`<tr>` and `<td>`"),
    (is_one_wavelength, refuse_one_wavelength, "n and k of one wavelength, which are refused", "`n = 0.43, k = 2.46`"),
    (lambda text: True, read_columns, "a table", "everything else"),
)
"""(whether a Text is of this format, its reader, what it is, how it is known); the first that fits is taken."""


def read(what, choose=()):
    """The OpticalConstants in a file, or in a text of several lines.

    what    path (text of one line, or os.PathLike), the measurements themselves, or a page's address
    choose  as :func:`read_file` has it

    Raises FacetFilmError as :func:`read_file` does.

    >>> read("wavelength_nm, n\\n400, 1.5\\n700, 1.5").n.tolist()
    [1.5, 1.5]
    """
    if isinstance(what, os.PathLike):
        return read_file(what, choose)
    if not isinstance(what, str):
        raise FacetFilmError(f"Measurements are read from a path or a text, not from {type(what).__name__}.")
    is_text = "\n" in what or "\r" in what or what.strip().lower().startswith(("http://", "https://"))
    return read_text(what, choose=choose) if is_text else read_file(what, choose)


def read_file(path, choose=()):
    """The OpticalConstants in a file of any of the formats; what was taken for granted stands in their `assumed`.

    path    of a file of at most 8 MB
    choose  where a file holds several things or can mean two: the name of the one that is meant, or names

    Raises Ambiguous, with its `choices`, where one has to be chosen, and
    FacetFilmError with the number of the line and what was expected there for
    a file that cannot be opened, is none of the formats, or has anything wrong
    inside.
    """
    return _read(text_of_file(path, choose))


def read_text(text, name="pasted text", choose=()):
    """The OpticalConstants in a text, as from the clipboard.

    text    of any of the formats, or a Text
    name    what messages and the dataset call it
    choose  as :func:`read_file` has it

    Raises FacetFilmError as :func:`read_file` does.

    >>> read_text("lambda/um; n; k\\n0,4; 1,47; 1,95\\n0,7; 0,13; 4,05").at(700.0)[1].tolist()
    4.05
    """
    return _read(text if isinstance(text, Text) else Text(name, text, choose=choose))


def format_of(text):
    """What a Text is read as, in words."""
    return next(what for fits, _, what, _ in FORMATS if fits(text))


def _read(text):
    return next(reader for fits, reader, _, _ in FORMATS if fits(text))(text)
