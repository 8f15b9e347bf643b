"""What the documents link to is there, and what is generated is small and says where it is from."""

import re
from pathlib import Path

import pytest
from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
DOCUMENTS = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / "CHANGELOG.md", *sorted((ROOT / "docs").glob("*.md"))]
PICTURES = sorted((ROOT / "docs" / "pictures").iterdir())
MOST_BYTES = {"poster.jpg": 1_500_000}
"""Of a sheet that shows hundreds."""
LINK = re.compile(r"\]\((?!https?:|#)([^)#\s]+)")


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_links_lead_somewhere(document):
    for target in LINK.findall(document.read_text(encoding="utf-8")):
        assert (document.parent / target).exists(), f"{document.name} links to {target}"


def test_every_picture_is_shown():
    shown = "".join(document.read_text(encoding="utf-8") for document in DOCUMENTS)
    assert PICTURES
    assert not [picture.name for picture in PICTURES if f"pictures/{picture.name}" not in shown]


def generator_of(picture):
    """The script that made a picture: named in it, or the one that names the picture."""
    with Image.open(picture) as image:
        note = str(image.info.get("Source") or image.info.get("comment", b"").decode())
    found = re.fullmatch(r"Made by (demo_blend/\w+\.py)", note)
    if found:
        return ROOT / found.group(1)
    scripts = [*(ROOT / "tools").glob("*.py"), *(ROOT / "tests" / "bench").glob("*.py")]
    return next((path for path in scripts if picture.name in path.read_text(encoding="utf-8")), None)


@pytest.mark.parametrize("picture", PICTURES, ids=lambda path: path.name)
def test_pictures_have_a_generator_and_are_small(picture):
    assert picture.stat().st_size <= MOST_BYTES.get(picture.name, 500_000)
    generator = generator_of(picture)
    assert generator and generator.is_file()
    assert generator.parent.name != "demo_blend" or picture.name.startswith(generator.stem)


def test_pictures_are_small_together():
    assert sum(picture.stat().st_size for picture in PICTURES) < 12_000_000
