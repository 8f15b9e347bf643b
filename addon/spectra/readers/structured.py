"""Formats that are no lines of a table, brought to one: JSON, HTML, CGATS, scenes of pbrt and Mitsuba.

One more library's words are one more word in the tables of headings.py.
"""

import html
import json
import re

from .columns import finished, read_columns, series_of
from .headings import column_of
from .text import NUMBER, Text

__all__ = ["is_json", "read_json", "is_html", "read_html", "is_cgats", "read_cgats", "is_scene", "read_scene"]

CELL = re.compile(r"<t[dh]\b[^>]*>(.*?)(?=</t[dh]>|<t[dh]\b|</tr>|<tr\b|</table>|$)", re.IGNORECASE | re.DOTALL)
TAG = re.compile(r"<[^>]{0,300}>")
DEEPEST = 12
MOST_VALUES = 400_000


def is_json(text):
    """Whether the first letter is one of JSON's, and all of it can be JSON."""
    start = text.content.lstrip()[:1]
    if start != "[":
        return start == "{"
    try:
        json.loads(text.content)
    except (ValueError, RecursionError):
        return text.suffix == ".json"
    return True


def read_json(text):
    """The OpticalConstants of a Text in JSON: lists by name, rows, or one material of several.

    Raises FacetFilmError, or Ambiguous where several materials are there.

    >>> from .text import Text
    >>> read_json(Text("x.json", '{"wavelength": [400, 700], "n": [1.5, 1.4], "k": [0, 0]}')).n.tolist()
    [1.5, 1.4]
    """
    try:
        value = json.loads(text.content, parse_constant=lambda word: None)
    except (ValueError, RecursionError):
        text.refuse(None, "begins as JSON and is none", "JSON, or lines of wavelength, n, k")
    tables = {}
    _tables_in(value, "", tables, 0, {})
    if not tables:
        text.refuse(
            None,
            "is JSON without lists that are named as wavelengths and n, k or R: there are no numbers to read",
            'lists such as "wavelength", "n" and "k"',
        )
    names = list(tables)
    name = names[0] if len(names) == 1 else text.ask(None, "holds the materials", names, "one of them by its name")
    if len(names) > 1:
        text.assume(f"of {len(names)} materials: {name}")
    return read_columns(_as_text(text, tables[name]))


def _as_text(text, lines):
    """A Text of other lines that keeps the name, the choices and what was assumed."""
    made = Text(text.name, "\n".join(lines), text.path, text.choose)
    made.assumed = text.assumed
    return made


def _tables_in(value, name, tables, depth, units):
    """Add {name: lines of a table} of everything that is one within a JSON value."""
    if depth > DEEPEST or len(tables) > 500:
        return
    if isinstance(value, dict):
        units = {
            **units,
            **{str(key).lower(): word for key, word in value.items() if isinstance(word, str) and len(word) < 40},
        }
        lines = _of_lists(value, units) or _of_pairs(value, units) or _of_mapping(value)
        if lines:
            tables[name or str(value.get("name") or value.get("material") or "all")] = lines
            return
        for key, inner in value.items():
            title = inner.get("name") if isinstance(inner, dict) and isinstance(inner.get("name"), str) else None
            deeper = str(title or key) if str(key).lower() not in {"data", "values", "spectrum", "spectral"} else name
            _tables_in(inner, deeper, tables, depth + 1, units)
    elif isinstance(value, list) and value:
        if all(isinstance(row, dict) for row in value):
            lines = _of_records(value, units)
            if lines:
                tables[name or "all"] = lines
                return
            for at, row in enumerate(value[:500]):
                title = row.get("name") or row.get("id") or row.get("material") or row.get("label")
                _tables_in(row, str(title or f"{name} {at + 1}".strip()), tables, depth + 1, units)
        elif len(value) > 1 and all(isinstance(row, list) for row in value):
            lines = _of_rows(value, units)
            if lines:
                tables[name or "all"] = lines


def _is_numbers(value):
    return (
        isinstance(value, list)
        and len(value) > 1
        and all(isinstance(one, (int, float, type(None))) and not isinstance(one, bool) for one in value)
    )


