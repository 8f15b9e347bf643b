"""Builds the library node_groups/groups from the formulas, where it is not there or its sources have changed.

    python tools/build_groups.py [--again] [--record]

A file for every group of a model, and one for the finishes; none for those of OSL, whose compiled code belongs to one
Blender version.  A file that an older Blender wrote opens in a newer one, so one library serves all.  --record writes
the groups' fingerprints into node_groups/versions.json, and refuses where a group has changed and its version has not.
"""

import argparse
import json
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from tools import packed_blend, stamps  # noqa: E402

__all__ = ["LIBRARY", "STAMP", "VERSIONS", "build", "ensure", "record", "why_not_recorded"]

LIBRARY = ROOT / "node_groups" / "groups"
STAMP = LIBRARY / "stamp.json"
VERSIONS = ROOT / "node_groups" / "versions.json"
"""{group: {version, fingerprint}}: what has been given to users or is about to be."""


def ensure(again=False):
    """Build the library unless it is current; whether it was built."""
    if not again and stamps.is_current(STAMP):
        return False
    start = time.perf_counter()
    build(LIBRARY)
    stamps.write(STAMP, stamps.loaded_sources())
    print(f"node groups built in {time.perf_counter() - start:.0f} s", flush=True)
    return True


def build(folder):
    """Build every group anew and save each file with nothing else; a line a group of how far it is."""
    import bpy

    from addon import models
    from addon.blender.datablocks import groups
    bpy.ops.wm.read_factory_settings(use_empty=True)
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*.blend"):
        old.unlink()  # a group that is brought in is taken from here
    wanted = [group for group in groups.all_groups() if not group.osl]
    files = {}
    for number, group in enumerate(wanted, 1):
        tree = groups.build_group(group.identifier)
        if not group.stand_in:  # the others get a second shader when they are brought in
            groups.mark(tree, group)
        files.setdefault(groups.library_file(group.identifier).name, set()).add(tree)
        print(f"{number}/{len(wanted)} {group.name}: {len(tree.nodes)} nodes", flush=True)
    # What the first click of a session brings in, as a rule.
    first = groups.library_file(models.named(models.DEFAULT).groups[0].identifier).name
    for name, trees in files.items():
        packed_blend.write(folder / name, trees, loosely=name == first)


def fingerprints():
    """{group: {version, fingerprint}} of all groups as they are built now."""
    import bpy

    from addon.blender.datablocks import fingerprints, groups
    bpy.ops.wm.read_factory_settings(use_empty=True)
    return {group.identifier: {"version": group.version,
                               "fingerprint": fingerprints.fingerprint(groups.node_group(group.identifier))}
            for group in groups.all_groups()}


def why_not_recorded(now, recorded):
    """What keeps each of the groups from being recorded: {group: sentence}.

    >>> one = {"g": {"version": 1, "fingerprint": "a"}}
    >>> why_not_recorded({"g": {"version": 1, "fingerprint": "b"}}, one)
    {'g': 'g computes something else than version 1 did: raise its version'}
    >>> why_not_recorded({"g": {"version": 2, "fingerprint": "b"}}, one)
    {}
    """
    return {name: f"{name} computes something else than version {found['version']} did: raise its version"
            for name, found in now.items()
            if name in recorded and found["version"] <= recorded[name]["version"] and found != recorded[name]}


def record():
    """Write versions.json; sentences on what is refused."""
    now = fingerprints()
    recorded = json.loads(VERSIONS.read_text(encoding="utf-8")) if VERSIONS.exists() else {}
    refused = why_not_recorded(now, recorded)
    if not refused:
        VERSIONS.write_text(json.dumps(now, indent=1) + "\n", encoding="utf-8")
    return refused


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--again", action="store_true", help="build even what is current")
    parser.add_argument("--record", action="store_true", help="write the fingerprints into versions.json")
    options = parser.parse_args()
    ensure(options.again)
    if options.record:
        sentences = record().values()
        if sentences:
            sys.exit("\n".join(sentences))
