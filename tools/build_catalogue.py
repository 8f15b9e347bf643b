"""Builds docs/materials.md: a table of every preset, baked, with where its data is from.

    python tools/build_catalogue.py [OUTPUT_FILE]

The same presets and tables give the same text.
"""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from addon.bake import bake  # noqa: E402
from addon.bake.srgb import hex_of  # noqa: E402
from addon.catalogue import presets  # noqa: E402
from addon.catalogue.entries import thumbnail  # noqa: E402
from addon.catalogue.kinds import KINDS  # noqa: E402
from addon.models.making import made  # noqa: E402
from addon.spectra import tables  # noqa: E402

FILE = ROOT / "docs" / "materials.md"
TOOL = "tools/build_catalogue.py"
HEAD = ("Preset", "Also called", "Colour", "F0", "F82 tint", "s", "m (share)", "Fit", "Data")
UNMEASURED_HEAD = ("Preset", "Also called", "Picture", "What it is")

INTRODUCTION = """\
# Materials

<!-- Made by {tool} from the models' presets.json and the {source},
{version} ({licence}). Edit those, not this. -->

{count} presets of all models, {metals} of them metals and alloys. Each name works in `bake`, in
`create_material(preset=…)`, and in the panel; so do the other names. Beyond these, every dataset of
refractiveindex.info that covers the visible can be baked by its id, such as `main/Cu/Johnson`:
`python -m addon search TEXT` finds them.

- **Colour** shows the preset on a ball in a studio, and is the mirror's at normal incidence, as sRGB, brought into the
  gamut where it lies outside (marked \\*).
- **F0** and **F82 tint** are linear Rec.709 in D65 for the 2° observer, before that.
- **s** is the specular fraction (the diffuse one is d = 1 − s); **m** the rms slope, with each one's share where
  there are several. Those of the paper's figures are the paper's; all others are chosen to look like the material
  as it is commonly met, and are no measurements.
- **Fit** is the largest CIEDE2000 from 0 to 89° between the measured colours and the fitted n and k a channel.
- **Data** is the dataset, with the number of its source below, and what is to be said about it. *Estimated* says
  what was not measured, and from what it was guessed.
"""


def main(path=FILE):
    """Write the catalogue."""
    about, _, _ = tables.read("refractiveindex")
    everything = presets.all_presets().values()
    records = {preset: made(preset=preset.name) for preset in everything if preset.measured}
    baked = {preset: (bake(preset.name), record.parameters)
             for preset, record in records.items() if "conductor" in record.baked}
    citations = list(dict.fromkeys(record.baked["source"]["citation"] for preset, record in sorted(
        records.items(), key=lambda item: list(KINDS).index(item[0].kind)) if preset.dataset))
    metals = sum(preset.kind in {"metal", "alloy"} for preset in everything)
    parts = [INTRODUCTION.format(**about | {"tool": TOOL}, count=len(everything), metals=metals)]
    for kind, title in KINDS.items():
        of_kind = [preset for preset in everything if preset.kind == kind]
        rows = [row(preset, *baked[preset], citations) for preset in of_kind if preset in baked]
        others = [other_row(preset, records.get(preset), citations) for preset in of_kind if preset not in baked]
        listed = [table(head, found) for head, found in ((HEAD, rows), (UNMEASURED_HEAD, others)) if found]
        parts.append(f"## {title}\n\n" + "\n".join(listed))
    sources = "\n".join(f"{number}. {' '.join(text.split())}" for number, text in enumerate(citations, 1))
    parts.append(f"## Sources\n\nAs refractiveindex.info cites them.\n\n{sources}\n")
    pathlib.Path(path).write_text("\n".join(parts), encoding="utf-8")


def table(head, rows):
    """A table as Markdown."""
    return "\n".join(map(line, [head, ["---"] * len(head), *rows])) + "\n"


def line(cells):
    """A line of a table."""
    return "| " + " | ".join(cells) + " |"


def other_row(preset, record, citations):
    """The cells of a preset that was not measured, or whose record is not of a mirror's curve."""
    called = ", ".join(dict.fromkeys([preset.title, *preset.aliases]))
    data = ""
    if preset.dataset:
        data = f"`{preset.dataset}` [{citations.index(record.baked['source']['citation']) + 1}]. "
    return (f"`{preset.name}`", called, picture(preset.name), data + (record.baked["note"] if record else preset.note))


def row(preset, bake, surface, citations):
    """The cells of a measured preset."""
    slopes = ", ".join(f"{m:g}" + (f" ({w:g})" if len(surface.slopes) > 1 else "") for m, w in surface.slopes)
    data = [f"`{preset.dataset}` [{citations.index(bake.source.citation) + 1}]." if preset.dataset else "",
            preset.note, preset.estimated and "*Estimated:* " + preset.estimated.removeprefix("Estimated: ")]
    return (f"`{preset.name}`", ", ".join(dict.fromkeys([preset.title, *preset.aliases])),
            f"{picture(preset.name)} `{hex_of(bake.normal_rgb)}`" + ("\\*" if bake.gamut.outside else ""),
            numbers(bake.f0, 3), numbers(bake.f82_tint, 2), f"{surface.specular:g}", slopes,
            f"{bake.conductor.delta_e_2000_max:.2f}", " ".join(filter(None, data)))


def picture(name):
    """The preset's thumbnail, seen from docs/."""
    return f'<img src="../addon/thumbnails/{thumbnail(name).name}" width="40" alt="{name}">'


def numbers(values, digits):
    """Numbers in a row; without the sign of a zero."""
    return " ".join(f"{round(value, digits) + 0.0:.{digits}f}" for value in values)


if __name__ == "__main__":
    main(*sys.argv[1:2])
