"""The shell's door, as a shell sees it."""

import json
import pathlib
import subprocess
import sys

import pytest

from addon.cli import main

ROOT = pathlib.Path(__file__).resolve().parents[2]


def test_list(capsys):
    assert main(["list", "--json"]) == 0
    assert {"copper", "gold", "vinyl"} <= {preset["name"] for preset in json.loads(capsys.readouterr().out)}
    assert main(["list"]) == 0
    assert "main/Cu/Johnson" in capsys.readouterr().out


def test_bake_for_people(capsys):
    assert main(["bake", "copper"]) == 0
    out = capsys.readouterr().out
    for word in ("F0", "F82 tint", "CIEDE2000", "main/Cu/Johnson", "Johnson and R. W. Christy"):
        assert word in out


def test_bake_as_json(capsys):
    assert main(["bake", "main/Au/Babar", "--json", "--space", "Rec.2020", "--illuminant", "D50", "--adapt"]) == 0
    record = json.loads(capsys.readouterr().out)
    assert record["space"] == "Rec.2020" and record["illuminant"] == "D50"


@pytest.mark.parametrize("words", [["bake", "coper"], ["bake", "copper", "--gamut", "cut"], ["bake", "a/b/c"]])
def test_wrong_input_is_one_sentence_and_status_2(words, capsys):
    assert main(words) == 2
    shown = capsys.readouterr()
    assert shown.out == "" and shown.err.startswith("error: ") and shown.err.count("\n") == 1


def test_as_a_process_without_bpy():
    code = ("import sys, addon; from addon.cli import main; main(['bake', 'copper']); "
            "sys.exit('bpy' in sys.modules)")
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    done = subprocess.run([sys.executable, "-m", "addon", "bake", "coper"], cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 2 and "did you mean 'copper'" in done.stderr
