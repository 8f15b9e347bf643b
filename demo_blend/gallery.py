"""A shelf of presets to open and look at, and metals beside what three wavelengths make of them."""

import bpy
import numpy as np
from bpy_extras.object_utils import world_to_camera_view
from mathutils import Vector

from .interiors import LEAST_SAMPLES
from .job import Figure
from .pictures import annotated, column, labelled, row, strip
from .shapes import rounded_box
from .studio import add_camera, add_cove, add_softbox, matt, new_scene, set_sky
from .turned import turned_object

SHELF = (
    ("copper", "gold", "silver", "aluminium", "brass", "bronze", "chromium"),
    ("titanium", "tungsten", "zinc", "electrum", "purple_gold", "titanium_nitride", "stainless_steel"),
    ("haematite", "cuprite", "silicon", "obsidian", "vinyl", "rust", "olive_drab"),
    ("nacre", "beetle", "old_bronze", "raku_glaze", "oil_on_water", "pearl_lacquer", "heat_tinted_titanium"),
)
"""From the front row to the last: metals, alloys and compounds, others, layers."""

METALS = ("gold", "bronze", "purple_gold", "titanium_nitride")

FINIAL_PROFILE = (
    (0.00, 0.00), (0.40, 0.00), (0.43, 0.02), (0.43, 0.07), (0.40, 0.10), (0.27, 0.13), (0.20, 0.18), (0.18, 0.24),
    (0.21, 0.29), (0.32, 0.34), (0.44, 0.45), (0.52, 0.60), (0.55, 0.77), (0.53, 0.94), (0.45, 1.10), (0.33, 1.21),
    (0.20, 1.27), (0.12, 1.31), (0.10, 1.34), (0.13, 1.38), (0.14, 1.43), (0.11, 1.48), (0.00, 1.51),
)
"""A finial: a foot with a rim, a ball, a knob; edges, hollows and a broad curve on one object."""

STEP = (1.36, 1.25, 1.62)
"""From one object to the next: along the row, to the row behind, up."""


def _material(name):
    from addon import api
    from addon.catalogue.presets import all_presets
    return api.create_material(preset=name, realisation="fast" if all_presets()[name].measured else "exact")


def three_wavelengths(metal):
    """The metal as it is often made: n and k at 650, 550 and 450 nm taken for red, green and blue."""
    from addon import api
    from addon.bake.paper import SAMPLED_NM
    from addon.catalogue.resolving import resolve
    constants = resolve(metal).constants
    n, k = constants.at(np.array(SAMPLED_NM))
    return api.create_material(preset=metal, name=f"{metal}, three wavelengths", n=tuple(n.tolist()),
                               k=tuple(k.tolist()))


def lit_scene(job, width, height, samples):
    """Two soft lamps, a strip and a sky: what a photographer of metal sets up."""
    scene = new_scene(job.size(width, height), job.samples(samples), denoise=True, noise=0.02)
    add_softbox(scene, (-6.5, -6.0, 6.5), (0.0, 1.0, 1.0), (4.5, 4.5), 1.6)
    add_softbox(scene, (7.0, -3.5, 5.0), (0.0, 1.0, 1.0), (1.2, 5.5), 1.9)
    add_softbox(scene, (0.0, 2.5, 9.0), (0.0, 1.0, 0.0), (9.0, 2.5), 1.1)
    set_sky(scene, (0.34, 0.36, 0.40), (0.20, 0.20, 0.20), (0.06, 0.055, 0.05))
    return scene


def gallery(job):
    """The shelf, with the name of each preset below it."""
    scene = lit_scene(job, 1600, 1240, 12)
    scene.cycles.adaptive_min_samples = LEAST_SAMPLES
    scene.view_settings.view_transform, scene.view_settings.exposure = "Khronos PBR Neutral", 0.9
    add_cove(scene, (0.16, 0.165, 0.175), back=7.0)
    board = matt("Board", (0.075, 0.078, 0.085))
    camera = add_camera(scene, (0.0, -16.5, 6.0), (0.0, 1.2, 3.16), 57.0)
    places = []
    for r, names in enumerate(SHELF):
        y, z = r * STEP[1], r * STEP[2]
        if r:
            tier = rounded_box("Tier", (8.0 * STEP[0], STEP[1] * (len(SHELF) - r) + 0.2, STEP[2]), 0.03, board)
            tier.location = (0.0, y - 0.62 + 0.5 * (STEP[1] * (len(SHELF) - r) + 0.2), z - 0.5 * STEP[2])
        for c, name in enumerate(names):
            finial = turned_object(name, FINIAL_PROFILE, _material(name), segments=128)
            finial.location = (STEP[0] * (c - 0.5 * (len(names) - 1) + (0.25, -0.25)[r % 2]), y, z)
            places.append((name.replace("_", " "), finial.location.copy()))
    bpy.context.view_layer.update()
    labels = [(name, *below(scene, camera, place)) for name, place in places]
    job.write(annotated(job.render(scene, "gallery"), labels, size=19 * job.scale), "gallery.jpg")
    job.save_scene("gallery")


def below(scene, camera, place):
    """Where in the picture a label stands under what stands at this place: its middle, and below its foot."""
    foot = place + Vector((0.0, -0.62, -0.16))
    return world_to_camera_view(scene, camera, place)[0], world_to_camera_view(scene, camera, foot)[1]


def naive(job):
    """Metals baked over the whole spectrum, and below them by three wavelengths."""
    from addon import api
    from addon.bake import ways
    scene = lit_scene(job, 190, 220, 12)
    add_cove(scene, (0.16, 0.165, 0.175))
    add_camera(scene, (0.0, -5.6, 1.9), (0.0, 0.0, 0.76), 85.0)
    finial = turned_object("Finial", FINIAL_PROFILE, matt("none", 0.5))
    above, below = [], []
    for metal in METALS:
        off = {way.name: way for way in ways(metal).ways}["three_wavelengths"].delta_e_2000_max
        for found, material, text in ((above, api.create_material(preset=metal), metal.replace("_", " ")),
                                      (below, three_wavelengths(metal), f"off by {off:.1f}")):
            finial.data.materials[0] = material
            found.append(labelled(job.render(scene, material.name), text, size=max(1, round(14 * job.scale))))
    width, size = row(above).shape[1], max(1, round(15 * job.scale))
    job.write(column([strip("baked from the whole spectrum", width, size), row(above),
                      strip("n and k at 650, 550 and 450 nm; largest CIEDE2000 over angle", width, size), row(below)]),
              "gallery_three_wavelengths.jpg")


FIGURES = (
    Figure("gallery", "28 presets on a shelf", 120.0, gallery),
    Figure("gallery_three_wavelengths", "Metals beside their three-wavelength versions", 70.0, naive),
)
