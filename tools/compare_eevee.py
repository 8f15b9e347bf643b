"""Hold EEVEE with the Standard materials against Cycles: the same spheres, their colours and a picture side by side.

    blender --python tools/compare_eevee.py -- out

EEVEE needs a window or a driver that renders without one; software OpenGL does, and takes a minute to compile.
"""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

import bpy  # noqa: E402
import numpy as np  # noqa: E402

from addon import api  # noqa: E402
from addon.bake.srgb import bytes_of  # noqa: E402
from addon.blender import compat  # noqa: E402
from addon.verify import layered_rgb_scenes as layered_scenes  # noqa: E402
from addon.verify import scenes  # noqa: E402
from tools.png_file import png_bytes  # noqa: E402

__all__ = ["SPHERES", "pair"]

FIGURE_3 = dict(ior=(1.4, 1.45, 1.6), exponent_r=90.0, exponent_t=170.0, thickness=70.0, diffuse=0.7)
FIGURE_5 = dict(ior=(1.5, 1.6, 1.8), exponent_r=130.0, exponent_t=130.0, thickness=90.0, diffuse=0.5)
SPHERES = {
    "Cook-Torrance, copper, m 0.3": lambda: api.create_material("cook_torrance", preset="copper", slopes=[(0.3, 1.0)]),
    "layered, figure 3, parallel": lambda: layered_scenes.material("fast", **FIGURE_3),
    "layered, figure 3, 10°": lambda: layered_scenes.material("fast", **FIGURE_3, deviation=np.radians(10.0)),
    "layered, figure 5, 14°": lambda: layered_scenes.material("fast", **FIGURE_5, deviation=np.radians(14.0)),
}
RESOLUTION = 144
SAMPLES = {"CYCLES": 256, "EEVEE": 64}
SUN, SUN_DIAMETER, SKY = np.radians(45.0), np.radians(10.0), 0.25
WHITE = 1.6
"""Radiance that the picture shows as white."""
LOST_BITS = 1
"""Of eight a channel: no eye sees it, and the file shrinks by a quarter."""


def pair(make):
    """The sphere of a material by Cycles and by EEVEE, each ``(rows from the bottom, columns, 3)``."""
    scene = scenes.empty_scene(RESOLUTION, samples=SAMPLES["CYCLES"])
    scenes.add_sphere(make())
    scenes.add_sun(scene, SUN, strength=np.pi, diameter=SUN_DIAMETER)
    scenes.set_world(scene, SKY)
    by_cycles = scenes.render(scene)
    scene.render.engine = compat.eevee_engine()
    scene.eevee.taa_render_samples = SAMPLES["EEVEE"]
    return by_cycles, scenes.render(scene)


def row(name, by_cycles, by_eevee, mask):
    """A line of the table: mean colours, and the largest difference of a ring's mean in a channel."""
    colours = " | ".join(" ".join(f"{value:.3f}" for value in picture[mask].mean(axis=0))
                         for picture in (by_cycles, by_eevee))
    rings = [layered_scenes.ring_means(picture, mask) for picture in (by_cycles, by_eevee)]
    return f"| {name} | {colours} | {np.abs(rings[1] / rings[0] - 1.0).max():.0%} |"


def shown(picture, mask):
    """As sRGB, 8 bits, top row first, nothing where there is no sphere."""
    return (bytes_of(picture / WHITE * mask[..., None]) >> LOST_BITS << LOST_BITS)[::-1]


def main(folder):
    """Render all spheres; write the picture, print the table."""
    _, mask = scenes.pixel_normals(RESOLUTION)
    columns, lines = [], []
    for name, make in SPHERES.items():
        by_cycles, by_eevee = pair(make)
        lines.append(row(name, by_cycles, by_eevee, mask))
        columns.append(np.concatenate([shown(by_cycles, mask), shown(by_eevee, mask)]))
        print(lines[-1], flush=True)
    pixels = np.concatenate(columns, axis=1)
    opaque = np.full((*pixels.shape[:2], 1), 255, np.uint8)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "eevee.png").write_bytes(png_bytes(np.concatenate([pixels, opaque], axis=-1)))
    (folder / "eevee.txt").write_text("\n".join([bpy.app.version_string, *lines, ""]), encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[sys.argv.index("--") + 1] if "--" in sys.argv else "out"))
    bpy.ops.wm.quit_blender()
