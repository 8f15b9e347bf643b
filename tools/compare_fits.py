"""Writes the tables and pictures of docs/measured_brdfs.md: three models fitted to real measurements.

    python tools/compare_fits.py FOLDER

FOLDER holds _rgb.bsdf files of the RGL-EPFL database, which are not part of
this repository.  The layered model is searched from thirty starts by chance,
always the same, the others as addon.measured does.
"""

import pathlib
import re
import sys

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from addon.bake.srgb import bytes_of  # noqa: E402
from addon.export.png import png  # noqa: E402
from addon.measured import fit, read_brdf  # noqa: E402
from addon.measured.ball import ball  # noqa: E402
from addon.measured.fit import report_of  # noqa: E402
from addon.measured.fitting import FITTED_BALL, SHOWN_BALL  # noqa: E402
from addon.measured.least_squares import least_squares  # noqa: E402
from addon.measured.picture import picture_pixels  # noqa: E402
from addon.measured.problems import ImageProblem, SampleProblem, guess_of  # noqa: E402
from addon.models import named  # noqa: E402
from addon.models.fitted import UP  # noqa: E402

PAGE = ROOT / "docs" / "measured_brdfs.md"
PICTURES = ROOT / "docs" / "pictures"
SHOWN = {"cc_iris_purple_gem": ("curve", "measured_cc_iris_purple_gem.png"),
         "vch_golden_yellow": ("n_k", "measured_vch_golden_yellow.png"),
         "irid_flake_paint2": ("f0", "measured_irid_flake_paint2.png")}
"""Materials that are pictured: the fit beside each, and the picture."""
STARTS, ROUNDS, SEED = 30, 20, 1
BEGIN, END = "<!-- made by tools/compare_fits.py -->\n", "<!-- end -->\n"


class Layered:
    """The layered RGB model under fit: ln d, r1 of three channels, ln e0, ln e1, specular, diffuse; deviation 0."""

    name, slopes = "layered", 0
    model = named("layered_rgb")
    low = np.r_[0.0, [1.01] * 3, np.log(0.5), np.log(0.5), 0.0, 0.0]
    high = np.r_[np.log(3000.0), [5.0] * 3, np.log(2e4), np.log(2e4), 1.0, 1.0]
    groups = [(i,) for i in range(8)]

    def bends(self, p):
        """None."""
        return np.zeros(0)

    def checked(self, p):
        """The model's checked parameters."""
        d, e0, e1 = np.exp(p[[0, 4, 5]])
        return self.model.parameters(thickness=d, ior=tuple(p[1:4]), exponent_r=e0, exponent_t=e1, specular=p[6],
                                     diffuse=p[7])

    final = checked

    def evaluate(self, p, v, l):
        """Model.evaluate; nothing where the model's own formula has no value."""
        return self.standard(self.checked(p), v, l, "")

    def standard(self, parameters, v, l, _formula):
        """As the formula."""
        with np.errstate(all="ignore"):
            return np.nan_to_num(self.model.evaluate(parameters, np.broadcast_to(UP, v.shape), v, l))

    def starts(self, guess):
        """By chance: indices that differ little, exponents that belong together."""
        rng = np.random.default_rng(SEED)
        for _ in range(STARTS):
            ior, e = 1.2 + rng.uniform(0.0, 1.8) + rng.uniform(-0.1, 0.1, 3), rng.uniform(np.log(3.0), np.log(2000.0))
            yield np.clip(np.r_[rng.uniform(np.log(15.0), np.log(500.0)), np.sort(ior), e, e + rng.normal(0.0, 0.5),
                                rng.uniform(0.02, 0.8), rng.uniform(0.05, 0.8)], self.low, self.high)


def found(search):
    """What a search finds."""
    try:
        while True:
            next(search)
    except StopIteration as end:
        return end.value


def layered(measurement):
    """The Fit of the layered model."""
    form = Layered()
    problem = SampleProblem(form, measurement.samples)
    best = min((found(least_squares(problem, start, rounds=ROUNDS)) for start in form.starts(
        guess_of(measurement.samples))), key=lambda one: one.cost)
    shown = ball(*FITTED_BALL)
    image = ImageProblem(form, shown, shown.of_brdf(measurement.brdf))
    best = found(least_squares(image, best.parameters, rounds=ROUNDS))
    return report_of(measurement, form, best.parameters, measurement.brdf, ball(*SHOWN_BALL), {})


def main(folder):
    """Fit everything; write table, summary and pictures."""
    rows, pictures = [], {}
    for file in sorted(pathlib.Path(folder).glob("*_rgb.bsdf")):
        measurement, name = read_brdf(file), file.stem.removesuffix("_rgb")
        fits = {"layered": layered(measurement),
                **{fresnel: fit(measurement, fresnel=fresnel) for fresnel in ("f0", "n_k", "curve", "best")}}
        rows.append((name, measurement.title, fits))
        if name in SHOWN:
            pictures[name] = fits[SHOWN[name][0]], fits["layered"]
        print(name, {key: round(one.mean, 2) for key, one in fits.items()}, flush=True)
    for name, (one, other) in pictures.items():
        pixels = np.concatenate([picture_pixels(one, 200), picture_pixels(other, 200)[:, 200:]], axis=1)
        (PICTURES / SHOWN[name][1]).write_bytes(png(bytes_of(pixels)))
    text = PAGE.read_text(encoding="utf-8")
    text = re.sub(f"{BEGIN}.*?{END}", lambda _: BEGIN + table(rows) + END, text, flags=re.DOTALL)
    PAGE.write_text(text, encoding="utf-8")


def table(rows):
    """The rows as Markdown, with means below."""
    keys = ("layered", "f0", "n_k", "curve", "best")
    lines = ["| material | layered RGB | Cook–Torrance, F0 | Cook–Torrance, n, k | curve | taken | verdict |",
             "|---|---|---|---|---|---|---|"]
    for name, title, fits in rows:
        numbers = [f"{fits[key].mean:.2f}" for key in keys[:-1]]
        best = fits["best"]
        lines.append(f"| {name}: {title.replace('|', '/').strip(' ,')} | " + " | ".join(numbers)
                     + f" | {best.fresnel} {best.mean:.2f} (95 %: {best.p95:.1f}) | {best.verdict.split(',')[0]} |")
    means = {key: np.array([fits[key].mean for *_, fits in rows]) for key in keys}
    for what, of in (("mean", np.mean), ("median", np.median)):
        lines.append(f"| **{what}** | " + " | ".join(f"**{of(means[key]):.2f}**" for key in keys) + " | |")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    main(sys.argv[1])
