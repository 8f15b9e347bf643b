"""Tables of numbers: wavelength, n[, k] or wavelength, R, a point a line.

Separated by comma, semicolon, tab or spaces, with decimal point or comma, with
headings or without, in nm or µm.  Two blocks below each other, n and then k, are
the CSV that refractiveindex.info exports.  In a LuxPop .nk file the wavelengths
are in Å and comments begin with a semicolon.
"""

import dataclasses
import re

import numpy as np

from .headings import Column, columns_of, in_nm
from .points import Points, checked, constants
from .text import number_of

__all__ = ["read_columns"]

DATA = re.compile(r"[\"'\s,;]*[+-]?(?:[.,]?\d|nan\b|inf(?:inity)?\b)", re.IGNORECASE)
COMMA_NUMBER = r"[+-]?\d+(?:,\d+)?(?:[eE][+-]?\d+)?"
DECIMAL_COMMA_ROW = re.compile(rf"{COMMA_NUMBER}(?:\s+{COMMA_NUMBER})+")
VISIBLE = {"nm": (360.0, 780.0), "µm": (0.36, 0.78), "Å": (3600.0, 7800.0)}
LARGEST_PLAIN_INDEX, LEAST_PLAIN_PERCENT = 3.0, 10.0
"""In a table of two columns without headings: n up to the one, a reflectance in percent from the other on.

Between them lie the percents of glasses and the n of semiconductors alike.
"""


@dataclasses.dataclass
class Block:
    """Rows below one line of headings, or below none.

    columns  the Columns, or None
    lines    the number of each row's line
    rows     the numbers, a list a row
    """

    columns: list
    lines: list
    rows: list


def read_columns(text):
    """The OpticalConstants of a Text that holds a table.

    Raises FacetFilmError with the line and what was expected there.

    >>> from .text import Text
    >>> read_columns(Text("glass.txt", "400 1.52\\n700 1.51")).n.tolist()
    [1.52, 1.51]
    """
    blocks = _blocks(text)
    units = _units(text, blocks)
    found = []
    for block, unit in zip(blocks, units):
        table = np.array(block.rows)
        wavelength = in_nm(table[:, 0], unit)
        columns = block.columns or _columns_by_values(text, block, table)
        for column, values in zip(columns[1:], table.T[1:]):
            values = _share(column, values) if column.role == "R" else values
            found.append(checked(text, Points(column.role, wavelength, values, np.array(block.lines))))
    return constants(text, found)


def _blocks(text):
    """The Blocks of a Text."""
    content = _content(text)
    data = [line for _, line in content if DATA.match(line)]
    if not data:
        text.refuse(content[0][0] if content else None, "there are no numbers", "lines of wavelength, n, k")
    separator, decimal_comma = _separator(data)
    blocks = []
    for number, line in content:
        if not DATA.match(line):
            blocks.append(Block(columns_of(text, number, line), [], []))
            continue
        blocks = blocks or [Block(None, [], [])]
        row = _row(text, number, line, separator, decimal_comma, blocks[-1].columns)
        _check_count(text, number, row, blocks[-1])
        blocks[-1].lines.append(number)
        blocks[-1].rows.append(row)
    for block in blocks:
        if not block.rows:
            text.refuse(None, "there is a line of headings without numbers below", "numbers below it")
    if separator == "," and not any(c in line for line in data for c in ".eE") and len(blocks[0].rows[0]) > 2:
        text.refuse(blocks[0].lines[0], "whole numbers between commas may be decimal commas",
                    "decimal points, or semicolons between the columns")
    return blocks


def _content(text):
    """(number, line) of what is neither empty nor a comment."""
    content = []
    for number, line in enumerate(text.lines, 1):
        line = "" if line.lstrip()[:1] in ("%", "!") else line.split("#", 1)[0].strip(" \f\v")
        if line.strip() and not (line.startswith(";") and not content):
            content.append((number, line))
    return content


