"""Clear bodies: water in a glass, a brilliant, a bottle, panes in the sun, soap bubbles."""

import bpy
import numpy as np

from .cut_stone import box, brilliant
from .job import Figure
from .studio import add_camera, add_cove, add_softbox, add_sun_of_solid_angle, matt, new_scene, set_sky
from .turned import turned_object

__all__ = ["FIGURES", "mesh_object"]

BOUNCES = 24

TUMBLER_OUTSIDE = ((0.0, 0.0), (0.60, 0.0), (0.68, 0.03), (0.72, 0.12), (0.82, 1.1), (0.92, 2.1))
TUMBLER_LIP = ((0.93, 2.14), (0.92, 2.17), (0.895, 2.17), (0.88, 2.14))
LEVEL = 1.55
TUMBLER_INSIDE = ((0.83, LEVEL), (0.775, 1.1), (0.69, 0.35), (0.64, 0.27), (0.5, 0.25), (0.0, 0.25))
"""From the water's edge down to the middle of the floor."""

BOTTLE_PROFILE = (
    (0.0, 0.14), (0.18, 0.12), (0.32, 0.02), (0.38, 0.0), (0.42, 0.04), (0.43, 0.12), (0.43, 1.0), (0.43, 1.9),
    (0.40, 2.1), (0.28, 2.35), (0.19, 2.55), (0.165, 2.75), (0.16, 3.1), (0.19, 3.12), (0.19, 3.24), (0.16, 3.27),
    (0.13, 3.26), (0.12, 3.2), (0.12, 2.75), (0.15, 2.54), (0.24, 2.34), (0.36, 2.08), (0.39, 1.88), (0.39, 1.0),
    (0.39, 0.15), (0.34, 0.1), (0.18, 0.19), (0.0, 0.21),
)
"""A wine bottle, 33 cm tall with walls of 4 mm at ten centimetres a unit."""


def mesh_object(name, corners, faces, material):
    """An object of flat faces."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(np.array(corners).tolist(), [], faces)
    mesh.materials.append(material)
    made = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(made)
    return made


def clear_scene(job, width, height, samples, *, noise=0.02, **look):
    """A scene whose light passes many faces."""
    scene = new_scene(job.size(width, height), job.samples(samples), denoise=True, noise=noise, **look)
    cycles = scene.cycles
    cycles.max_bounces = cycles.transmission_bounces = cycles.glossy_bounces = BOUNCES
    cycles.transparent_max_bounces = BOUNCES
    cycles.caustics_reflective = cycles.caustics_refractive = False  # the shadows are straight
    return scene


def _material(preset, **parameters):
    from addon import api
    return api.create_material(preset=preset, **parameters)


def glass_of_water(job):
    """Three faces: glass against air, glass against water, water against air; the second one once."""
    scene = clear_scene(job, 960, 1200, 24)
    glass = _material("low_iron_glass", scene_scale=0.05)
    dry = (*TUMBLER_OUTSIDE, *TUMBLER_LIP, TUMBLER_INSIDE[0])
    turned_object("Glass against air", dry, glass)
    water = _material("water", scene_scale=0.05)
    turned_object("Water against glass", TUMBLER_INSIDE[::-1], _common_face(water, glass))
    meniscus = ((0.83, LEVEL), (0.80, LEVEL - 0.02), (0.74, LEVEL - 0.028), (0.0, LEVEL - 0.03))
    turned_object("Water against air", meniscus, water)
    straw = _straw()
    straw.location = (0.1, 0.0, 0.33)
    add_cove(scene, (0.70, 0.72, 0.74), back=5.0)
    set_sky(scene, (0.55, 0.57, 0.60), (0.30, 0.31, 0.33), (0.03, 0.03, 0.03))
    add_softbox(scene, (-4.0, 3.0, 4.5), (0.0, 5.0, 1.5), (3.0, 3.0), 7.0)
    add_softbox(scene, (-5.0, -1.0, 3.5), (0.0, 0.0, 1.0), (1.5, 4.0), 3.5)
    add_softbox(scene, (4.5, -2.0, 3.0), (0.0, 0.0, 1.0), (0.4, 4.0), 6.0)
    add_camera(scene, (0.0, -9.0, 2.6), (0.0, 0.0, 1.22), 88.0)
    job.write(job.render(scene, "glass of water"), "clear_water.jpg", most_bytes=80_000)
    job.save_scene("clear_water")


def _common_face(inside, outside):
    from addon import api
    return api.common_face(inside, outside)


def _straw():
    """A striped straw, leaning: the eye's test of where the water begins."""
    from mathutils import Matrix
    corners, faces = [], []
    segments, rings = 24, 60
    for ring in range(rings + 1):
        for k in range(segments):
            angle = 2.0 * np.pi * k / segments
            corners.append((0.07 * np.cos(angle), 0.07 * np.sin(angle), 3.0 * ring / rings))
    for ring in range(rings):
        for k in range(segments):
            after = (k + 1) % segments
            faces.append((ring * segments + k, ring * segments + after, (ring + 1) * segments + after,
                          (ring + 1) * segments + k))
    straw = mesh_object("Straw", corners, faces, matt("White", 0.8))
    straw.data.materials.append(matt("Red", (0.65, 0.03, 0.03)))
    for number, face in enumerate(straw.data.polygons):
        face.use_smooth = True
        face.material_index = number // segments // 6 % 2
    straw.matrix_world = Matrix.Rotation(np.radians(14.0), 4, "Y")
    return straw


