"""The examples in the docstrings of everything that runs without Blender."""

import doctest
import importlib
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
NEEDS_BLENDER = ("addon/blender/", "addon/nodes/", "addon/verify/")
RUNS = ("addon/__main__.py",)

PRINTED = "1.25" if np.lib.NumpyVersion(np.__version__) >= "2.0.0" else False
"""How numpy prints: plain numbers as plain numbers, in 2.0 and later too."""

MODULES = sorted(
    ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")
    for path in [*(ROOT / "addon").rglob("*.py"), *(ROOT / "tools").glob("*.py")]
    if ">>>" in path.read_text(encoding="utf-8") and not path.relative_to(ROOT).as_posix().startswith(NEEDS_BLENDER)
    and path.relative_to(ROOT).as_posix() not in RUNS)
"""Those of NEEDS_BLENDER are in tests/render/test_doctests_in_blender.py."""


def test_every_room_has_examples():
    rooms = {".".join(name.split(".")[:2]) for name in MODULES if name.count(".") > 1}
    assert rooms >= {f"addon.{room}" for room in ("reflectance", "models", "spectra", "bake", "catalogue", "export")}


@pytest.mark.parametrize("name", MODULES)
def test_examples_say_what_happens(name):
    module = importlib.import_module(name)
    with np.printoptions(legacy=PRINTED):  # colour-science, which other tests import, changes it for all
        results = doctest.testmod(module, optionflags=doctest.NORMALIZE_WHITESPACE)
    assert results.failed == 0


@pytest.mark.parametrize("name", [
    name for name in MODULES if name.startswith("addon.reflectance.")
    or name.startswith("addon.models.") and name.endswith((".formulas", ".sampler", ".lobes", ".albedo"))])
def test_every_public_formula_has_an_example(name):
    module = importlib.import_module(name)
    functions = [getattr(module, symbol) for symbol in module.__all__]
    bare = [f.__name__ for f in functions if callable(f) and ">>>" not in (f.__doc__ or "")]
    assert not bare
