"""Makes every picture and plot of the documents.

    python -m demo_blend.figures [NAME …] [--scale SHARE] [--pictures FOLDER] [--scenes FOLDER] [--other PYTHON]

Without names all of them.  Pictures go to docs/pictures, the scenes as .blend
files to out.  --scale 0.25 makes small ones, to look at within a minute or two.
"""

import argparse
import sys
import time
from importlib import import_module
from pathlib import Path

from .job import Clock, Job

MODULES = ("show_metals", "show_films", "show_glass", "show_paint", "show_vases", "poster", "vases", "twelve_vases",
           "watch", "plots", "layers", "gallery", "finishes", "clear", "spectrum", "tutorials", "side_by_side")
"""Of demo_blend, each with FIGURES."""


def all_figures():
    """Name -> (module, Figure), in the order of making."""
    found = {}
    for name in MODULES:
        module = import_module(f".{name}", __package__)
        found.update({figure.name: (name, figure) for figure in module.FIGURES})
    return found


def make(chosen, job):
    """Make the figures; returns those that failed, as (name, why)."""
    clock = Clock(planned=sum(figure.seconds * job.scale ** 3 for _, figure in chosen))
    failed = []
    for number, (module, figure) in enumerate(chosen, 1):
        job.heading = lambda number=number: f"[{number}/{len(chosen)}, {clock.left()}] "
        job.generator = f"demo_blend/{module}.py"
        print(f"{job.heading()}{figure.title}", flush=True)
        begun = time.perf_counter()
        try:
            figure.make(job)
        except Exception as error:  # one picture that fails must not cost the others
            failed.append((figure.name, f"{type(error).__name__}: {error}"))
            print(f"  failed: {failed[-1][1]}", file=sys.stderr)
        clock.finished(figure.seconds * job.scale ** 3)
        print(f"  {figure.name}: {time.perf_counter() - begun:.0f} s", flush=True)
    return failed


def main(arguments=None):
    """From the command line; the exit status says whether all were made."""
    figures = all_figures()
    parser = argparse.ArgumentParser(prog="python -m demo_blend.figures", description=__doc__.split("\n")[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help="only these: " + ", ".join(figures))
    parser.add_argument("--scale", type=float, default=1.0, help="of sizes and samples (1)")
    parser.add_argument("--pictures", type=Path, default=Path("docs/pictures"), help="folder (docs/pictures)")
    parser.add_argument("--scenes", type=Path, default=Path("out"), help="folder of the .blend files (out)")
    parser.add_argument("--other", help="python of an environment with another Blender, for side_by_side_versions")
    options = parser.parse_args(arguments)
    unknown = [name for name in options.names if name not in figures]
    if unknown:
        parser.error(f"{', '.join(unknown)}: no such figure; there are {', '.join(figures)}")
    chosen = [figures[name] for name in options.names or figures]
    job = Job(options.pictures, options.scenes, options.scale, other=options.other)
    begun = time.perf_counter()
    failed = make(chosen, job)
    for path in job.written:
        print(f"{path}  {path.stat().st_size / 1024:.0f} KB")
    print(f"{len(chosen) - len(failed)} of {len(chosen)} made in {(time.perf_counter() - begun) / 60:.1f} min")
    for name, why in failed:
        print(f"not made: {name}: {why}", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
