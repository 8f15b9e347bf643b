"""How far the layered model's Standard is from the formula, as the table of docs/accuracy.md.

    python -m tests.bench.measure_layered_fast

Albedo: tiles at eight angles under a white sky, rms difference over rms.
Picture: a sphere under a sun of 25° at 45°, rms difference over rms of the
pixels; both for red, green and blue.
"""

import math
from importlib.metadata import version

import numpy as np

from tests.render import probes
from tests.render.layered_scenes import (
    TILE_ANGLES,
    Reference,
    furnace_means,
    furnace_tiles,
    material,
    sphere_reference,
    tile_normal,
)

LAYERS = {
    "figure 3's, 92 nm": dict(ior=(1.4, 1.45, 1.6), exponent_r=90.0, exponent_t=170.0, thickness=92.0),
    "figure 5's, 170 nm": dict(ior=(1.5, 1.6, 1.8), exponent_r=130.0, exponent_t=130.0, thickness=170.0),
}
DEVIATIONS = (0.0, 5.0, 10.0, 14.0)
RESOLUTION = 32
SAMPLES = 100
SUN, SUN_HEIGHT = math.radians(25.0), math.radians(45.0)
HEADING = "| layer | deviation | albedo, R G B | picture, R G B |"


def relative_rms(found, expected):
    """Rms difference over rms for each channel, (3,)."""
    return np.sqrt(np.mean((found - expected) ** 2, axis=0) / np.mean(expected ** 2, axis=0))


def albedo_error(parameters):
    """Of the eight tiles."""
    scene = furnace_tiles("fast", parameters, samples=SAMPLES)
    found = furnace_means(probes.render_seeds(scene, 2)).mean(axis=0)
    reference = Reference.of(**parameters)
    return relative_rms(found, np.array([reference.albedo(tile_normal(angle)) for angle in TILE_ANGLES]))


def picture_error(parameters):
    """Of the sphere's pixels."""
    scene = probes.empty_scene(RESOLUTION, samples=SAMPLES)
    probes.add_sphere(material("fast", **parameters))
    towards = probes.add_sun(scene, SUN_HEIGHT, diameter=SUN)
    reference, mask = sphere_reference(Reference.of(**parameters), RESOLUTION, towards, SUN)
    return relative_rms(probes.render(scene)[mask], reference[mask])


def row(layer, deviation):
    """Both errors of one line, (6,)."""
    parameters = dict(LAYERS[layer], deviation=math.radians(deviation), diffuse=0.0)
    return np.concatenate([albedo_error(parameters), picture_error(parameters)])


def line(layer, deviation, errors):
    """The row as the table has it."""
    figures = [f"{error:.1%}" for error in errors]
    return f"| {layer} | {deviation:g}° | {' '.join(figures[:3])} | {' '.join(figures[3:])} |"


def main():
    """Print the table."""
    lines = [f"bpy {version('bpy')}", "", HEADING, "|---|---|---|---|"]
    lines += [line(layer, deviation, row(layer, deviation)) for layer in LAYERS for deviation in DEVIATIONS]
    print("\n".join(lines))


if __name__ == "__main__":
    main()
