"""Builds docs/parameters.md from the tables of the models.

    python tools/build_parameters.py [OUTPUT_FILE]
"""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from addon import models  # noqa: E402
from addon.models.realisations import REALISATIONS  # noqa: E402

__all__ = ["FILE", "text"]

FILE = ROOT / "docs" / "parameters.md"
HEAD = """\
# Parameters

<!-- Made by tools/build_parameters.py from the models' tables, addon/models/<model>/parameters.py.
Edit those, not this. -->

What `create_material` takes, what the panels and group nodes show, and what a preset sets. A value out of its range is
answered with one sentence, and nothing is made.
"""
COLUMNS = ("Parameter", "Symbol", "Socket", "Default", "Range", "What it is")
LIVE_ONLY = "Sockets alone, which scripts do not set: "


def text():
    """The document."""
    return "\n".join([HEAD, *(_section(model) for model in models.all_models())])


def _section(model):
    rows = [row for row in model.parameters.TABLE if row.is_value]
    lines = [COLUMNS, ("---",) * len(COLUMNS), *(_cells(row) for row in rows)]
    table = "\n".join("| " + " | ".join(cells) + " |" for cells in lines)
    others = ", ".join(f"{socket.name} ({socket.tip[0].lower()}{socket.tip[1:]})" for row in model.parameters.TABLE
                       if not row.is_value for socket in row.sockets())
    head = f"## {model.title}\n\n{model.citation}. `create_material(\"{model.name}\", …)`"
    return f"{head}\n\n{table}\n\n{LIVE_ONLY}{others}.\n"


def _cells(row):
    sockets = ", ".join(socket.name for socket in row.sockets())
    titles = " and ".join(REALISATIONS[name].title for name in row.realisations or ())
    limited = f" Only by {titles}." if titles else ""
    unit = f" {row.unit}" if row.unit else ""
    default = _value(getattr(row, "usual", row.default))
    return (f"`{row.name}`", row.symbol, sockets, default, row.range_text() + unit, row.tip + "." + limited)


def _value(value):
    if isinstance(value, tuple):
        return "(" + ", ".join(map(_value, value)) + ("," if len(value) == 1 else "") + ")"
    return f"{value:g}" if isinstance(value, float) else "" if value is None else str(value)


if __name__ == "__main__":
    path = pathlib.Path(sys.argv[1]) if sys.argv[1:] else FILE
    path.write_text(text(), encoding="utf-8")
