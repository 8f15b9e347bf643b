"""The verification: every check fails when the thing it checks is broken, and the report says so in its first line.

`make verify` runs the checks as they are; here each renders a material that
differs from its formula by a little.
"""

import json
import math

import numpy as np
import pytest

from addon import models
from addon.cli import main
from addon.errors import FacetFilmError
from addon.verify import report, running, scenes
from addon.verify.checks import Check, Figure, Outcome

CHECKS, LEFT_OUT = running.checks()

# Model and start of the check's name -> what is changed in the material and not in the formula.
BROKEN = {
    ("cook_torrance", "two slopes"): {"slopes": ((0.4, 0.37), (0.2, 0.6))},
    ("cook_torrance", "slope 0.4"): {"slopes": ((0.41, 1.0),)},
    ("cook_torrance", "figure 6b's slopes"): {"specular": 0.32},
    ("cook_torrance", "Gaussian"): {"distribution": "beckmann"},
    ("cook_torrance", "published scale and c"): {"gaussian_c": 2.1},
    ("cook_torrance", "energy"): {"scale": "published"},
    ("cook_torrance", "furnace, two slopes"): {"slopes": ((0.4, 0.39), (0.2, 0.6))},
    ("cook_torrance", "furnace, diffuse part"): {"diffuse": (0.89, 0.6, 0.5)},
    ("cook_torrance", "furnace, Gaussian"): {"gaussian_c": 2.05},
    ("cook_torrance", "sphere under a soft sun"): {"slopes": ((0.5, 0.4), (0.2, 0.6))},
    ("cook_torrance", "sphere under an area lamp"): {"slopes": ((0.5, 0.4), (0.2, 0.6))},
    ("cook_torrance", "anisotropic"): {"anisotropy": 0.3},
    ("cook_torrance", "default width"): {"slopes": ((0.4, 0.36), (0.2, 0.54))},
    ("layered_rgb", "furnace, parallel boundaries over"): {"diffuse": 0.68},
    ("layered_rgb", "furnace, parallel"): {"thickness": 75.0},
    ("layered_rgb", "furnace, deviated"): {"ior": (1.4, 1.45, 1.7)},
    ("layered_rgb", "furnace, published"): {"scale": "energy"},
    ("layered_rgb", "diffuse part"): {"thickness": 92.5},
    ("layered_rgb", "sphere under a soft sun"): {"exponent_t": 120.0},
    ("layered_rgb", "default width"): {"specular": 0.75},
    ("film", "TiO2 0-200 nm / Ti, 60"): {"thickness": 52.0},
    ("film", "TiO2"): {"thickness": 110.0},
    ("film", "SiO2"): {"thickness": 285.0},
    ("film", "Fe3O4"): {"thickness": 36.0},
    ("film", "soap 5-1000 nm / 1.0001"): {"thickness": 385.0},
    ("film", "soap 5-1000 nm / air"): {"see_through": 0.9},
    ("film", "MgF2"): {"see_through": 0.9},
    ("clear", "furnace"): {"tint": (0.9, 0.9, 0.9)},
    ("clear", "slab"): {"absorption": (33.0, 132.0, 330.0)},
    ("clear", "thin wall"): {"ior": 1.7},
    ("clear", "see-through shadow"): {"ior": 1.7},
    ("clear", "shadow of a ball"): {"tint": (0.9, 0.9, 0.9)},
    ("data", "fits"): {"worse_by": 5.0},
    ("data", "colours of copper"): {"preset": "main/Cu/McPeak"},
    ("data", "colours of gold"): {"preset": "gold_johnson"},
    ("data", "colours of aluminium"): {"preset": "silver"},
    ("data", "colours of titanium"): {"preset": "chromium"},
}


def test_a_configuration_that_cannot_be_checked_is_said_in_a_sentence(monkeypatch):
    monkeypatch.setattr(scenes, "TOLD", (0.25, 0.5, 0.8))  # as a configuration would bring it back
    scenes.require_readable()
    monkeypatch.setattr(scenes, "render", lambda _scene: np.full((2, 2, 3), 0.5))
    with pytest.raises(FacetFilmError, match="do not come back .* use one that has a role for data"):
        scenes.require_readable()


