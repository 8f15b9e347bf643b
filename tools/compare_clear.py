"""Hold Cycles with our clear materials against Mitsuba's pictures, and against what people build by hand.

    python -m tools.compare_clear

Reads tests/data/mitsuba_clear.npz (tools/mitsuba_clear.py renders it) and prints tables: mean CIEDE2000 and noise of
Dispersive, Standard and three Glass BSDFs; water in a glass.
"""

import argparse
import json
from pathlib import Path

import bpy
import mathutils
import numpy as np

from addon import api
from addon.bake.clear_index import index_of
from addon.bake.colour import delta_e_2000, lab
from addon.blender import compat
from addon.catalogue import presets
from addon.reflectance.transmission import cauchy
from addon.verify import scenes
from addon.verify.running import _quiet as quiet

from .clear_scenes import SCENES

__all__ = ["MOST", "MOST_COLUMN", "MOST_NOISE", "WAYS", "bias", "column_error", "cycles_scene", "difference", "noise",
           "record", "surface", "water_in_a_glass"]

RECORD = Path(__file__).resolve().parent.parent / "tests" / "data" / "mitsuba_clear.npz"
BOUNCES = 26
BANDS_NM = (611.0, 549.0, 464.0)
"""For red, green and blue of three Glass BSDFs: the mean wavelengths of the channels."""
MOST = {"plate": 2.5, "prism": 3.0, "ball": 2.0, "brilliant": 1.0}
"""Mean CIEDE2000 of Dispersive."""
MOST_COLUMN, MOST_NOISE = 0.01, 0.6


def record():
    """(what the record says of itself, {scene: linear Rec.709, or grey})."""
    with np.load(RECORD) as held:
        return json.loads(str(held["about"])), {name: held[name].astype(float) for name in held.files
                                                if name != "about"}


def dispersive(preset):
    """Our material with its rainbow."""
    return api.create_material(preset=preset, realisation="dispersive", concentration=0.0)


def standard(preset):
    """Our material of one index."""
    return api.create_material(preset=preset, realisation="fast", concentration=0.0)


def three_glasses(preset):
    """What people build: a red, a green and a blue Glass BSDF, each with its index, added."""
    found = index_of(presets.constants(presets.find(preset)))
    indices = cauchy(np.array(BANDS_NM) / 1e3, found.d, found.b, found.c).tolist()
    return surface("Three Glasses", [("ShaderNodeBsdfGlass", {"Color": [*np.eye(3)[i], 1.0], "IOR": n,
                                                              "Roughness": 0.0}) for i, n in enumerate(indices)])


WAYS = {"Dispersive": dispersive, "Standard": standard, "three Glass BSDFs": three_glasses}


