"""File, Export in a window: what OBJ and FBX read is there before a format is chosen, tuned or not."""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))

import hands  # noqa: E402
from hands import key, middle_of, picture, step, until  # noqa: E402


def material():
    """The cube's."""
    return bpy.data.objects["Cube"].active_material


def stand_in():
    """The roughness of the Principled BSDF that exporters find, or None."""
    for node in material().node_tree.nodes:
        if node.bl_idname == "ShaderNodeBsdfPrincipled" and "facet_film_standin" in node:
            return node.inputs["Roughness"].default_value
    return None


def open_export(area):
    """Open File, Export as its menu, and look that it is drawn."""
    with hands.within(area):
        bpy.ops.wm.call_menu(name="TOPBAR_MT_file_export")
    yield 0.5


def written(name):
    """What an OBJ that is exported now says of the material."""
    file = hands.FOLDER / f"{name}.obj"
    bpy.ops.wm.obj_export(filepath=str(file), export_pbr_extensions=True)
    return file.with_suffix(".mtl").read_text().splitlines()


def session():
    """Bake, export, tune, export."""
    hands.installed()
    area = hands.area_of("VIEW_3D")
    with hands.within(area):
        bpy.ops.facet_film.search(preset="copper")
    yield 0.5
    assert stand_in() is None

    step("the menu has the stand-in made")
    yield from open_export(area)
    picture("export_menu")
    yield from until(lambda: stand_in() is not None, "a Principled BSDF for exporters")
    yield from key("ESC", middle_of(area))
    assert "Pm 1.000000" in written("copper")

    step("what is tuned is made anew")
    group, = [node for node in material().node_tree.nodes if node.bl_idname == "ShaderNodeGroup"]
    group.inputs["Roughness"].default_value = 0.75
    yield 0.3
    yield from open_export(area)
    yield from until(lambda: abs(stand_in() - 0.75) < 1e-3, "the roughness of now")
    yield from key("ESC", middle_of(area))
    assert "Pr 0.750000" in written("tuned")

    step("it is seen for what it is, and undone like anything")
    area.ui_type = "ShaderNodeTree"
    yield 1.0
    with hands.within(area):
        bpy.ops.node.view_all()
    yield 1.0
    picture("nodes")
    yield from hands.undo(middle_of(area))
    assert bpy.data.objects["Cube"] is not None


hands.play(session)
