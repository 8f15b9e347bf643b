"""The shell's door, as a shell sees it."""

import json
import pathlib
import subprocess
import sys

import pytest
from PIL import Image

from addon import models
from addon.catalogue.presets import all_presets
from addon.cli import main

ROOT = pathlib.Path(__file__).resolve().parents[2]


def presets_of(model):
    """Presets of a model, in the catalogue's order."""
    return [preset for preset in all_presets().values() if (preset.model or models.DEFAULT) == model]


def test_list(capsys):
    assert main(["list", "--json"]) == 0
    assert {"copper", "gold", "vinyl"} <= {preset["name"] for preset in json.loads(capsys.readouterr().out)}
    assert main(["list"]) == 0
    assert "main/Cu/Johnson" in capsys.readouterr().out
    assert main(["list", "illuminants"]) == 0
    assert "LED-B3" in capsys.readouterr().out


def test_bake_for_people(capsys):
    assert main(["bake", "copper"]) == 0
    out = capsys.readouterr().out
    for word in ("F0", "F82 tint", "CIEDE2000", "main/Cu/Johnson", "Johnson and R. W. Christy"):
        assert word in out


def test_bake_as_json(capsys):
    options = ["--space", "Rec.2020", "--illuminant", "D50", "--adapt"]
    assert main(["bake", "main/Au/Babar", "--json", *options]) == 0
    record = json.loads(capsys.readouterr().out)
    assert record["space"] == "Rec.2020" and record["illuminant"] == "D50"


@pytest.mark.parametrize("model", models.names())
def test_a_preset_of_every_model_bakes(model, capsys):
    """For people and as JSON; a form that its model has not is refused in a sentence."""
    name = presets_of(model)[0].name
    assert main(["bake", name]) == 0
    assert capsys.readouterr().out.strip()
    assert main(["bake", name, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)
    assert main(["bake", name, "--spectrum-csv"]) in (0, 2)
    assert "Traceback" not in capsys.readouterr().err


def test_glass_says_what_was_baked(capsys):
    assert main(["bake", "glass", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert set(found["ior"]) == {"d", "cauchy", "error_max"} and found["abbe"] == pytest.approx(64.0, abs=0.1)
    assert set(found["attenuation"]) == {"sigma_per_m", "colour", "distance_m", "delta_e_2000_max"}


def test_swatches(capsys, tmp_path):
    """Over the angle, thickness and depth, as a table, JSON and a picture; nothing for a look without a measurement."""
    assert main(["swatch", "copper"]) == 0
    assert "over angle" in capsys.readouterr().out
    assert main(["swatch", "anodised_titanium", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["over"] == "thickness" and len(found["srgb"]) == len(found["places"]) == len(set(found["srgb"]))
    strip = tmp_path / "glass.png"
    assert main(["swatch", "glass", "--space", "ACEScg", "-o", str(strip)]) == 0
    assert Image.open(strip).size == (512, 96)
    assert main(["swatch", "nacre"]) == 2


def test_search(capsys):
    assert main(["search", "gold", "babar"]) == 0
    assert "main/Au/Babar" in capsys.readouterr().out
    assert main(["search", "acetone", "rheims", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)[0]
    assert found["id"] == "organic/acetone/Rheims" and found["covers_visible"] is False


def test_check(capsys):
    assert main(["check", "--n", "0.2", "1", "1.3", "--k", "3.2", "2.6", "2.4", "--against", "copper"]) == 0
    assert "CIEDE2000" in capsys.readouterr().out
    assert main(["check", "--f0", "1", "0.78", "0.34", "--against", "gold", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["dataset"] == "main/Au/Babar"
    assert main(["check", "main/Au/Johnson", "--against", "gold"]) == 0
    assert "Babar" in capsys.readouterr().out


def test_spread_and_ways(capsys):
    assert main(["spread", "gold"]) == 0
    assert "farthest apart" in capsys.readouterr().out
    assert main(["spread", "copper", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["reference"] == "main/Cu/Johnson"
    assert main(["ways", "copper"]) == 0
    assert "(1982)" in capsys.readouterr().out
    assert main(["ways", "copper", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["ways"][0]["delta_e_2000_max"] == 0.0


@pytest.mark.parametrize("words", [
    ["bake", "coper"], ["bake", "copper", "--gamut", "cut"], ["bake", "a/b/c"], ["search", "xyzzyq"],
    ["search", "gold", "--limit", "0"], ["check", "--against", "gold"], ["spread", "xyzzyq"],
    ["ways", "coper"],
    ["check", "--n", "0", "1", "1", "--k", "1", "1", "1", "--against", "gold"]])
def test_wrong_input_is_one_sentence_and_status_2(words, capsys):
    assert main(words) == 2
    shown = capsys.readouterr()
    assert shown.out == "" and shown.err.startswith("error: ") and shown.err.count("\n") == 1


def test_as_a_process_without_bpy():
    code = ("import sys, addon; from addon.cli import main; main(['bake', 'copper']); "
            "sys.exit('bpy' in sys.modules)")
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    command = [sys.executable, "-m", "addon", "bake", "coper"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 2 and "did you mean 'copper'" in done.stderr


def test_a_finish_goes_on_what_is_baked(capsys):
    assert main(["bake", "copper", "--finish", "brushed", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert (found["finish"], found["anisotropy"]) == ("brushed", 0.764)
    assert main(["bake", "copper", "--finish", "satin"]) == 0
    assert ["finish", "satin"] in [line.split() for line in capsys.readouterr().out.splitlines()]
    assert main(["bake", "copper", "--finish", "bruhsed"]) == 2
    assert "did you mean 'brushed'" in capsys.readouterr().err
    assert main(["list", "finishes", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)[0]["name"] == "polished"
    assert main(["list", "finishes"]) == 0
    assert "hammered" in capsys.readouterr().out
