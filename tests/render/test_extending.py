"""The model of docs/extending.md, written into a folder of its own, is a model of the extension: no other file is
touched.
"""

import json
import re
from pathlib import Path
from types import SimpleNamespace

import bpy
import numpy as np
import pytest

import addon
from addon import api, models
from addon.blender.assets import names, search_items
from addon.blender.datablocks import groups, materials, menu
from addon.blender.panels import picker
from addon.blender.panels.material import FACET_FILM_PT_parameters
from addon.blender.panels.node_menu import FACET_FILM_MT_add
from addon.catalogue import entries, presets, search
from addon.cli import main
from addon.errors import FacetFilmError
from addon.verify.running import checks
from tests.drawn import drawn, properties_editor

ROOT = Path(__file__).resolve().parents[2]
DOCUMENT = (ROOT / "docs" / "extending.md").read_text(encoding="utf-8")
FILES = dict(re.findall(r"`lambert/(\S+)`:\n\n```\w+\n(.*?)```", DOCUMENT, re.DOTALL))


def forget():
    """What looks at the folders once looks anew."""
    for module in (models, entries, presets, search, groups, menu, names, search_items):
        module.forget()


@pytest.fixture
def lambert(tmp_path):
    """The model of the document, in a folder that only the test knows; the extension registered in an empty file."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    folder = tmp_path / "lambert"
    folder.mkdir()
    for name, text in FILES.items():
        (folder / name).write_text(text, encoding="utf-8")
    models.__path__.append(str(tmp_path))
    forget()
    addon.register()
    yield models.named("lambert")
    addon.unregister()
    models.__path__.remove(str(tmp_path))
    forget()


def test_the_document_has_all_files():
    assert set(FILES) == {"__init__.py", "parameters.py", "formulas.py", "fast.py", "presets.json"}


def test_it_is_in_the_list_of_models(lambert):
    assert set(models.names()) == {"clear", "cook_torrance", "film", "lambert", "layered_rgb"}


def test_its_group_is_built_with_its_sockets(lambert):
    tree = groups.node_group("lambert_fast")
    assert groups.input_names(tree) == ["Reflectance", "Tint", "Normal"]
    assert not groups.edited(tree) and tree.name == "Lambert Standard"


def test_its_materials_are_made_by_preset_and_by_parameters(lambert):
    chalk = api.create_material(preset="blackboard chalk")
    assert chalk.name == "Tinted chalk" and materials.model_of(chalk) is lambert
    record = api.record_of(chalk)
    assert record.parameters.reflectance == pytest.approx(0.9)
    assert record.source.name == "tinted_chalk"
    made = api.create_material("lambert", reflectance=0.3, tint=(0.2, 0.4, 0.6))
    assert np.allclose(made.diffuse_color[:3], (0.06, 0.12, 0.18))
    with pytest.raises(FacetFilmError, match="reflectance must be a number from 0 to 1"):
        api.create_material("lambert", reflectance=2)
    with pytest.raises(FacetFilmError, match="realisation 'exact' is unknown"):
        api.switch_realisation(made, "exact")
    with pytest.raises(FacetFilmError, match="takes no measurement"):
        api.create_material("lambert", preset="main/Cu/Johnson")


def test_it_is_listed_and_found(lambert, capsys):
    assert main(["list", "--json"]) == 0
    assert {"name": "tinted_chalk", "model": "lambert"}.items() <= next(
        row for row in json.loads(capsys.readouterr().out) if row["name"] == "tinted_chalk").items()
    assert main(["search", "tinted chalk"]) == 0
    assert capsys.readouterr().out.startswith("tinted_chalk")
    assert main(["bake", "tinted_chalk"]) == 0
    assert "reflectance  0.9" in capsys.readouterr().out


def test_the_panel_offers_it_and_shows_its_parameters(lambert):
    assert picker.search("tinted chalk") == [("tinted_chalk", "Tinted chalk")]
    assert ("tinted_chalk", "blackboard chalk ▸ Tinted chalk") in [item[:2] for item in search_items.items()]
    target = bpy.data.objects.new("Target", bpy.data.meshes.new("Target"))
    bpy.context.scene.collection.objects.link(target)
    bpy.context.view_layer.objects.active = target
    assert bpy.ops.facet_film.bake_preset(preset="tinted_chalk") == {"FINISHED"}
    layout = drawn(FACET_FILM_PT_parameters, properties_editor(material=target.active_material))
    assert {"Reflectance", "Tint"} <= set(layout.texts)


def test_the_add_menu_offers_it(lambert):
    context = SimpleNamespace(window_manager=bpy.context.window_manager)
    assert "Lambert Standard" in drawn(FACET_FILM_MT_add, context).texts


def test_its_check_renders_it_and_fails_where_it_is_broken(lambert):
    found, _ = checks("lambert")
    check, = found
    assert (check.model, check.realisation) == ("lambert", "fast")
    assert check.run().passed
    assert not check.run(reflectance=0.7).passed
