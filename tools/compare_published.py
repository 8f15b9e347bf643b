"""Writes the comparison with published fits of docs/measured_brdfs.md: Cook and Torrance's model on MERL's materials.

    python tools/compare_published.py FOLDER        (needs h5py)

FOLDER holds, neither of which is part of this repository,
- merl_nbrdf.zip of github.com/asztr/Neural-BRDF (MIT): nets trained on MERL's measurements, whose own files are 33 MB
  each (Sztrajman et al., "Neural BRDF Representation and Importance Sampling", Computer Graphics Forum 40(6), 2021)
- ngan_cooktorrance.fit and low_cooktorrance_E2.fit of github.com/bsdfbenchmark/bbm: the parameters of Ngan, Durand,
  Matusik, "Experimental Analysis of BRDF Models", EGSR 2005, and of Löw, Kronander, Ynnerman, Unger, "BRDF Models for
  Accurate and Efficient Rendering of Glossy Surfaces", ACM Transactions on Graphics 31(1), 2012

Each net is written as a .binary, which is fitted as any file is, with one slope and with two.
"""

import io
import pathlib
import re
import sys
import zipfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "tests" / "unit")]

from brdf_files import MERL_SCALE, merl_bytes  # noqa: E402

from addon.measured import fit  # noqa: E402
from addon.measured.ball import ball  # noqa: E402
from addon.measured.fitting import SHOWN_BALL  # noqa: E402
from addon.measured.lights import HELD_OUT  # noqa: E402
from addon.measured.reading import read_brdf_bytes  # noqa: E402
from addon.reflectance.directions import half_vector  # noqa: E402
from addon.reflectance.fresnel import dielectric, schlick  # noqa: E402
from addon.reflectance.masking import v_cavity  # noqa: E402
from addon.reflectance.slopes import beckmann  # noqa: E402

PAGE = ROOT / "docs" / "measured_brdfs.md"
BEGIN, END = "<!-- made by tools/compare_published.py -->\n", "<!-- end -->\n"
SMOOTHEST_TOLD = 0.05
"""Slope from which lobes are wider than the nets' and the table's cells, so that it can be told."""


def nets(file):
    """{material: function (v, l) -> f} of the nets."""
    import h5py
    with zipfile.ZipFile(file) as archive:
        for entry in sorted(archive.namelist()):
            if not entry.endswith(".h5"):
                continue
            arrays = []
            with h5py.File(io.BytesIO(archive.read(entry)), "r") as weights:
                weights.visititems(lambda name, item: arrays.append((name, np.array(item)))
                                   if hasattr(item, "shape") else None)
            yield pathlib.Path(entry).stem, net_of([array for _, array in sorted(arrays, key=lambda pair: pair[0])])


def net_of(arrays):
    """f of a net of 6 × 21 × 21 × 3, of the half and the difference vector; the last layer is exp(x) − 1."""
    first, middle, last = sorted((a for a in arrays if a.ndim == 2), key=lambda a: (a.shape[0] != 6, a.shape[1] == 3))
    biases = [a for a in arrays if a.ndim == 1]
    out = next(a for a in biases if len(a) == 3)
    inner = [a for a in biases if len(a) == 21]

    def f(v, l):
        h = half_vector(v, l)
        across = np.hypot(h[:, 0], h[:, 1])
        along = np.where(across[:, None] > 1e-12, h[:, :2] / np.maximum(across, 1e-12)[:, None], (1.0, 0.0))
        x, y = along[:, 0] * l[:, 0] + along[:, 1] * l[:, 1], along[:, 0] * l[:, 1] - along[:, 1] * l[:, 0]
        given = np.stack([across, 0.0 * across, h[:, 2], h[:, 2] * x - across * l[:, 2], y,
                          across * x + h[:, 2] * l[:, 2]], axis=1)
        hidden = np.maximum(np.maximum(given @ first + inner[0], 0.0) @ middle + inner[1], 0.0)
        return np.maximum(np.exp(np.minimum(hidden @ last + out, 15.0)) - 1.0, 0.0)
    return f


