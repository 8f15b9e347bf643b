"""What the layered RGB realisations cost and how noisy they are: python -m tests.bench.bench_layered

Ratios within one run on this machine: time per sample of each realisation over
Standard's, noise at equal time under an environment, and the noise of the default
width over that of width 0 under a sun of 5°.
"""

import math
import time

import numpy as np

from tests.render import probes
from tests.render.layered_scenes import material

RESOLUTION = 96
SAMPLES = 64
SEEDS = 6
MATERIAL = dict(thickness=92.0, deviation=math.radians(10.0), diffuse=0.5)
RUNS = {
    "fast": ("fast", {}),
    "exact, width 0": ("exact", {"sampling_width": 0.0}),
    "exact, default width": ("exact", {}),
    "osl_fast": ("osl_fast", {}),
    "osl, default width": ("osl", {}),
}


def environment(scene):
    """A sky that brightens from one side to the other, so that directions matter."""
    background = probes.set_world(scene, 1.0)
    tree = scene.world.node_tree
    coordinates = tree.nodes.new("ShaderNodeTexCoord")
    separate = tree.nodes.new("ShaderNodeSeparateXYZ")
    power = tree.nodes.new("ShaderNodeMath")
    power.operation = "POWER"
    shift = tree.nodes.new("ShaderNodeMath")
    shift.inputs[1].default_value = 1.0
    power.inputs[1].default_value = 3.0
    tree.links.new(coordinates.outputs["Generated"], separate.inputs[0])
    tree.links.new(separate.outputs[0], shift.inputs[0])
    tree.links.new(shift.outputs[0], power.inputs[0])
    tree.links.new(power.outputs[0], background.inputs["Strength"])


def measured(realisation, parameters, light):
    """Seconds a picture, and the noise of one sample: rms of the pixels' standard deviation over the mean."""
    scene = probes.empty_scene(RESOLUTION, samples=SAMPLES, osl=realisation.startswith("osl"), extent=2.0)
    probes.add_sphere(material(realisation, **MATERIAL, **parameters))
    light(scene)
    probes.render(scene)  # compiles, builds the BVH
    start = time.perf_counter()
    pictures = probes.render_seeds(scene, SEEDS)
    seconds = (time.perf_counter() - start) / SEEDS
    _, mask = probes.pixel_normals(RESOLUTION)
    inside = pictures[:, mask]
    noise = np.sqrt(np.mean(inside.var(axis=0, ddof=1))) / inside.mean() * math.sqrt(SAMPLES)
    return seconds, noise


def sun(scene):
    probes.add_sun(scene, math.radians(40.0), diameter=math.radians(5.0))


def main():
    under_sky = {name: measured(*run, environment) for name, run in RUNS.items()}
    under_sun = {name: measured(*run, sun) for name, run in RUNS.items() if name.startswith("exact")}
    fast_seconds, fast_noise = under_sky["fast"]
    print(f"{'':24}{'time / fast':>12}{'noise / fast':>14}{'at equal time':>15}")
    for name, (seconds, noise) in under_sky.items():
        time_ratio, noise_ratio = seconds / fast_seconds, noise / fast_noise
        print(f"{name:24}{time_ratio:12.2f}{noise_ratio:14.2f}{noise_ratio * math.sqrt(time_ratio):15.2f}")
    ratio = under_sun["exact, default width"][1] / under_sun["exact, width 0"][1]
    print(f"sun of 5°: noise of the default width over width 0: {ratio:.2f}")


if __name__ == "__main__":
    main()
