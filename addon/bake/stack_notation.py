"""Stacks in one line, from the outside in: ``water | MgF2 100 nm / glass``.

    [outside |] film / film / … / below

outside   what is above, "air" where nothing is said
film      what it is of, then its thickness: "60 nm", "0.1 µm", or a range
          "0-1000 nm" of what varies; several ranges vary together
below     what is below, without a thickness
( … )xN   films that repeat: "(TiO2 58 nm / SiO2 94 nm)x8 / glass"

A layer is of a dataset "shelf/book/page", a word that the look-up knows, or an
index (:func:`addon.bake.film_names.constant_index`).  Between layers a slash
has a space at both sides: datasets and Cauchy's b/λ² have slashes of their own.
"""

import functools
import re
from typing import NamedTuple

from ..errors import FacetFilmError

__all__ = ["Layer", "Layers", "layers_of", "parse", "text_of", "written"]

NUMBER = r"(\d+\.?\d*|\.\d+)"
THICKNESS = re.compile(rf"^(.*\S)\s+(-?){NUMBER}\s*(?:[-–]\s*{NUMBER}\s*)?(nm|µm|μm|um|Å)$")
UNITS = {"nm": 1.0, "µm": 1000.0, "μm": 1000.0, "um": 1000.0, "Å": 0.1}
REPEAT = re.compile(r"^\((.*)\)\s*[x×*]\s*(\d+)$", re.DOTALL)
MOST_REPEATS = 50


class Layer(NamedTuple):
    """A film as a text says it: its word, thickness from low to high in nm, and the piece of the text."""

    word: str
    low: float
    high: float
    place: str = ""


class Layers(NamedTuple):
    """What a text says, before anything is looked up: words of what is outside and below, and a Layer for each film."""

    outside: str
    films: tuple
    below: str


def parse(text, lookup):
    """The Stack that a text says.

    lookup  function of a word -> OpticalConstants, which raises FacetFilmError
            for what it does not know; words of film_names.DATASETS, "air" and
            indices never reach it

    Raises FacetFilmError that begins with the place.

    >>> from ..spectra.optical_constants import load
    >>> stack = parse("water | SiO2 0-100 nm / 2.4+0.1i 20 nm / main/Ti/Palm", load)
    >>> stack.thickness_range_nm, len(stack.films), written(stack)
    ((0.0, 100.0), 2, 'water | SiO2 0-100 nm / 2.4+0.1i 20 nm / main/Ti/Palm')
    >>> parse("SiO2 -60 nm / glass", load)
    Traceback (most recent call last):
    ...
    addon.errors.FacetFilmError: At 'SiO2 -60 nm': a thickness is from 0 nm on, the lower end of a range first.
    """
    from .film_names import film_lookup
    from .film_stack import Film, Stack
    said, find = layers_of(text), functools.cache(film_lookup(lookup))  # films alike are then told by their constants
    films = tuple(Film(film.word, _found(film.word, film.place, find), film.low, film.high) for film in said.films)
    return Stack(said.outside, _found(said.outside, said.outside, find), films,
                 said.below, _found(said.below, said.below, find))


def layers_of(text):
    """The :class:`Layers` of a text, films that repeat one by one.  Raises FacetFilmError that begins with the place.

    >>> layers_of("water | (TiO2 58 nm / SiO2 90-94 nm)x2 / glass").films[1][:3]
    ('SiO2', 90.0, 94.0)
    """
    if not isinstance(text, str) or not text.strip():
        raise FacetFilmError("A stack is a text such as 'SiO2 0-1000 nm / Si', from the outside in, not {value!r}.",
                             value=text)
    outside, bar, inside = text.rpartition("|")
    outside = outside.strip() or "air"
    if bar and "|" in outside:
        raise FacetFilmError("At {place!r}: what is outside stands before one bar, and there are more.",
                             place=text.strip())
    *films, below = _pieces(inside)
    films = tuple(film for piece in films for film in _films(piece))
    if THICKNESS.match(below) or REPEAT.match(below):
        raise FacetFilmError("At {place!r}: the last layer is what is below all films and has no thickness; name it "
                             "after another ' / '.", place=below)
    return Layers(outside, films, below)