def published(file):
    """{material: {"kd", "ks", "eta", "m"}} of a .fit file."""
    found = {}
    for line in pathlib.Path(file).read_text(encoding="utf-8").splitlines():
        name, _, said = line.partition(" = ")
        if line.startswith("#") or not said:
            continue
        albedos = [np.array(text.split(","), float) for text in re.findall(r"albedo = \[([^\]]*)\]", said)]
        numbers = {key: float(value) for key, value in re.findall(r"(eta|roughness) = ([-\d.e+]+)", said)}
        found[name.strip()] = {"kd": albedos[0], "ks": albedos[1], "eta": numbers["eta"], "m": numbers["roughness"]}
    return found


def brdf_of(p, fresnel, d_over, scale):
    """f of published numbers: kd/π + ks F D G/(π (N·V)(N·L)), D over π in Ngan's, whose colours lack MERL's scale."""
    def f(v, l):
        h = half_vector(v, l)
        n_h, n_v, n_l, v_h = h[:, 2], np.maximum(v[:, 2], 1e-4), np.maximum(l[:, 2], 1e-4), np.sum(v * h, axis=-1)
        d = beckmann(n_h, p["m"]) / d_over
        lobe = fresnel(v_h, p["eta"]) * d * v_cavity(n_h, n_v, n_l, v_h) / (np.pi * n_v * n_l)
        return (p["kd"] / np.pi + p["ks"] * lobe[:, None]) * scale
    return f


def main(folder):
    """Compare, print and write."""
    folder = pathlib.Path(folder)
    ngan, low = published(folder / "ngan_cooktorrance.fit"), published(folder / "low_cooktorrance_E2.fit")
    shown, rows = ball(*SHOWN_BALL), []
    for name, net in nets(folder / "merl_nbrdf.zip"):
        measurement = read_brdf_bytes(merl_bytes(net), f"{name}.binary")
        reference, row = shown.of_brdf(net), {"name": name}
        for key, slopes in (("one", 1), ("two", 2)):
            found = fit(measurement, fresnel="f0", slopes=slopes)
            row[key], row["m"] = found.mean, row.get("m", found.parameters.slopes[0][0])
        others = {"ngan": (ngan.get(name), schlick, np.pi, np.array(MERL_SCALE) * 1500.0),
                  "low": (low.get(name), dielectric, 1.0, 1.0)}
        for key, (p, *how) in others.items():
            if p:
                off = shown.differences(reference, shown.of_brdf(brdf_of(p, *how)), HELD_OUT)
                row[key], row[f"{key} m"] = float(shown.mean(off)), p["m"]
        rows.append(row)
        print({key: x if isinstance(x, str) else round(x, 4) for key, x in row.items()}, flush=True)
    text = PAGE.read_text(encoding="utf-8")
    PAGE.write_text(re.sub(f"{BEGIN}.*?{END}", lambda _: BEGIN + table(rows) + END, text, flags=re.DOTALL),
                    encoding="utf-8")


def table(rows):
    """Differences and slopes as Markdown; rows {"name", "m", "one", "two", "ngan", "ngan m", "low", "low m"}."""
    lines = ["| fit | materials | mean CIEDE2000 | median | its m over ours: median (quartiles) |",
             "|---|---|---|---|---|"]
    for title, key in (("Ngan et al. 2005", "ngan"), ("Löw et al. 2012", "low")):
        of = [row for row in rows if key in row]
        ratios = np.array([row[f"{key} m"] / row["m"] for row in of if min(row[f"{key} m"], row["m"]) > SMOOTHEST_TOLD])
        first, middle, last = np.percentile(ratios, (25, 50, 75))
        off = np.array([row[key] for row in of])
        lines.append(f"| {title} | {len(of)} | {off.mean():.2f} | {np.median(off):.2f} | {middle:.2f} ({first:.2f} to "
                     f"{last:.2f}), {len(ratios)} with m above {SMOOTHEST_TOLD:g} |")
    for title, key in (("ours, one slope", "one"), ("ours, two slopes", "two")):
        off = np.array([row[key] for row in rows])
        lines.append(f"| {title} | {len(rows)} | {off.mean():.2f} | {np.median(off):.2f} | |")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    main(sys.argv[1])
