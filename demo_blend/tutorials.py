"""What the tutorials end with: each picture is of the very snippet that its document shows."""

import re
from pathlib import Path

import bpy

from .job import Figure
from .studio import add_camera, add_cove, add_softbox, new_scene, set_sky

__all__ = ["FIGURES", "snippets"]

INSTALLED = "bl_ext.user_default.facet_film.addon"
"""What the extension is called where it is installed, and in the tutorials."""
DOCUMENTS = Path(__file__).resolve().parent.parent / "docs"


def snippets(document):
    """The Python snippets of a document, in order, as they run in a checkout."""
    text = (DOCUMENTS / document).read_text(encoding="utf-8").replace(INSTALLED, "addon")
    return re.findall(r"```python\n(.*?)```", text, re.S)


def made(job, document, *, samples, bounces=8):
    """A scene in which what the document's snippets make stands in soft light."""
    scene = new_scene(job.size(900, 600), job.samples(samples), look="Khronos PBR Neutral", denoise=True, noise=0.02)
    cycles = scene.cycles
    cycles.max_bounces = cycles.transmission_bounces = cycles.glossy_bounces = bounces
    cycles.transparent_max_bounces = 16
    cycles.caustics_reflective = cycles.caustics_refractive = False
    for snippet in snippets(document):
        exec(snippet, {})
    return scene


def brushed_copper(job):
    """A rounded cube on a grey floor: a broad window at the left, a strip at the right, light from behind."""
    scene = made(job, "brushed_copper.md", samples=64)
    cube = bpy.data.objects["Cube"]
    cube.location, cube.rotation_euler = (0.0, 0.0, 1.0), (0.0, 0.0, 0.6)
    add_cove(scene, (0.20, 0.205, 0.215), back=7.0)
    add_softbox(scene, (-5.0, -4.0, 4.0), (0.0, 0.0, 1.0), (3.5, 4.5), 3.6)
    add_softbox(scene, (6.0, -3.0, 2.4), (0.0, 0.0, 1.0), (1.6, 5.0), 4.4)
    add_softbox(scene, (0.5, 3.0, 7.0), (0.0, 0.0, 1.0), (7.0, 3.5), 3.2)
    set_sky(scene, (0.55, 0.56, 0.58), (0.24, 0.24, 0.25), (0.05, 0.05, 0.05))
    add_camera(scene, (0.0, -10.5, 4.2), (0.0, 0.0, 0.97), 80.0)
    job.write(job.render(scene, "brushed copper"), "tutorials_brushed_copper.jpg")
    job.save_scene("tutorials_brushed_copper")


def anodised_ring(job):
    """The ring stands, and its rainbow runs from top to bottom."""
    scene = made(job, "anodised_ring.md", samples=64)
    ring = bpy.data.objects["Torus"]
    ring.location, ring.rotation_euler = (0.0, 0.0, 1.25), (0.0, 0.0, 0.45)
    add_cove(scene, (0.24, 0.245, 0.255), back=7.0)
    add_softbox(scene, (-5.5, -3.5, 5.0), (0.0, 0.0, 1.2), (4.0, 5.0), 5.5)
    add_softbox(scene, (6.0, -3.0, 2.4), (0.0, 0.0, 1.2), (1.6, 5.0), 5.5)
    add_softbox(scene, (0.0, 2.5, 7.0), (0.0, 0.0, 1.2), (7.0, 4.0), 5.0)
    set_sky(scene, (0.85, 0.86, 0.88), (0.50, 0.50, 0.51), (0.10, 0.10, 0.10))
    add_camera(scene, (0.0, -11.5, 2.6), (0.0, 0.0, 1.24), 90.0)
    job.write(job.render(scene, "anodised ring"), "tutorials_anodised_ring.jpg")
    job.save_scene("tutorials_anodised_ring")


def glass_of_water(job):
    """Before a bright wall, whose edges the glass bends to dark rims."""
    scene = made(job, "glass_of_water.md", samples=96, bounces=24)
    add_cove(scene, (0.68, 0.71, 0.74), back=5.0)
    add_softbox(scene, (-4.0, 3.0, 4.5), (0.0, 5.0, 1.5), (3.0, 3.0), 6.0)
    add_softbox(scene, (-5.0, -1.0, 3.5), (0.0, 0.0, 1.0), (1.5, 4.0), 3.0)
    add_softbox(scene, (4.5, -2.0, 3.0), (0.0, 0.0, 1.0), (0.4, 4.0), 5.0)
    set_sky(scene, (0.50, 0.52, 0.55), (0.28, 0.29, 0.31), (0.03, 0.03, 0.03))
    add_camera(scene, (0.0, -9.6, 2.7), (0.0, 0.0, 1.05), 85.0)
    job.write(job.render(scene, "glass of water"), "tutorials_glass_of_water.jpg")
    job.save_scene("tutorials_glass_of_water")


FIGURES = (
    Figure("tutorials_brushed_copper", "The tutorial's brushed copper", 60.0, brushed_copper),
    Figure("tutorials_anodised_ring", "The tutorial's anodised ring", 60.0, anodised_ring),
    Figure("tutorials_glass_of_water", "The tutorial's glass of water", 120.0, glass_of_water),
)
