"""Write docs/verification.md from the records of `make verify` on every Blender supported.

    python tools/verification_page.py out/verification-4.5.json … [--out docs/verification.md]
"""

import argparse
import json
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from addon.verify.report import realisation_title  # noqa: E402

OUT = ROOT / "docs" / "verification.md"
MODELS = {"cook_torrance": "Cook–Torrance", "layered_rgb": "Layered RGB", "data": "Measured data"}
HEAD = """# Verification

`make verify`, `python -m addon verify` where bpy is installed, `blender --command facet_film verify`, or the button in
the extension's preferences: this Blender renders the probes of every model and realisation, on the CPU or the GPU, and
holds the pixels against the formulas by quadrature. The report is one HTML page with reference, render and difference
of each check, and its first line says whether all passed. Below are the figures of the last reports.

A figure passes when it is at most its limit. |z| is a difference in standard errors of independent seeds; its limit is
what chance exceeds once in a thousand runs of the check (Student's t, Šidák's correction). The tests show each check
failing when the material it renders differs from its formula.
"""


def verdict(record):
    """Whether all of its checks passed, in words."""
    failed = [check for check in record["checks"] if not check.get("passed")]
    facts = record["facts"]
    word = f"**not green**: {len(failed)} of {len(record['checks'])} failed" if failed else \
        f"green: all {len(record['checks'])} checks passed"
    return f"- Blender {facts['Blender']}, {facts['Device']}, {facts['When'].split()[0]}: {word}"


def number(figure):
    """A figure as people read it."""
    return f"{figure['value']:.3g}" if figure else "–"


def rows(records, model):
    """The table of a model: realisation, check, figure, limit, and the value on each Blender."""
    names = [record["facts"]["Blender"].split()[0] for record in records]
    lines = ["| realisation | check | figure | limit | " + " | ".join(names) + " |", "|---" * (4 + len(names)) + "|"]
    for check in records[0]["checks"]:
        if check["model"] != model:
            continue
        for figure in check.get("figures", ()):
            found = [figure_of(record, check, figure["name"]) for record in records]
            limits = {f"{f['limit']:.3g}" for f in found if f}
            name = figure["name"].replace("|", "\\|")
            lines.append(f"| {realisation_title(check['realisation'])} | {check['name']} | {name} | "
                         f"{', '.join(sorted(limits))} | {' | '.join(map(number, found))} |")
    return "\n".join(lines)


def figure_of(record, check, name):
    """The same figure in another record, or None."""
    key = [check[part] for part in ("model", "realisation", "name")]
    for other in record["checks"]:
        if [other[part] for part in ("model", "realisation", "name")] == key:
            return next((figure for figure in other.get("figures", ()) if figure["name"] == name), None)
    return None


def page(records):
    """The whole page."""
    parts = [HEAD, "\n".join(map(verdict, records))]
    for model, title in MODELS.items():
        parts += [f"\n## {title}\n", rows(records, model)]
    return "\n".join(parts) + "\n"


def main():
    """Read the records, write the page."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("records", nargs="+", type=Path)
    parser.add_argument("--out", type=Path, default=OUT)
    arguments = parser.parse_args()
    records = [json.loads(path.read_text(encoding="utf-8")) for path in arguments.records]
    arguments.out.write_text(page(records), encoding="utf-8")
    print(arguments.out)


if __name__ == "__main__":
    main()
