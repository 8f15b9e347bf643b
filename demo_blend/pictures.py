"""Pictures as arrays: reading, labelling, laying out in a sheet, writing small."""

from pathlib import Path

import numpy as np
from matplotlib import get_data_path
from PIL import Image, ImageDraw, ImageFont

__all__ = ["read", "labelled", "annotated", "face", "row", "column", "strip", "write", "INK", "PAPER"]

INK = (232, 232, 230)
PAPER = (24, 25, 28)
MOST_BYTES = 480_000
"""Of one picture in docs: small enough to load at once, and to keep in a repository."""


def read(path):
    """An 8-bit RGB picture, (rows, columns, 3)."""
    with Image.open(path) as found:
        return np.asarray(found.convert("RGB"))


def labelled(picture, text, *, size=None):
    """The picture with lines of text on a strip below it; the first line is the stronger one."""
    rows, columns = picture.shape[:2]
    size = max(6, size or max(11, columns // 28))
    lines = text.split("\n")
    below = Image.new("RGB", (columns, int(size * (1.45 * len(lines) + 0.9))), PAPER)
    draw = ImageDraw.Draw(below)
    for j, line in enumerate(lines):
        type_face = face(line, size if j == 0 else max(6, int(size * 0.86)), columns - size, bold=j == 0)
        draw.text((columns / 2, size * (1.15 + 1.45 * j)), line, INK if j == 0 else (170, 172, 175),
                  font=type_face, anchor="mm")
    return np.concatenate([picture, np.asarray(below)], axis=0)


def annotated(picture, labels, *, size):
    """The picture with words centred at places given as shares of its width and, from below, of its height."""
    image = Image.fromarray(picture)
    draw = ImageDraw.Draw(image)
    for text, x, y in labels:
        draw.text((x * image.width, (1.0 - y) * image.height), text, INK, anchor="mm",
                  font=face(text, max(6, round(size)), image.width, bold=False))
    return np.asarray(image)


def face(line, size, width, bold=False):
    """The type at this size, or smaller where the line would not fit."""
    path = Path(get_data_path()) / "fonts" / "ttf" / ("DejaVuSans-Bold.ttf" if bold else "DejaVuSans.ttf")
    found = ImageFont.truetype(path, size)
    length = found.getlength(line)
    return found if length <= width else ImageFont.truetype(path, max(6, int(size * width / length)))


def row(pictures, gap=6):
    """Pictures side by side; lower ones are filled up below."""
    tallest = max(len(picture) for picture in pictures)
    filled = [_filled(picture, tallest - len(picture), 0) for picture in pictures]
    between = np.full((tallest, gap, 3), PAPER, np.uint8)
    parts = [part for picture in filled for part in (picture, between)]
    return np.concatenate(parts[:-1], axis=1)


def column(pictures, gap=6):
    """Pictures below each other; narrower ones are filled up at the right."""
    widest = max(picture.shape[1] for picture in pictures)
    filled = [_filled(picture, 0, widest - picture.shape[1]) for picture in pictures]
    between = np.full((gap, widest, 3), PAPER, np.uint8)
    parts = [part for picture in filled for part in (picture, between)]
    return np.concatenate(parts[:-1], axis=0)


def strip(text, width, size=15):
    """A line of text of its own, as a picture of this width."""
    return labelled(np.empty((0, width, 3), np.uint8), text, size=size)


def _filled(picture, below, right):
    padding = np.full((picture.shape[0] + below, picture.shape[1] + right, 3), PAPER, np.uint8)
    padding[:picture.shape[0], :picture.shape[1]] = picture
    return padding


def write(picture, path, generator, most_bytes=MOST_BYTES):
    """Write a .jpg or .png that names its generator; a .jpg at the best quality that stays small."""
    path = Path(path)
    note = f"Made by {generator}"
    image = Image.fromarray(np.ascontiguousarray(picture))
    if path.suffix == ".png":
        from PIL.PngImagePlugin import PngInfo
        about = PngInfo()
        about.add_text("Source", note)
        image.save(path, pnginfo=about, optimize=True)
        return path
    for quality in (93, 90, 86, 80, 72):
        image.save(path, quality=quality, subsampling=0, optimize=True, comment=note.encode())
        if path.stat().st_size <= most_bytes:
            break
    return path
