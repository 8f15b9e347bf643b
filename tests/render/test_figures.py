"""Every figure is made, small, by its script; the ones that the documents show are exactly these."""

from pathlib import Path

import bpy
import numpy as np
import pytest

from addon.bake.srgb import bytes_of
from addon.catalogue.entries import entries
from demo_blend import figures, helmet, pictures, poster, show_glass, watch
from demo_blend.job import Job
from demo_blend.side_by_side import compared
from demo_blend.studio import matt, new_scene

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


def lowest(objects):
    bpy.context.view_layer.update()
    return min((made.matrix_world @ vertex.co).z for made in objects for vertex in made.data.vertices)


@pytest.fixture()
def empty_scene():
    new_scene((16, 16), 1)


def test_the_watch_stands_on_links_that_lie_flat(empty_scene):
    parts = watch.build_watch()
    floor = watch.loop()[:, 1].min() - 0.5 * watch.LINK_HEIGHT
    assert lowest(parts) == pytest.approx(floor, abs=0.01)
    standing = [part for part in parts if part.name.startswith("Link") and lowest([part]) < floor + 0.02]
    assert len(standing) >= 6, "two rows of three links carry it"


def test_a_stone_lies_on_its_pavilion(empty_scene):
    show_glass.stone("diamond", (0.0, 0.0), 0.2, 0.3)
    stone = bpy.data.objects["diamond"]
    bpy.context.view_layer.update()
    heights = sorted((stone.matrix_world @ vertex.co).z for vertex in stone.data.vertices)
    assert heights[:4] == pytest.approx([0.0] * 4, abs=1e-6), "a facet, and not a corner, is on the sill"


def test_a_helmet_stands_on_its_trim(empty_scene):
    made = helmet.helmet("Helmet", matt("Shell", 0.5), matt("Visor", 0.5), detail=0.2)
    bpy.context.view_layer.update()
    edge = [vertex.co.z for vertex in made.data.vertices]
    assert min(edge) == pytest.approx(0.0, abs=1e-6)
    assert len({polygon.material_index for polygon in made.data.polygons}) == 3, "shell, rubber and visor"


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