def surface(name, shaders):
    """A material of these closures, added."""
    material = bpy.data.materials.new(name)
    compat.enable_nodes(material)
    tree = material.node_tree
    tree.nodes.clear()
    made = None
    for kind, values in shaders:
        node = tree.nodes.new(kind)
        for socket, value in values.items():
            node.inputs[socket].default_value = value
        if made is not None:
            both = tree.nodes.new("ShaderNodeAddShader")
            tree.links.new(made.outputs[0], both.inputs[0])
            tree.links.new(node.outputs[0], both.inputs[1])
            node = both
        made = node
    tree.links.new(made.outputs[0], tree.nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    return material


def _add(name, corners, faces, material):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(np.array(corners).tolist(), [], [tuple(map(int, face)) for face in faces])
    mesh.materials.append(material)
    bpy.context.scene.collection.objects.link(bpy.data.objects.new(name, mesh))


def cycles_scene(name, material_of, resolution, samples, change=None):
    """The open file as one of SCENES.

    material_of  function(inside, outside) -> material of a body with these media
    change       function of the Scene that gives another, or None
    """
    made = (change or (lambda scene: scene))(SCENES[name]())
    scene = scenes.empty_scene(resolution, samples=samples)
    scene.render.resolution_y = round(resolution * made.height)
    for kind in ("max", "transmission", "glossy"):
        setattr(scene.cycles, f"{kind}_bounces", BOUNCES)
    scene.cycles.transparent_max_bounces = scene.cycles.min_light_bounces = BOUNCES
    scenes.set_world(scene, made.sky)
    _aim(scene.camera, made)
    for body in made.bodies:
        _add("Body", body.corners, body.faces, material_of(body.inside, body.outside))
    for lamp in made.lamps:
        light = surface("Lamp", [("ShaderNodeEmission", {"Strength": lamp.radiance})])
        _add("Lamp", lamp.corners, [(0, 1, 2, 3)], light)
    return scene


def _aim(camera, made):
    """Put the camera where a Scene has it; a horizontal picture angle is what Blender's is."""
    eye, target, up = (mathutils.Vector(v) for v in (made.eye, made.target, made.up))
    back = (eye - target).normalized()
    right = up.cross(back).normalized()
    axes = mathutils.Matrix((right, back.cross(right), back)).transposed()
    camera.matrix_world = mathutils.Matrix.Translation(eye) @ axes.to_4x4()
    camera.data.type = "PERSP"
    camera.data.sensor_fit = "HORIZONTAL"
    camera.data.angle = np.radians(made.fov)
    camera.data.clip_start = 1e-3


def difference(pictures, reference, block=1):
    """Mean CIEDE2000 of the mean of pictures ``(K, H, W, 3)`` from a reference, both cut off at 1.

    block  side of the squares of pixels whose means are compared: few samples have much noise
    """
    found, expected = (_blocks(np.clip(x, 0.0, 1.0), block) for x in (np.mean(pictures, axis=0), reference))
    return float(delta_e_2000(lab(found), lab(expected)).mean())


def _blocks(picture, block):
    rows, columns = (side // block for side in picture.shape[:2])
    return picture.reshape(rows, block, columns, block, 3).mean(axis=(1, 3))


def bias(pictures, reference):
    """Rms difference of two pictures from a reference, both cut off at 1, without their noise: from the product."""
    first, second = np.clip(pictures, 0.0, 1.0) - np.clip(reference, 0.0, 1.0)
    return float(np.sqrt(max((first * second).mean(), 0.0)))


def noise(pictures):
    """Rms of a pixel between two pictures of other seeds, cut off at 1."""
    first, second = np.clip(pictures, 0.0, 1.0)
    return float(np.sqrt(((first - second) ** 2).mean() / 2.0))


def water_in_a_glass(resolution, samples):
    """Grey picture of the common face as one, its index that of water over that of glass."""
    from .mitsuba_clear import N_D_OF_WATER
    glass = {"preset": "window_glass", "realisation": "fast", "concentration": 0.0}
    ior = api.create_material(**glass)
    n = api.record_of(ior).parameters.ior
    scene = cycles_scene("water in a glass", lambda inside, _: api.create_material(**glass) if inside == "body" else
                         api.create_material(preset="water", concentration=0.0, ior=N_D_OF_WATER, outside=n),
                         resolution, samples)
    return scenes.render(scene, 1).mean(axis=2)


def column_error(picture, reference):
    """Largest difference of a column's mean."""
    return float(np.abs((picture - reference).mean(axis=0)).max())


def main():
    """Render, and print the tables."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--samples", type=int, default=4096)
    samples = parser.parse_args().samples
    _, reference = record()
    print("| scene | way | mean CIEDE2000 | rms difference | noise at 256 samples |\n|---|---|---|---|---|")
    for name in MOST:
        preset = SCENES[name]().material
        for way, make in WAYS.items():
            with quiet():
                scene = cycles_scene(name, lambda *_, make=make: make(preset), len(reference[name]), samples)
                pictures = scenes.render_seeds(scene, 2)
                scene.cycles.samples = 256
                noisy = noise(scenes.render_seeds(scene, 2, 7))
            print(f"| {name} | {way} | {difference(pictures, reference[name]):.2f} | "
                  f"{bias(pictures, reference[name]):.3f} | {noisy:.4f} |", flush=True)
    with quiet():
        picture = water_in_a_glass(reference["water in a glass"].shape[1], samples)
    print(f"water in a glass: largest column error {column_error(picture, reference['water in a glass']):.4f}")


if __name__ == "__main__":
    main()
