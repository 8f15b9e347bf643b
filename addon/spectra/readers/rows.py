"""Lines of text as tables of cells: which lines are numbers, what parts their columns, what stands above them.

One more way to part columns or to write a number is one more line in SEPARATORS, COMMENTS, MISSING or NUMBERS.
"""

import csv
import dataclasses
import re

from .headings import LONGEST, column_of, columns_of
from .text import NUMBER, shown

__all__ = ["Table", "Row", "ROW", "tables_of", "number_in", "numbers", "MISSING", "COMMENTS", "SEPARATORS"]

COMMENTS = ("#", "%", "!", "//", "*", "--", "'", "\\")
"""What lines begin with that are remarks, and ";" where the table's first line has it; they can name the columns."""
SEPARATORS = {"\t": "tabs", ";": "semicolons", "|": "bars", ",": "commas", None: "spaces"}
"""What parts columns, most certain first."""
MISSING = {"", "nan", "na", "n/a", "#n/a", "-nan", "null", "-", "--", "---", "nd", "n.d."}
"""Cells of a table in which nothing was measured, in small letters."""

ROW = -1
MOST_TABLES = 200
"""In one file, below each other."""
DATA = re.compile(r"[\"'“”\s,;|(]*[+\-−]?(?:[.,]?\d|nan\b|inf(?:inity)?\b)", re.IGNORECASE)
BRACKETED = re.compile(r"[\[(]{1,2}([^\[\]]*?)[\])]{0,2}\s*[,;]?")
PLAIN = re.compile(r"[-+0-9.eE,;|\t ]*")
COMMA_NUMBER = r"[+-]?\d+(?:,\d+)?(?:[eE][+-]?\d+)?"
DECIMAL_COMMA_ROW = re.compile(rf"{COMMA_NUMBER}(?:\s+{COMMA_NUMBER})+")
NUM = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?"
COMPLEX = re.compile(
    rf"\(?\s*(?P<re>{NUM})\s*(?P<sign>[+-])\s*(?:(?P<im>(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)\s*\*?\s*[ij]|[ij]\s*\*?\s*(?P<mi>(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?))\s*\)?",
    re.ASCII | re.IGNORECASE,
)
SPACED_COMPLEX = re.compile(r"(?<=[\d.)])\s+([+-])\s+(?=[\dij.])")
SUFFIXED = re.compile(rf"(?P<number>{NUM})\s*(?P<unit>nm|um|µm|μm|ev|%|å|cm-1|thz)", re.ASCII | re.IGNORECASE)
FORTRAN = re.compile(r"([+-]?(?:\d+\.?\d*|\.\d+))[dD]([+-]?\d+)", re.ASCII)


@dataclasses.dataclass
class Row:
    """A line of numbers.

    line    its number
    values  floats, complex numbers, and NaN where a cell is empty or is no number
    faults  (what was found, what was expected) by column of cells that are no numbers; by ROW of the whole row
    """

    line: int
    values: list
    faults: dict = None


@dataclasses.dataclass
class Table:
    """Rows below each other with the same number of columns.

    above    (line, text, whether it is a remark) of what stands above, down to the first row
    rows     the Rows
    columns  the Columns that headings name, or None; set where they stand
    below    the same as above, of what follows
    """

    above: list
    rows: list
    columns: list = None
    below: list = dataclasses.field(default_factory=list)

    @property
    def width(self):
        """How many columns there are."""
        return len(self.rows[0].values)


def tables_of(text):
    """The Tables of a Text, from the top down.

    Raises FacetFilmError where there are no numbers, and where rows differ in length.
    """
    content = list(_content(text))
    data = [line for _, line, remark in content if not remark and DATA.match(line)]
    if not data:
        text.refuse(content[0][0] if content else None, "there are no numbers", "lines of wavelength, n, k")
    separator, decimal_comma = _separator(data)
    spans, above, faulty, first_fault = [], [], [], None
    for number, line, remark in content:
        row = None if remark or not DATA.match(line) else _row(number, line, separator, decimal_comma)
        if row is None or row.faults and not _has_numbers(row) and (not spans or above):
            if row is None and not remark and len(line) > LONGEST:
                text.refuse(number, f"has {len(line)} letters and begins with no number", "numbers, or short headings")
            first_fault = first_fault or row
            faulty = [*faulty, row] if row is not None and row.values[0] == row.values[0] else []
            above.append((number, line, remark))
            continue
        if above or not spans:
            # Faulty lines of as many cells right above are lines of the table.
            start = [one for one in faulty if len(one.values) == len(row.values) > 1]
            spans.append(([one for one in above if one[0] not in {row.line for row in start}], start))
            above, faulty = [], []
            if len(spans) > MOST_TABLES:
                text.refuse(number, f"is in the table number {len(spans)} of the file", f"{MOST_TABLES} at most")
        spans[-1][1].append(row)
    if not spans:
        text.refuse(first_fault.line, *next(iter(first_fault.faults.values())))
    if not decimal_comma:
        _refuse_whole_numbers(text, data, separator, spans)
    return _joined(text, _without_counts(spans), above)


