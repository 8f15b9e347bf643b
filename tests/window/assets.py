"""The asset library: added by the button, dragged from an Asset Browser onto the cube, its slider moved, rendered;
Re-bake All stopped.
"""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))

import hands  # noqa: E402
from hands import area_of, drag, find, key, middle_of, picture, preset, region_of, step, until, within  # noqa: E402


def session():
    """Everything, in order."""
    hands.installed()
    step("drag a material from the Asset Browser onto the cube")
    with within(area_of("PROPERTIES")):
        bpy.ops.facet_film.add_asset_library()
    # A cube that fills the view is hit in its middle; the editor below the view is too low for assets, the right one
    # not.
    area = area_of("PROPERTIES")
    area.ui_type = "ASSETS"
    yield 1.0
    view = area_of("VIEW_3D")
    with within(view):
        bpy.ops.view3d.view_selected()
    area.spaces.active.show_region_toolbar = False
    area.spaces.active.params.asset_library_reference = "Facet & Film"
    region = region_of(area)
    for _ in range(20):
        yield 1.0
        yield from hands.click(*thumbnail(region))
        if chosen(area):
            break
    picture("browser")
    assert chosen(area), "The Asset Browser shows no asset of ours"
    bpy.ops.ed.undo_push(message="Start")
    yield from drag(thumbnail(region), middle_of(view))
    yield 1.0
    picture("dropped")
    yield from until(lambda: preset() is not None, "the cube has a material of ours")

    step("move the slider of the dragged material's roughness")
    area.ui_type = "PROPERTIES"
    area.spaces.active.context = "MATERIAL"
    yield 1.5
    slider = yield from find(area, "default_value", across=(0.5,))
    before = roughness()
    yield from drag(slider, (slider[0] + 40, slider[1]))
    yield from until(lambda: roughness() != before, "the roughness is another")
    picture("slid")
    yield from hands.undo(middle_of(view))
    yield from until(lambda: roughness() == before, "the roughness is as before after undo")

    step("render it in the viewport")
    view.spaces.active.shading.type = "RENDERED"
    yield 5.0
    picture("rendered")
    view.spaces.active.shading.type = "SOLID"
    yield from hands.undo(middle_of(view))
    yield from until(lambda: preset() is None, "no material of ours after undo")

    step("stop Re-bake All by Esc")
    from bl_ext.user_default.facet_film.addon import api
    for _ in range(60):
        api.create_material(preset="copper").use_fake_user = True
    before = records()
    bpy.context.window_manager.facet_film.illuminant = "A"
    with within(view):
        assert "RUNNING_MODAL" in bpy.ops.facet_film.rebake_all("INVOKE_DEFAULT")
    yield 0.2
    yield 0.2  # the first step is over now, and the status bar drawn
    picture("baking")
    yield from key("ESC", middle_of(view))
    yield 0.5
    assert records() == before, "Esc changed materials"

    step("bake all materials again to the end, and undo that")
    bpy.ops.ed.undo_push(message="Sixty materials")
    with within(view):
        bpy.ops.facet_film.rebake_all("INVOKE_DEFAULT")
    yield from until(lambda: all(new != old for new, old in zip(records(), before, strict=True)), "all are changed", 40)
    yield from hands.undo(middle_of(view))
    yield from until(lambda: records() == before, "all are as before after undo")


def roughness():
    """The roughness of the cube's material."""
    nodes = bpy.data.objects["Cube"].active_material.node_tree.nodes
    return next(node.inputs["Roughness"].default_value for node in nodes if node.bl_idname == "ShaderNodeGroup")


def records():
    """What each material of ours says of itself."""
    return [material["facet_film"] for material in bpy.data.materials if "facet_film" in material]


def thumbnail(region):
    """The first thumbnail of the library."""
    return region.x + 60, region.y + region.height - 70


def chosen(area):
    """The chosen asset, or None while the library is being read."""
    with within(area):
        return bpy.context.asset


hands.play(session)