def written(stack):
    """The text of a Stack, with what repeats in brackets.

    >>> from ..spectra.optical_constants import load
    >>> written(parse("(TiO2 58 nm / SiO2 94 nm)x3 / TiO2 58nm / glass", load))
    '(TiO2 58 nm / SiO2 94 nm)x3 / TiO2 58 nm / glass'
    """
    return text_of(stack)


def text_of(layers):
    """The text of a Stack or of :class:`Layers`.

    >>> text_of(Layers("air", (Layer("SiO2", 0.0, 300.0),), "Si"))
    'SiO2 0-300 nm / Si'
    """
    outside = "" if layers.outside == "air" else f"{layers.outside} | "
    return outside + " / ".join([*_folded([_film_text(film) for film in layers.films]), layers.below])


def _pieces(text):
    """The pieces between slashes that have spaces around and stand in no brackets."""
    pieces, depth, start = [], 0, 0
    for match in re.finditer(r"[()]|(?<=\s)/(?=\s)", text):
        depth += {"(": 1, ")": -1}.get(match[0], 0)
        if depth < 0:
            break
        if match[0] == "/" and not depth:
            pieces.append(text[start:match.start()])
            start = match.end()
    if depth:
        raise FacetFilmError("At {place!r}: a bracket has no other; films that repeat are written "
                             "'(TiO2 58 nm / SiO2 94 nm)x8'.", place=text[start:].strip())
    pieces = [piece.strip() for piece in (*pieces, text[start:])]
    if not all(pieces):
        raise FacetFilmError("At {place!r}: a layer is missing between two slashes or at an end.", place=text.strip())
    return pieces


def _films(piece):
    """The Layers of one piece: one, or those that repeat."""
    repeated = REPEAT.match(piece)
    if repeated:
        times = int(repeated[2])
        if not 1 <= times <= MOST_REPEATS:
            raise FacetFilmError("At {place!r}: films repeat 1 to {most} times, not {times}.", place=piece,
                                 most=MOST_REPEATS, times=times)
        return [film for inner in _pieces(repeated[1]) for film in _films(inner)] * times
    return [_film(piece)]


def _film(piece):
    found = THICKNESS.match(piece)
    if not found:
        raise FacetFilmError("At {place!r}: a film is named with its thickness, such as 'SiO2 100 nm', or with a "
                             "range, 'SiO2 0-1000 nm'.", place=piece)
    word, sign, first, last, unit = found.groups()
    low, high = (round(float(number) * UNITS[unit], 6) for number in (first, last or first))
    if sign or high < low:
        raise FacetFilmError("At {place!r}: a thickness is from 0 nm on, the lower end of a range first.", place=piece)
    return Layer(word, low, high, piece)


def _found(word, place, find):
    try:
        return find(word)
    except FacetFilmError as error:
        raise FacetFilmError("At {place!r}: {why}", place=place, why=error) from None


def _film_text(film):
    span = f"{film.low:g}-{film.high:g}" if film.high > film.low else f"{film.low:g}"
    return f"{film.word} {span} nm"


def _folded(texts):
    """The texts with runs that repeat in brackets, the longest run first at each place."""
    found, place = [], 0
    while place < len(texts):
        period, times = max(((p, _times(texts, place, p)) for p in range(1, (len(texts) - place) // 2 + 1)),
                            key=lambda run: (run[0] * run[1] if run[1] > 1 else 0, -run[0]), default=(1, 1))
        if times > 1:
            found.append(f"({' / '.join(texts[place:place + period])})x{times}")
        else:
            period, times = 1, 1
            found.append(texts[place])
        place += period * times
    return found


def _times(texts, place, period):
    """How often the texts from a place on repeat with this period, up to what parse() takes."""
    times = 1
    while times < MOST_REPEATS and texts[place + times * period:place + (times + 1) * period] == \
            texts[place:place + period]:
        times += 1
    return times