def _refuse_whole_numbers(text, data, separator, spans):
    row = spans[0][1][0]
    if separator == "," and len(row.values) > 2 and not any(c in line for line in data for c in ".eE"):
        text.refuse(
            row.line,
            "whole numbers between commas may be decimal commas",
            "decimal points, or semicolons between the columns",
        )


def _content(text):
    """(number, line, whether it is a remark) of what is not empty; most lines are plain numbers, and soon done with."""
    begun = False
    for number, line in enumerate(text.lines, 1):
        if line[:1].isdigit() and PLAIN.fullmatch(line):
            begun = True
            yield number, line.rstrip(), False
            continue
        bare = line.strip(" \f\v\r\n\xa0\u3000")
        start = bare.lstrip()
        if not start or start.lower().startswith("sep="):
            continue
        mark = next((mark for mark in COMMENTS if start.startswith(mark)), None)
        if mark == "'" and (start.count("'") > 1 or DATA.match(start)) or mark == "--" and not start.strip("-,;|\t "):
            mark = None if mark == "'" else mark
        if mark == "%" and start[1:2].lower() in ("r", "t") and ("," in start or "\t" in start):
            mark = None
        if mark == "*" and DATA.match(start.lstrip("*")) is not None:
            mark = "*"
        if mark is None and start.startswith(";") and not begun:
            mark = ";"
        if mark is not None:
            said = start.lstrip("#%!/*;-'\\ \t").rstrip("*/ ")
            if said:
                yield number, said, True
            continue
        if "#" in bare and "#/" not in bare and "#n/a" not in bare.lower() and "#DIV" not in bare and DATA.match(bare):
            bare = bare.split("#", 1)[0].rstrip()
        if " //" in bare and DATA.match(bare):
            bare = bare.split(" //", 1)[0].rstrip()
        if bare.strip('|- :+=\t,;"_') == "" and ("--" in bare or "==" in bare or "__" in bare):
            continue
        bare = _without_brackets(bare)
        if not bare:
            continue
        if DATA.match(bare):
            begun = True
        yield number, bare, False


def _without_brackets(line):
    """A line of numbers without the brackets of a list that stand around all of it."""
    if line[0] in "[(" or line.rstrip(",; ")[-1:] in ("]", ")"):
        inner = BRACKETED.fullmatch(line) if len(line) <= LONGEST else None
        if (
            inner
            and inner[1].count("(") == inner[1].count(")")
            and (DATA.match(inner[1]) or not inner[1].strip("[]() ,;"))
        ):
            return inner[1].strip("[] ")
    return line


def _separator(data):
    """(what stands between columns, None for spaces; whether numbers have decimal commas)."""
    sample = data if len(data) <= 4000 else data[:2000] + data[-2000:]
    commas = any("," in line for line in sample)
    for separator in ("\t", ";", "|"):
        with_it = sum(separator in line.strip() for line in sample)
        if (
            separator == ";"
            and with_it
            and all(";" not in line.rstrip("; ") and re.search(r"\S\s+\S|,", line.rstrip("; ")) for line in sample)
        ):
            continue
        if with_it == len(sample) or separator != "\t" and with_it or separator == "\t" and with_it > 0.9 * len(sample):
            points = any(re.search(r"\d\.\d", line) for line in sample)
            between = separator == "\t" and commas and all(re.search(r",\s*\t|\t\s*,", line) for line in sample)
            if between:
                return ",", False
            return separator, commas and not (points and not any(re.search(r"\d,\d", line) for line in sample))
    quoted = [cell for line in sample[:50] for cell in re.findall(r'"([^"]*)"', line)]
    if commas and quoted and any(re.fullmatch(r"\s*[+-]?\d+,\d+\s*", cell) for cell in quoted):
        return ",", True
    if commas and all(DECIMAL_COMMA_ROW.fullmatch(line.strip()) for line in sample):
        return None, True
    if commas and any(re.search(r"\(\s*[\d.+-]+\s*,\s*[\d.+-]+\s*\)", line) for line in sample):
        return ",", False
    return ("," if commas else None), False


