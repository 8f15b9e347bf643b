"""Cut the pictures of the documents' clicks out of those that the window tests took.

    python tools/click_pictures.py [out/window]

of docs/first_copper.md, and of docs/brushed_copper.md, docs/anodised_ring.md and docs/glass_of_water.md, whose sessions
`tests/window/run.py --blender … tutorials` runs.
"""

import sys
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parent.parent
PARTS = {
    "click_1.png": ("newcomer/click_1", (300, 0, 1600, 340)),
    "click_2.png": ("newcomer/click_2", (300, 0, 1600, 340)),
    "click_3.png": ("newcomer/click_3", (400, 24, 1600, 560)),
    "step_copper_1.png": ("tutorial_copper/finishes", (1350, 386, 1598, 688)),
    "step_copper_2.png": ("tutorial_copper/rougher", (1350, 386, 1598, 454)),
    "step_ring_1.png": ("tutorial_ring/search", (1324, 258, 1598, 330)),
    "step_ring_2.png": ("tutorial_ring/thickness", (1350, 606, 1598, 852)),
    "step_ring_3.png": ("tutorial_ring/volts", (240, 195, 1080, 675)),
    "step_water_1.png": ("tutorial_water/wall", (1350, 545, 1598, 725)),
}
"""Name -> session and picture; left, top, right and bottom in pixels of a window of 1600 by 900."""


def main():
    """Cut those that were taken, and reduce to a palette, which is enough for an interface."""
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "out" / "window"
    for name, (source, part) in PARTS.items():
        if not (folder / f"{source}.png").exists():
            continue
        target = ROOT / "docs" / "pictures" / name
        with Image.open(folder / f"{source}.png") as picture:
            picture.convert("RGB").crop(part).quantize(256, dither=Image.Dither.NONE).save(target, optimize=True)
        print(f"{target.relative_to(ROOT)}: {target.stat().st_size / 1024:.0f} KiB")


if __name__ == "__main__":
    main()
