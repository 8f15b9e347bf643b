"""The table of Layered RGB Standard's errors in docs/accuracy.md is what is measured."""

from pathlib import Path

import numpy as np
import pytest

from tests.bench import measure_layered_fast as table

DOCS = Path(__file__).resolve().parents[2] / "docs" / "accuracy.md"
NOISE = 0.01
"""Of a picture's error; the albedo's is smaller."""


def printed(layer, deviation):
    """The line of the table for a layer and a deviation, (6,)."""
    start = f"| {layer} | {deviation:g}° |"
    line, = [line for line in DOCS.read_text(encoding="utf-8").splitlines() if line.startswith(start)]
    return np.array([float(figure.rstrip("%")) / 100.0 for figure in line[len(start):].replace("|", " ").split()])


def test_the_table_has_every_line():
    assert table.HEADING in DOCS.read_text(encoding="utf-8").splitlines()
    assert all(printed(layer, deviation).shape == (6,) for layer in table.LAYERS for deviation in table.DEVIATIONS)


@pytest.mark.parametrize("layer, deviation", [("figure 3's, 92 nm", 0.0), ("figure 5's, 170 nm", 14.0)])
def test_a_line_is_what_is_measured(layer, deviation):
    np.testing.assert_allclose(table.row(layer, deviation), printed(layer, deviation), atol=NOISE)
