"""The site's files by themselves: links, the catalogue's data against its schema, weights."""

import json
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit

import jsonschema
import pytest

from tools import build_site


class Page(HTMLParser):
    """The addresses that a page names, and the names of the places in it."""

    def __init__(self, text):
        super().__init__()
        self.addresses, self.places = [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src") and value:
                self.addresses.append(value)
            if name in ("id", "name") and value:
                self.places.add(value)


def dead_links(site):
    """(page, address) of everything that leads nowhere within the site."""
    pages = {path: Page(path.read_text(encoding="utf-8")) for path in site.rglob("*.html")}
    categories = {"#" + name for name in build_site.CATEGORIES}  # the script's own, of the catalogue
    found = []
    for path, page in pages.items():
        for address in page.addresses:
            parts = urlsplit(address)
            if parts.scheme or parts.netloc:
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            there = target.is_file() and (not parts.fragment or target.suffix != ".html"
                                          or parts.fragment in pages[target].places
                                          or target.name == "materials.html" and "#" + parts.fragment in categories)
            if not there:
                found.append((path.name, address))
    return found


def test_every_link_leads_somewhere(site):
    assert not dead_links(site)


def test_a_dead_link_is_seen(tmp_path):
    (tmp_path / "a.html").write_text('<a href="b.html">x</a> <a href="#c">y</a> <img src="a.html">')
    assert dead_links(tmp_path) == [("a.html", "b.html"), ("a.html", "#c")]


def test_no_page_needs_another_host(site):
    for path in site.rglob("*.html"):
        for address in Page(path.read_text(encoding="utf-8")).addresses:
            loaded = address.endswith((".js", ".css", ".woff2", ".png", ".webp", ".jpg"))
            assert not loaded or not (address.startswith("//") or "://" in address)


def test_the_data_keeps_its_schema(site, data):
    schema = json.loads((site / "catalogue.schema.json").read_text(encoding="utf-8"))
    jsonschema.validate(data, schema)
    wrong = {**data, "materials": [{**data["materials"][0], "srgb": "red"}]}
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(wrong, schema)


def test_the_data_is_there_to_load_down(site, data):
    assert json.loads((site / "catalogue.json").read_text(encoding="utf-8")) == data


def test_pages_are_light(site, tmp_path):
    assert not build_site.heavy_pages(site)
    (tmp_path / "a.html").write_text('<img src="large.png">')
    (tmp_path / "large.png").write_bytes(bytes(build_site.MOST_BYTES + 1))
    assert build_site.heavy_pages(tmp_path) == ["a.html"]
