"""Builds the site: the documents, the catalogue, a page a material.  Static files that need no server.

    python tools/build_site.py [--out dist/site] [--data dist/catalogue.json] [--only NAME ...]

Documents and materials are laid out in a folder that Sphinx turns into pages (tools/site holds its settings and the
templates).  A link that leads nowhere stops the build.
"""

import argparse
import json
import re
import shutil
import subprocess
import sys
import tempfile
import unicodedata
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from addon.catalogue.categories import CATEGORIES  # noqa: E402
from addon.export import json_text  # noqa: E402
from addon.models import named  # noqa: E402
from addon.models.making import exported, made  # noqa: E402
from tools import build_data  # noqa: E402

SITE = ROOT / "tools" / "site"
THUMBNAILS = ROOT / "addon" / "thumbnails"
AS_MATERIALX = "materialx"
RAW = "````{raw} html\n%s\n````\n"
SHOWN = re.compile(r'(?:src|href)="([^":#]+\.(?:png|jpe?g|webp|svg|css|js)(?:\?[^"]*)?)"')
TITLES = {"f0": "F0", "f82_tint": "F82 tint", "n": "n", "k": "k"}


UPSTAIRS = {"CONTRIBUTING.md": "contributing.md", "CHANGELOG.md": "changelog.md"}
"""Documents beside docs/, and where the site has them."""
MOST_BYTES = 3_000_000
"""That a page may weigh with all that it shows."""


class SiteError(Exception):
    """Why there is no site, as one sentence."""


def templates():
    """The templates of tools/site, which escape what they are given."""
    from jinja2 import Environment, FileSystemLoader  # of the site's environment, which is not Blender's
    return Environment(loader=FileSystemLoader(SITE), autoescape=True)


def plain(text):
    """Small letters without accents, as the search compares them.

    >>> plain("Fe₂O₃ Glänzend")
    'fe2o3 glanzend'
    """
    spread = unicodedata.normalize("NFKD", text.lower())
    return "".join(letter for letter in spread if not unicodedata.combining(letter))


def row_of(values):
    """A number or several, as people paste them.

    >>> row_of([0.5, 1.0]), row_of(1.5168)
    ('0.5000, 1.0000', '1.5168')
    """
    return ", ".join(f"{value + 0.0:.4f}" for value in (values if isinstance(values, list) else [values]))


def rows(one):
    """(what, value) of all numbers of a material's entry in the catalogue that people copy."""
    found = [("sRGB", one["srgb"])]
    for space, numbers in one["spaces"].items():
        of_space = {**numbers, **numbers.get("conductor", {})}
        found += [(f"{title}, linear {space}", row_of(of_space[name])) for name, title in TITLES.items()
                  if name in of_space]
        body = numbers.get("attenuation")
        if body and body["distance_m"]:
            found += [(f"Absorption σ in 1/m, linear {space}", row_of(body["sigma_per_m"])),
                      (f"Colour after {body['distance_m']:.4g} m, linear {space}", row_of(body["colour"]))]
    numbers = next(iter(one["spaces"].values()), {})
    found += [(title, row_of(value)) for title, value in (
        ("IOR", numbers.get("ior", {}).get("d")), ("Abbe number", numbers.get("abbe"))) if value]
    found += [("Stack of films", numbers["stack"])] if "stack" in numbers else []
    roughness = roughness_of(one["parameters"])
    return found + ([("Roughness", row_of(roughness))] if roughness is not None else [])


def roughness_of(parameters):
    """Roughness by Blender's convention, √m, of a model's parameters; None of one that has no slopes.

    >>> roughness_of({"slopes": [[0.25, 1.0]]}), roughness_of({"roughness": 0.3}), roughness_of({})
    (0.5, 0.3, None)
    """
    if "roughness" in parameters:
        return parameters["roughness"]
    return parameters["slopes"][0][0] ** 0.5 if "slopes" in parameters else None


def shown(one):
    """An entry of the catalogue with what its page shows beside it, and the files that it offers."""
    words = " ".join([one["title"], one["name"].replace("_", " "), *one["aliases"]])
    picture = next((path.name for path in THUMBNAILS.glob(f"{one['name']}.*")), "")
    return {**one, "words": plain(words), "picture": picture, "rows": rows(one), "files": files(one)}


def files(one):
    """(file's name, title, text) of each form that a material can be downloaded in."""
    record = made(preset=one["name"])
    found = [(f"{one['name']}.json", "JSON", json_text(one))]
    if AS_MATERIALX in named(record.model).forms and record.measured:
        found.append((f"{one['name']}.mtlx", "MaterialX", exported(record, AS_MATERIALX)))
    return found


