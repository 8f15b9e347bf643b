"""Hold Cycles with our baked metals, and with the ways people have without us, against Mitsuba's spectral spheres.

    python -m tools.compare_renderers

Reads tests/data/mitsuba_spheres.npz (tools/mitsuba_spheres.py renders it) and prints a table of CIEDE2000.
"""

import argparse
import json
from importlib.metadata import version
from pathlib import Path

import bpy
import numpy as np

from addon import api
from addon.bake.colour import delta_e_2000, lab
from addon.bake.reflected import reflect
from addon.blender import compat
from addon.spectra.observers import WAVELENGTH_NM
from addon.verify import scenes
from addon.verify.running import _quiet as quiet

__all__ = ["record", "cycles_sphere", "difference", "WAYS", "LIGHTS", "RIM"]

RECORD = Path(__file__).resolve().parent.parent / "tests" / "data" / "mitsuba_spheres.npz"
LIGHTS = ("sky", "sun")
RIM = 0.2
"""N·V below which pixels are the rim: the two renderers' Smith terms differ there."""

SAMPLES = 256
WAVELENGTHS = (650.0, 550.0, 450.0)

# Linear Rec.709 F0 and F82 tint as Adobe publishes them for its Standard Material, "Metal material references".
PUBLISHED = {
    "silver": ((0.9868, 0.9830, 0.9667), (0.9929, 0.9961, 1.0000)),
    "aluminium": ((0.9157, 0.9226, 0.9236), (0.9090, 0.9365, 0.9596)),
    "gold": ((1.0000, 0.7099, 0.3148), (0.9408, 0.9636, 0.9099)),
    "chromium": ((0.5496, 0.5561, 0.5531), (0.7372, 0.7511, 0.8170)),
    "copper": ((1.0000, 0.6504, 0.5274), (0.9755, 0.9349, 0.9301)),
    "iron": ((0.8951, 0.8755, 0.8154), (0.8551, 0.8800, 0.8966)),
    "magnesium": ((0.8918, 0.8821, 0.8948), (0.8949, 0.9147, 0.9504)),
    "nickel": ((0.7014, 0.6382, 0.5593), (0.8134, 0.8352, 0.8725)),
    "palladium": ((0.7363, 0.7023, 0.6602), (0.8095, 0.8369, 0.8739)),
    "platinum": ((0.9602, 0.9317, 0.8260), (0.9501, 0.9461, 0.9352)),
    "titanium": ((0.4432, 0.3993, 0.3599), (0.8627, 0.9066, 0.9481)),
    "zinc": ((0.8759, 0.8685, 0.8542), (0.8769, 0.9037, 0.9341)),
}


def record():
    """(what the record says of itself, {"metal/light": linear Rec.709})."""
    with np.load(RECORD) as held:
        return json.loads(str(held["about"])), {name: held[name].astype(float) for name in held.files if "/" in name}


def baked(metal, slope):
    """Our material."""
    return api.create_material(preset=metal, slopes=[(slope, 1.0)], specular=1.0)


def published(metal, slope):
    """The Metallic BSDF with published F0 and F82 tint, or None where none are published."""
    if metal not in PUBLISHED:
        return None
    f0, tint = PUBLISHED[metal]
    return _metallic(slope, "F82", {"Base Color": (*f0, 1.0), "Edge Tint": (*tint, 1.0)})


def three_wavelengths(metal, slope):
    """The Metallic BSDF with the same n and k at three wavelengths."""
    mirror = reflect(metal)
    n, k = (tuple(np.interp(WAVELENGTHS, WAVELENGTH_NM, values).tolist()) for values in (mirror.n, mirror.k))
    return _metallic(slope, "PHYSICAL_CONDUCTOR", {"IOR": n, "Extinction": k})


WAYS = {"baked by Facet & Film": baked, "F82, published colours": published,
        "n and k at three wavelengths": three_wavelengths}


def _metallic(slope, fresnel, values):
    material = bpy.data.materials.new("Metallic")
    compat.enable_nodes(material)
    nodes = material.node_tree.nodes
    nodes.clear()
    metallic = nodes.new("ShaderNodeBsdfMetallic")
    metallic.distribution, metallic.fresnel_type = "BECKMANN", fresnel
    metallic.inputs["Roughness"].default_value = slope ** 0.5
    for name, value in values.items():
        metallic.inputs[name].default_value = value
    material.node_tree.links.new(metallic.outputs[0], nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    return material


def cycles_sphere(make_material, light, resolution, sun_angle):
    """The sphere as Cycles renders it, (rows from the bottom, columns, 3); None where there is no such material."""
    scene = scenes.empty_scene(resolution, samples=SAMPLES)
    material = make_material()
    if material is None:
        return None
    scenes.add_sphere(material)
    if light == "sky":
        scenes.set_world(scene, 1.0)
    else:
        scenes.add_sun(scene, sun_angle)
    return scenes.render(scene)


def difference(picture, reference, perfect):
    """(mean, largest) CIEDE2000 over the sphere without its rim, the perfect reflector's brightest pixel as white."""
    normals, mask = scenes.pixel_normals(len(picture), subsamples=3)
    mask &= normals[..., 2].min(axis=2) > RIM
    white = perfect[mask].max()
    found = delta_e_2000(lab(picture[mask] / white), lab(reference[mask] / white))
    return float(found.mean()), float(found.max())


def compare(metals=None):
    """Rows (metal, light, way, mean, largest) of all metals and ways."""
    about, reference = record()
    rows = []
    for metal in metals or about["datasets"]:
        for light in LIGHTS:
            for way, material in WAYS.items():
                picture = cycles_sphere(lambda: material(metal, about["slope"]), light,
                                        len(reference[f"perfect/{light}"]), np.radians(about["sun_angle"]))
                if picture is not None:
                    rows.append((metal, light, way, *difference(picture, reference[f"{metal}/{light}"],
                                                                reference[f"perfect/{light}"])))
    return rows


def table(rows):
    """The rows as Markdown, mean and largest of each way in a column."""
    head = "| metal | light | " + " | ".join(WAYS) + " |"
    lines = [head, "|" + "---|" * (2 + len(WAYS))]
    for metal, light in dict.fromkeys(row[:2] for row in rows):
        cells = []
        for way in WAYS:
            found = [row for row in rows if row[:3] == (metal, light, way)]
            cells.append(f"{found[0][3]:.2f}, {found[0][4]:.2f}" if found else "–")
        lines.append(f"| {metal} | {light} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def main():
    """Render, and print the table."""
    argparse.ArgumentParser(description=__doc__.splitlines()[0]).parse_args()
    with quiet():
        rows = compare()
    print(f"bpy {version('bpy')}; {record()[0]['renderer']}; mean, largest CIEDE2000\n")
    print(table(rows))


if __name__ == "__main__":
    main()
