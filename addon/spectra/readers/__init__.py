"""A user's own measurements, from a file or pasted as text.

columns.py   wavelength, n[, k] or wavelength, R; the two-block CSV of refractiveindex.info; LuxPop .nk
sopra.py     SOPRA .nk
database.py  YAML of refractiveindex.info
One more format is one more file with a function from a Text to OpticalConstants,
and a line in :func:`read_text`'s list.
"""

from .reading import SUFFIXES, read, read_file, read_text

__all__ = ["SUFFIXES", "read", "read_file", "read_text"]
