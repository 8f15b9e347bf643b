"""The examples in the docstrings of everything that runs without Blender."""

import doctest
import importlib
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
ROOMS = ("addon/reflectance", "addon/spectra", "addon/bake", "addon/export")
TOOLS = ("tools/setup_venv.py", "tools/package.py")
NEEDS_BLENDER_OR_RUNS = ("__init__.py", "__main__.py", "api.py")

PRINTED = "1.25" if np.lib.NumpyVersion(np.__version__) >= "2.0.0" else False
"""How numpy prints: plain numbers as plain numbers, in 2.0 and later too."""

MODULES = sorted(
    ".".join(path.relative_to(ROOT).with_suffix("").parts)
    for path in [*(ROOT / "addon").glob("*.py"), *(ROOT / name for name in TOOLS),
                 *(path for room in ROOMS for path in (ROOT / room).rglob("*.py"))]
    if path.name not in NEEDS_BLENDER_OR_RUNS)


@pytest.mark.parametrize("name", MODULES)
def test_examples_say_what_happens(name):
    module = importlib.import_module(name)
    with np.printoptions(legacy=PRINTED):  # colour-science, which other tests import, changes it for all
        results = doctest.testmod(module, optionflags=doctest.NORMALIZE_WHITESPACE)
    assert results.failed == 0


@pytest.mark.parametrize("name", [name for name in MODULES if name.startswith("addon.reflectance.")])
def test_every_public_formula_has_an_example(name):
    module = importlib.import_module(name)
    functions = [getattr(module, symbol) for symbol in module.__all__]
    bare = [f.__name__ for f in functions if callable(f) and ">>>" not in (f.__doc__ or "")]
    assert not bare
