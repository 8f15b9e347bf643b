"""A file or pasted text as numbered lines, and the one way in which readers refuse it."""

import codecs
import os
import re
import stat

from ...errors import FacetFilmError

__all__ = ["Text", "Ambiguous", "text_of_file", "number_of", "shown", "LARGEST_BYTES"]

LARGEST_BYTES = 8_000_000
"""Of a file or text."""
MOST_LINES = 100_000
"""A spectrum has hundreds; so many are read in about a second."""

BYTE_ORDER_MARKS = (
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF32_LE, "utf-32"),
    (codecs.BOM_UTF32_BE, "utf-32"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)
NOT_TEXT = re.compile(r"[\x00-\x08\x0e-\x1f\x7f\ud800-\udfff]")
END_OF_FILE = "\x1a"
"""With which files of DOS end: those of the SOPRA collection are as old."""
LONGEST_LINE = 1_000_000
"""Letters: a spectrum in one line has thousands."""
NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", re.ASCII)
OLD_ENCODINGS = ("gb18030", "shift_jis", "cp1251", "cp949", "cp1250", "cp1252")
"""Of text that is not UTF-8, those in which a heading is a word that headings have; else Latin-1."""
SAMPLE = 20_000
"""Bytes by which the encoding is told."""


class Ambiguous(FacetFilmError):
    """A file that holds or can mean several things: `choices` names them, and one is to be chosen by its name."""

    def __init__(self, sentence, choices):
        super().__init__(sentence)
        self.choices = tuple(choices)


class Text:
    """Lines of text with the name of where they are from.

    name     for messages
    lines    ``lines[0]`` is line 1
    path     of its file, or None: beside it the other half of a pair may lie
    choose   which of several things or readings is meant, names in small letters
    assumed  what was taken for granted so far, a line each

    Raises FacetFilmError for what is empty, too long or no text.

    >>> Text("gold.csv", "a\\r\\nb").lines
    ['a', 'b']
    """

    def __init__(self, name, content, path=None, choose=()):
        self.name = _one_line(name) or "text"
        self.path = path
        self.choose = tuple(
            str(one).strip().lower() for one in ((choose,) if isinstance(choose, str) else choose or ())
        )
        self.assumed = []
        if not isinstance(content, str):
            self.refuse(None, "is no text", "lines of numbers")
        if len(content) > LARGEST_BYTES:
            self.refuse(
                None,
                f"has {len(content) / 1e6:.1f} MB and is too large to be a spectrum",
                f"at most {LARGEST_BYTES / 1e6:g} MB",
            )
        content = content.removeprefix("\ufeff").rstrip(END_OF_FILE)
        self.lines = re.split(r"\r\n|\r|\n", content)
        strange = NOT_TEXT.search(content)
        if strange:
            line = len(re.split(r"\r\n|\r|\n", content[: strange.start()]))
            self.refuse(line, "is binary", "a text file such as CSV")
        if len(self.lines) > MOST_LINES:
            self.refuse(None, f"has {len(self.lines)} lines, too many for a spectrum", f"at most {MOST_LINES}")
        if not content.strip():
            self.refuse(None, "is empty", "lines of wavelength, n, k")
        longest = max(range(len(self.lines)), key=lambda at: len(self.lines[at]))
        if len(self.lines[longest]) > LONGEST_LINE and content.lstrip()[:1] not in ("{", "[", "<"):
            self.refuse(longest + 1, f"has {len(self.lines[longest])} letters", "a point a line")

    @property
    def suffix(self):
        """What the name ends with, in small letters: ".csv"."""
        return os.path.splitext(self.name)[1].lower()

    @property
    def title(self):
        """The name without what it ends with, for people."""
        return os.path.splitext(self.name)[0].replace("_", " ").strip() or self.name

    @property
    def content(self):
        """All of it, in lines."""
        return "\n".join(self.lines)

    def assume(self, what):
        """Keep a line that says what was taken for granted; once each."""
        if what not in self.assumed:
            self.assumed.append(what)

    def chosen(self, names):
        """The first of these names that the caller chose, or None."""
        return next((name for name in names if name.strip().lower() in self.choose), None)

    def ask(self, line, found, choices, expected="a choice of them"):
        """The one of the choices that the caller made; else raise Ambiguous, which names them."""
        chosen = self.chosen(choices)
        if chosen is not None:
            return chosen
        place = self.name if line is None else f"{self.name}, line {line}"
        shown = [_one_line(choice)[:40] for choice in choices[:8]]
        names = ", ".join(shown[:-1]) + " or " + shown[-1] if len(shown) > 1 and len(choices) <= 8 else ", ".join(shown)
        names += f", … ({len(choices)} in all)" if len(choices) > 8 else ""
        raise Ambiguous(f"{place}: {_one_line(found)} {names}; expected {expected}.", choices)

    def refuse(self, line, found, expected):
        """Raise the error that names line, what stands there, and what was expected.

        line  its number, or None for the whole text
        """
        place = self.name if line is None else f"{self.name}, line {line}"
        raise FacetFilmError(f"{place}: {_one_line(found)}; expected {expected}.")


