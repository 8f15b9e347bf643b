"""Renders a preview of every preset and every node group into addon/thumbnails/, on the oldest Blender supported.

    python tools/render_previews.py [--only NAME …] [--into FOLDER] [--threads N]

See preview_scene.py; groups by themselves. Some fifteen minutes on two cores for all; --only for what has changed.
"""

import argparse
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

import bpy  # noqa: E402

from addon import api  # noqa: E402
from addon.blender.datablocks.groups import all_groups, model_of_group, node_group  # noqa: E402
from addon.catalogue import presets  # noqa: E402
from addon.finishes import of_group  # noqa: E402
from tools import preview_scene  # noqa: E402

__all__ = ["FOLDER", "GROUP", "names"]

FOLDER = ROOT / "addon" / "thumbnails"
QUALITY = 75
GROUP = "group "
"""What the names of groups' previews begin with."""
RAMP = "group fresnel_ramp"
SHOWN_WITH = {"layered_rgb": {"thickness": 200.0}}
"""Parameters of a model whose own defaults show little of what its groups do."""
SHOWN_BY = {"film_anodising": "anodised_titanium", "film_heat_tint": "heat_tinted_steel"}
"""Groups whose output is a number in nm -> the preset that shows what it makes."""


def names():
    """The previews that there are: of every preset, every group of the Add menu but those of OSL, and the ramp."""
    groups = [GROUP + group.identifier for group in all_groups() if group.in_menu and not group.osl]
    return (*presets.names(), *groups, RAMP)


def main(wanted, folder=FOLDER, threads=0):
    """Render each and say how long it took.

    threads  of the processor; 0 for all
    """
    folder.mkdir(exist_ok=True)
    scene, piece = preview_scene.new_scene()
    if threads:
        scene.render.threads_mode, scene.render.threads = "FIXED", threads
    for name in wanted:
        start = time.perf_counter()
        material = _material(name)
        record = None if name.startswith(GROUP) else api.record_of(material)
        with tempfile.TemporaryDirectory() as scratch:
            rendered = Path(scratch) / "preview.png"
            preview_scene.render(scene, piece, material, rendered,
                                 rainbows=record is not None and record.realisation == "dispersive")
            pack(rendered, folder / f"{name}.webp")
        bpy.data.materials.remove(material)
        print(f"{name}: {time.perf_counter() - start:.1f} s", flush=True)


def pack(picture, file):
    """A picture as a WebP file, more patiently than Blender makes it: 3 kB."""
    from PIL import Image
    with Image.open(picture) as opened:
        opened.save(file, "WEBP", quality=QUALITY, method=6)


def _material(name):
    if not name.startswith(GROUP):
        return api.create_material(preset=name)
    if name == RAMP:
        return _emitting(api.create_fresnel_ramp("copper"), "Color")
    identifier = name.removeprefix(GROUP)
    if identifier in SHOWN_BY:
        return api.create_material(preset=SHOWN_BY[identifier])
    model = model_of_group(identifier)
    if model is None:
        return api.create_material(preset="copper", finish=of_group(identifier).name)
    realisation = model.realisation_of(identifier)
    if realisation is None:
        return _emitting(node_group(identifier), "Field")
    return api.create_material(model.name, realisation=realisation[0], **SHOWN_WITH.get(model.name, {}))


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


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--only", nargs="+", metavar="NAME", help="the presets and groups to render (all)")
    parser.add_argument("--into", type=Path, default=FOLDER, help="where the pictures go (addon/thumbnails)")
    parser.add_argument("--threads", type=int, default=0, help="of the processor (all)")
    options = parser.parse_args()
    chosen = options.only or names()
    unknown = [name for name in chosen if name not in names()]
    if unknown:
        parser.error(f"there is no preset or group {', '.join(unknown)}")
    if bpy.app.version[:2] != (4, 5):
        parser.error("render the previews on Blender 4.5, on which the assets are built")
    main(chosen, options.into, options.threads)
