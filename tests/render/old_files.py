"""Writes a file of every model and realisation as this version on Blender 4.5 saves it, and what it renders like.

    .venv-4.5/bin/python -m tests.render.old_files

Writes tests/data/saved_by_4.5.blend and tests/data/saved_by_4.5.json. They stay as they are: newer versions of the
extension and of Blender have to open them.
"""

import json
import shutil
import tempfile
from pathlib import Path

import bpy
import numpy as np

from addon import api, models

__all__ = ["FILE", "COLOURS", "colours"]

FILE = Path(__file__).parents[1] / "data" / "saved_by_4.5.blend"
COLOURS = FILE.with_suffix(".json")
SIDE, SAMPLES = 16, 64
PRESETS = {"cook_torrance": "copper", "layered_rgb": "nacre"}


def make_scene():
    """A ball in front of a camera, under a sky of one colour: little noise, and light from everywhere."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x = scene.render.resolution_y = SIDE
    scene.cycles.samples, scene.cycles.use_adaptive_sampling, scene.cycles.use_denoising = SAMPLES, False, False
    scene.cycles.shading_system = True
    bpy.ops.mesh.primitive_uv_sphere_add(segments=32, ring_count=16)
    bpy.context.active_object.name = "Ball"
    bpy.ops.object.camera_add(location=(0.0, 0.0, 3.0))
    scene.camera = bpy.context.active_object
    scene.camera.data.type, scene.camera.data.ortho_scale = "ORTHO", 1.2
    scene.world = bpy.data.worlds.new("Sky")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (1.0, 0.9, 0.8, 1.0)


def colours(folder):
    """{material: mean colour of the ball's middle} of every material in the open file, linear."""
    found = {}
    for material in bpy.data.materials:
        if not material.use_fake_user:
            continue
        ball = bpy.data.objects["Ball"]
        ball.data.materials.clear()
        ball.data.materials.append(material)
        bpy.context.scene.render.filepath = str(Path(folder) / "picture.exr")
        bpy.context.scene.render.image_settings.file_format = "OPEN_EXR"
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(bpy.context.scene.render.filepath)
        pixels = np.array(image.pixels[:]).reshape(SIDE * SIDE, 4)[:, :3]
        bpy.data.images.remove(image)
        found[material.name] = [round(float(channel), 4) for channel in pixels.mean(axis=0)]
    return found


def main():
    """Make, save, render, and write what came out."""
    if bpy.app.version[:2] != (4, 5):
        raise SystemExit("the old file is written by Blender 4.5")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    make_scene()
    for model in PRESETS:
        for realisation in models.named(model).realisations:
            api.create_material(model, preset=PRESETS[model], realisation=realisation,
                                name=f"{model} {realisation}").use_fake_user = True
    with tempfile.TemporaryDirectory() as folder:  # a file says where it was saved
        bpy.ops.wm.save_as_mainfile(filepath=str(Path(folder) / FILE.name), compress=True)
        shutil.copy(Path(folder) / FILE.name, FILE)
    COLOURS.write_text(json.dumps(colours(bpy.app.tempdir), indent=1) + "\n", encoding="utf-8")
    print(f"{FILE.name}: {FILE.stat().st_size / 1024:.0f} kB")


if __name__ == "__main__":
    main()
