"""The same materials by Standard, Reference and OSL, and by two Blenders, with the difference pictures and figures.

Nothing here is denoised: the differences would be the denoiser's.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from addon.bake.srgb import bytes_of

from .job import Figure
from .pictures import column, labelled, row, strip

MATERIALS = (("copper of figure 6b", "cook_torrance", {"preset": "figure_6b"}),
             ("layers of figure 5, 92 nm", "layered_rgb", {"preset": "figure_5_79_106_nm", "thickness": 92.0}))
REALISATIONS = (("fast", "Standard"), ("exact", "Reference"), ("osl", "OSL"))
BRIGHTER = 5.0
"""Differences are shown this many times as large, about a middle grey."""


def sphere_scene(job, side, samples):
    """A ball under a soft lamp and a sky, without adaptive sampling."""
    import bpy

    from .studio import add_camera, add_softbox, new_scene, set_sky
    scene = new_scene(job.size(side, side), job.samples(samples))
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.seed = 1
    bpy.ops.mesh.primitive_uv_sphere_add(segments=128, ring_count=64, radius=1.0)
    bpy.ops.object.shade_smooth()
    add_softbox(scene, (-3.5, -4.0, 4.0), (0.0, 0.0, 0.0), 4.0, 1.5)
    set_sky(scene, 0.35, 0.2, 0.06)
    add_camera(scene, (0.0, -6.6, 0.0), (0.0, 0.0, 0.0), 100.0)
    return scene, bpy.context.object


def rendered(job, model, options, realisation, title, side=150, samples=640):
    """The ball of this material, scene-linear."""
    from addon import api
    scene, ball = sphere_scene(job, side, samples)
    scene.cycles.shading_system = realisation.startswith("osl")
    ball.data.materials.append(api.create_material(model, realisation=realisation, **options))
    return job.render_linear(scene, title)


def compared(reference, other):
    """The difference as a picture about middle grey, and its figures in words."""
    difference = other - reference
    scale = np.sqrt(np.mean(reference ** 2))
    rms = np.sqrt(np.mean(difference ** 2)) / scale
    mean = np.mean(difference) / np.mean(reference)
    return bytes_of(0.2 + BRIGHTER * difference), f"rms {100 * rms:.2f} %\nmean {100 * mean:+.2f} %"


def realisations(job):
    """Each material by each realisation, and what Standard and Reference differ from OSL by."""
    size = max(1, round(14 * job.scale))
    rows = []
    for title, model, options in MATERIALS:
        found = {name: rendered(job, model, options, name, f"{title}, {shown}") for name, shown in REALISATIONS}
        pictures = [labelled(bytes_of(found[name]), shown, size=size) for name, shown in REALISATIONS]
        for name, shown in REALISATIONS[:2]:
            difference, words = compared(found["osl"], found[name])
            pictures.append(labelled(difference, f"{BRIGHTER:g} × ({shown} − OSL)\n{words}", size=size))
        whole = row(pictures)
        rows += [strip(title, whole.shape[1], size=size), whole]
    job.write(column(rows), "side_by_side_realisations.jpg")


def versions(job):
    """Each material by Reference in this Blender and in the other."""
    if not job.other:
        raise RuntimeError("needs a second Blender: --other PYTHON, which make figures sets up where its Python is "
                           "there")
    import bpy
    here, size, rows = _in_this_blender(job), max(1, round(14 * job.scale)), []
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "balls.npz"
        subprocess.run([job.other, "-m", "demo_blend.side_by_side", str(path), str(job.scale)], check=True,
                       stdout=subprocess.DEVNULL)
        with np.load(path) as balls:
            there = dict(balls)
    this, other = bpy.app.version_string.split()[0], str(there["version"])
    for title, *_ in MATERIALS:
        difference, words = compared(there[title], here[title])
        whole = row([labelled(bytes_of(here[title]), f"Blender {this}", size=size),
                     labelled(bytes_of(there[title]), f"Blender {other}", size=size),
                     labelled(difference, f"{BRIGHTER:g} × difference\n{words}", size=size)])
        rows += [strip(title, whole.shape[1], size=size), whole]
    job.write(column(rows), "side_by_side_versions.jpg")


def _in_this_blender(job):
    return {title: rendered(job, model, options, "exact", f"{title}, Reference")
            for title, model, options in MATERIALS}


FIGURES = (
    Figure("side_by_side_realisations", "Standard, Reference and OSL side by side", 450.0, realisations),
    Figure("side_by_side_versions", "Two Blenders side by side", 230.0, versions),
)


def main(path, scale):
    """The balls in this Blender, written as .npz for the other one."""
    import bpy

    from .job import Job
    job = Job(Path(path).parent, Path(path).parent, float(scale))
    np.savez(path, version=bpy.app.version_string.split()[0], **_in_this_blender(job))


if __name__ == "__main__":
    main(*sys.argv[1:])
