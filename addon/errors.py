"""The one error that users of this extension see, and the checks that raise it."""

import math
import numbers

__all__ = ["FacetFilmError", "number", "numbers_of", "choice"]


class FacetFilmError(ValueError):
    """Input that cannot be used: one sentence naming the thing, its range and the way out.

    sentence  what is wrong, with {names} of the values that stand in it: what a translation is looked up by
    values    those; a tuple is a choice of names, `name` is what the thing is called in the interface, and an error
              is the reason, said in the same language
    """

    def __init__(self, sentence, **values):
        self.sentence, self.values = sentence, values
        super().__init__(self.said())

    def said(self, translate=str):
        """The whole sentence; `translate` takes English, with {names} as it stands in the source, to another language.

        >>> error = FacetFilmError("{name} {value!r} is unknown", name="preset", value="coper")
        >>> error.said({"preset": "Voreinstellung", "{name} {value!r} is unknown": "{name} {value!r} fehlt"}.get)
        "Voreinstellung 'coper' fehlt"
        """
        if not self.values:
            return translate(self.sentence)
        shown = {key: translate(value) if key == "name" else
                 translate(" or ").join(map(repr, value)) if isinstance(value, tuple) else
                 value.said(translate) if isinstance(value, FacetFilmError) else value
                 for key, value in self.values.items()}
        return translate(self.sentence).format(**shown)


def number(name, value, low=-math.inf, high=math.inf, *, above=None, below=None, unit=""):
    """The value as a float within [low, high], and above or below a bound that it may not touch.

    Raises FacetFilmError naming the parameter and its range.

    >>> number("slope m", 0.3, above=0)
    0.3
    >>> number("specular", 2, 0, 1)
    Traceback (most recent call last):
    ...
    addon.errors.FacetFilmError: specular must be a number from 0 to 1, not 2.
    """
    lowest = f"above {above:g}" if above is not None else f"from {low:g}" if low > -math.inf else ""
    highest = f"below {below:g}" if below is not None else f"to {high:g}" if high < math.inf else ""
    if not highest and lowest.startswith("from"):
        lowest = f"at least {low:g}"
    if lowest.startswith("above") and highest.startswith("to"):
        highest = f"and at most {high:g}"
    if lowest and highest.startswith("below"):
        highest = "and " + highest
    span = " ".join(part for part in (lowest, highest, unit) if part) or "finite"
    valid = isinstance(value, numbers.Real) and not isinstance(value, bool) and math.isfinite(value)
    valid = valid and low <= value <= high
    valid = valid and (above is None or value > above) and (below is None or value < below)
    if not valid:
        raise FacetFilmError(f"{name} must be a number {span}, not {value!r}.")
    return float(value)


def numbers_of(name, values, count, low=-math.inf, high=math.inf, **bounds):
    """Exactly `count` numbers as a tuple of floats, each checked as :func:`number` does."""
    try:
        found = tuple(values.tolist() if hasattr(values, "tolist") else values)
    except TypeError:
        found = None
    if found is None or isinstance(values, (str, bytes)) or len(found) != count:
        raise FacetFilmError(f"{name} must be {count} numbers, not {values!r}.")
    return tuple(number(f"{name}[{i}]", value, low, high, **bounds) for i, value in enumerate(found))


def choice(name, value, valid):
    """The value if it is one of the valid names; else an error with the nearest of them.

    >>> choice("realisation", "fst", ("fast", "exact"))
    Traceback (most recent call last):
    ...
    addon.errors.FacetFilmError: realisation 'fst' is unknown; did you mean 'fast'? Valid: 'fast', 'exact'.
    """
    valid = tuple(valid)
    if isinstance(value, str) and value in valid:
        return value
    import difflib
    near = tuple(difflib.get_close_matches(str(value), valid, 3, 0.5))
    shown = ", ".join(map(repr, valid[:12])) + (", …" if len(valid) > 12 else "")
    if near:
        raise FacetFilmError("{name} {value!r} is unknown; did you mean {near}? Valid: {valid}.",
                             name=name, value=value, near=near, valid=shown)
    raise FacetFilmError("{name} {value!r} is unknown; Valid: {valid}.", name=name, value=value, valid=shown)
