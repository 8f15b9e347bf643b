"""Films: anodised titanium, heat-tinted steel, a soap film in a loop and a bubble, a beetle, a wafer.

    python -m demo_blend.figures show_films
"""

import math

import bpy
import numpy as np
from mathutils import Matrix, Vector

from .interiors import focus, set_room, show_scene
from .job import Figure
from .studio import add_camera, add_cove, add_softbox, matt
from .turned import bent_rod, turned_object

MUG = (
    (0.00, 0.00), (0.46, 0.00), (0.52, 0.015), (0.545, 0.06), (0.55, 0.20), (0.55, 0.98), (0.555, 1.02), (0.575, 1.04),
    (0.58, 1.055), (0.57, 1.065), (0.552, 1.05), (0.54, 1.00), (0.535, 0.20), (0.52, 0.07), (0.45, 0.03), (0.00, 0.03),
)
PIPE = (
    (0.30, 0.00), (0.335, 0.00), (0.34, 0.02), (0.33, 0.04), (0.315, 0.08), (0.315, 0.62), (0.325, 0.64), (0.33, 0.66),
    (0.325, 0.68), (0.315, 0.70), (0.315, 1.30), (0.325, 1.32), (0.33, 1.34), (0.325, 1.36), (0.315, 1.38),
    (0.315, 2.30), (0.30, 2.31), (0.29, 2.30), (0.29, 0.02), (0.30, 0.00),
)
STAND = ((0.00, 0.00), (0.30, 0.00), (0.33, 0.02), (0.33, 0.05), (0.28, 0.08), (0.08, 0.11), (0.05, 0.16), (0.05, 0.22),
         (0.00, 0.23))


LEAN = math.radians(15.0)
"""By which the loop leans back, so that its film mirrors the lamp above the camera."""


def film(preset):
    """A film of the catalogue."""
    from addon import api
    return api.create_material(preset=preset)


def mug(place):
    """A titanium mug with a wire handle, its colours from rim to foot."""
    colours = film("anodised_titanium")
    turned_object("Mug", MUG, colours, points_between=8).location = place
    loop = [(0.51, 0.0, 0.86), (0.58, 0.0, 0.86), (0.76, 0.0, 0.86), (0.90, 0.0, 0.76), (0.92, 0.0, 0.56),
            (0.86, 0.0, 0.36), (0.72, 0.0, 0.26), (0.58, 0.0, 0.25), (0.51, 0.0, 0.25)]
    turn = Matrix.Rotation(-0.9, 3, "Z")
    bent_rod("Handle", [turn @ Vector(point) + Vector(place) for point in loop], 0.028, colours)


def pipe(place):
    """A steel pipe that has been hot at one end, lying on the table."""
    lying = turned_object("Pipe", PIPE, film("heat_tinted_steel"), points_between=6)
    lying.matrix_world = (Matrix.Translation(Vector(place) + Vector((0.0, 0.0, 0.34)))
                          @ Matrix.Rotation(math.radians(24.0), 4, "Z") @ Matrix.Rotation(math.radians(90.0), 4, "Y"))


def soap(place, radius=0.62):
    """A loop of wire on a stand, dipped: the film in it drains and is thinnest on top."""
    from addon import api
    steel = api.create_material(preset="stainless_steel", slopes=[(0.05, 1.0)])
    turned_object("Stand", STAND, steel, segments=96).location = place
    top = Vector(place) + Vector((0.0, 0.0, 0.72 + radius))
    bent_rod("Stem", [Vector(place) + Vector((0.0, 0.0, z)) for z in (0.2, 0.45, 0.72)], 0.022, steel)
    bpy.ops.mesh.primitive_torus_add(major_radius=radius, minor_radius=0.024, major_segments=160, minor_segments=24,
                                     location=top, rotation=(math.radians(90.0) - LEAN, 0.0, 0.0))
    _smoothed(bpy.context.object, steel)
    bpy.ops.mesh.primitive_circle_add(vertices=160, radius=radius, fill_type="NGON", location=(0.0, 0.0, 0.0))
    skin = bpy.context.object
    skin.data.transform(Matrix.Rotation(math.radians(90.0), 4, "X"))  # Generated's Z is then up and down
    skin.location, skin.rotation_euler = top, (-LEAN, 0.0, 0.0)
    skin.data.materials.append(film("draining_soap_film"))


def bubble(place, radius):
    """Half a bubble that sits on the table."""
    bpy.ops.mesh.primitive_uv_sphere_add(segments=192, ring_count=96, radius=radius, location=place)
    _smoothed(bpy.context.object, film("soap_bubble"))


