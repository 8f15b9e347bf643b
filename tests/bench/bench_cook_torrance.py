"""What the Cook-Torrance realisations cost and how noisy they are: python -m tests.bench.bench_cook_torrance

Ratios of medians within one run on this machine, in processor time: a sample of each
realisation over one of Standard, Standard over Metallic BSDFs wired by hand, noise at
equal time under an environment picture, and the noise of the default width
over that of width 0 under a sun of 5°.
"""

import argparse
import time

import bpy
import numpy as np

from addon import api
from addon.blender import compat
from tests.render import cook_torrance_scenes as scenes
from tests.render import probes

RESOLUTION = 96
SAMPLES = 64
SLOPES = {
    "m 0.2": ((0.2, 1.0),),
    "m 0.4": ((0.4, 1.0),),
    "m 0.6": ((0.6, 1.0),),
    "figure 6b": scenes.FIGURE_6B,
}
RUNS = {
    "fast": ("fast", {}),
    "exact, width 0": ("exact", {"sampling_width": 0.0}),
    "exact, default width": ("exact", {}),
    "osl_fast": ("osl_fast", {}),
    "osl, width 0": ("osl", {"sampling_width": 0.0}),
    "osl, default width": ("osl", {}),
}


def sun(scene):
    """5° of sun from half-way up."""
    probes.add_sun(scene, np.radians(45.0), diameter=np.radians(5.0))


LIGHTS = {"environment": scenes.add_sky, "sun of 5°": sun}


def by_hand(slopes):
    """Metallic BSDFs of these slopes mixed by weight, as a user would wire them."""
    material = bpy.data.materials.new("By hand")
    compat.enable_nodes(material)
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    total, passed = None, 0.0
    for m, w in slopes:
        metallic = nodes.new("ShaderNodeBsdfMetallic")
        metallic.distribution, metallic.fresnel_type = "BECKMANN", "PHYSICAL_CONDUCTOR"
        metallic.inputs["Roughness"].default_value = m ** 0.5
        metallic.inputs["IOR"].default_value = scenes.COPPER["n"]
        metallic.inputs["Extinction"].default_value = scenes.COPPER["k"]
        passed += w
        if total is None:
            total = metallic
            continue
        mix = nodes.new("ShaderNodeMixShader")
        mix.inputs[0].default_value = w / passed
        links.new(total.outputs[0], mix.inputs[1])
        links.new(metallic.outputs[0], mix.inputs[2])
        total = mix
    links.new(total.outputs[0], nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    return material


def rendered(make_material, light, osl, seeds):
    """Pictures of a sphere, ``(seeds, height, width, channels)``, and the processor seconds of each."""
    scene = probes.empty_scene(RESOLUTION, samples=SAMPLES, osl=osl)
    probes.add_sphere(make_material())
    light(scene)
    probes.render(scene, 0)
    pictures, seconds = [], []
    for seed in seeds:
        start = time.process_time()
        pictures.append(probes.render(scene, seed))
        seconds.append(time.process_time() - start)
    return np.stack(pictures), seconds


def makers(slopes):
    """{run: (makes the material, whether by OSL)}."""
    found = {"by hand": (lambda: by_hand(slopes), False)}
    for name, (realisation, parameters) in RUNS.items():
        def material(realisation=realisation, parameters=parameters):
            return api.create_material(realisation=realisation, slopes=slopes, **parameters, **scenes.COPPER)
        found[name] = material, realisation.startswith("osl")
    return found


def table(slopes, light, rounds):
    """{run: (median of the processor seconds, noise of one sample: rms deviation over the mean)}.

    Every round renders every run, so that a machine that slows down for a while slows all of them.
    """
    found = {name: [] for name in ["by hand", *RUNS]}
    for j in range(rounds):
        for name, (make_material, osl) in makers(slopes).items():
            found[name].append(rendered(make_material, light, osl, range(3 * j + 1, 3 * j + 4)))
    inside = probes.pixel_normals(RESOLUTION)[1]
    return {name: (np.median([seconds for _, seconds in runs]),  # of all pictures of all rounds
                   _noise(np.concatenate([pictures for pictures, _ in runs])[:, inside]))
            for name, runs in found.items()}


def _noise(pixels):
    return np.sqrt(np.mean(pixels.var(axis=0, ddof=1)) * SAMPLES) / pixels.mean()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--slopes", nargs="*", choices=SLOPES, default=list(SLOPES))
    arguments = parser.parse_args()
    print(f"Blender {bpy.app.version_string}, sphere of {RESOLUTION} pixels, {SAMPLES} samples, copper")
    print(f"{'slopes':10} {'light':12} {'run':22} {'time':>6} {'noise':>8} {'noise at equal time':>20} "
          f"{'over width 0':>13}")
    for slopes in arguments.slopes:
        for light, add in LIGHTS.items():
            found = table(SLOPES[slopes], add, arguments.rounds)
            seconds, noise = found["fast"]
            for name, (s, n) in found.items():
                mirrors = found[name.split(",")[0] + ", width 0"][1] if "default" in name else np.nan
                quieter = f"1/{mirrors / n:.1f}" if "default" in name else ""
                print(f"{slopes:10} {light:12} {name:22} {s / seconds:6.2f} {n:8.3f} "
                      f"{n / noise * np.sqrt(s / seconds):20.2f} {quieter:>13}", flush=True)


if __name__ == "__main__":
    main()
