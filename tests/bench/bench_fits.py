"""How close to the measured colours each way comes, over every metal of the database.

    python tests/bench/bench_fits.py

Largest CIEDE2000 over 0 to 89°: half of the metals are within the first
number, 95 of 100 within the second, all within the third.  A metal here is a
dataset whose median k in the visible exceeds 1.
"""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

import numpy as np  # noqa: E402

from addon.bake import bake, ways  # noqa: E402
from addon.bake.colour import SPACES  # noqa: E402
from addon.spectra import observers, optical_constants  # noqa: E402


def metals():
    """The ids of the metals."""
    for dataset in optical_constants.dataset_ids():
        constants = optical_constants.load(dataset)
        if constants.has_k and np.median(constants.at(observers.WAVELENGTH_NM)[1]) > 1.0:
            yield dataset


def show(title, differences):
    """One line: the three numbers, and the share within 0.2."""
    half, most, every = np.percentile(differences, [50, 95, 100])
    within = 100 * np.mean(np.array(differences) <= 0.2)
    print(f"{title:62} {half:6.2f} {most:6.2f} {every:6.2f}   {within:3.0f} % within 0.2")


def main():
    datasets = list(metals())
    print(f"{len(datasets)} datasets of metals")
    for space in SPACES:
        for formula in ("exact", "blender-4.5"):
            bakes = [bake(dataset, space=space, formula=formula) for dataset in datasets]
            inside = [baked for baked in bakes if not baked.gamut.outside]
            title = f"{space}, {formula}, {len(inside)} in gamut"
            show(f"{title}: n and k", [baked.conductor.delta_e_2000_max for baked in inside])
            if formula == "exact":
                show(f"{title}: F82", [baked.f82.delta_e_2000_max for baked in inside])
                outside = [baked.conductor.delta_e_2000_max for baked in bakes if baked.gamut.outside]
                if outside:
                    show(f"{space}, {formula}, {len(outside)} desaturated: n and k", outside)
    found = [ways(dataset).ways for dataset in datasets]
    for place, way in enumerate(found[0][1:], start=1):
        show(way.title, [ways_of_one[place].delta_e_2000_max for ways_of_one in found])


if __name__ == "__main__":
    main()
