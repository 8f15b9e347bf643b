"""The figures of Layered RGB Standard: its nodes, its time over a Principled BSDF's, and how far its rings are off.

    python -m tests.bench.measure_layered_rings

Time: processor seconds of the sphere of tests.bench.bench, one after the other, the median of the ratios.  Rings: a
sphere under a sun of no size; the largest difference from the formula in the mean of any of six rings that exceeds 2 %
of the channel's peak, its brightest pixel; and of those, darker ones too, that exceed 2 % of its brightest ring's.
"""

import math
import statistics
from importlib.metadata import version

import bpy
import numpy as np

from tests.bench.bench import measured, principled
from tests.bench.measure_layered_fast import LAYERS
from tests.render import probes
from tests.render.layered_scenes import Reference, material, ring_means, sphere_reference

PAIRS = 5
TIMED_SAMPLES = 32
RESOLUTION, SAMPLES = 48, 64
SUNS = (0.0, 30.0, 45.0, 60.0, 75.0)
DEVIATIONS = (0.0, 5.0, 10.0, 14.0)
THICKNESSES = (15.0, 70.0, 170.0)
SEEN = 0.02
"""Of a channel's peak, or of its brightest ring: darker rings are not compared."""


def nodes_of(tree):
    """Nodes of a tree and of the groups in it, without frames and the groups' ends."""
    count = 0
    for node in tree.nodes:
        if getattr(node, "node_tree", None):
            count += nodes_of(node.node_tree)
        elif node.bl_idname not in {"NodeFrame", "NodeReroute", "NodeGroupInput", "NodeGroupOutput"}:
            count += 1
    return count


def time_ratio(deviation):
    """Of Standard over the Principled BSDF, for a deviation in degrees."""
    timed = {"thickness": 70.0, "deviation": math.radians(deviation)}
    ratios = []
    for _ in range(PAIRS):
        seconds = [measured(make, TIMED_SAMPLES, 2)[0]
                   for make in (lambda: material("fast", **timed), principled)]
        ratios.append(seconds[0] / seconds[1])
    return statistics.median(ratios)


def largest_of_the_rings(parameters, polar):
    """How far the mean of any ring is off under a sun at this angle from the viewer, in radians.

    Of the rings above SEEN of the channel's brightest pixel, and of those above SEEN of its brightest ring.
    """
    scene = probes.empty_scene(RESOLUTION, samples=SAMPLES)
    probes.add_sphere(material("fast", **parameters))
    towards = probes.add_sun(scene, polar, diameter=0.0)
    reference, mask = sphere_reference(Reference.of(**parameters), RESOLUTION, towards, 0.0, subsamples=8)
    found, expected = ring_means(probes.render(scene), mask), ring_means(reference, mask)
    off = np.abs(found / np.maximum(expected, 1e-9) - 1.0)
    return [off[expected > SEEN * brightest].max() for brightest in (reference[mask].max(axis=0), expected.max(axis=0))]


def row(layer, deviation):
    """Of each sun, the largest of the thicknesses, (suns, 2)."""
    parameters = {**LAYERS[layer], "deviation": math.radians(deviation), "diffuse": 0.0}
    return [np.max([largest_of_the_rings({**parameters, "thickness": thickness}, math.radians(sun))
                    for thickness in THICKNESSES], axis=0) for sun in SUNS]


def main():
    """Print all three."""
    print(f"Blender {bpy.app.version_string}, bpy {version('bpy')}")
    print(f"nodes: {nodes_of(material('fast', thickness=70.0).node_tree)}")
    print(f"time over a Principled BSDF: {time_ratio(0.0):.2f} parallel, {time_ratio(10.0):.2f} deviated by 10°")
    print("| layer | deviation | " + " | ".join(f"sun at {sun:g}°" for sun in SUNS) + " |")
    for layer in LAYERS:
        for deviation in DEVIATIONS:
            figures = " | ".join(f"{above:.0%}, {darker:.0%}" for above, darker in row(layer, deviation))
            print(f"| {layer.partition(',')[0]} | {deviation:g}° | {figures} |", flush=True)


if __name__ == "__main__":
    main()
