"""All materials of the catalogue on one sheet, from the pictures that the picker shows: no rendering.

    python -m demo_blend.figures poster
"""

import numpy as np
from PIL import Image, ImageDraw

from .job import Figure
from .pictures import INK, PAPER, face

COLUMNS = 24
MOST_BYTES = 1_400_000
"""A sheet of some 450 pictures, which are looked at one by one."""
HEAD = "Facet & Film"


def poster(job):
    """Shelf by shelf, in the order of the catalogue; what is made from what is measured stands first."""
    from addon.catalogue.categories import CATEGORIES
    from addon.catalogue.entries import in_category
    sheet = Sheet(max(12, round(96 * job.scale)))
    shelves = {category: in_category(category) for category in CATEGORIES}
    sheet.heading(HEAD, f"{sum(map(len, shelves.values()))} materials, measured and modelled", 3.0)
    for category, entries in shelves.items():
        sheet.heading(CATEGORIES[category].split("/")[-1], str(len(entries)), 1.0)
        for first in range(0, len(entries), COLUMNS):
            sheet.row(entries[first:first + COLUMNS])
    job.write(sheet.picture(), "poster.jpg", most_bytes=MOST_BYTES)


class Sheet:
    """Rows of pictures and headings, below each other.

    side  of a picture, in pixels; everything else is measured by it
    """

    def __init__(self, side):
        self.side, self.gap = side, max(1, side // 12)
        self.margin = side // 2
        self.width = 2 * self.margin + COLUMNS * side + (COLUMNS - 1) * self.gap
        self.rows = [self._empty(self.margin)]

    def heading(self, title, about, scale):
        """A line of text, and a fainter one after it."""
        size = max(6, round(0.3 * scale * self.side))
        image = Image.fromarray(self._empty(round(1.9 * size)))
        draw = ImageDraw.Draw(image)
        bold, plain = face(title, size, self.width, bold=True), face(about, max(6, round(0.62 * size)), self.width)
        base = round(1.35 * size)
        draw.text((self.margin, base), title, INK, font=bold, anchor="ls")
        draw.text((self.margin + bold.getlength(title) + 0.5 * size, base), about, (150, 152, 156), font=plain,
                  anchor="ls")
        self.rows.append(np.asarray(image))

    def row(self, entries):
        """Materials side by side, their titles below."""
        from addon.catalogue.entries import thumbnail
        line = max(6, round(0.115 * self.side))
        image = Image.fromarray(self._empty(self.side + round(3.4 * line)))
        draw = ImageDraw.Draw(image)
        for column, entry in enumerate(entries):
            x = self.margin + column * (self.side + self.gap)
            with Image.open(thumbnail(entry.name)) as found:
                image.paste(found.convert("RGB").resize((self.side, self.side), Image.Resampling.LANCZOS), (x, 0))
            for number, words in enumerate(in_two_lines(entry.title)):
                draw.text((x + 0.5 * self.side, self.side + (0.9 + 1.15 * number) * line), words, INK, anchor="mm",
                          font=face(words, line, self.side + self.gap - 2))
        self.rows.append(np.asarray(image))

    def picture(self):
        """The whole sheet, (rows, columns, 3)."""
        return np.concatenate([*self.rows, self._empty(self.margin)], axis=0)

    def _empty(self, rows):
        return np.full((rows, self.width, 3), PAPER, np.uint8)


def in_two_lines(title):
    """The words of a title on one line, or parted where the longer of two lines is shortest.

    >>> in_two_lines("Copper"), in_two_lines("Anodised Aluminium, Space Grey")
    (['Copper'], ['Anodised', 'Aluminium, Space Grey'])
    """
    words = title.split()
    if len(title) <= 16 or len(words) == 1:
        return [title]
    parted = [[" ".join(words[:cut]), " ".join(words[cut:])] for cut in range(1, len(words))]
    return min(parted, key=lambda lines: max(map(len, lines)))


FIGURES = (Figure("poster", "All materials of the catalogue", 5.0, poster),)