def _cells(line, separator):
    if separator == "\t":
        cells = [cell.strip() for cell in line.strip(" ").split("\t")]
        return (
            [cell for cell in cells if cell] if "\t\t" in line and all(cells[::2]) and not any(cells[1::2]) else cells
        )
    if separator == "," and '"' in line and line.count('"') % 2 == 0:
        return [cell.strip() for cell in next(csv.reader([line], skipinitialspace=True))]
    if separator == "," and "(" in line:
        return [cell.strip() for cell in re.split(r",(?![^()]*\))", line)]
    if separator is None:
        return SPACED_COMPLEX.sub(r"\1", line.rstrip("; ")).split()
    cells = (line.rstrip("; ") if separator == "," else line).split(separator)
    if separator == "|":
        cells = cells[1:] if not cells[0].strip() else cells
        cells = cells[:-1] if len(cells) > 1 and not cells[-1].strip() else cells
    return [cell.strip() for cell in cells]


def _row(number, line, separator, decimal_comma):
    """The Row of a line that begins with a number."""
    if separator != "|" and not decimal_comma and PLAIN.fullmatch(line) and not (separator == "\t" and "\t\t" in line):
        try:
            return Row(number, [float(cell) for cell in line.split(separator)])
        except ValueError:
            pass
    values, faults = [], {}
    cells = [_unquoted(cell) for cell in _cells(line, separator)]
    for at, cell in enumerate(cells):
        try:
            values.append(number_in(cell, decimal_comma))
        except ValueError as error:
            what = "the wavelength" if at == 0 else f"number {at + 1}"
            faults[at] = _fault_of(what, cell, decimal_comma, str(error))
            values.append(float("nan"))
    return Row(number, values, faults)


def _unquoted(cell):
    return cell[1:-1].strip() if len(cell) > 1 and cell[0] == cell[-1] and cell[0] in "\"'" else cell


def _fault_of(what, cell, decimal_comma, why):
    if why == "large":
        return f"{what} is {shown(cell)}, which is too large", "a number"
    if decimal_comma and "." in cell:
        return (
            f"{shown(cell)} has a decimal point where other numbers have a decimal comma",
            "the same in all numbers, as a number",
        )
    return f"{what} is {shown(cell)}", "a number"


def number_in(cell, decimal_comma=False):
    """A cell as a float or a complex number; NaN where nothing was measured.

    Raises ValueError for what is none.

    >>> number_in("1.5D0"), number_in("(1.48-1.883j)"), number_in("0,4", True), number_in("400nm")
    (1.5, (1.48-1.883j), 0.4, 400.0)
    """
    if cell.lower() in MISSING:
        return float("nan")
    plain = cell.replace("−", "-")
    if decimal_comma:
        if "." in plain:
            raise ValueError("point")
        plain = plain.replace(",", ".", 1)
    if NUMBER.fullmatch(plain):
        value = float(plain)
        if abs(value) == float("inf"):
            raise ValueError("large")
        return value
    fortran = FORTRAN.fullmatch(plain)
    if fortran:
        return number_in(f"{fortran[1]}e{fortran[2]}")
    found = COMPLEX.fullmatch(plain)
    if found:
        imaginary = float(found["im"] or found["mi"])
        value = complex(float(found["re"]), -imaginary if found["sign"] == "-" else imaginary)
        if abs(value.real) == float("inf") or abs(value.imag) == float("inf"):
            raise ValueError("large")
        return value
    suffixed = SUFFIXED.fullmatch(plain)
    if suffixed:
        return number_in(suffixed["number"])
    raise ValueError("no number")


def _has_numbers(row):
    """Whether two or more of a row's cells, and most of them, are numbers."""
    numbers = sum(value == value for value in row.values)
    return numbers >= 2 and 2 * numbers > len(row.values)


def _without_counts(spans):
    """Spans whose rows are as wide as most; counts and settings above them are remarks."""
    widths = {}
    for _, rows in spans:
        for row in rows:
            widths[len(row.values)] = widths.get(len(row.values), 0) + 1
    usual = max(widths, key=lambda width: (widths[width], width))
    kept, above = [], []
    for heads, rows in spans:
        above += heads
        few = len(rows) <= 2 and all(len(row.values) == 1 for row in rows) and usual > 1
        if few:
            above += [(row.line, " ".join(f"{value:g}" for value in row.values), True) for row in rows]
            continue
        while rows and len(rows[0].values) == 1 and usual > 1 and len(rows) > 2 and not kept:
            above.append((rows[0].line, f"{rows[0].values[0]:g}", True))
            rows = rows[1:]
        kept.append((above, rows))
        above = []
    return [*kept, (above, [])] if above else kept


