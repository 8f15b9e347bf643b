"""Three vases: Cook and Torrance's copper of 1982, Granier and Heidrich's layer of 2003, an anodised film of today.

    python -m demo_blend.figures show_vases
"""

import numpy as np

from .interiors import set_room, show_scene
from .job import Figure
from .pictures import labelled, row
from .shapes import rounded_box
from .studio import add_camera, add_cove, add_softbox, matt
from .turned import VASE_PROFILE, turned_object

WIDTH, HEIGHT, GAP = 528, 860, 8
"""Of one panel, in pixels, and between two."""

PANELS = (
    ("1982", "Copper, by Cook and Torrance", "figure_6b", {"scale": "energy"}),
    ("2003", "A layer, by Granier and Heidrich", "figure_2_coloured", {"realisation": "exact"}),
    ("today", "Titania on titanium, the whole spectrum", "anodised_titanium", {}),
)


def vases(job):
    """A panel a vase: one stand, one light."""
    from addon import api
    scene = _stage(job)
    panels = []
    stood = []
    for year, about, preset, given in PANELS:
        vase = turned_object(year, VASE_PROFILE, api.create_material(preset=preset, **given), points_between=10)
        vase.location.z = 0.3
        for other in stood:
            other.hide_render = True
        stood.append(vase)
        panels.append(labelled(job.render(scene, f"vases, {year}"), f"{year}\n{about}", size=round(20 * job.scale)))
    job.write(row(panels, gap=max(1, round(GAP * job.scale))), "show_vases.jpg")
    for place, vase in zip(np.linspace(-2.4, 2.4, len(stood)), stood):
        vase.hide_render, vase.location.x = False, place
    job.save_scene("show_vases")


def _stage(job):
    scene = show_scene(job, 20, size=(WIDTH, HEIGHT), exposure=0.4)
    set_room(scene, "interior.exr", strength=0.3, turn=2.2)
    add_cove(scene, (0.055, 0.060, 0.066), back=3.0)
    rounded_box("Stand", (9.0, 1.7, 0.3), 0.02, matt("Stand", (0.10, 0.10, 0.105))).location = (0.0, 0.0, 0.15)
    add_softbox(scene, (-3.6, -2.4, 4.2), (0.0, 0.0, 1.6), (2.0, 3.4), 6.0)
    add_softbox(scene, (4.0, -1.2, 3.0), (0.0, 0.0, 1.6), (0.8, 4.2), 5.0)
    add_softbox(scene, (0.4, 2.6, 5.2), (0.0, 0.0, 1.8), (3.0, 1.0), 3.0)
    add_softbox(scene, (0.0, 1.6, 5.0), (0.0, 5.0, 2.2), (1.0, 0.5), 9.0, seen=False)
    add_camera(scene, (0.0, -9.6, 2.9), (0.0, 0.0, 1.66), 74.0)
    return scene


FIGURES = (Figure("show_vases", "The papers' vases, and today's", 120.0, vases),)
