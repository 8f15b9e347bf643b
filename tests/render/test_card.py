"""The card, the menus and the preferences: which ways to a material are drawn where."""

from types import SimpleNamespace

import bpy
import pytest

import addon
from addon import api
from addon.blender import compat, settings
from addon.blender.assets import library
from addon.blender.operators import apply
from addon.blender.panels import card, menus, preferences
from addon.blender.panels.shelves import PICKER, SHELF
from tests.drawn import Layout, drawn, properties_editor


class Shelves(Layout):
    """A layout that notes the shelves that open from it."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self.shelves = parent.shelves if parent else []

    def row(self, *_arguments, **_options):
        """A part of this layout."""
        return Shelves(self)

    column = split = row

    def template_asset_shelf_popover(self, shelf, **_options):
        """Note the shelf."""
        self.shelves.append(shelf)


@pytest.fixture
def cube():
    """The start scene, with the extension registered."""
    bpy.ops.wm.read_factory_settings()
    addon.register()
    yield bpy.data.objects["Cube"]
    for entry in library.ours():
        bpy.context.preferences.filepaths.asset_libraries.remove(entry)
    addon.unregister()


def drawn_card():
    layout = Shelves()
    card.draw_first(SimpleNamespace(layout=layout), properties_editor())
    return layout


def test_the_first_click_adds_the_library_and_then_the_picture_opens_all(cube):
    before = drawn_card()
    assert "facet_film.choose" in before.operators and not before.shelves
    assert library.add()
    after = drawn_card()
    assert after.shelves == [PICKER] and "facet_film.choose" not in after.operators
    assert {"facet_film.search", "facet_film.shelf"} <= set(after.operators) & set(before.operators)


def test_a_linked_material_has_a_button_that_makes_it_local(cube, tmp_path):
    assert "facet_film.make_local" not in drawn_card().operators
    made = api.create_material(preset="copper", name="Linked")
    bpy.data.libraries.write(str(tmp_path / "other.blend"), {made})
    with bpy.data.libraries.load(str(tmp_path / "other.blend"), link=True) as (_, target):
        target.materials = ["Linked"]
    cube.active_material = target.materials[0]
    assert "facet_film.make_local" in drawn_card().operators


def test_nothing_for_what_takes_no_material(cube):
    bpy.context.view_layer.objects.active = bpy.data.objects["Camera"]
    assert not drawn_card().operators


@pytest.mark.parametrize("space, expected", [
    (SimpleNamespace(type="VIEW_3D"), ["facet_film.choose"]),
    (SimpleNamespace(type="NODE_EDITOR", tree_type="ShaderNodeTree"), ["facet_film.choose"]),
    (SimpleNamespace(type="NODE_EDITOR", tree_type="GeometryNodeTree"), [])])
def test_headers(cube, space, expected):
    layout = Layout()
    menus.draw_in_header(SimpleNamespace(layout=layout), SimpleNamespace(space_data=space))
    assert layout.operators == expected


def test_the_preferences_say_where_it_is(cube, monkeypatch):
    monkeypatch.setattr(menus, "preferences", lambda: SimpleNamespace(in_headers=False, in_menus=False))
    layout = Layout()
    menus.draw_in_header(SimpleNamespace(layout=layout), SimpleNamespace(space_data=SimpleNamespace(type="VIEW_3D")))
    menus.draw_in_menu(SimpleNamespace(layout=layout), None)
    assert not layout.operators


def test_menus_offer_the_pictures_and_the_search(cube):
    layout = Layout()
    menus.draw_in_menu(SimpleNamespace(layout=layout), None)
    assert layout.operators == ["facet_film.choose", "facet_film.search"]
    menus.draw_in_object_menu(SimpleNamespace(layout=layout), None)
    assert layout.operators[2:] == ["facet_film.choose", "facet_film.search", "facet_film.common_face"]


def test_new_materials_render_as_the_preferences_say(cube, monkeypatch):
    monkeypatch.setattr(apply, "preferences", lambda: SimpleNamespace(realisation="exact", finish="brushed"))
    bpy.ops.facet_film.apply(preset="gold")
    record = api.record_of(cube.active_material)
    assert (record.realisation, record.finish) == ("exact", "brushed")


def test_the_preferences_are_drawn(cube):
    layout, shown = Layout(), vars(settings.DEFAULTS)
    panel = SimpleNamespace(layout=layout, **shown, **{
        name: getattr(preferences.FacetFilmPreferences, name).__get__(SimpleNamespace())
        for name in ("_draw_library", "_draw_verification")})
    preferences.FacetFilmPreferences.draw(panel, bpy.context)
    assert set(shown) <= set(layout.properties)
    assert {"facet_film.add_asset_library", "wm.path_open", "facet_film.verify"} <= set(layout.operators)
    assert preferences.README.exists()


def test_the_shelves_are_there_in_every_blender(cube):
    shelf = getattr(bpy.types, SHELF)
    assert getattr(bpy.types, PICKER).bl_activate_operator == shelf.bl_activate_operator == "FACET_FILM_OT_apply"
    assert ("NO_ASSET_DRAG" in shelf.bl_options) == (not compat.drags_from_shelves())
    assert not bpy.ops.facet_film.shelf.poll() or bpy.context.window


def test_the_sidebar_is_asked_for(cube):
    assert drawn(menus.FACET_FILM_PT_view3d, properties_editor()) is None
