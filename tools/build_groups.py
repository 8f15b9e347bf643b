"""Builds node_groups/facet_film_groups.blend from the formulas, on the oldest Blender supported.

    python tools/build_groups.py [--out FILE]

Holds every group but those of OSL, whose compiled code belongs to one Blender
version.  A text in the file, the stamp, is the hash of the sources that the
groups are built from; a test compares it with the sources as they are.
"""

import argparse
import hashlib
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

import bpy  # noqa: E402

from addon.blender.groups import GROUPS, LIBRARY, build_group  # noqa: E402

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


def build(path):
    """Build every group anew and save them, compressed, with nothing else."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    stamp = bpy.data.texts.new(STAMP)
    stamp.write(source_stamp())
    groups = [build_group(identifier) for identifier, place in GROUPS.items() if not place.startswith("osl_groups")]
    bpy.data.libraries.write(str(path), {*groups, stamp}, fake_user=True, compress=True)
    return groups


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--out", type=Path, default=LIBRARY, help="the .blend to write")
    options = parser.parse_args()
    if bpy.app.version[:2] != OLDEST:
        parser.error("build the groups on Blender {}.{}, whose files every later one opens".format(*OLDEST))
    for group in build(options.out):
        print(f"{group.name}: {len(group.nodes)} nodes")
    print(f"{options.out.name}: {options.out.stat().st_size / 1024:.0f} kB")
