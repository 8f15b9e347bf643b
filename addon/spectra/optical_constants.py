"""Optical constants n and k over wavelength: the record, and the database they are loaded from."""

import dataclasses
import difflib
import functools
import re
import urllib.parse

import numpy as np

from ..errors import FacetFilmError
from ..reflectance import fresnel
from . import dispersion, names, tables

__all__ = [
    "OpticalConstants", "load", "from_normal_reflectance", "dataset_ids", "sampled_formula", "sampled_wavelengths",
    "on_common_wavelengths", "ascending", "dataset_of_address", "VISIBLE_NM", "CORE_NM", "SOURCE",
]

VISIBLE_NM = (360.0, 780.0)
CORE_NM = (400.0, 700.0)
SOURCE = "refractiveindex.info"
TABLE = "refractiveindex"
SHELVES = ("main", "organic", "glass", "other", "3d", "specs", "popular_glass")


@dataclasses.dataclass(frozen=True, eq=False)
class OpticalConstants:
    """n and k of a material at some wavelengths; linear in between, held beyond the ends.

    wavelength_nm  ascending, ``(W,)``
    n, k           index of refraction and extinction coefficient, ``(W,)``
    dataset        what identifies it: "shelf/book/page" of the database, or a file's name
    title          what it is, for people
    citation       who measured it and where that is published
    licence        of the data
    range_nm       wavelengths that were measured, low and high: may exceed what is kept of them
    has_k          whether k was measured; else it is 0
    normal_only    whether n stands for a measured normal reflectance, with k = 0
    comment        what the database says of the sample
    assumed        what a reader of files took for granted, a line each
    """

    wavelength_nm: np.ndarray
    n: np.ndarray
    k: np.ndarray
    dataset: str
    title: str = ""
    citation: str = ""
    licence: str = ""
    range_nm: tuple = ()
    has_k: bool = True
    normal_only: bool = False
    comment: str = ""
    assumed: tuple = ()

    def __post_init__(self):
        for name in ("wavelength_nm", "n", "k"):
            object.__setattr__(self, name, np.asarray(getattr(self, name), float))
        if not self.range_nm:
            ends = self.wavelength_nm[[0, -1]]
            object.__setattr__(self, "range_nm", tuple(ends.tolist()))

    def at(self, wavelength_nm):
        """(n, k) at these wavelengths, each of their shape: linear interpolation, ends held.

        >>> n, k = load("main/Cu/Johnson").at([550.0, 560.0])
        >>> k.round(2).tolist()
        [2.58, 2.62]
        """
        return (np.interp(wavelength_nm, self.wavelength_nm, self.n),
                np.interp(wavelength_nm, self.wavelength_nm, self.k))

    @property
    def covers_visible(self):
        """Whether 400 to 700 nm were measured wholly."""
        return self.range_nm[0] <= CORE_NM[0] and self.range_nm[1] >= CORE_NM[1]


def from_normal_reflectance(wavelength_nm, reflectance, dataset, **about):
    """OpticalConstants that stand for a normal reflectance: k = 0 and the effective index of each wavelength.

    wavelength_nm  ascending, ``(W,)``
    reflectance    at normal incidence, [0, 1], ``(W,)``; linear in between
    dataset, about as OpticalConstants has them: title, citation, licence …

    n = (1 + √F0)/(1 − √F0).  Cook and Torrance 1982.

    >>> from_normal_reflectance([400.0, 700.0], [0.04, 0.04], "glass").at(550.0)[0].round(6).tolist()
    1.5
    """
    measured = np.asarray(wavelength_nm, float)
    wavelength = _distinct(measured, np.arange(np.ceil(measured[0]), measured[-1]))
    n = fresnel.index_from_normal(np.interp(wavelength, measured, reflectance))
    return OpticalConstants(wavelength, n, np.zeros_like(n), dataset, has_k=False, normal_only=True,
                            range_nm=(float(measured[0]), float(measured[-1])), **about)


def dataset_ids():
    """The ids of all datasets, "shelf/book/page", in order.

    >>> "main/Au/Babar" in dataset_ids()
    True
    """
    return tuple(tables.part(TABLE, "places"))


@functools.lru_cache(maxsize=64)
def load(dataset):
    """The OpticalConstants of a dataset, "shelf/book/page" as refractiveindex.info names it.

    Points within 360 to 780 nm and a neighbour at either side; a dispersion
    formula is sampled at every nm of its range there.  Raises FacetFilmError
    with the nearest ids where there is no such dataset.

    >>> load("main/Cu/Johnson").title
    'Copper, Johnson and Christy 1972'
    """
    dataset = dataset_of_address(dataset) or dataset
    place = tables.part(TABLE, "places").get(dataset)
    if place is None:
        _refuse(dataset, tables.part(TABLE, "left_out"), dataset_ids())
    _, title, citation, comment, n_model, k_model = tables.line(TABLE, "records", place)
    n_points = _points(n_model)
    k_points = _points(k_model) if k_model else (n_points[0][:1], np.zeros(1))
    wavelength, n, k = on_common_wavelengths(n_points, k_points)
    ranges = [model[-2:] for model in (n_model, k_model) if model]
    return OpticalConstants(
        wavelength, n, np.maximum(k, 0.0), dataset, names.title_of(dataset, title),
        tables.line(TABLE, "citations", citation), tables.about(TABLE)["licence"],
        (max(low for low, _ in ranges), min(high for _, high in ranges)), bool(k_model), comment=comment)