def wafer(place):
    """A silicon wafer with its flat, lying."""
    count = 256
    angles = [a for a in np.linspace(0.0, 2.0 * np.pi, count, endpoint=False) if abs(a - 1.5 * np.pi) > 0.26]
    mesh = bpy.data.meshes.new("Wafer")
    rim = [(0.74 * math.cos(a), 0.74 * math.sin(a)) for a in angles]
    vertices = [(x, y, z) for z in (0.0, 0.018) for x, y in rim]
    n = len(rim)
    mesh.from_pydata(vertices, [], [tuple(range(n, 2 * n)), tuple(range(n))[::-1],
                                    *((j, (j + 1) % n, n + (j + 1) % n, n + j) for j in range(n))])
    mesh.transform(Matrix.Rotation(math.radians(90.0), 4, "X"))  # the wedge of its oxide runs along Z
    mesh.materials.append(film("silicon_nitride_wafer"))
    made = bpy.data.objects.new("Wafer", mesh)
    bpy.context.scene.collection.objects.link(made)
    made.matrix_world = (Matrix.Translation(place) @ Matrix.Rotation(math.radians(-28.0), 4, "Z")
                         @ Matrix.Rotation(math.radians(-90.0), 4, "X"))


def beetle(place, turn):
    """A jewel beetle: wing covers, shield, head, six legs, two feelers."""
    shell = film("jewel_beetle")
    legs = matt("Legs", (0.012, 0.016, 0.010))
    put = Matrix.Translation(place) @ Matrix.Rotation(turn, 4, "Z")
    for side in (-1.0, 1.0):
        cover = _blob("Wing cover", (0.46, 0.205, 0.20), shell, flat_side=side)
        cover.matrix_world = put @ Matrix.Translation((-0.12, side * 0.004, 0.15))
        for x, reach, back in ((0.26, 0.34, 0.20), (0.02, 0.40, -0.02), (-0.18, 0.42, -0.26)):
            bent_rod("Leg", [put @ Vector(point) for point in (
                (x, side * 0.12, 0.12), (x + 0.3 * back, side * (0.18 + 0.4 * reach), 0.20),
                (x + 0.8 * back, side * (0.16 + 0.7 * reach), 0.02), (x + back, side * (0.16 + 0.85 * reach), 0.012))],
                0.011, legs)
        bent_rod("Feeler", [put @ Vector(point) for point in (
            (0.60, side * 0.05, 0.17), (0.72, side * 0.12, 0.22), (0.84, side * 0.22, 0.20))], 0.007, legs)
    _blob("Shield", (0.17, 0.195, 0.15), shell).matrix_world = put @ Matrix.Translation((0.36, 0.0, 0.15))
    _blob("Head", (0.10, 0.115, 0.09), shell).matrix_world = put @ Matrix.Translation((0.53, 0.0, 0.135))


def _blob(name, size, material, flat_side=0.0):
    """An ellipsoid, its lower half flattened; with flat_side only what lies on that side of Y = 0."""
    bpy.ops.mesh.primitive_uv_sphere_add(segments=128, ring_count=64, radius=1.0)
    made = bpy.context.object
    made.name = name
    place = np.empty(3 * len(made.data.vertices))
    made.data.vertices.foreach_get("co", place)
    place = place.reshape(-1, 3)
    if flat_side:
        place[:, 1] = flat_side * np.maximum(flat_side * place[:, 1], 0.0)
    place[:, 2] = np.where(place[:, 2] < 0.0, 0.55 * place[:, 2], place[:, 2])
    made.data.vertices.foreach_set("co", (place * np.array(size)).ravel())
    _smoothed(made, material)
    return made


def _smoothed(made, material):
    made.data.polygons.foreach_set("use_smooth", np.ones(len(made.data.polygons), bool))
    made.data.materials.append(material)


def films(job):
    """All of them on dark paper under large soft lamps, which is what films are seen by."""
    scene = show_scene(job, 18)
    scene.cycles.max_bounces = 12
    scene.cycles.transparent_max_bounces = 16
    set_room(scene, "studio.exr", strength=0.9, turn=0.6)
    add_cove(scene, (0.060, 0.062, 0.068), back=4.0)
    mug((-1.78, 0.3, 0.0))
    pipe((-0.95, 1.5, 0.0))
    soap((0.55, 0.75, 0.0))
    bubble((-0.62, -0.55, 0.0), 0.42)
    wafer((1.66, 0.4, 0.0))
    beetle((0.62, -0.85, 0.0), 2.6)
    add_softbox(scene, (-3.2, 0.6, 5.2), (0.0, 0.2, 0.4), (5.0, 3.6), 5.0)
    add_softbox(scene, (4.4, -2.4, 3.2), (0.3, 0.2, 0.5), (2.2, 3.8), 3.4)
    add_softbox(scene, (0.4, 4.4, 2.8), (0.4, 0.4, 0.8), (6.0, 2.6), 2.0)
    add_softbox(scene, (0.4, -8.0, 6.0), (0.5, 0.5, 1.2), (7.0, 7.0), 3.0)
    add_softbox(scene, (-4.5, -6.0, 1.8), (-1.5, 0.3, 0.5), (3.0, 3.6), 3.0)
    add_softbox(scene, (0.3, 3.2, 5.5), (0.3, 8.0, 1.2), (3.0, 1.0), 4.5, seen=False)
    camera = add_camera(scene, (0.0, -8.2, 3.1), (-0.06, 0.25, 0.72), 61.5)
    focus(camera, (0.3, 0.0, 0.6), 8.0)
    job.write(job.render(scene, "films"), "show_films.jpg")
    job.save_scene("show_films")


FIGURES = (Figure("show_films", "Films: titanium, steel, soap, a beetle, a wafer", 250.0, films),)
