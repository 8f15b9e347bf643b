"""Renders a preview of every preset and every node group into addon/thumbnails/, on the oldest Blender supported.

    python tools/render_previews.py [--only NAME …]

A ball in neutral light, by the realisation Fast; groups by themselves. Some five
minutes on two cores for all; --only for what has changed.
"""

import argparse
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

import bpy  # noqa: E402

from addon import api  # noqa: E402
from addon.blender.groups import node_group  # noqa: E402
from addon.layered_presets import PRESETS  # noqa: E402
from addon.spectra import presets  # noqa: E402
from tools import preview_scene  # noqa: E402
from tools.png_file import png_bytes  # noqa: E402

__all__ = ["FOLDER", "GROUP_PREVIEWS", "NAMES"]

FOLDER = ROOT / "addon" / "thumbnails"
GROUP_PREVIEWS = {
    "group cook_torrance_fast": lambda: _own("cook_torrance", "fast"),
    "group cook_torrance_fast_f82": lambda: _own("cook_torrance", "fast", preset="sapphire"),
    "group cook_torrance_exact": lambda: _own("cook_torrance", "exact"),
    "group layered_rgb_fast": lambda: _own("layered_rgb", "fast", thickness=200.0),
    "group layered_rgb_exact": lambda: _own("layered_rgb", "exact", thickness=200.0),
    "group layer_thickness": lambda: _emitting(node_group("layer_thickness"), "Field"),
    "group fresnel_ramp": lambda: _emitting(api.create_fresnel_ramp("copper"), "Color"),
}
"""Preview -> the material that shows what the group does with its own defaults."""

NAMES = (*presets.names(), *PRESETS, *GROUP_PREVIEWS)
LOST_BITS = 1
"""Of eight a channel: no eye sees it, and the files shrink by a quarter."""


def main(names):
    """Render each and say how long it took."""
    FOLDER.mkdir(exist_ok=True)
    scene, ball = preview_scene.new_scene()
    with tempfile.TemporaryDirectory() as scratch:
        rendered = Path(scratch) / "preview.png"
        for name in names:
            start = time.perf_counter()
            material = _material(name)
            preview_scene.render(scene, ball, material, rendered)
            bpy.data.materials.remove(material)
            (FOLDER / f"{name}.png").write_bytes(png_bytes(_coarser(_pixels(rendered))))
            print(f"{name}: {time.perf_counter() - start:.1f} s", flush=True)


def _material(name):
    if name in GROUP_PREVIEWS:
        return GROUP_PREVIEWS[name]()
    return api.create_material("layered_rgb" if name in PRESETS else "cook_torrance", preset=name)


def _own(model, realisation, preset=None, **parameters):
    return api.create_material(model, realisation=realisation, preset=preset, **parameters)


def _emitting(group, output):
    """A material that shows one output of a group as it is."""
    material = bpy.data.materials.new(group.name)
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    node = tree.nodes.new("ShaderNodeGroup")
    node.node_tree = group
    emission = tree.nodes.new("ShaderNodeEmission")
    surface = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(node.outputs[output], emission.inputs["Color"])
    tree.links.new(emission.outputs[0], surface.inputs["Surface"])
    return material


def _pixels(path):
    """A PNG's pixels, 8 bits RGBA, top row first."""
    image = bpy.data.images.load(str(path))
    width, height = image.size
    pixels = np.empty(width * height * 4, np.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return np.round(pixels * 255.0).astype(np.uint8).reshape(height, width, 4)[::-1]


def _coarser(pixels):
    """Without the lowest bits of each colour; nothing where nothing is seen."""
    colour = pixels[..., :3] >> LOST_BITS << LOST_BITS
    colour = colour | colour >> 8 - LOST_BITS  # white stays white
    return np.concatenate([np.where(pixels[..., 3:] > 0, colour, 0), pixels[..., 3:]], axis=-1)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--only", nargs="+", metavar="NAME", help="the presets and groups to render (all)")
    chosen = parser.parse_args().only or NAMES
    unknown = [name for name in chosen if name not in NAMES]
    if unknown:
        parser.error(f"there is no preset or group {', '.join(unknown)}")
    if bpy.app.version[:2] != (4, 5):
        parser.error("render the previews on Blender 4.5, on which the assets are built")
    main(chosen)
