"""The shell's door with files: a user's own data in, other programs' formats out."""

import json
import xml.etree.ElementTree as ElementTree

import pytest

from addon.bake import bake
from addon.cli import main
from addon.spectra.readers import read_file

OWN = "wavelength_nm,n,k\n400,1.5,2\n550,0.5,2.5\n700,0.2,4\n"


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """An empty folder that the commands run in, with one file of measurements."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "own.csv").write_text(OWN)
    return tmp_path


def test_a_file_is_baked(capsys):
    assert main(["bake", "own.csv", "--json"]) == 0
    record = json.loads(capsys.readouterr().out)
    assert record == record | bake(read_file("own.csv")).to_dict()
    assert record["slopes"] == [[0.2, 1.0]]
    assert record["source"]["dataset"] == "file:own.csv"
    assert main(["bake", "own.csv"]) == 0
    assert "the user's own data" in capsys.readouterr().out


def test_a_file_is_checked_and_shown_in_all_ways(capsys):
    assert main(["check", "own.csv", "--against", "gold"]) == 0
    assert main(["check", "gold", "--against", "own.csv"]) == 0
    assert main(["ways", "own.csv"]) == 0
    assert capsys.readouterr().out.count("own") >= 3


def test_a_file_without_a_usual_ending_is_read_unless_a_material_has_its_name(folder, capsys):
    for name in ("measured", "copper"):
        (folder / name).write_text(OWN)
    assert main(["bake", "measured", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["source"]["dataset"] == "file:measured"
    assert main(["bake", "copper", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["source"]["dataset"] == "main/Cu/Johnson"


def test_forms_are_shown_or_written(folder, capsys):
    for form in ("--json", "--csv", "--spectrum-csv", "--materialx"):
        assert main(["bake", "own.csv", form]) == 0
        shown = capsys.readouterr().out
        assert main(["bake", "own.csv", form, "-o", "out.file"]) == 0
        assert capsys.readouterr().out == "Wrote out.file\n"
        assert (folder / "out.file").read_text(encoding="utf-8") == shown
    assert ElementTree.fromstring(shown).tag == "materialx"
    assert sorted(path.name for path in folder.iterdir()) == ["out.file", "own.csv"]


@pytest.mark.parametrize("space, called", [("ACEScg", "acescg"), ("Rec.2020", "lin_rec709")])
def test_materialx_is_in_a_space_that_it_knows(space, called, capsys):
    assert main(["bake", "copper", "--materialx", "--space", space]) == 0
    assert ElementTree.fromstring(capsys.readouterr().out).get("colorspace") == called


def test_a_spectrum_goes_out_and_comes_back(capsys):
    assert main(["bake", "copper", "--spectrum-csv", "-o", "copper.csv"]) == 0
    capsys.readouterr()
    assert main(["bake", "copper.csv", "--json"]) == 0
    record, theirs = json.loads(capsys.readouterr().out), bake("copper").to_dict()
    assert record["f0"] == theirs["f0"]
    for number in ("n", "k"):  # the last bits of a fit are the linear algebra's
        assert record["conductor"][number] == pytest.approx(theirs["conductor"][number], rel=1e-9)


@pytest.mark.parametrize("words", [
    ["bake", "none.csv"], ["bake", "bad.csv"], ["bake", "own.csv", "--csv", "-o", "none/a.csv"],
    ["bake", "own.csv", "-o", "."], ["bake", "own.csv", "--materialx", "--formula", "blender-4.5"],
    ["bake", "own.csv", "--json", "--csv"], ["ways", "none.nk"], ["check", "none.csv", "--against", "gold"]])
def test_wrong_input_is_refused_and_nothing_is_written(words, folder, capsys):
    (folder / "bad.csv").write_text("400,1.5\n300,1.5\n")
    before = {path.name: path.read_text() for path in folder.iterdir()}
    assert main(words) == 2
    shown = capsys.readouterr()
    assert shown.out == "" and "error: " in shown.err
    assert {path.name: path.read_text() for path in folder.iterdir()} == before


def test_the_line_at_fault_is_named(folder, capsys):
    (folder / "bad.csv").write_text("400,1.5\n500,abc\n700,1.5\n")
    assert main(["bake", "bad.csv"]) == 2
    assert capsys.readouterr().err.startswith("error: bad.csv, line 2: ")
