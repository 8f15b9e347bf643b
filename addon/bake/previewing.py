"""What a file of measurements is read as, before anything is made of it."""

import dataclasses

from ..errors import FacetFilmError
from ..reflectance import fresnel
from ..spectra import observers
from ..spectra.readers import Ambiguous, format_of, read_text
from ..spectra.readers.text import Text, text_of_file
from .reflected import Viewing
from .srgb import encoded

__all__ = ["Preview", "preview", "preview_text"]


@dataclasses.dataclass(frozen=True)
class Preview:
    """What a file is read as.

    name        of the file
    read_as     its format, in words
    quantity    "n and k", "n" or "R"; "" where nothing could be read
    range_nm    what was measured, low and high, or ()
    covers_visible  whether 400 to 700 nm were measured wholly
    f0          linear Rec.709 at normal incidence, before colours are brought into the gamut, or ()
    swatch      the same as sRGB for a screen, each in 0 to 1, or ()
    assumed     what was taken for granted, a line each
    choices     names of which one is to be chosen, as `choose`; then the reading is open
    trouble     the sentence that says why nothing could be read, or ""
    constants   the OpticalConstants, or None
    """

    name: str
    read_as: str = ""
    quantity: str = ""
    range_nm: tuple = ()
    covers_visible: bool = False
    f0: tuple = ()
    swatch: tuple = ()
    assumed: tuple = ()
    choices: tuple = ()
    trouble: str = ""
    constants: object = None


def preview(path, choose=()):
    """The Preview of a file; never raises for what the file holds.

    path, choose  as :func:`addon.spectra.readers.read_file` has them
    """
    try:
        text = text_of_file(path, choose)
    except FacetFilmError as error:
        return Preview(str(path), trouble=str(error))
    return _of(text)


def preview_text(content, name="pasted text", choose=()):
    """The Preview of a text, as from the clipboard.

    >>> seen = preview_text("nm, n, k\\n400, 1.66, 1.96\\n700, 0.13, 4.07")
    >>> seen.quantity, seen.range_nm, seen.read_as
    ('n and k', (400.0, 700.0), 'a table')
    >>> preview_text("400, 4.2\\n700, 4.1").choices
    ('n', 'R', 'R in %')
    """
    try:
        text = Text(name, content, choose=choose)
    except FacetFilmError as error:
        return Preview(name, trouble=str(error))
    return _of(text)


def _of(text):
    read_as = format_of(text)
    try:
        constants = read_text(text)
    except Ambiguous as error:
        return Preview(text.name, read_as, choices=error.choices, trouble=str(error), assumed=tuple(text.assumed))
    except FacetFilmError as error:
        return Preview(text.name, read_as, trouble=str(error), assumed=tuple(text.assumed))
    viewing = Viewing()
    n, k = constants.at(observers.WAVELENGTH_NM)
    f0 = fresnel.conductor(1.0, n, k) @ viewing.weights
    srgb = encoded(viewing.map(f0)[0])
    quantity = "R" if constants.normal_only else "n and k" if constants.has_k else "n"
    return Preview(text.name, read_as, quantity, tuple(constants.range_nm), constants.covers_visible,
                   tuple(f0.tolist()), tuple(srgb.tolist()), constants.assumed, constants=constants)