def dataset_of_address(address):
    """The id of the dataset that an id, the address of its page or its path in the database names, or None.

    >>> dataset_of_address("https://refractiveindex.info/?shelf=main&book=Au&page=Johnson")
    'main/Au/Johnson'
    >>> dataset_of_address("database/data/main/Au/nk/Johnson.yml"), dataset_of_address("main/Au/Jonson")
    ('main/Au/Johnson', None)
    """
    places = tables.part(TABLE, "places")
    if address in places:
        return address
    plain = urllib.parse.unquote(str(address)).strip()
    query = urllib.parse.parse_qs(urllib.parse.urlsplit(plain).query) if "?" in plain else {}
    if {"book", "page"} <= set(query):
        parts = [query.get("shelf", ["main"])[0], query["book"][0], query["page"][0]]
    else:
        parts = re.split(r"[/\\]", re.sub(r"\.ya?ml$", "", plain))
        parts = [part for part in parts if part not in {"", ".", "nk", "data-nk"}]
        while parts and parts[0] not in SHELVES:
            parts = parts[1:]
    if len(parts) < 3:
        return None
    books = ("/".join(parts[1:-1]), "-".join(parts[1:-1]), parts[-2], parts[-2].rpartition(" - ")[2])
    by_path = _by_path()
    return next((by_path[one] for book in books if (one := _plain(f"{parts[0]}/{book}/{parts[-1]}")) in by_path), None)


@functools.lru_cache(maxsize=1)
def _by_path():
    return {_plain(dataset): dataset for dataset in tables.part(TABLE, "places")}


def _plain(dataset):
    return dataset.lower().replace("_", " ").replace("%20", " ")


def _refuse(dataset, left_out, known):
    """Raise the error of a dataset that is not in the table."""
    if dataset in left_out["no n"]:
        raise FacetFilmError("Dataset {dataset!r} has k but no n: no reflectance follows; choose another.",
                             dataset=dataset)
    if dataset in left_out["outside the visible"]:
        raise FacetFilmError("Dataset {dataset!r} covers less than 50 nm of the visible, 400 to 700 nm; "
                             "choose another.", dataset=dataset)
    book = "/".join(str(dataset).split("/")[:2]) + "/"
    same_material = [other for other in known if other.startswith(book)]
    near = difflib.get_close_matches(str(dataset), same_material or known, 3, 0.6) or same_material[:3]
    if near:
        raise FacetFilmError("dataset {dataset!r} is unknown; did you mean {near}? Datasets are named "
                             "'shelf/book/page', as refractiveindex.info does; a search finds them.",
                             dataset=dataset, near=tuple(near))
    raise FacetFilmError("dataset {dataset!r} is unknown. Datasets are named 'shelf/book/page', "
                         "as refractiveindex.info does; a search finds them.", dataset=dataset)


def _points(model):
    """(wavelengths in nm, values) of a stored model."""
    if model[0] == 0:
        _, place_w, place_v, count, _, _ = model
        # The database has at most 7 digits: take what single precision added away.
        wavelength = np.round(tables.numbers(TABLE, place_w, count).astype(float) * 1000.0, 4)
        return ascending(wavelength), tables.numbers(TABLE, place_v, count).astype(float)
    formula, place, count, low, high = model
    return sampled_formula(formula, tables.numbers(TABLE, place, count), low, high)


def sampled_formula(formula, coefficients, low, high):
    """(wavelengths in nm, n): a dispersion formula at every nm of its range within 360 to 780 nm.

    formula, coefficients  as :func:`addon.spectra.dispersion.index` has them
    low, high              range, nm; some of it within 360 to 780

    >>> sampled_formula(5, [1.5], 400.0, 402.5)[0].tolist()
    [400.0, 401.0, 402.0, 402.5]
    """
    wavelength = sampled_wavelengths(low, high)
    return wavelength, dispersion.index(formula, coefficients, wavelength / 1000.0)


def sampled_wavelengths(low, high):
    """Every nm of a range within 360 to 780 nm, and its ends.

    >>> sampled_wavelengths(778.5, 2000.0).tolist()
    [778.5, 779.0, 780.0]
    """
    low, high = max(low, VISIBLE_NM[0]), min(high, VISIBLE_NM[1])
    return _distinct([low], np.arange(np.ceil(low), high), [high])


def _distinct(*wavelengths):
    """All of them, ascending, each once: as numpy.unique, which loads half of numpy with its first call."""
    ascending = np.sort(np.concatenate(wavelengths))
    return ascending[np.concatenate([[True], ascending[1:] != ascending[:-1]])]


def ascending(wavelength):
    """Wavelengths of which none occurs twice: of those that do, all but the last come a trifle earlier.

    Of two values at one wavelength the last counts there, as with numpy.interp.
    """
    if np.all(wavelength[1:] > wavelength[:-1]):
        return wavelength
    apart = 1e-5 * np.arange(wavelength.size)
    return np.minimum.accumulate((wavelength - apart)[::-1])[::-1] + apart


def on_common_wavelengths(n_points, k_points):
    """(wavelengths, n, k): linear interpolation between them gives what it gave between each one's own.

    n_points, k_points  (wavelengths, values), ``(W,)`` each, W of either one's own

    >>> n = np.array([400.0, 700.0]), np.array([1.0, 2.0])
    >>> k = np.array([500.0, 700.0]), np.array([0.0, 1.0])
    >>> [found.round(3).tolist() for found in on_common_wavelengths(n, k)]
    [[400.0, 500.0, 700.0], [1.0, 1.333, 2.0], [0.0, 0.0, 1.0]]
    """
    (n_wavelength, n), (k_wavelength, k) = n_points, k_points
    if np.array_equal(n_wavelength, k_wavelength):
        return n_wavelength, n, k
    wavelength = _distinct(n_wavelength, k_wavelength)
    return wavelength, np.interp(wavelength, n_wavelength, n), np.interp(wavelength, k_wavelength, k)
