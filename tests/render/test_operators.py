"""The operators, called as scripts and the panel call them."""

import json
from types import SimpleNamespace

import bpy
import pytest

import addon
from addon import api
from addon.blender.datablocks import materials
from addon.blender.operators import measurements, realisation
from addon.blender.panels.preview import draw_preview
from addon.export import spectrum_csv
from addon.models.realisations import REALISATIONS
from addon.spectra.optical_constants import load
from tests import drawn


@pytest.fixture
def target():
    """An object with an empty material slot, the extension registered."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    addon.register()
    mesh = bpy.data.meshes.new("Target")
    found = bpy.data.objects.new("Target", mesh)
    bpy.context.scene.collection.objects.link(found)
    bpy.context.view_layer.objects.active = found
    yield found
    addon.unregister()


def test_a_file_becomes_a_material_and_goes_out_again(target, tmp_path):
    file = tmp_path / "my copper.csv"
    file.write_text(spectrum_csv(load("main/Cu/Johnson")))
    assert bpy.ops.facet_film.import_constants(filepath=str(file)) == {"FINISHED"}
    own = materials.parameters_of(target.active_material)
    assert bpy.ops.facet_film.switch_realisation(realisation="exact") == {"FINISHED"}
    assert bpy.ops.facet_film.export(filepath=str(tmp_path / "again.csv"), form="spectrum_csv") == {"FINISHED"}
    assert (tmp_path / "again.csv").read_text() == file.read_text()
    assert bpy.ops.facet_film.bake_preset(preset="copper") == {"FINISHED"}
    assert own.n == pytest.approx(materials.parameters_of(target.active_material).n, rel=1e-4)
    for form, found in (("json", '"dataset": "main/Cu/Johnson"'), ("csv", "cos_theta,r,g,b"),
                        ("spectrum_csv", "wavelength_nm,n,k"), ("materialx", "conductor_bsdf")):
        out = tmp_path / f"out_{form}"
        assert bpy.ops.facet_film.export(filepath=str(out), form=form) == {"FINISHED"}
        assert found in out.read_text(encoding="utf-8")
    assert json.loads((tmp_path / "out_json").read_text(encoding="utf-8"))["name"] == "copper"


def test_a_bad_file_changes_nothing(target, tmp_path):
    bpy.ops.facet_film.bake_preset(preset="copper")
    before = materials.parameters_of(target.active_material)
    file = tmp_path / "bad.csv"
    file.write_text("wavelength_nm,n,k\n400,1.2,3\n550,-1.1,2\n700,1.1,2\n")
    with pytest.raises(RuntimeError, match="line 3"):
        bpy.ops.facet_film.import_constants(filepath=str(file))
    assert materials.parameters_of(target.active_material) == before
    assert len(bpy.data.materials) == 1


def test_a_file_that_can_mean_two_things_is_asked_about(target, tmp_path):
    file = tmp_path / "two.txt"
    file.write_text("400, 4.2\n700, 4.1\n")
    with pytest.raises(RuntimeError, match="n or R"):
        bpy.ops.facet_film.import_constants(filepath=str(file))
    assert not bpy.data.materials
    assert bpy.ops.facet_film.import_constants(filepath=str(file), choose="n") == {"FINISHED"}
    assert materials.baked_of(target.active_material)["source"]["assumed"]
    layout = drawn.Layout()
    operator = SimpleNamespace(filepath=str(file), choose="")
    draw_preview(layout, operator, measurements.preview_of(operator))
    assert "choose" in layout.properties and "n or R" in " ".join(layout.texts)
    operator.choose = "n"
    layout = drawn.Layout()
    draw_preview(layout, operator, measurements.preview_of(operator))
    said = " ".join(layout.texts)
    assert "400–700 nm" in said and "0.374" in said and "taken as 0" in said


def test_a_surface_in_water_is_baked_again_in_water(target):
    """Gold by Johnson and Christy under water, whose F0 is 1.031 .687 .285."""
    assert bpy.ops.facet_film.bake_preset(preset="main/Au/Johnson", medium="water", gamut="leave") == {"FINISHED"}
    material = target.active_material
    assert materials.baked_of(material)["f0"] == pytest.approx((1.031, 0.687, 0.285), abs=1e-3)
    api.rebake(material)
    assert materials.baked_of(material)["f0"] == pytest.approx((1.031, 0.687, 0.285), abs=1e-3)
    assert api.record_of(material).viewing["medium"] == "water"
    with pytest.raises(RuntimeError, match="absorbs light"):
        bpy.ops.facet_film.bake_preset(preset="gold", medium="silver")


def test_check_and_spread_answer(target):
    assert bpy.ops.facet_film.check(against="copper", kind="material", material="gold") == {"FINISHED"}
    assert bpy.ops.facet_film.check(against="copper", kind="nk") == {"FINISHED"}
    assert bpy.ops.facet_film.check(against="copper", kind="f0") == {"FINISHED"}
    assert bpy.ops.facet_film.spread(material="gold") == {"FINISHED"}
    with pytest.raises(RuntimeError, match="did you mean"):
        bpy.ops.facet_film.check(against="coper")


def test_operators_are_off_where_they_cannot_work(target):
    assert not bpy.ops.facet_film.export.poll()
    assert not bpy.ops.facet_film.switch_realisation.poll()
    bpy.context.view_layer.objects.active = None
    assert not bpy.ops.facet_film.bake_preset.poll()
    assert not bpy.ops.facet_film.import_constants.poll()
    empty = bpy.data.objects.new("Empty", None)
    bpy.context.scene.collection.objects.link(empty)
    bpy.context.view_layer.objects.active = empty
    assert not bpy.ops.facet_film.bake_preset.poll()


def test_the_button_of_each_way_to_render_says_what_it_is_for(target):
    switch = realisation.FACET_FILM_OT_switch_realisation
    said = {name: switch.description(bpy.context, SimpleNamespace(realisation=name)) for name in REALISATIONS}
    assert said["fast"].startswith("Clean and fast") and "published formula itself" in said["exact"]
    assert len(set(said.values())) == len(REALISATIONS)
