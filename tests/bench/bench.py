"""All that is measured of time, noise and size, in one run: a record for machines, and a page with a plot.

    python -m tests.bench.bench [--record out/bench.json] [--page docs/benchmarks.md] [--quick] [--other PYTHON]

Renders are of a copper sphere of slope 0.3 under a sun of 5° and a dim sky, in processor seconds of this process;
medians of the repeats, and ratios to the Principled BSDF within the run. Noise is the rms deviation between
independent seeds over the mean.
"""

import argparse
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from importlib.metadata import version
from pathlib import Path

import bpy
import numpy as np

from addon import api, models
from addon.blender import compat
from addon.models.realisations import REALISATIONS
from addon.verify import scenes
from addon.verify.running import _quiet as quiet
from tests.bench import bench_bake, bench_interface
from tests.bench.bench_cook_torrance import by_hand
from tests.render.cook_torrance_scenes import COPPER
from tests.render.layered_scenes import material as layered_material
from tools.package import build

ROOT = Path(__file__).resolve().parents[2]
RESOLUTION = 64
SLOPES = ((0.3, 1.0),)
WAYS = {
    "Principled BSDF": lambda: principled(),
    "Metallic BSDF by hand": lambda: by_hand(SLOPES),
    "Standard": lambda: copper("fast"),
    "Reference": lambda: copper("exact"),
    "Reference, width 0": lambda: copper("exact", sampling_width=0.0),
    "OSL": lambda: copper("osl"),
    "OSL Standard": lambda: copper("osl_fast"),
    "Layered RGB Standard": lambda: layered_material("fast", thickness=70.0),
    "Layered RGB Reference": lambda: layered_material("exact", thickness=70.0),
    "Layered RGB OSL": lambda: layered_material("osl", thickness=70.0),
}
REFERENCE = "Principled BSDF"

GROWTH = """
import bpy, numpy
from pathlib import Path
def resident():
    return int(Path("/proc/self/statm").read_text().split()[1]) * 4096 / 2 ** 20
before = resident()
from addon import api, models
for realisation in models.named("cook_torrance").realisations:
    api.create_material(preset="copper", realisation=realisation)
print("grew", resident() - before)
"""
"""Prints MiB that a Blender grows by; Linux says what is resident."""


def principled():
    """A metal of the Principled BSDF that looks much the same."""
    material = bpy.data.materials.new("Principled")
    compat.enable_nodes(material)
    shader = next(node for node in material.node_tree.nodes if node.bl_idname == "ShaderNodeBsdfPrincipled")
    settings = {"Base Color": (0.93, 0.62, 0.52, 1.0), "Metallic": 1.0, "Roughness": SLOPES[0][0] ** 0.5}
    for name, value in settings.items():
        shader.inputs[name].default_value = value
    return material


def copper(realisation, slopes=SLOPES, **parameters):
    """Our copper."""
    return api.create_material(realisation=realisation, slopes=slopes, **parameters, **COPPER)