def _numbers_of(value):
    """A list of numbers as it is, and of one whose numbers are written as text as well."""
    if (
        isinstance(value, list)
        and len(value) > 1
        and all(isinstance(one, str) and NUMBER.fullmatch(one.strip()) for one in value)
    ):
        return [float(one) for one in value]
    return value


def _heading(key, units):
    """A heading for a list's name, with the unit that stands beside it: wavelength_unit, units …"""
    plain = str(key)
    column = column_of(plain)
    if column.is_axis and not column.unit:
        for name in (
            f"{plain.lower()}_unit",
            f"{plain.lower()}_units",
            f"unit_{plain.lower()}",
            f"{plain.lower()}unit",
            "unit",
            "units",
            "x_unit",
            "xunit",
        ):
            word = units.get(name)
            if (
                word
                and column_of(f"wavelength ({word})").unit
                and not column_of(f"wavelength ({word})").unit.startswith("?")
            ):
                return f"{plain} ({word})"
    return plain.replace("\t", " ").replace("\n", " ")[:60]


def _of_lists(value, units):
    """Lines of lists of one length, one of which is an axis."""
    lists = {key: found for key, one in value.items() if _is_numbers(found := _numbers_of(one))}
    axes = [key for key in lists if column_of(str(key)).is_axis]
    if not axes:
        return None
    size = len(lists[axes[0]])
    columns = {key: one for key, one in lists.items() if len(one) == size and (key in axes or column_of(str(key)).role)}
    if len(columns) < 2:
        columns = {key: one for key, one in lists.items() if len(one) == size}
    if len(columns) < 2 or size * len(columns) > MOST_VALUES:
        return None
    return ["\t".join(_heading(key, units) for key in columns), *_lines(zip(*columns.values()))]


def _lines(rows):
    return ["\t".join("nan" if cell is None else repr(cell) for cell in row) for row in rows]


def _of_pairs(value, units):
    """Lines of {"n": [[λ, n] …], "k": [[λ, k] …]}, one table below the other."""
    found = []
    for key, rows in value.items():
        role = column_of(str(key)).role
        if (
            role in {"n", "k", "R", "ε1", "ε2"}
            and isinstance(rows, list)
            and rows
            and all(_is_numbers(row) and len(row) == 2 for row in rows)
        ):
            found += ["\t".join((_heading("wavelength", units), str(key))), *_lines(rows), ""]
        elif role in {"n", "k", "R", "ε1", "ε2"} and isinstance(rows, dict):
            axis = next((one for one in rows if column_of(str(one)).is_axis and _is_numbers(rows[one])), None)
            other = next(
                (
                    one
                    for one in rows
                    if one != axis and _is_numbers(rows[one]) and axis and len(rows[one]) == len(rows[axis])
                ),
                None,
            )
            if other is not None:
                found += [
                    "\t".join(
                        (
                            _heading(
                                axis, {**units, **{str(k).lower(): v for k, v in rows.items() if isinstance(v, str)}}
                            ),
                            str(key),
                        )
                    ),
                    *_lines(zip(rows[axis], rows[other])),
                    "",
                ]
    return found or None


def _of_mapping(value):
    """Lines of {"400": 0.38, "410": 0.39 …}."""
    if len(value) < 4 or not all(NUMBER.fullmatch(str(key).strip().removesuffix("nm").strip()) for key in value):
        return None
    if not all(isinstance(one, (int, float)) and not isinstance(one, bool) for one in value.values()):
        return None
    return [f"{str(key).strip().removesuffix('nm').strip()}\t{one!r}" for key, one in value.items()]


def _of_records(rows, units):
    """Lines of [{"wavelength": 400, "n": 1.5} …]."""
    keys = [key for key, one in rows[0].items() if isinstance(one, (int, float)) and not isinstance(one, bool)]
    if (
        len(rows) < 2
        or len(keys) < 2
        or not any(column_of(str(key)).is_axis for key in keys)
        or len(rows) * len(keys) > MOST_VALUES
    ):
        return None
    table = [[row.get(key) for key in keys] for row in rows]
    if not all(
        one is None or isinstance(one, (int, float)) and not isinstance(one, bool) for row in table for one in row
    ):
        return None
    return ["\t".join(_heading(key, units) for key in keys), *_lines(table)]


