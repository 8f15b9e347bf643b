"""Every figure is made, small, by its script; the ones that the documents show are exactly these."""

from pathlib import Path

import numpy as np
import pytest

from addon.bake.srgb import bytes_of
from addon.catalogue.entries import entries
from demo_blend import figures, pictures, poster
from demo_blend.job import Job
from demo_blend.side_by_side import compared

SHOWN = Path(__file__).resolve().parents[2] / "docs" / "pictures"
SCALE = 0.05


def test_unknown_figure_is_refused(capsys):
    with pytest.raises(SystemExit):
        figures.main(["vases_7"])
    assert "vases_7: no such figure" in capsys.readouterr().err


def test_the_documents_pictures_are_the_figures():
    modules = tuple(figures.MODULES)
    shown = {path.stem for path in SHOWN.iterdir() if path.name.startswith(modules)}
    assert shown == set(figures.all_figures())


@pytest.mark.parametrize("name", [name for name in figures.all_figures() if name != "side_by_side_versions"])
def test_figure_is_made(name, tmp_path, capfd):
    assert figures.main([name, "--scale", str(SCALE), "--pictures", str(tmp_path), "--scenes", str(tmp_path)]) == 0
    made = [path for path in tmp_path.iterdir() if path.suffix != ".blend"]
    assert [path.stem for path in made] == [name]
    assert np.ptp(pictures.read(made[0])) > 60


def test_the_poster_shows_every_material(monkeypatch, tmp_path):
    shown = []
    monkeypatch.setattr(poster.Sheet, "row", lambda sheet, row: shown.extend(entry.name for entry in row))
    poster.poster(Job(tmp_path, tmp_path, 0.2))
    assert sorted(shown) == sorted(entries())


@pytest.mark.parametrize(("title", "lines"), [
    ("Copper", ["Copper"]), ("Molybdenum disulphide", ["Molybdenum", "disulphide"]),
    ("Anodised aluminium, space grey", ["Anodised aluminium,", "space grey"])])
def test_a_title_has_two_lines_at_most(title, lines):
    assert poster.in_two_lines(title) == lines


def test_one_blender_cannot_be_compared_with_another_that_is_not_there(tmp_path, capsys):
    assert figures.main(["side_by_side_versions", "--pictures", str(tmp_path)]) == 1
    assert "needs a second Blender" in capsys.readouterr().err


def test_difference_is_stated_as_it_is():
    picture, words = compared(np.full((4, 4, 3), 0.5), np.full((4, 4, 3), 0.51))
    assert words == "rms 2.00 %\nmean +2.00 %"
    assert (picture == bytes_of(np.array(0.25))).all()


def test_sizes_follow_the_scale(tmp_path):
    job = Job(tmp_path, tmp_path, 0.5)
    assert job.size(400, 300) == (200, 150)
    assert job.samples(64) == 32
