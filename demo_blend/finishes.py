"""Every finish on a ball, a box with rounded edges and a monkey's head, of copper and of plastic."""

import math

import bpy
from mathutils import Vector

from .job import Figure
from .pictures import column, labelled, row
from .shapes import rounded_box
from .studio import add_softbox, new_scene, set_sky

MATERIALS = ("copper", "plastic_blue")
SIDE = 200
"""Of an object's picture in pixels."""
APART = 2.35


def finishes(job):
    """A row a finish."""
    from addon import api
    from addon.finishes import all_finishes
    scene = _studio(job)
    material = api.create_material(preset="copper")
    _objects(material)
    rows = []
    for finish in all_finishes():
        pictures = []
        for preset in MATERIALS:
            api.create_material(preset=preset, material=material, finish=finish.name)
            pictures.append(job.render(scene, f"{finish.title} {preset}"))
        rows.append(labelled(row(pictures), finish.title, size=15 * job.scale))
    job.write(column(rows), "finishes.jpg")


def _studio(job):
    """A dim sky with a bright horizon, three softboxes ten times as bright, a camera that looks down a little."""
    scene = new_scene(job.size(3 * SIDE, SIDE), job.samples(32), look="Khronos PBR Neutral", denoise=True, noise=0.02)
    add_softbox(scene, (-5.0, -5.5, 6.0), (0.0, 0.0, 0.0), (2.6, 2.6), 7.0)
    add_softbox(scene, (6.5, -1.5, 3.0), (0.0, 0.0, 0.0), (0.9, 5.5), 6.0)
    add_softbox(scene, (0.0, 5.0, 6.0), (0.0, 0.0, 0.0), (8.0, 1.2), 5.0)
    set_sky(scene, (0.30, 0.31, 0.33), (0.62, 0.62, 0.62), (0.10, 0.095, 0.09))
    lens = bpy.data.cameras.new("Camera")
    lens.type, lens.ortho_scale = "ORTHO", 3.0 * APART
    camera = bpy.data.objects.new("Camera", lens)
    camera.location = (0.0, -9.0, 3.0)
    camera.rotation_euler = Vector(camera.location).to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(camera)
    scene.camera = camera
    return scene


def _objects(material):
    """The three, side by side."""
    bpy.ops.mesh.primitive_uv_sphere_add(segments=96, ring_count=48, radius=1.0, location=(-APART, 0.0, 0.0))
    ball = bpy.context.active_object
    box = rounded_box("Box", (1.5, 1.5, 1.5), 0.08, material)
    box.rotation_euler = (0.0, 0.0, math.radians(35.0))
    bpy.ops.mesh.primitive_monkey_add(size=2.0, location=(APART, 0.0, 0.0))
    monkey = bpy.context.active_object
    monkey.rotation_euler = (math.radians(-12.0), 0.0, math.radians(18.0))
    smooth = monkey.modifiers.new("Subdivision", "SUBSURF")
    smooth.levels = smooth.render_levels = 2
    for target in (ball, monkey):
        target.data.polygons.foreach_set("use_smooth", [True] * len(target.data.polygons))
        target.data.materials.append(material)


FIGURES = (Figure("finishes", "All finishes, on copper and on plastic", 240.0, finishes),)