def _separator(data):
    """(what stands between columns, None for spaces; whether numbers have decimal commas)."""
    commas = any("," in line for line in data)
    if all("\t" in line for line in data):
        return "\t", commas
    if any(";" in line for line in data):
        return ";", commas
    if commas and all(DECIMAL_COMMA_ROW.fullmatch(line.strip()) for line in data):
        return None, True
    return ("," if commas else None), False


def _row(text, number, line, separator, decimal_comma, columns):
    """The numbers of a line."""
    cells = [cell.strip() for cell in line.split(separator)]
    while len(cells) > 1 and not cells[-1]:
        cells.pop()
    cells = [cell[1:-1].strip() if len(cell) > 1 and cell[0] == cell[-1] == '"' else cell for cell in cells]
    names = ["the wavelength", *(column.role for column in (columns or [])[1:])]
    names += [f"number {i + 1}" for i in range(len(names), len(cells))]
    return [number_of(text, number, cell, name, decimal_comma) for cell, name in zip(cells, names)]


def _check_count(text, number, row, block):
    if block.columns is not None and len(row) != len(block.columns):
        text.refuse(number, f"has {_numbers(len(row))}", f"{len(block.columns)}, as the headings name")
    if block.rows and len(row) != len(block.rows[0]):
        text.refuse(number, f"has {_numbers(len(row))}", f"{len(block.rows[0])}, as in the lines before")
    if not 2 <= len(row) <= 3:
        text.refuse(number, f"has {_numbers(len(row))}",
                    "two or three: wavelength, n and k, or wavelength and R")


def _numbers(count):
    return "1 number" if count == 1 else f"{count} numbers"


def _units(text, blocks):
    """The unit of wavelength of each block: what its heading says, else what its numbers can be."""
    units = [block.columns[0].unit if block.columns else "" for block in blocks]
    unnamed = [row[0] for block, unit in zip(blocks, units) if not unit for row in block.rows]
    if not unnamed:
        return units
    low, high = min(unnamed), max(unnamed)
    candidates = ["nm", "µm"]
    if text.suffix == ".nk":
        candidates = ["Å"]
    elif any(line.lstrip().startswith(";") for line in text.lines):
        candidates = ["nm", "µm", "Å"]
    fitting = [unit for unit in candidates if low <= VISIBLE[unit][1] and high >= VISIBLE[unit][0]]
    line = next(block.lines[0] for block, unit in zip(blocks, units) if not unit)
    if not fitting:
        text.refuse(line, f"the wavelengths, {low:g} to {high:g}, are not visible in "
                    + " or ".join(candidates), "400 to 700 nm or a good part of it, the unit in a heading")
    if len(fitting) > 1:
        text.refuse(line, f"the wavelengths, {low:g} to {high:g}, may be in " + " or ".join(fitting),
                    "one unit throughout, named in a heading such as wavelength_nm")
    return [unit or fitting[0] for unit in units]


def _columns_by_values(text, block, table):
    """The Columns of a block without headings: three are wavelength, n, k; two may be n or R."""
    if table.shape[1] == 3:
        return [Column("wavelength"), Column("n"), Column("k")]
    values = table[:, 1]
    if values.min() <= 0.0 or (values >= 1.0).all() and values.max() <= LARGEST_PLAIN_INDEX:
        return [Column("wavelength"), Column("n")]
    if (values < 1.0).all():
        return [Column("wavelength"), Column("R")]
    if (values >= LEAST_PLAIN_PERCENT).all():
        return [Column("wavelength"), Column("R", "%")]
    span = f"{values.min():g} to {values.max():g}"
    return text.refuse(block.lines[0], f"the second numbers, {span}, may be n or R",
                       "a heading such as 'wavelength_nm, n' or 'wavelength_nm, R (%)'")


def _share(column, values):
    """A reflectance in 0 to 1: from percent where the heading says so, or where all are above 1."""
    percent = column.unit == "%" or ((values > 1.0).all() and values.max() > 2.0)
    return values / 100.0 if percent else values
