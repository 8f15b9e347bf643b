"""Cut the pictures of docs/first_copper.md out of those that the window tests took.

    python tools/click_pictures.py [out/window/newcomer]
"""

import sys
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parent.parent
PARTS = {"click_1.png": (300, 0, 1600, 340), "click_2.png": (300, 0, 1600, 340), "click_3.png": (400, 24, 1600, 560)}
"""Name -> left, top, right and bottom in pixels of a window of 1600 by 900."""


def main():
    """Cut, and reduce to a palette, which is enough for an interface."""
    source = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "out" / "window" / "newcomer"
    for name, part in PARTS.items():
        target = ROOT / "docs" / "pictures" / name
        with Image.open(source / name) as picture:
            picture.convert("RGB").crop(part).quantize(256, dither=Image.Dither.NONE).save(target, optimize=True)
        print(f"{target.relative_to(ROOT)}: {target.stat().st_size / 1024:.0f} KiB")


if __name__ == "__main__":
    main()