def text_of_file(path, choose=()):
    """The Text in a file: UTF-8, UTF-16 or UTF-32 with a byte order mark, an older encoding, or Latin-1.

    Raises FacetFilmError for a file that cannot be read or is longer than LARGEST_BYTES.
    """
    try:
        shown = os.fsdecode(path)
        name = _one_line(os.path.basename(shown) or shown)
        found = os.stat(path)
        if stat.S_ISDIR(found.st_mode):
            raise FacetFilmError(f"{name}: is a folder; expected a file of measurements.")
        if not stat.S_ISREG(found.st_mode):
            raise FacetFilmError(f"{name}: is a device, not a file; expected a file of measurements.")
        if found.st_size > LARGEST_BYTES:
            raise FacetFilmError(
                f"{name}: has {found.st_size / 1e6:.1f} MB and is too large "
                "to be a spectrum; "
                f"expected at most {LARGEST_BYTES / 1e6:g} MB."
            )
        with open(path, "rb") as file:
            content = file.read(LARGEST_BYTES + 1)
    except OSError as error:
        why = (error.strerror or "cannot be read").lower()
        raise FacetFilmError(f"{name or 'The path'}: {why}; expected a file that can be read.") from None
    except FacetFilmError:
        raise
    except (TypeError, ValueError):
        raise FacetFilmError(f"{_one_line(path)!r} is no path of a file; expected one.") from None
    return Text(name, _decoded(name, content), shown, choose)


def _decoded(name, content):
    for mark, encoding in BYTE_ORDER_MARKS:
        if content.startswith(mark):
            try:
                return content.decode(encoding)
            except UnicodeDecodeError:
                raise FacetFilmError(
                    f"{name}: is damaged, or not the {encoding} text that its first bytes "
                    "announce; expected UTF-8 text."
                ) from None
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError:
        return content.decode(
            next((encoding for encoding in OLD_ENCODINGS if _makes_sense(content, encoding)), "latin-1"), "replace"
        )


def _makes_sense(content, encoding):
    """Whether bytes in an encoding have a word of the headings that they lack as plain letters."""
    from .headings import names_beyond_ascii

    try:
        sample = content[:SAMPLE].decode(encoding, "strict" if len(content) <= SAMPLE else "ignore")
    except UnicodeDecodeError:
        return False
    return names_beyond_ascii(sample)


def number_of(text, line, word, what, decimal_comma=False):
    """A word of the text as a float.

    line  its number
    what  what the number is, for the message

    Raises FacetFilmError where it is none, or not finite.

    >>> number_of(Text("a", "1,5"), 1, "1,5", "n", decimal_comma=True)
    1.5
    """
    if decimal_comma:
        if "." in word:
            text.refuse(
                line,
                f"{shown(word)} has a decimal point where other numbers have a decimal comma",
                "the same in all numbers",
            )
        plain = word.replace(",", ".", 1)
    else:
        plain = word
    if not NUMBER.fullmatch(plain):
        found = f"{what} is missing" if not word else f"{what} is {shown(word)}"
        text.refuse(line, found, "a number")
    value = float(plain)
    if value in (float("inf"), float("-inf")):
        text.refuse(line, f"{what} is {shown(word)}, which is too large", "a number")
    return value


def shown(word):
    """A word for a message: quoted, and not too long."""
    return repr(word if len(word) <= 24 else word[:24] + "…")


def _one_line(value):
    """Anything as one short line of printable characters."""
    printable = "".join(c if c.isprintable() else " " for c in str(value)[:400])
    return " ".join(printable.split())[:200]
