"""How far Cook-Torrance Standard is from the formula, as the table of docs/accuracy.md.

    python -m tests.bench.measure_fast

A sphere of copper under a sharp sun at 60°: rms difference over rms, of pixels
whose N·V is above 0.2, from the formula with the paper's V-cavity G; and the same
of closures whose slope, weight and anisotropy do not follow N·V.
"""

from importlib.metadata import version

from tests.render.test_fast import COPPER, formula, relative_rms, rendered

SLOPES = (0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6)


def row(m, distribution):
    """Relative rms from the formula: of Standard, and for Beckmann's D of closures that do not follow it."""
    parameters = {"slopes": [(m, 1.0)], "distribution": distribution}
    picture, towards = rendered(**parameters, **COPPER)
    whole, mask = formula(towards, **parameters)
    if distribution == "gaussian":
        return (relative_rms(picture, whole, mask),)
    plain, _ = formula(towards, closures={"widened": False, "weighed": False, "leaning": False}, slopes=[(m, 1.0)])
    return relative_rms(picture, whole, mask), relative_rms(plain, whole, mask)


def main():
    """Print the table."""
    lines = [f"bpy {version('bpy')}", "", "| m | Beckmann | Beckmann with Smith's G as it is | Gaussian |",
             "|---|---|---|---|"]
    for m in SLOPES:
        values = (*row(m, "beckmann"), *row(m, "gaussian"))
        lines.append(f"| {m:.2f} | " + " | ".join(f"{value:.2%}" for value in values) + " |")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
