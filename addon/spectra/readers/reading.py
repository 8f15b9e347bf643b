"""Takes a file or a text to the reader of its format."""

import os

from ...errors import FacetFilmError
from .columns import read_columns
from .database import is_database, read_database
from .sopra import is_sopra, read_sopra
from .text import Text, text_of_file

__all__ = ["SUFFIXES", "read", "read_file", "read_text"]

SUFFIXES = (".csv", ".tsv", ".txt", ".dat", ".nk", ".yml", ".yaml")
"""What files of measurements are usually called."""

FORMATS = ((is_database, read_database), (is_sopra, read_sopra), (lambda text: True, read_columns))
"""(whether a Text is of this format, its reader); the first that fits is taken."""


def read(what):
    """The OpticalConstants in a file, or in a text of several lines.

    what  path (text of one line, or os.PathLike), or the measurements themselves

    Raises FacetFilmError as :func:`read_file` does.

    >>> read("wavelength_nm, n\\n400, 1.5\\n700, 1.5").n.tolist()
    [1.5, 1.5]
    """
    if isinstance(what, os.PathLike):
        return read_file(what)
    if not isinstance(what, str):
        raise FacetFilmError(f"Measurements are read from a path or a text, not from {type(what).__name__}.")
    return read_text(what) if "\n" in what or "\r" in what else read_file(what)


def read_file(path):
    """The OpticalConstants in a file of any of the formats.

    path  of a file of at most 8 MB

    Raises FacetFilmError with the number of the line and what was expected
    there for a file that cannot be opened, is none of the formats, or has
    anything wrong inside.
    """
    return _read(text_of_file(path))


def read_text(text, name="pasted text"):
    """The OpticalConstants in a text, as from the clipboard.

    text  of any of the formats
    name  what messages and the dataset call it

    Raises FacetFilmError as :func:`read_file` does.

    >>> read_text("lambda/um; n; k\\n0,4; 1,47; 1,95\\n0,7; 0,13; 4,05").at(700.0)[1].tolist()
    4.05
    """
    return _read(Text(name, text))


def _read(text):
    return next(reader for fits, reader in FORMATS if fits(text))(text)