def cut_diamond(job):
    """A brilliant, Dispersive, under small lamps in dim surroundings, which make its fire."""
    scene = clear_scene(job, 1280, 960, 32)
    stone = mesh_object("Brilliant", *brilliant(), _material("diamond"))
    stone.rotation_euler = (np.radians(36.0), np.radians(8.0), 0.3)
    stone.location = (0.0, 0.0, 0.86)
    add_cove(scene, (0.022, 0.025, 0.034), back=5.0)
    set_sky(scene, (0.36, 0.38, 0.42), (0.05, 0.05, 0.06), (0.01, 0.01, 0.01))
    random = np.random.default_rng(8)
    for turn in np.linspace(0.0, 2.0 * np.pi, 23)[:-1]:
        height = random.uniform(0.25, 1.25)
        place = 9.0 * np.array([np.cos(turn) * np.cos(height), np.sin(turn) * np.cos(height), np.sin(height)])
        add_softbox(scene, tuple(place), (0.0, 0.0, 0.8), 0.75, 26.0)
    add_camera(scene, (0.0, -6.6, 4.5), (0.0, 0.0, 0.86), 98.0)
    job.write(job.render(scene, "brilliant"), "clear_brilliant.jpg")
    job.save_scene("clear_brilliant")


def bottles(job):
    """Wine and beer bottles as solid walls before a bright ground."""
    scene = clear_scene(job, 1200, 1350, 20)
    for x, y, preset, size in ((-0.95, 0.1, "bottle_green", 1.0), (0.05, -0.45, "low_iron_glass", 0.8),
                               (1.0, 0.15, "bottle_brown", 0.9)):
        bottle = turned_object(preset, BOTTLE_PROFILE, _material(preset, scene_scale=0.1))
        bottle.location, bottle.scale = (x, y, 0.0), (size,) * 3
    add_cove(scene, (0.80, 0.79, 0.76), back=4.0)
    set_sky(scene, (0.5, 0.5, 0.52), (0.35, 0.35, 0.36), (0.05, 0.05, 0.05))
    add_softbox(scene, (0.0, 2.5, 7.0), (0.0, 6.5, 1.2), (5.0, 2.0), 6.0)
    add_softbox(scene, (-5.0, -2.0, 4.0), (0.0, 0.0, 1.6), (1.0, 5.0), 5.0)
    add_softbox(scene, (5.0, 1.0, 4.0), (0.0, 0.0, 1.4), (0.7, 4.0), 4.0)
    add_camera(scene, (0.0, -11.0, 2.5), (0.02, 0.0, 1.56), 92.0)
    job.write(job.render(scene, "bottles"), "clear_bottles.jpg")
    job.save_scene("clear_bottles")


