"""Builds addon/spectra/data/clear.table: σ of the clear presets' absorption, in the usual light.

    python tools/build_clear_facts.py [OUTPUT_FOLDER]

A fit takes up to a tenth of a second, and a click takes σ from there.  To be run whenever a clear preset's dataset
changes or how σ is fitted.
"""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from addon.bake.clear_absorption import alpha_of, attenuation_of  # noqa: E402
from addon.bake.reflected import Viewing  # noqa: E402
from addon.catalogue import presets  # noqa: E402
from addon.catalogue.resolving import resolve  # noqa: E402
from addon.models.clear import known  # noqa: E402
from addon.models.clear.baking import absorbing  # noqa: E402
from addon.spectra import tables as packed  # noqa: E402

__all__ = ["build", "found"]


def found():
    """[(dataset, sum of α in 1/m, σ, colour, distance, largest CIEDE2000)] of what absorbs, each dataset once."""
    rows = {}
    for name in presets.of_model("clear"):
        k = absorbing(resolve(name))
        if k is not None and k.dataset not in rows:
            alpha = alpha_of(k)
            rows[k.dataset] = (k.dataset, float(alpha.sum()), *attenuation_of(alpha, Viewing()))
    return list(rows.values())


def build(folder):
    """Write the table; how many datasets it holds."""
    rows = found()
    about = {"title": "Absorption of clear presets as three numbers", "source": "presets.json, refractiveindex.table",
             "version": packed.about("refractiveindex")["version"], "licence": "CC0-1.0",
             "tool": "tools/build_clear_facts.py"}
    packed.pack(folder / f"{known.NAME}.table", about, {"attenuations": {"rows": rows}})
    return len(rows)


if __name__ == "__main__":
    print(f"{build(Path(*sys.argv[1:]) if sys.argv[1:] else packed.DIRECTORY)} datasets")