def _of_rows(rows, units):
    """Lines of [[400, 1.5, 0] …], below their headings where the first row has those."""
    head = rows[0] if all(isinstance(cell, str) for cell in rows[0]) and rows[0] else None
    body = rows[1:] if head else rows
    if not body or not all(_is_numbers(row) for row in body) or len(body) * len(body[0]) > MOST_VALUES:
        return None
    if not head and len(body) <= 4 < len(body[0]):
        body = [list(row) for row in zip(*body)]
    return [*(["\t".join(_heading(cell, units) for cell in head)] if head else []), *_lines(body)]


def is_html(text):
    """Whether there are rows of an HTML table."""
    content = text.content
    return "<" in content and bool(
        re.search(r"<tr\b", content, re.IGNORECASE) and re.search(r"<td\b", content, re.IGNORECASE)
    )


def read_html(text):
    """The OpticalConstants of a Text with an HTML table.

    >>> from .text import Text
    >>> read_html(Text("x.html", "<table><tr><td>400<td>1.5<tr><td>700<td>1.4</table>")).n.tolist()
    [1.5, 1.4]
    """
    rows = []
    for row in re.split(r"<tr\b", text.content, flags=re.IGNORECASE)[1:]:
        cells = [" ".join(html.unescape(TAG.sub("", cell)).split()) for cell in CELL.findall(row)]
        if any(cells):
            rows.append("\t".join(cells))
    if not rows:
        text.refuse(None, "is a web page in whose table there are no numbers", "a table of wavelength, n, k")
    return read_columns(_as_text(text, rows))


def is_cgats(text):
    """Whether there is a BEGIN_DATA and a list of fields with wavelengths, as in Argyll's files."""
    content = text.content
    return "BEGIN_DATA" in content and "BEGIN_DATA_FORMAT" in content


WAVELENGTH_FIELD = re.compile(
    r"(?:SPEC|SPECTRAL|NM|R|SPECTRAL_NM|SPECTRAL_|LAMBDA)[_ ]*(?:NM)?_?(\d{3,4}(?:\.\d+)?)(?:NM)?", re.IGNORECASE
)


def read_cgats(text):
    """The OpticalConstants of the reflectances in a CGATS file: the only set, or the chosen one.

    Raises Ambiguous, which names the sets, where none is chosen.

    >>> from .text import Text
    >>> fields = " ".join(f"SPEC_{w}" for w in (400, 500, 600, 700))
    >>> sp = f"BEGIN_DATA_FORMAT\\n{fields}\\nEND_DATA_FORMAT\\nBEGIN_DATA\\n38 47 93 97\\nEND_DATA"
    >>> read_cgats(Text("x.sp", sp)).normal_only
    True
    """
    content = text.content
    fields = _between(content, "BEGIN_DATA_FORMAT", "END_DATA_FORMAT").split()
    body = re.split(r"^\s*BEGIN_DATA\s*$", content, maxsplit=1, flags=re.MULTILINE)
    rows = [
        _words(line)
        for line in (body[1].partition("END_DATA")[0] if len(body) > 1 else "").splitlines()
        if line.strip()
    ]
    places = {at: float(match[1]) for at, field in enumerate(fields) if (match := WAVELENGTH_FIELD.fullmatch(field))}
    if len(places) < 2:
        text.refuse(None, "is CGATS without spectra: no field names a wavelength", "fields such as SPEC_400")
    words = [word for row in rows for word in row]
    if fields and len(words) % len(fields) == 0 and any(len(row) != len(fields) for row in rows):
        rows = [words[at : at + len(fields)] for at in range(0, len(words), len(fields))]
    sets = {}
    for at, row in enumerate(rows):
        if len(row) != len(fields):
            text.refuse(None, f"set {at + 1} has {len(row)} cells", f"{len(fields)}, as its fields")
        labels = [
            row[place]
            for place, field in enumerate(fields)
            if field.upper() in {"SAMPLE_NAME", "SAMPLE_ID", "SAMPLEID", "SAMPLE_LOC", "NAME"}
        ]
        name = labels[-1] if labels else str(at + 1)
        sets.setdefault(name if name not in sets else f"{name} ({at + 1})", row)
    if not sets:
        text.refuse(None, "there are no numbers between BEGIN_DATA and END_DATA", "a set of numbers")
    names = list(sets)
    name = names[0] if len(names) == 1 else text.ask(None, "holds the spectra", names, "one of them by its name")
    if len(names) > 1:
        text.assume(f"of {len(names)} spectra: {name}")
    emission = re.search(r"SPECTRAL_MEAS(?:UREMENT)?_TYPE\s+\"?(EMISSION|AMBIENT|TRANSMISSIVE)", content, re.IGNORECASE)
    if emission:
        text.refuse(None, f"is a spectrum of {emission[1].lower()} light", "a reflectance")
    norm = re.search(r"SPECTRAL_NORM\s+\"?([\d.]+)", content)
    values = {at: sets[name][at] for at in places}
    percent = norm is None or float(norm[1]) == 100.0
    numeric = [float(word) for word in values.values() if NUMBER.fullmatch(word)]
    if norm is None and numeric and max(numeric) <= 1.5:
        percent = False
    lines = [f"nm\t{'R (%)' if percent else 'R'}", *(f"{nm:g}\t{values[at]}" for at, nm in places.items())]
    return read_columns(_as_text(text, lines))