def measured(make, samples, repeats, osl=False, spheres=1):
    """(median processor seconds of a picture, noise): a sphere, or a grid of spheres of different materials."""
    side = int(np.ceil(np.sqrt(spheres)))
    scene = scenes.empty_scene(RESOLUTION, samples=samples, osl=osl, extent=2.0 * side)
    for number in range(spheres):
        ball = scenes.add_sphere(make(), 64)
        ball.location = (2 * (number % side) + 1 - side, 2 * (number // side) + 1 - side, 0.0)
    scenes.set_world(scene, 0.1)
    scenes.add_sun(scene, np.radians(45.0), diameter=np.radians(5.0))
    pictures, seconds = [scenes.render(scene, 1)], []
    for seed in range(2, 2 + repeats):
        start = time.process_time()
        pictures.append(scenes.render(scene, seed))
        seconds.append(time.process_time() - start)
    lit = np.stack(pictures)[:, scenes.pixel_normals(RESOLUTION)[1]] if spheres == 1 else np.stack(pictures)
    return statistics.median(seconds), float(np.sqrt(np.mean(lit.var(axis=0, ddof=1))) / lit.mean())


def noise_over_time(counts, repeats):
    """{realisation: [(samples, seconds, noise)]}."""
    return {name: [(count, *measured(make, count, repeats, osl="OSL" in name)) for count in counts]
            for name, make in WAYS.items()}


def growth(samples, repeats):
    """How the time of Reference and Standard grows with slopes and with materials in the scene, over the first."""
    slopes = {count: tuple((0.1 * (j + 1), 1.0 / count) for j in range(count)) for count in (1, 2, 4)}
    by_slopes = {name: {count: measured(lambda: copper(name, slopes[count]), samples, repeats)[0] for count in slopes}
                 for name in ("fast", "exact")}
    numbers = iter(range(10 ** 6))

    def another(name):
        return lambda: copper(name, ((0.2 + 0.001 * (next(numbers) % 500), 1.0),))
    by_materials = {name: {count: measured(another(name), samples, repeats, spheres=count)[0] for count in (1, 4, 16)}
                    for name in ("fast", "exact")}
    return {"slopes": by_slopes, "materials": by_materials}


def sizes():
    """Zip in KiB, and MiB that enabling and one material of each realisation add to Blender."""
    with tempfile.TemporaryDirectory() as folder:
        zip_kib = build(folder).stat().st_size / 1024
    said = subprocess.run([sys.executable, "-c", GROWTH], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    return {"zip_kib": zip_kib, "memory_mib": float(said.split("grew")[1].split()[0])}


def times():
    """Milliseconds and seconds of baking, and of making a material."""
    return {"bake_one_ms": bench_bake.one_bake(), "bake_all_datasets_s": bench_bake.whole_database(),
            "create_material_ms": create_ms()}


def interface(other):
    """{Blender: what bench_interface measures}, of this one and of the one that another Python has."""
    found = {bpy.app.version_string: bench_interface.measure(5)}
    if other:
        def said(*arguments):
            # Python's environment, for bpy adds its own colour configuration to the process's, which no other one
            # reads.
            return subprocess.run([other, *arguments], cwd=ROOT, env=dict(os.environ), capture_output=True, text=True,
                                  check=True).stdout
        version_string = said("-c", "import bpy; print('is', bpy.app.version_string)").split("is ")[1].strip()
        after = said(bench_interface.__file__, "--json").split("measured ")[1]
        found[version_string] = json.loads(after.splitlines()[0])
    return found


def create_ms():
    """{realisation: median ms of create_material in a file that has the group}."""
    found = {}
    for realisation in models.named("cook_torrance").realisations:
        api.create_material(preset="copper", realisation=realisation)
        durations = []
        for _ in range(5):
            start = time.process_time()
            api.create_material(preset="copper", realisation=realisation)
            durations.append((time.process_time() - start) * 1e3)
        found[realisation] = statistics.median(durations)
    return found


def record(quick, other):
    """Everything measured."""
    counts, repeats = ((4, 16), 2) if quick else ((4, 16, 64), 3)
    with quiet():
        return {
            "blender": bpy.app.version_string, "bpy": version("bpy"), "resolution": RESOLUTION,
            "cores": scenes.TWO_CORES,
            "noise_over_time": noise_over_time(counts, repeats), "growth": growth(counts[-1], repeats),
            "times": times(), "interface": interface(other), "sizes": sizes(),
            "peak_memory_of_this_run_mib": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024}


# --- The page ---

def plot(found, path):
    """Noise over time, both axes logarithmic: lower left is better."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    from matplotlib.ticker import NullFormatter
    figure, axes = pyplot.subplots(1, 2, figsize=(11, 4.8), sharey=True, layout="constrained")
    for name, points in found.items():
        layered = name.startswith("Layered")
        axis = axes[1] if layered else axes[0]
        axis.loglog([p[1] for p in points], [p[2] for p in points], marker="o", markersize=4,
                    linestyle="--" if "BSDF" in name else "-", label=name.removeprefix("Layered RGB "))
    for axis, title in zip(axes, ("Cook–Torrance and native BSDFs", "Layered RGB")):
        axis.set_title(title)
        axis.set_xlabel("processor seconds")
        axis.grid(True, which="both", alpha=0.25)
        axis.xaxis.set_minor_formatter(NullFormatter())
        axis.legend(fontsize="small", ncols=4, loc="upper center", bbox_to_anchor=(0.5, -0.16))
    axes[0].set_ylabel("noise: rms over mean")
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, dpi=110)


def table(found):
    """Time and noise of the most samples, over the Principled BSDF's."""
    samples, seconds, noise = found[REFERENCE][-1]
    lines = [f"| {samples} samples | time | noise | noise in the same time |", "|---|---|---|---|"]
    for name, points in found.items():
        _, s, n = points[-1]
        lines.append(f"| {name} | {s / seconds:.2f} | {n / noise:.2f} | {n / noise * (s / seconds) ** 0.5:.2f} |")
    return "\n".join(lines)


def growth_table(found):
    """Time over that of the first in each row."""
    lines = ["| | " + " | ".join(("1", "2", "4")) + " slopes | 1 | 4 | 16 materials |", "|---|---|---|---|---|---|---|"]
    for name in ("fast", "exact"):
        cells = [f"{value / next(iter(found[what][name].values())):.2f}"
                 for what in ("slopes", "materials") for value in found[what][name].values()]
        lines.append(f"| {REALISATIONS[name].title} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def page(found, picture):
    """Markdown."""
    t, s = found["times"], found["sizes"]
    made = ", ".join(f"{REALISATIONS[name].title} {ms:.0f} ms" for name, ms in t["create_material_ms"].items())
    return f"""# Benchmarks

`make bench` measures all of this in one run and writes `out/bench.json`. Blender {found['blender']}, {found['cores']}
threads of a shared machine: trust the ratios, not the seconds. A copper sphere of slope 0.3 under a sun of 5° and a dim
sky, {found['resolution']} × {found['resolution']} pixels. Ratios are to the Principled BSDF of the same run; noise is
the rms deviation of a pixel between seeds over the mean, and "in the same time" is what it comes to when both render
equally long.

{table(found['noise_over_time'])}

![Noise over time]({picture})

Sampling Width 0 is a mirror about every facet drawn, which only light that it happens to hit can reach: that is its
noise under a small sun. The default width is what to render with under lamps.

How the time grows, over the first of each row (a grid of spheres fills the same pixels):

{growth_table(found['growth'])}

| | |
|---|---|
| bake one preset | {t['bake_one_ms']:.1f} ms |
| bake all datasets of the database | {t['bake_all_datasets_s']:.1f} s |
| `create_material`, a preset, group already in the file | {made} |
| the zip | {s['zip_kib']:.0f} KiB |
| memory added to Blender by a material of each realisation | {s['memory_mib']:.0f} MiB |

{interface_part(found['interface'])}"""


def interface_part(found):
    """What one waits for, by Blender."""
    parts = ["""## The interface

`python tests/bench/bench_interface.py` measures this part alone: the zip as it is installed, each figure the median of
five fresh Blenders. "First" is the first time in a session, with everything that is loaded for it (of enabling the
first time after installing, which compiles the modules; of presets and search once the panel is there); "later" is the
slowest after that, of drawing the median. The bars are for all but the first column of enabling and of drawing.
"""]
    parts += [f"Blender {blender}:\n\n{bench_interface.table(figures)}\n" for blender, figures in found.items()]
    return "\n".join(parts)


def main():
    """Measure, write record, plot and page."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--record", type=Path, default=ROOT / "out" / "bench.json")
    parser.add_argument("--page", type=Path, default=ROOT / "docs" / "benchmarks.md")
    parser.add_argument("--other", help="the Python of another Blender, whose interface is to be timed too")
    parser.add_argument("--quick", action="store_true", help="few samples: to see that it works")
    arguments = parser.parse_args()
    found = record(arguments.quick, arguments.other)
    picture = arguments.page.parent / "pictures" / "noise_over_time.png"
    arguments.record.parent.mkdir(parents=True, exist_ok=True)
    arguments.record.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    plot(found["noise_over_time"], picture)
    arguments.page.write_text(page(found, picture.relative_to(arguments.page.parent).as_posix()), encoding="utf-8")
    print(arguments.record, arguments.page, sep="\n")


if __name__ == "__main__":
    main()
