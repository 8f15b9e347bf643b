"""What it costs a material by OSL that its group holds another realisation: python -m tests.bench.measure_without_osl

Processor time of a sample, and of what comes before the first, over those of the same group without the other
realisation: medians of one run, the two rendered in turn.
"""

import argparse
import statistics
import time

import bpy
import numpy as np

from addon import api, models
from addon.blender.datablocks import materials
from addon.models.realisations import REALISATIONS
from addon.verify import scenes
from addon.verify.running import _quiet as quiet

RESOLUTION, SAMPLES, PICTURES = 48, 128, 5


def script_alone(material):
    """Take the other realisation out of the material's group."""
    tree = materials.our_node(material).node_tree
    script = next(node for node in tree.nodes if node.bl_idname == "ShaderNodeScript")
    output = next(node for node in tree.nodes if node.bl_idname == "NodeGroupOutput")
    tree.links.new(script.outputs["BSDF"], output.inputs[0])


def seconds(model, realisation, change):
    """(median of a picture, the first one's above it)."""
    scene = scenes.empty_scene(RESOLUTION, samples=SAMPLES, osl=True)
    material = api.create_material(model, realisation=realisation)
    change(material)
    scenes.add_sphere(material, 64)
    scenes.set_world(scene, 0.3)
    scenes.add_sun(scene, 0.7, diameter=np.radians(5.0))
    found = []
    for seed in range(PICTURES + 1):
        start = time.process_time()
        scenes.render(scene, seed)
        found.append(time.process_time() - start)
    median = statistics.median(found[1:])
    return median, found[0] - median


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=4)
    rounds = parser.parse_args().rounds
    print(f"Blender {bpy.app.version_string}")
    for model in models.all_models():
        for realisation in (name for name in model.realisations if REALISATIONS[name].osl):
            both = [], []
            for _ in range(rounds):
                for found, change in zip(both, (lambda material: None, script_alone)):
                    with quiet():
                        found.append(seconds(model.name, realisation, change))
            (time_both, first_both), (time_alone, first_alone) = (np.median(found, axis=0) for found in both)
            print(f"{model.name:14} {realisation:9} {time_both / time_alone:.3f} times the time of a sample, "
                  f"{1e3 * (first_both - first_alone):+.0f} ms before the first", flush=True)


if __name__ == "__main__":
    main()