PANES = ("window_glass", "green_glass", "bronze_glass", "cobalt_glass", "filter_amber", "grey_glass")


def window(job):
    """Panes of six glasses, thin-walled, in the sun: straight shadows in the colours of the panes, without noise."""
    scene = clear_scene(job, 1280, 960, 16)
    frame = matt("Frame", (0.62, 0.58, 0.52))
    for column in range(3):
        for row in range(2):
            corners = [(x, 0.0, z) for x, z in ((-0.58, -0.58), (0.58, -0.58), (0.58, 0.58), (-0.58, 0.58))]
            pane = mesh_object("Pane", corners, [(0, 1, 2, 3)], _material(
                PANES[3 * row + column], walls="thin", thickness=0.006, concentration=1.0))
            pane.location = (1.25 * (column - 1), 0.0, 0.85 + 1.25 * row)
    for x in (-1.875, -0.625, 0.625, 1.875):
        mesh_object("Bar", *box(0.1, 0.15, 2.61), frame).location = (x, 0.0, 1.475)
    for z in (0.225, 1.475, 2.725):
        mesh_object("Bar", *box(3.84, 0.14, 0.1), frame).location = (0.0, 0.0, z)
    add_cove(scene, (0.80, 0.76, 0.70), back=60.0)
    set_sky(scene, (0.10, 0.15, 0.26), (0.50, 0.55, 0.62), (0.05, 0.05, 0.05))
    add_sun_of_solid_angle(scene, 7e-5, 3.2, (0.40, 0.9, 0.66))
    add_camera(scene, (2.6, -10.0, 3.6), (-0.55, -1.2, 0.95), 56.0)
    job.write(job.render(scene, "window"), "clear_window.jpg")
    job.save_scene("clear_window")


def bubbles(job):
    """Soap bubbles: the film model's sheet between air and air."""
    scene = clear_scene(job, 1280, 960, 12, exposure=0.8)
    bubble = _material("soap_bubble")
    for place, size in (((-0.75, 0.0, 1.35), 1.0), ((0.95, 0.5, 1.9), 0.55), ((0.75, -0.7, 0.75), 0.42)):
        ball = turned_object("Bubble", _circle(), bubble, segments=96, points_between=2)
        ball.location, ball.scale = place, (size,) * 3
    add_cove(scene, (0.02, 0.022, 0.028), back=5.0)
    set_sky(scene, (0.7, 0.75, 0.85), (0.45, 0.46, 0.48), (0.05, 0.05, 0.05))
    add_softbox(scene, (-5.0, -3.0, 6.0), (0.0, 0.0, 1.2), (4.0, 4.0), 6.0)
    add_softbox(scene, (5.0, -1.0, 4.0), (0.0, 0.0, 1.2), (1.5, 5.0), 6.0)
    add_softbox(scene, (0.0, 5.0, 7.0), (0.0, 0.0, 1.2), (6.0, 2.5), 5.0)
    add_camera(scene, (0.0, -9.0, 2.0), (0.0, 0.0, 1.35), 85.0)
    job.write(job.render(scene, "bubbles"), "clear_bubbles.jpg")
    job.save_scene("clear_bubbles")


def _circle(points=49):
    angle = np.linspace(-0.5 * np.pi, 0.5 * np.pi, points)
    return np.stack([np.cos(angle), np.sin(angle)], axis=1)


FIGURES = (
    Figure("clear_water", "Water in a glass", 90.0, glass_of_water),
    Figure("clear_brilliant", "A brilliant", 120.0, cut_diamond),
    Figure("clear_bottles", "Bottles", 80.0, bottles),
    Figure("clear_window", "Panes in the sun", 60.0, window),
    Figure("clear_bubbles", "Soap bubbles", 60.0, bubbles),
)