def _between(content, start, end):
    return content.partition(start)[2].partition(end)[0]


def _words(line):
    return [quoted or bare for quoted, bare in re.findall(r'"([^"]*)"|(\S+)', line)]


PBRT = re.compile(r'"(?:spectrum|float)\s+(?:\w+\.)?(eta|k)"\s*(?:\[\s*([^\]]*?)\s*\]|("[^"]*"))')
MITSUBA = re.compile(r"<spectrum\b([^<>]*)>", re.IGNORECASE)
ATTRIBUTE = re.compile(r'\b(name|value|filename)\s*=\s*"([^"]*)"', re.IGNORECASE)
NAMES = {"eta": "eta", "int_eta": "eta", "k": "k", "reflectance": "reflectance", "specular_reflectance": "reflectance"}
"""What a scene calls a spectrum -> what is read of it."""


def _mitsuba(content):
    """(name, its numbers as text, or in quotes the name of what holds them) of the spectra of a scene of Mitsuba."""
    for tag in MITSUBA.finditer(content):
        said = {key.lower(): value for key, value in ATTRIBUTE.findall(tag[1])}
        name = NAMES.get(said.get("name", "").lower())
        if name and ("value" in said or "filename" in said):
            yield name, said["value"] if "value" in said else f'"{said["filename"]}"'


def is_scene(text):
    """Whether it has a spectrum as scenes of pbrt or Mitsuba do."""
    content = text.content
    pbrt = '"spectrum ' in content and PBRT.search(content)
    return bool(pbrt) or "<spectrum" in content and any(True for _ in _mitsuba(content))


def read_scene(text):
    """The OpticalConstants of eta and k that stand in a scene of pbrt or Mitsuba.

    >>> from .text import Text
    >>> scene = '"spectrum eta" [ 400 0.1 700 0.2 ] "spectrum k" [ 400 2 700 4 ]'
    >>> read_scene(Text("x.pbrt", scene)).k.tolist()
    [2.0, 4.0]
    """
    lines, seen = [], set()
    found = [(match[1].lower(), match[2] or match[3] or "") for match in PBRT.finditer(text.content)]
    found += _mitsuba(text.content)
    for name, content in found:
        if content.startswith('"'):
            text.refuse(
                None,
                f"{name} is the spectrum named {content[:60]}, and not in this file",
                "its numbers, or that file itself",
            )
        numbers = [word for word in re.split(r"[\s,:]+", content.strip()) if word]
        if len(numbers) < 4 or len(numbers) % 2 or not all(NUMBER.fullmatch(word) for word in numbers):
            text.refuse(None, f"{name} is no row of wavelengths and values", "wavelength and value by turns")
        if name in seen:
            text.refuse(None, f"{name} comes a second time", "one material")
        seen.add(name)
        lines += [
            f"wavelength\t{'R' if 'reflectance' in name else name}",
            *(f"{w}\t{v}" for w, v in zip(numbers[::2], numbers[1::2])),
            "",
        ]
    series = _as_text(text, lines)
    if seen == {"eta"} or seen == {"k"}:
        text.refuse(None, f"has {seen.pop()} alone, half of a pair", "eta and k")
    return finished(series, series_of(series))
