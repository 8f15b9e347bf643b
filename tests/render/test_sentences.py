"""What the panels and buttons say where they cannot do what is asked, and what to do about it."""

from types import SimpleNamespace

import bpy
import pytest

import addon
from addon import api
from addon.blender import compat
from addon.blender.datablocks import materials
from addon.blender.operators import rebake_all as rebake_all_operator
from addon.blender.panels.material import FACET_FILM_PT_material, FACET_FILM_PT_parameters
from addon.blender.panels.measurement import FACET_FILM_PT_measurement
from tests.drawn import drawn, properties_editor


@pytest.fixture(autouse=True)
def ball():
    """An active mesh without a material in an empty file, the extension registered, Cycles."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    addon.register()
    bpy.context.scene.render.engine = "CYCLES"
    made = bpy.data.objects.new("Ball", bpy.data.meshes.new("Ball"))
    bpy.context.scene.collection.objects.link(made)
    bpy.context.view_layer.objects.active = made
    made.select_set(True)
    yield made
    addon.unregister()


def said_by_panel(**context):
    """All that the panel says, and its layout."""
    layout = drawn(FACET_FILM_PT_material, properties_editor(**context))
    return " ".join(layout.texts), layout


def refusal(operator, **options):
    """Why a button is grey."""
    assert not operator.poll()
    with pytest.raises(RuntimeError) as error:
        operator(**options)
    return str(error.value)


# --- Nothing to work on ---

def test_no_object(ball):
    ball.select_set(False)
    bpy.context.view_layer.objects.active = None
    assert "Select an object first" in refusal(bpy.ops.facet_film.bake_preset)
    assert "Select an object first" in refusal(bpy.ops.facet_film.paste_constants)
    assert drawn(FACET_FILM_PT_material, properties_editor()) is None  # the Properties editor has no such tab then


def test_an_object_that_takes_no_material(ball):
    ball.select_set(False)
    empty = bpy.data.objects.new("Empty", None)
    bpy.context.scene.collection.objects.link(empty)
    bpy.context.view_layer.objects.active = empty
    said = refusal(bpy.ops.facet_film.bake_preset)
    assert "Empty takes no materials" in said and "select a mesh" in said


@pytest.mark.parametrize("name, sentence", [
    ("rebake", "Bake a measured material first"), ("export", "Bake a measured material first"),
    ("switch_realisation", "Bake a preset first"), ("rebake_all", "bake a preset first")])
def test_no_material(name, sentence):
    assert sentence in refusal(getattr(bpy.ops.facet_film, name))


def test_no_material_to_save():
    with pytest.raises(RuntimeError, match="Apply a material of Facet & Film first: there is nothing to save"):
        bpy.ops.facet_film.save_user_preset(name="Mine")


def test_without_a_material_the_panel_shows_how_to_get_one(ball):
    said, layout = said_by_panel()
    assert "Choose a material by its picture, above" in said and not layout.operators
    assert drawn(FACET_FILM_PT_parameters, properties_editor()) is None
    assert "facet_film.bake_preset" in drawn(FACET_FILM_PT_measurement, properties_editor()).operators
    assert bpy.ops.facet_film.bake_preset() == {"FINISHED"}
    assert drawn(FACET_FILM_PT_parameters, properties_editor()) is not None


def test_a_material_that_is_not_ours(ball):
    ball.active_material = bpy.data.materials.new("Plain")
    compat.enable_nodes(ball.active_material)
    assert "this material is not one of Facet & Film" in refusal(bpy.ops.facet_film.switch_realisation)
    assert "Renders by" not in said_by_panel()[0]


# --- Data of another file ---

@pytest.fixture
def linked(ball, tmp_path):
    """The ball with copper, linked from another file."""
    bpy.ops.facet_film.bake_preset(preset="copper")
    file = str(tmp_path / "source.blend")
    bpy.data.libraries.write(file, {ball})
    with bpy.data.libraries.load(file, link=True) as (_, target):
        target.objects, target.materials = ["Ball"], ["Copper"]
    return target.objects[0]


@pytest.mark.parametrize("overridden, sentence", [
    (False, "is linked from another file: make it local first"), (True, "is a library override")])
def test_linked_and_overridden_materials(linked, overridden, sentence):
    material = linked.active_material
    if overridden:
        material = material.override_create()
        assert material is not None
    assert sentence in said_by_panel(target=linked, material=material)[0]
    shown = drawn(FACET_FILM_PT_parameters, properties_editor(linked, material))
    assert not shown.enabled
    with bpy.context.temp_override(material=material):
        for name in ("switch_realisation", "rebake"):
            assert sentence in refusal(getattr(bpy.ops.facet_film, name))


# --- What the scene lacks ---

def osl_off(scene):
    scene.cycles.shading_system = False


def osl_on_gpu(scene):
    scene.cycles.shading_system, scene.cycles.device = True, "GPU"


def workbench(scene):
    scene.render.engine = "BLENDER_WORKBENCH"


def eevee(scene):
    scene.render.engine = compat.eevee_engine()


@pytest.mark.parametrize("realisation, arrange, sentence", [
    ("osl", osl_off, "Reference is shown in its place until you switch it on in the Render properties"),
    ("osl_fast", osl_off, "Standard is shown in its place until you switch it on in the Render properties"),
    ("osl", osl_on_gpu, "OSL needs the CPU or OptiX: Reference is shown in its place on this device"),
    ("fast", workbench, "choose Cycles in the Render properties"),
    ("exact", workbench, "choose Cycles in the Render properties"),
    ("exact", eevee, "This engine renders Standard in its place: for this realisation choose Cycles")])
def test_the_panel_says_what_the_scene_lacks(ball, realisation, arrange, sentence):
    ball.active_material = api.create_material(preset="copper", realisation=realisation)
    scene = bpy.context.scene
    arrange(scene)
    said, layout = said_by_panel()
    assert sentence in said
    assert ("shading_system" in layout.properties) == (realisation.startswith("osl"))  # the switch itself
    scene.render.engine, scene.cycles.shading_system, scene.cycles.device = "CYCLES", True, "CPU"
    assert sentence not in said_by_panel()[0]


@pytest.mark.parametrize("realisation, arrange", [("fast", eevee), ("fast", osl_off), ("exact", osl_on_gpu)])
def test_the_panel_says_nothing_where_nothing_is_lacking(ball, realisation, arrange):
    ball.active_material = api.create_material(preset="copper", realisation=realisation)
    arrange(bpy.context.scene)
    assert said_by_panel()[0] == "Renders by Standard Reference OSL OSL Standard"


# --- What takes longer: Re-bake All, step by step ---

class Standing:
    """The operator as Blender runs it, without a window: its functions on an object, and what it reports."""

    def __init__(self):
        self.reports = []
        held = {**vars(rebake_all_operator.OneByOne), **vars(rebake_all_operator.FACET_FILM_OT_rebake_all)}
        for name, value in held.items():
            if callable(value) and not name.startswith("__"):
                setattr(self, name, value.__get__(self))

    def report(self, _kind, text):
        self.reports.append(text)


class Window:
    """The context of an operator that runs on: notes timers, progress and the status bar."""

    def __init__(self):
        self.window, self.timers, self.progress, self.status = object(), [], [], [None]
        self.workspace = SimpleNamespace(status_text_set=self.status.append)
        self.window_manager = SimpleNamespace(
            facet_film=bpy.context.window_manager.facet_film, modal_handler_add=lambda _operator: True,
            event_timer_add=self._add, event_timer_remove=self.timers.remove, progress_begin=self._at(0),
            progress_update=self.progress.append, progress_end=lambda: self.progress.append("end"))

    def _add(self, _seconds, window):
        assert window is self.window
        self.timers.append("timer")
        return "timer"

    def _at(self, place):
        return lambda *span: self.progress.append(span[place])


@pytest.fixture
def baking():
    """Re-bake All begun on three materials that were baked for another light, and its window."""
    for preset in ("copper", "gold", "silver"):
        api.create_material(preset=preset, viewing={"illuminant": "A"}).use_fake_user = True
    operator, window = Standing(), Window()
    assert operator.invoke(window, None) == {"RUNNING_MODAL"} and window.timers == ["timer"]
    return operator, window


def illuminants():
    return [materials.baked_of(material)["illuminant"] for material in bpy.data.materials]


def test_re_baking_all_goes_on_to_the_end_with_progress(baking):
    operator, window = baking
    for _ in range(3):
        assert operator.modal(window, SimpleNamespace(type="TIMER")) == {"RUNNING_MODAL"}
        assert operator.modal(window, SimpleNamespace(type="MOUSEMOVE")) == {"RUNNING_MODAL"}
    assert illuminants() == ["A"] * 3  # written together, so that one undo takes them back
    assert "Baking Copper, 2 more   (Esc stops)" in window.status and window.progress == [0, 0, 1, 2]
    assert operator.modal(window, SimpleNamespace(type="TIMER")) == {"FINISHED"}
    assert illuminants() == ["D65"] * 3 and operator.reports == ["3 materials baked again"]
    assert window.timers == [] and window.status[-1] is None and window.progress[-1] == "end"


@pytest.mark.parametrize("ticks", (0, 1, 3))
def test_esc_stops_re_baking_all_and_changes_nothing(baking, ticks):
    operator, window = baking
    for _ in range(ticks):
        operator.modal(window, SimpleNamespace(type="TIMER"))
    assert operator.modal(window, SimpleNamespace(type="ESC")) == {"CANCELLED"}
    assert illuminants() == ["A"] * 3 and operator.reports == ["Stopped: no material was changed"]
    assert window.timers == [] and window.status[-1] is None and window.progress[-1] == "end"


def test_re_baking_all_ends_where_blender_ends_it(baking):
    """As it does when another file is opened."""
    operator, window = baking
    operator.modal(window, SimpleNamespace(type="TIMER"))
    operator.cancel(window)
    assert illuminants() == ["A"] * 3 and window.timers == [] and window.status[-1] is None