def _joined(text, spans, below):
    """The Tables: rows go on below a remark, and begin anew below headings."""
    tables, last = [], None
    for above, rows in spans:
        if not rows:
            below = above + below
            continue
        cut = _trim(rows)
        usual = _usual(rows)
        columns = _headings_above(text, above, usual)
        if columns is not None and usual < len(columns) <= usual + cut:
            text.assume("nothing stands below " + ", ".join(repr(column.name) for column in columns[usual:]))
            columns = columns[:usual]
        if tables and columns is None and usual == last:
            tables[-1].rows += rows
            tables[-1].below += above
            continue
        tables.append(Table(above, rows, columns))
        last = usual
    if not tables:
        text.refuse(None, "there are no numbers", "lines of wavelength, n, k")
    tables[-1].below += below
    if below and not below[-1][2] and columns_of(below[-1][1]):
        text.refuse(below[-1][0], "there is a line of headings without numbers below", "numbers below it")
    for table in tables:
        _check_widths(text, table)
    return tables


def _usual(rows):
    """How many cells most rows have."""
    widths = [len(row.values) for row in rows]
    return max(set(widths), key=lambda width: (widths.count(width), width)) if len(set(widths)) > 1 else widths[0]


def _trim(rows):
    """Take away the empty cells that all rows end with; how many these are."""
    whole = width = max(len(row.values) for row in rows)
    while width > 1 and all(len(row.values) < width or _is_empty(row, width - 1) for row in rows):
        for row in rows:
            del row.values[width - 1 :]
        width -= 1
    return whole - width


def _is_empty(row, at):
    return row.values[at] != row.values[at] and not (row.faults and at in row.faults)


def _headings_above(text, above, count):
    """The Columns of the last line above that names them; a row of units below it counts."""
    for at in range(len(above) - 1, -1, -1):
        number, line, remark = above[at]
        columns = columns_of(line, count)
        far = at < len(above) - 3 and not all(column.role for column in columns or ())
        if columns is None or far or remark and len(columns) != count:
            continue
        if at > 0 and all(
            not column.role or column.unit and column.is_axis or column.role == "number" for column in columns
        ):
            # Perhaps a row of units; then the names stand above it.
            names = columns_of(above[at - 1][1], count)
            if names:
                return _with_units(names, columns)
        before = columns_of(above[at - 1][1], count) if at and not above[at - 1][2] and not remark else None
        if (
            before
            and all(one.role for one in before)
            and {one.role for one in before} ^ {one.role for one in columns}
            and any(one.is_axis for one in before)
        ):
            text.refuse(above[at - 1][0], "there is a line of headings without numbers below", "numbers below it")
        for _, below, _ in above[at + 1 : at + 2]:
            columns = _with_unit_row(columns, below)
        return columns
    return None


def _with_unit_row(columns, line):
    """The Columns with the units that the line below their names gives."""
    for separator in ("\t", ";", "|", ",", None):
        cells = [cell.strip() for cell in line.split(separator)]
        if 1 <= len(cells) <= len(columns) and (separator is None or separator in line):
            units = [column_of(cell) for cell in cells]
            if any(unit.is_axis and unit.unit for unit in units):
                return _with_units(columns, units)
    return columns


def _with_units(names, units):
    found = []
    for at, name in enumerate(names):
        unit = units[at] if at < len(units) else None
        if unit is not None and name.is_axis and not name.unit and unit.is_axis:
            name = dataclasses.replace(name, role=unit.role, unit=unit.unit)
        elif unit is not None and name.role in {"R", "T", "A"} and not name.unit and unit.unit == "%":
            name = dataclasses.replace(name, unit="%")
        found.append(name)
    return found


def _check_widths(text, table):
    """Mark rows of another length as faulty: what they lack may lie outside the visible."""
    named = table.columns is not None
    usual = _usual(table.rows)
    if named and usual != len(table.columns):
        row = next(row for row in table.rows if len(row.values) == usual)
        text.refuse(row.line, f"has {numbers(usual)}", f"{len(table.columns)}, as the headings name")
    for row in table.rows:
        if len(row.values) != usual:
            row.faults = {
                ROW: (
                    f"has {numbers(len(row.values))}",
                    f"{usual}, as the headings name" if named else f"{usual}, as in the other lines",
                )
            }
            row.values = (row.values + [float("nan")] * usual)[:usual]


def numbers(count):
    """How many numbers, in words."""
    return "1 number" if count == 1 else f"{count} numbers"
