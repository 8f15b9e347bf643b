"""Pages of refractiveindex.info as people paste them: the address, and the n and k of one wavelength."""

import re

from ..optical_constants import dataset_of_address, load

__all__ = ["is_address", "read_address", "is_one_wavelength", "refuse_one_wavelength"]

ADDRESS = re.compile(r"\s*<?https?://\S*refractiveindex\.info\S*>?\s*", re.IGNORECASE)
ONE_VALUE = re.compile(
    r"(?:^|[\s,;])(?:n|k|refractive index|extinction coefficient|wavelength|λ|R|α)\b[^=:\n]{0,40}[=:]\s*[-+]?\d",
    re.IGNORECASE,
)
FEW_LINES = 12


def is_address(text):
    """Whether it is nothing but the address of a page there."""
    return bool(ADDRESS.fullmatch(text.content))


def read_address(text):
    """The OpticalConstants of the dataset whose page has this address.

    Raises FacetFilmError where the bundle has no such dataset.

    >>> from .text import Text
    >>> read_address(Text("pasted", "https://refractiveindex.info/?shelf=main&book=Au&page=Johnson")).dataset
    'main/Au/Johnson'
    """
    address = text.content.strip().strip("<>")
    dataset = dataset_of_address(address)
    if dataset is None:
        text.refuse(
            None,
            f"the address {address[:80]} names no dataset",
            "one with shelf, book and page, such as …/?shelf=main&book=Au&page=Johnson",
        )
    return load(dataset)


def is_one_wavelength(text):
    """Whether it is no more than "n = …, k = …" of one wavelength, as a page shows them."""
    lines = [line for line in text.lines if line.strip()]
    return (
        len(lines) <= FEW_LINES
        and len(ONE_VALUE.findall(text.content)) >= 1
        and sum(bool(re.match(r"\s*[-+.\d]", line)) for line in lines) <= 1
    )


def refuse_one_wavelength(text):
    """Raise the error that says so."""
    text.refuse(
        None,
        "has n and k of one wavelength: a colour follows from the whole of the visible",
        "the data of the page (its CSV), or its address",
    )
