"""Salt and noise of copper by Cook-Torrance Reference under small suns: python -m tests.bench.bench_salt

Of the default finish, the 1982 one and brushed copper, at 256 samples: by how many local standard deviations the worst
pixel of several seeds exceeds what it converges to; the noise, the rms deviation of a pixel between seeds over the
mean; and the time over Standard's. With an earlier checkout, which has a Python of its own at .venv, also the noise
at equal time over the one there:

    python -m tests.bench.bench_salt --against CHECKOUT

Times are processor seconds of this process, the scenes one after the other, medians over the seeds.
"""

import argparse
import subprocess
import tempfile
import time
from pathlib import Path

import bpy
import numpy as np

from addon import api
from addon.verify.running import _quiet as quiet
from tests.render import probes
from tests.render.cook_torrance_scenes import FIGURE_6B

SAMPLES = 256
RESOLUTION = 32
FINISHES = {
    "default": {"slopes": ((0.12, 1.0),)},
    "1982": {"slopes": FIGURE_6B},
    "m 0.2": {"slopes": ((0.2, 1.0),)},
    "m 0.2, brushed": {"slopes": ((0.2, 1.0),), "anisotropy": 0.8},
}
DIAMETERS = (0.5, 5.0)
REALISATIONS = ("exact", "osl", "fast")


def save(folder, finish, realisation, diameter):
    """A copper sphere under a sun that is half-way up, as a file; returns its path."""
    scene = probes.empty_scene(RESOLUTION, samples=SAMPLES, osl=realisation.startswith("osl"))
    probes.add_sphere(api.create_material(preset="copper", realisation=realisation, **FINISHES[finish]))
    probes.add_sun(scene, np.radians(45.0), diameter=np.radians(diameter))
    path = Path(folder) / f"{finish} {realisation} {diameter}.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    return path


def rendered(path, seeds):
    """Grey pictures of a file, ``(seeds, height, width)``, and the processor seconds of each."""
    bpy.ops.wm.open_mainfile(filepath=str(path))
    probes.render(bpy.context.scene, 0)
    pictures, seconds = [], []
    for seed in seeds:
        start = time.process_time()
        pictures.append(probes.render(bpy.context.scene, seed).mean(axis=-1))
        seconds.append(time.process_time() - start)
    return np.stack(pictures), seconds


def measured(paths, rounds, each=3):
    """{case: (pictures, median seconds)} of {case: path}; every round renders every case."""
    found = {case: [] for case in paths}
    for number in range(rounds):
        for case, path in paths.items():
            found[case].append(rendered(path, range(1 + number * each, 1 + (number + 1) * each)))
    return {case: (np.concatenate([pictures for pictures, _ in runs]),
                   float(np.median([seconds for _, seconds in runs]))) for case, runs in found.items()}


def noise(pictures, mask):
    """The rms deviation of a pixel between seeds over the mean."""
    return float(np.sqrt(pictures.var(axis=0, ddof=1)[mask].mean()) / pictures[:, mask].mean())


def earlier(checkout, folder, finishes, diameters):
    """{case: path} of Reference as an earlier checkout has it, which saves with its own Python."""
    command = [str(checkout / ".venv" / "bin" / "python"), str(Path(__file__).resolve()), "--save", str(folder)]
    subprocess.run([*command, "--finishes", *finishes, "--suns", *map(str, diameters)], cwd=checkout, check=True,
                   stdout=subprocess.DEVNULL, env={"PYTHONPATH": str(checkout)})
    return {(finish, "earlier", d): folder / f"{finish} exact {d}.blend" for finish in finishes for d in diameters}


def report(finish, diameter, found):
    """A line for each realisation."""
    from tests.salt import salt  # which an earlier checkout need not have
    mask = probes.pixel_normals(RESOLUTION)[1]
    figures = {name: (noise(pictures, mask), seconds) for (f, name, d), (pictures, seconds) in found.items()
               if (f, d) == (finish, diameter)}
    for name, (deviation, seconds) in figures.items():
        pictures = found[finish, name, diameter][0]
        line = (f"{finish:15} {diameter:4} {name:8} worst {salt(pictures, mask).max():6.1f}  "
                f"noise {deviation:7.4f}")
        if "fast" in figures:
            line += f"  time {seconds / figures['fast'][1]:5.2f}"
        if "earlier" in figures:
            before, seconds_before = figures["earlier"]
            line += f"  at equal time {deviation / before * (seconds / seconds_before) ** 0.5:5.2f} of the earlier"
        print(line, flush=True)


def main():
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--against", type=Path, help="an earlier checkout")
    parser.add_argument("--rounds", type=int, default=4, help="of three seeds each")
    parser.add_argument("--finishes", nargs="*", choices=FINISHES, default=list(FINISHES))
    parser.add_argument("--suns", nargs="*", type=float, default=list(DIAMETERS), help="diameters in degrees")
    parser.add_argument("--realisations", nargs="*", choices=REALISATIONS, default=list(REALISATIONS))
    parser.add_argument("--save", type=Path, help="only save Reference's scenes here, for --against of a later one")
    arguments = parser.parse_args()
    cases = [(finish, d) for finish in arguments.finishes for d in arguments.suns]
    if arguments.save:
        for finish, d in cases:
            save(arguments.save, finish, "exact", d)
        return
    print(f"Blender {bpy.app.version_string}, sphere of {RESOLUTION} pixels, {SAMPLES} samples, copper")
    with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as folder_before:
        known = [finish for finish in arguments.finishes if "anisotropy" not in FINISHES[finish]]
        before = earlier(arguments.against.resolve(), Path(folder_before), known, arguments.suns) \
            if arguments.against else {}
        for finish, d in cases:
            with quiet():
                paths = {(finish, name, d): save(folder, finish, name, d) for name in arguments.realisations}
                paths.update({case: path for case, path in before.items() if (case[0], case[2]) == (finish, d)})
                found = measured(paths, arguments.rounds)
            report(finish, d, found)


if __name__ == "__main__":
    main()