def lay_out(folder, catalogue):
    """Write what Sphinx reads into a folder."""
    shutil.copytree(ROOT / "docs", folder, ignore=shutil.ignore_patterns("materials.md"), dirs_exist_ok=True)
    for name, target in UPSTAIRS.items():
        text = (ROOT / name).read_text(encoding="utf-8").replace("](docs/", "](")
        (folder / target).write_text(text, encoding="utf-8")
    for page in folder.glob("*.md"):
        text = page.read_text(encoding="utf-8")
        for name, target in UPSTAIRS.items():
            text = text.replace(f"](../{name})", f"]({target})")
        page.write_text(text, encoding="utf-8")
    shutil.copy(SITE / "index.md", folder)
    static = folder / "_static"
    shutil.copytree(THUMBNAILS, static / "thumbnails", ignore=shutil.ignore_patterns("group *"))
    for name in ("site.css", "catalogue.js", "material.js"):
        shutil.copy(SITE / name, static)
    extra = folder / "_extra"
    (extra / "downloads").mkdir(parents=True)
    (extra / "catalogue.json").write_text(json_text(catalogue), encoding="utf-8")
    shutil.copy(ROOT / "docs" / "catalogue.schema.json", extra)
    _materials(folder, catalogue["materials"])


def _materials(folder, entries):
    """A page and the files of each material, and the page of all."""
    order = list(CATEGORIES)
    pages = [shown(one) for one in sorted(entries, key=lambda one: order.index(one["category"]))]
    page, shelf = (templates().get_template(name) for name in ("material.html", "catalogue.html"))
    (folder / "material").mkdir()
    for one in pages:
        text = f"---\norphan: true\n---\n# {one['title']}\n\n" + RAW % page.render(one=one)
        (folder / "material" / f"{one['name']}.md").write_text(text, encoding="utf-8")
        for name, _, content in one["files"]:
            (folder / "_extra" / "downloads" / name).write_text(content, encoding="utf-8")
    used = {one["category"] for one in entries}
    (folder / "materials.md").write_text("# Materials\n\n" + RAW % shelf.render(
        materials=pages, categories={name: title.rpartition("/")[2] for name, title in CATEGORIES.items()
                                     if name in used}), "utf-8")


def build(out, catalogue):
    """Build the site of a catalogue, as build_data.catalogue() gives it, into a folder that is made anew."""
    with tempfile.TemporaryDirectory() as scratch:
        source = Path(scratch) / "source"
        lay_out(source, catalogue)
        command = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-c", SITE, "-d",
                   Path(scratch) / "trees", "-D", f"html_static_path={source / '_static'}",
                   "-D", f"html_extra_path={source / '_extra'}", source, Path(scratch) / "site"]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            raise SiteError(f"Sphinx refused:\n{done.stdout}{done.stderr}")
        _for_ears_and_keyboards(Path(scratch) / "site")
        shutil.rmtree(out, ignore_errors=True)
        shutil.copytree(Path(scratch) / "site", out, ignore=shutil.ignore_patterns(".buildinfo", "objects.inv"))
    return out


def _for_ears_and_keyboards(site):
    """What readers without a screen or a mouse need and Sphinx leaves out: a level for the captions of its menus, which
    have the role of a heading; and code that is wider than a phone is scrolled by keys once it can be reached.
    """
    for page in site.rglob("*.html"):
        text = page.read_text(encoding="utf-8")
        text = text.replace('class="caption" role="heading"', 'class="caption" role="heading" aria-level="2"')
        page.write_text(text.replace("<pre>", '<pre tabindex="0">'), encoding="utf-8")


def heavy_pages(site):
    """The pages that weigh more than MOST_BYTES with their pictures, styles and scripts, each picture counted."""
    heavy = []
    for page in sorted(site.rglob("*.html")):
        text = page.read_text(encoding="utf-8")
        shown = {page, *((page.parent / name.partition("?")[0]).resolve() for name in SHOWN.findall(text))}
        if sum(path.stat().st_size for path in shown if path.is_file()) > MOST_BYTES:
            heavy.append(page.relative_to(site).as_posix())
    return heavy


def main():
    """Build, and say how large it is."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=ROOT / "dist" / "site", help="folder, made anew (dist/site)")
    parser.add_argument("--data", type=Path, help="catalogue.json, where it is made already")
    parser.add_argument("--only", nargs="+", default=(), metavar="NAME", help="these presets")
    options = parser.parse_args()
    found = json.loads(options.data.read_text("utf-8")) if options.data else build_data.catalogue(options.only)
    try:
        build(options.out, found)
    except SiteError as error:
        sys.exit(f"No site: {error}")
    if heavy := heavy_pages(options.out):
        sys.exit(f"Heavier than {MOST_BYTES / 1e6:.0f} MB: {', '.join(heavy)}")
    sizes = [path.stat().st_size for path in options.out.rglob("*") if path.is_file()]
    print(f"{options.out}: {len(sizes)} files, {sum(sizes) / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
