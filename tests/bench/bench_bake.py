"""How long baking takes: one bake, the whole database, a cold start, a keystroke of the search.

    python tests/bench/bench_bake.py

Prints each figure with its limit; the exit status is 1 where one is exceeded.
Times are of one core.  The last line sets the whole bake beside the same
colours calculated with colour-science's functions, angle by angle.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import pathlib
import subprocess
import sys
import time
import warnings

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

import numpy as np  # noqa: E402

from addon.bake import bake, baking  # noqa: E402
from addon.bake.reflected import ANGLES, reflect  # noqa: E402
from addon.catalogue.search import search  # noqa: E402
from addon.spectra import optical_constants  # noqa: E402

QUERIES = ("gold babar", "titanium oxide", "stainless steel", "tungstn", "schott n-bk7")


def least_ms(work, times=20, runs=7):
    """The least mean time of a call, in ms of this process's processor time."""
    means = []
    for _ in range(runs):
        start = time.process_time()
        for _ in range(times):
            work()
        means.append((time.process_time() - start) / times * 1e3)
    return min(means)


def one_bake():
    def anew():
        baking._whatever_the_formula.cache_clear()
        bake("copper")
    anew()
    return least_ms(anew)


def whole_database():
    """Seconds for all datasets, in which a warning or a floating-point error is an error."""
    with warnings.catch_warnings(), np.errstate(all="raise", under="ignore"):
        warnings.simplefilter("error")
        start = time.process_time()
        for dataset in optical_constants.dataset_ids():
            bake(dataset)
        return time.process_time() - start


def cold_start():
    """Seconds of the shell command from start to end, the least of five."""
    durations = []
    for _ in range(5):
        start = time.perf_counter()
        command = [sys.executable, "-m", "addon", "bake", "copper"]
        subprocess.run(command, cwd=ROOT, check=True, capture_output=True)
        durations.append(time.perf_counter() - start)
    return min(durations)


def keystroke():
    """ms of the slowest letter typed into the search."""
    search("")
    texts = [query[:end] for query in QUERIES for end in range(1, len(query) + 1)]
    return max(least_ms(lambda text=text: search(text), 1, 3) for text in texts)


def colour_science():
    """ms for copper's colours at the bake's angles: colour-science's functions angle by angle, and ours."""
    import colour
    mirror = reflect("copper")
    index = mirror.n + 1j * mirror.k
    shape = colour.SpectralShape(360, 780, 1)
    cmfs = colour.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"].copy().align(shape)
    d65 = colour.SDS_ILLUMINANTS["D65"].copy().align(shape)

    def colours():
        for cos_theta in ANGLES:
            inside = np.sqrt(1 - (1 - cos_theta**2) / index**2)
            r_s = (cos_theta - index * inside) / (cos_theta + index * inside)
            r_p = (index * cos_theta - inside) / (index * cos_theta + inside)
            spectrum = colour.SpectralDistribution((abs(r_s)**2 + abs(r_p)**2) / 2, shape.wavelengths)
            xyz = colour.sd_to_XYZ(spectrum, cmfs, d65, method="Integration") / 100
            colour.XYZ_to_RGB(xyz, "ITU-R BT.709", apply_cctf_encoding=False)
    colours()
    return least_ms(colours, 1, 3), least_ms(lambda: reflect("copper"))


def main():
    figures = [
        ("one warm bake", one_bake(), 5.0, "ms"),
        ("all datasets", whole_database(), 15.0, "s"),
        ("python -m addon bake copper", cold_start(), 0.5, "s"),
        ("a keystroke of search", keystroke(), 30.0, "ms"),
    ]
    for name, value, limit, unit in figures:
        verdict = "" if value <= limit else "  EXCEEDED"
        print(f"{name:30} {value:8.2f} {unit:2}  of at most {limit:g} {unit}{verdict}")
    theirs, ours = colour_science()
    print(f"{'colours over angle':30} {ours:8.2f} ms  colour-science angle by angle: {theirs:.0f} ms, "
          f"{theirs / ours:.0f} times as long")
    return int(any(value > limit for _, value, limit, _ in figures))


if __name__ == "__main__":
    sys.exit(main())