def broken(check):
    """The change that the check has to notice."""
    found = [change for (model, name), change in BROKEN.items() if check.model == model and check.name.startswith(name)]
    return found[0]


def test_every_realisation_and_model_is_checked():
    assert not LEFT_OUT
    assert {(check.model, check.realisation) for check in CHECKS} >= {
        (model.name, realisation) for model in models.all_models() for realisation in model.realisations}
    assert len({check.title for check in CHECKS}) == len(CHECKS)


@pytest.mark.parametrize("check", CHECKS, ids=lambda check: check.title)
def test_the_check_fails_when_its_material_is_broken(check, record_property):
    outcome = check.run(**broken(check))
    print("; ".join(f"{figure.name} {figure.value:.4g} of {figure.limit:.4g}" for figure in outcome.figures))
    assert not outcome.passed


@pytest.fixture
def few_checks(monkeypatch):
    """Only the quick ones, and what the last of them finds."""
    quick = [check for check in CHECKS if check.name in ("diffuse part", "slope 0.4")]

    def run_with(*more):
        monkeypatch.setattr(running, "checks", lambda only=None: ([*quick, *more], [("osl", "a <reason>")]))
    return run_with


def first_line(path):
    return path.read_text(encoding="utf-8").splitlines()[0]


def test_a_green_report(few_checks, tmp_path, capsys):
    few_checks()
    path, record = tmp_path / "ünd so weiter.html", tmp_path / "record.json"
    assert main(["verify", "-o", str(path), "--json", str(record)]) == 0
    assert "Green: all 6 checks passed on Blender" in first_line(path)
    text = path.read_text(encoding="utf-8")
    assert text.count("data:image/png;base64,") == 6 and "a &lt;reason&gt;" in text and "Copper" in text
    assert "http" not in text.replace("http-equiv", "")  # it needs no other file
    held = json.loads(record.read_text(encoding="utf-8"))
    assert all(check["passed"] for check in held["checks"])
    assert "Green" in capsys.readouterr().out


@pytest.mark.parametrize("measure, words", [
    (lambda *_: Outcome((Figure("rms", 0.2, 0.1),)), "rms: 0.2 of at most 0.1"),
    (lambda *_: Outcome((Figure("rms", math.nan, 0.1),)), "rms: nan"),
    (lambda *_: 1 / 0, "ZeroDivisionError")])
def test_a_report_with_a_failure_is_not_green(few_checks, tmp_path, measure, words):
    few_checks(Check("data", "", "broken", "always", measure))
    path = tmp_path / "report.html"
    assert main(["verify", "-o", str(path)]) == 1
    assert "Not green: 1 of 7 checks failed on Blender" in first_line(path)
    assert words in path.read_text(encoding="utf-8") and "FAILED" in path.read_text(encoding="utf-8")


def test_a_run_cut_short_leaves_a_report_that_is_not_green(few_checks, tmp_path):
    few_checks(Check("data", "", "cut", "short", lambda *_: (_ for _ in ()).throw(KeyboardInterrupt)))
    with pytest.raises(KeyboardInterrupt):
        main(["verify", "-o", str(tmp_path / "report.html")])
    assert "Not green: not finished" in first_line(tmp_path / "report.html")


def test_nothing_checked_is_not_green():
    assert report.verdict([], (("Blender", "5"), ("Device", "CPU"))).startswith("Not green")


@pytest.mark.parametrize("words, sentence", [
    (["--device", "GPU"], "device GPU needs one"), (["--device", "TPU"], "device 'TPU' is unknown"),
    (["--device", "CUDA"], "device CUDA: Blender finds none"),
    (["--only", "layerd_rgb"], "did you mean 'layered_rgb'"), (["-o", "nowhere/report.html"], "does not exist")])
def test_what_cannot_be_verified_is_said(words, sentence, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["verify", *words]) == 2
    assert sentence in capsys.readouterr().err
    assert not list(tmp_path.iterdir())
