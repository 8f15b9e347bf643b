"""How far Cook-Torrance Fast is from the formula, as the table of docs/accuracy.md.

    python -m tests.bench.measure_fast

A sphere of copper under a sharp sun at 60°: rms difference over rms, of pixels
whose N·V is above 0.1, from the formula with the closure's Smith G and with the
paper's V-cavity G.
"""

from importlib.metadata import version

from tests.render.test_fast import COPPER, formula, relative_rms, rendered

SLOPES = (0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6)


def row(m, distribution):
    """Relative rms from the formula with Smith G, and with the V-cavity G."""
    parameters = {"slopes": [(m, 1.0)], "distribution": distribution}
    picture, towards = rendered(**parameters, **COPPER)
    smith, mask = formula(towards, **parameters)
    v_cavity, _ = formula(towards, **parameters, smith=False)
    return relative_rms(picture, smith, mask), relative_rms(picture, v_cavity, mask)


def main():
    """Print the table."""
    lines = [f"bpy {version('bpy')}", "",
             "| m | Beckmann, Smith G | Beckmann, V-cavity G | Gaussian, Smith G | Gaussian, V-cavity G |",
             "|---|---|---|---|---|"]
    for m in SLOPES:
        values = (*row(m, "beckmann"), *row(m, "gaussian"))
        lines.append(f"| {m:.2f} | " + " | ".join(f"{value:.2%}" for value in values) + " |")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
