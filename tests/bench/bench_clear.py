"""What clear materials cost over a Glass BSDF: ratios of medians of one run, the ways taken in turns.

    python -m tests.bench.bench_clear

Prints each figure with its limit; the exit status is 1 where one is exceeded.
"""

import statistics
import sys
import time

import bpy

from addon import api
from addon.bake.clear_absorption import alpha_of, attenuation_of
from addon.bake.reflected import Viewing
from addon.spectra.optical_constants import load
from addon.verify import scenes
from addon.verify.running import _quiet as quiet
from tools.clear_scenes import SCENES
from tools.compare_clear import cycles_scene, dispersive, standard, surface, three_glasses

RUNS, SAMPLES, RESOLUTION = 7, 64, 64
MOST = {"Standard": 1.1, "Dispersive": 1.6}
"""Times a Glass BSDF."""
MOST_FIT = 0.1
"""Seconds of processor for a material's absorption."""


def glass(preset):
    """A Glass BSDF of the same index."""
    n = api.record_of(standard(preset)).parameters.ior
    return surface("Glass", [("ShaderNodeBsdfGlass", {"IOR": n, "Roughness": 0.0})])


WAYS = {"Glass BSDF": glass, "Standard": standard, "Dispersive": dispersive, "three Glass BSDFs": three_glasses}


def times(name):
    """{way: median seconds} of a scene of tools.clear_scenes."""
    found = {way: [] for way in WAYS}
    for run in range(RUNS):
        for way, make in WAYS.items():
            with quiet():
                scene = cycles_scene(name, lambda *_, make=make: make(SCENES[name]().material), RESOLUTION, SAMPLES)
                scene.render.threads = 1
                bpy.context.view_layer.update()
                begun = time.process_time()
                scenes.render(scene, run)
                found[way].append(time.process_time() - begun)
    return {way: statistics.median(seconds) for way, seconds in found.items()}


def main():
    exceeded = []
    for name in ("plate", "ball", "brilliant"):
        found = times(name)
        print(name)
        for way, seconds in found.items():
            ratio = seconds / found["Glass BSDF"]
            print(f"  {way}: {ratio:.2f} (at most {MOST.get(way, float('inf')):g}), {seconds:.2f} s")
            exceeded += [f"{way}, {name}"] * (ratio > MOST.get(way, float("inf")))
    for dataset in ("glass/soda-lime/Rubin-clear", "specs/ISUZU-filter/IVG530", "main/H2O/Segelstein"):
        alpha, spent = alpha_of(load(dataset)), []
        for _ in range(5):
            begun = time.process_time()
            attenuation_of(alpha, Viewing())
            spent.append(time.process_time() - begun)
        print(f"absorption of {dataset}: {statistics.median(spent):.3f} s (at most {MOST_FIT:g})")
        exceeded += [dataset] * (statistics.median(spent) > MOST_FIT)
    print("exceeded: " + ", ".join(exceeded) if exceeded else "all within")
    return bool(exceeded)


if __name__ == "__main__":
    sys.exit(main())
