"""The examples in the docstrings of the modules that need Blender."""

import doctest
import importlib

import numpy as np
import pytest

from tests.unit.test_doctests import NEEDS_BLENDER, PRINTED, ROOT

MODULES = sorted(
    ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")
    for room in NEEDS_BLENDER for path in (ROOT / room).rglob("*.py") if ">>>" in path.read_text(encoding="utf-8"))


def test_there_are_examples():
    assert {"addon.verify.statistics", "addon.verify.checks", "addon.nodes.builder"} <= set(MODULES)


@pytest.mark.parametrize("name", MODULES)
def test_examples_say_what_happens(name):
    with np.printoptions(legacy=PRINTED):
        results = doctest.testmod(importlib.import_module(name), optionflags=doctest.NORMALIZE_WHITESPACE)
    assert results.failed == 0
