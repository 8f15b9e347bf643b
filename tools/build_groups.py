"""Builds the library node_groups/groups from the formulas, on the oldest Blender supported.

    python tools/build_groups.py [--out FOLDER]

A file for every group but those of OSL, whose compiled code belongs to one
Blender version.  A text in each, the stamp, is the hash of the sources that the
groups are built from; a test compares it with the sources as they are.
"""

import argparse
import hashlib
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

import bpy  # noqa: E402

from addon.blender.groups import (FAST_OF, FINGERPRINT_KEY, GROUPS, LIBRARY, build_group,  # noqa: E402
                                  fingerprint, library_file)

__all__ = ["STAMP", "source_stamp", "build"]

STAMP = "facet_film_groups stamp"
OLDEST = (4, 5)


def source_stamp():
    """Hash of the sources that the groups are built from."""
    digest = hashlib.sha256()
    files = [ROOT / "addon" / "operands.py", *sorted((ROOT / "addon" / "nodes").glob("*.py")),
             *sorted((ROOT / "addon" / "reflectance").glob("*.py"))]
    for file in files:
        digest.update(file.name.encode() + file.read_bytes())
    return digest.hexdigest()


def build(folder):
    """Build every group anew and save each, compressed, with nothing else; (group, file) of each."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    stamp = bpy.data.texts.new(STAMP)
    stamp.write(source_stamp())
    folder.mkdir(parents=True, exist_ok=True)
    built = []
    for identifier, place in GROUPS.items():
        if not place.startswith("osl_groups"):
            group, file = build_group(identifier), folder / library_file(identifier).name
            if identifier not in FAST_OF:  # the others get a second shader when they are brought in
                group[FINGERPRINT_KEY] = fingerprint(group)
            bpy.data.libraries.write(str(file), {group, stamp}, fake_user=True, compress=True)
            built.append((group, file))
    return built


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--out", type=Path, default=LIBRARY, help="the folder to write into")
    options = parser.parse_args()
    if bpy.app.version[:2] != OLDEST:
        parser.error("build the groups on Blender {}.{}, whose files every later one opens".format(*OLDEST))
    for made, written in build(options.out):
        print(f"{written.name}: {len(made.nodes)} nodes, {written.stat().st_size / 1024:.0f} kB")
