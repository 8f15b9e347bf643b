"""Build and validate the extension's zip with Blender's own tool, out of the bpy wheel.

    python tools/package.py [--out dist]

The zip is dist/facet_film-VERSION.zip, the same bytes whenever the same files are packed. Blender's tool
decides what goes in (blender_manifest.toml excludes what users do not need); a file outside SHIPPED that it
would pack stops the build.
"""

import argparse
import importlib.util
import subprocess
import sys
import tempfile
import tomllib
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from tools import build_assets, build_groups  # noqa: E402

SHIPPED = ("blender_manifest.toml", "__init__.py", "README.md", "LICENSE", "addon/", "node_groups/")
EARLIEST = (1980, 1, 1, 0, 0, 0)


class PackageError(Exception):
    """Why there is no zip, as one sentence."""


def blender_scripts():
    """The scripts folder of the installed bpy, found without importing it."""
    spec = importlib.util.find_spec("bpy")
    if spec is None:
        raise PackageError("bpy is not installed for this Python; run make package.")
    return next(Path(spec.origin).parent.glob("*/scripts"))


def extension_tool(*arguments, tagged=True):
    """Run Blender's extension tool; tagged: with the list of tags that its own command line checks against."""
    scripts = blender_scripts()
    tool = scripts / "addons_core" / "bl_pkg" / "cli" / "blender_ext.py"
    tags = scripts / "modules" / "_bpy_internal" / "extensions" / "tags.py"
    command = [sys.executable, "-B", tool, *arguments, *([f"--valid-tags={tags}"] if tagged else [])]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise PackageError(f"Blender's extension tool refused ({arguments[0]}): {done.stdout}{done.stderr}")


def check_shipped(names):
    """Raise PackageError naming the files that users would get and do not need.

    >>> check_shipped(["__init__.py", "addon/cli.py"])
    >>> check_shipped(["notes.txt"])
    Traceback (most recent call last):
    ...
    tools.package.PackageError: The zip would hold notes.txt: exclude it in blender_manifest.toml.
    """
    extra = [name for name in names if not any(
        name == entry or entry.endswith("/") and name.startswith(entry) for entry in SHIPPED)]
    if extra:
        raise PackageError(f"The zip would hold {', '.join(extra)}: exclude it in blender_manifest.toml.")


def repack(source, target):
    """Write the zip anew in sorted order, without times and owners, so that it is reproducible."""
    with zipfile.ZipFile(source) as packed, zipfile.ZipFile(target, "w") as fixed:
        check_shipped(packed.namelist())
        for name in sorted(packed.namelist()):
            entry = zipfile.ZipInfo(name, EARLIEST)
            entry.external_attr = 0o644 << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            fixed.writestr(entry, packed.read(name), compresslevel=9)


def build(folder, root=ROOT):
    """Build the extension in the checkout `root` into `folder`, validated; return the zip's path."""
    if root == ROOT:
        build_groups.ensure()
        build_assets.ensure()
    manifest = tomllib.loads((root / "blender_manifest.toml").read_text(encoding="utf-8"))
    target = Path(folder) / f"{manifest['id']}-{manifest['version']}.zip"
    target.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        as_built = Path(scratch) / target.name
        extension_tool("build", f"--source-dir={root}", f"--output-filepath={as_built}")
        fixed = Path(scratch) / "fixed" / target.name
        fixed.parent.mkdir()
        repack(as_built, fixed)
        extension_tool("validate", str(fixed))
        target.write_bytes(fixed.read_bytes())
    return target


def main():
    """Build, and say what came out."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=ROOT / "dist", help="folder of the zip (dist)")
    try:
        path = build(parser.parse_args().out)
    except PackageError as error:
        sys.exit(f"No package: {error}")
    with zipfile.ZipFile(path) as made:
        print(f"{path}: {len(made.namelist())} files, {path.stat().st_size / 1024:.0f} KiB, valid.")


if __name__ == "__main__":
    main()
