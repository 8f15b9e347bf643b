"""Puts a release together: what a static host serves, and what goes beside it.

    python tools/release.py [--out dist/release]

The zip, the site and catalogue.json are built before (make release does all of it).  What comes out:

    index.html …            the site, with the catalogue's data
    extensions/             the zip, and index.json: the address to add in Blender under Get Extensions, Repositories
    facet_film-VERSION.zip  the same zip for those who drag it in
    NOTES.md                what is new, from CHANGELOG.md
    SHA256SUMS              of every file
"""

import argparse
import hashlib
import re
import shutil
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from tools.package import PackageError, extension_tool  # noqa: E402

SUMS = "SHA256SUMS"


class ReleaseError(Exception):
    """Why there is no release, as one sentence."""


def version(root=ROOT):
    """The version in the manifest."""
    return tomllib.loads((root / "blender_manifest.toml").read_text(encoding="utf-8"))["version"]


def notes(changes, of):
    """The section of a version in the text of CHANGELOG.md.

    >>> notes("# Changes\\n\\n## 0.2.0\\n\\n- New.\\n\\n## 0.1.0\\n\\n- Old.\\n", "0.2.0")
    '- New.\\n'
    >>> notes("## 0.1.0\\n", "0.2.0")
    Traceback (most recent call last):
    ...
    tools.release.ReleaseError: CHANGELOG.md says nothing of 0.2.0: write its section first.
    """
    found = re.search(rf"^## {re.escape(of)}\s*\n(.*?)(?=^## |\Z)", changes, re.MULTILINE | re.DOTALL)
    if not found or not found.group(1).strip():
        raise ReleaseError(f"CHANGELOG.md says nothing of {of}: write its section first.")
    return found.group(1).strip() + "\n"


def index_of_extensions(folder, package):
    """Write index.json beside a copy of the zip, by Blender's own generator."""
    folder.mkdir(parents=True)
    shutil.copy(package, folder)
    extension_tool("server-generate", f"--repo-dir={folder}", tagged=False)


def sums(folder):
    """A line a file, as `sha256sum -c` reads them, in the order of their names."""
    files = sorted(path for path in folder.rglob("*") if path.is_file() and path.name != SUMS)
    return "".join(f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.relative_to(folder).as_posix()}\n"
                   for path in files)


def assemble(out, package, site):
    """Make the folder of a release anew.

    package, site  paths of what was built

    Raises ReleaseError where one of them is missing or is of another version.
    """
    if package.name != f"facet_film-{version()}.zip" or not package.is_file():
        raise ReleaseError(f"{package} is not the zip of {version()}: run make release.")
    if not (site / "catalogue.json").is_file():
        raise ReleaseError(f"{site} holds no site: run make release.")
    said = notes((ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), version())
    shutil.rmtree(out, ignore_errors=True)
    shutil.copytree(site, out)
    shutil.copy(package, out)
    index_of_extensions(out / "extensions", package)
    (out / "NOTES.md").write_text(said, encoding="utf-8")
    (out / SUMS).write_text(sums(out), encoding="utf-8")


def main():
    """Put it together, and say what it holds."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=ROOT / "dist" / "release", help="folder, made anew (dist/release)")
    out = parser.parse_args().out
    try:
        assemble(out, ROOT / "dist" / f"facet_film-{version()}.zip", ROOT / "dist" / "site")
    except (ReleaseError, PackageError) as error:
        sys.exit(f"No release: {error}")
    print(f"{out}: {len((out / SUMS).read_text('utf-8').splitlines())} files of {version()}")


if __name__ == "__main__":
    main()
