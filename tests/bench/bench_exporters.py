"""What the stand-in for exporters costs a render: ratios of medians, with and without in turns, and every pixel equal.

    python -m tests.bench.bench_exporters

Prints each ratio with its limit; the exit status is 1 where one is exceeded, or a pixel differs.
"""

import statistics
import sys
import time

import bpy
import numpy as np

from addon import api
from addon.blender.datablocks.materials import remove_standin
from addon.verify.running import _quiet as quiet
from tests.render import probes

RUNS, SAMPLES, RESOLUTION = 15, 1024, 24
MOST = 1.01
PRESETS = ("copper", "anodised_titanium", "green_glass", "nacre")


def seconds():
    """Processor seconds of a render, and its pixels."""
    start = time.process_time()
    pixels = probes.render(bpy.context.scene)
    return time.process_time() - start, pixels


def measured(preset):
    """(ratio of medians, whether every pixel is equal) of a material with its stand-in to without."""
    probes.set_world(probes.empty_scene(RESOLUTION, samples=SAMPLES), 1.0)
    bpy.context.scene.render.threads_mode, bpy.context.scene.render.threads = "FIXED", 1
    material = api.create_material(preset=preset)
    probes.add_sphere(material, segments=64)
    seconds()
    times, pictures = {"with": [], "without": []}, {}
    for turn in range(2 * RUNS):
        way = ("with", "without")[(turn + turn // 2) % 2]
        api.ready_for_export([material])
        if way == "without":  # both ways the nodes have just changed
            remove_standin(material)
        took, pictures[way] = seconds()
        times[way].append(took)
    ratio = statistics.median(times["with"]) / statistics.median(times["without"])
    return ratio, np.array_equal(pictures["with"], pictures["without"])


def main():
    """Print them all."""
    worst = 0.0
    for preset in PRESETS:
        with quiet():
            ratio, equal = measured(preset)
        print(f"{preset:20} {ratio:.4f} times (at most {MOST}), pixels {'equal' if equal else 'DIFFER'}")
        worst = max(worst, ratio if equal else np.inf)
    return int(worst > MOST)


if __name__ == "__main__":
    sys.exit(main())
