"""How long enabling the extension takes, in a fresh Blender each time; budget 50 ms.

    python tests/bench/bench_enable.py [--runs 7]

The zip is installed into an empty profile first; each run then starts a Blender, imports bpy, and times
addon_utils.enable alone, in processor time. The first run after installing compiles the modules and is told apart.
"""

import argparse
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from tools.package import build  # noqa: E402  (the checkout has to be on the path first)

BUDGET_MS = 50
INSTALL = """
import bpy, sys
bpy.ops.extensions.package_install_files(filepath=sys.argv[1], repo="user_default", enable_on_install=False)
"""
ENABLE = """
import time, bpy, addon_utils
start = time.process_time()
assert addon_utils.enable("bl_ext.user_default.facet_film") is not None
print("took", (time.process_time() - start) * 1000)
"""


def measure(runs):
    """Milliseconds of each run; the first one is cold."""
    with tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "BLENDER_USER_RESOURCES": str(Path(folder) / "profile")}
        environment.pop("PYTHONDONTWRITEBYTECODE", None)  # Blender itself keeps what it compiled
        Path(environment["BLENDER_USER_RESOURCES"]).mkdir()
        package = build(folder)

        def blender(code, *arguments):
            done = subprocess.run([sys.executable, "-c", code, *arguments], cwd=folder, env=environment,
                                  capture_output=True, text=True, check=True)
            return done.stdout

        blender(INSTALL, str(package))
        return [float(blender(ENABLE).split("took")[1]) for _ in range(runs)]


def main():
    """Measure, print, and fail above the budget."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=7)
    cold, *warm = measure(1 + parser.parse_args().runs)
    print(f"enable: {statistics.median(warm):.1f} ms (median of {len(warm)}), {max(warm):.1f} ms at most, "
          f"{cold:.1f} ms the first time after installing; budget {BUDGET_MS} ms")
    sys.exit(statistics.median(warm) > BUDGET_MS)


if __name__ == "__main__":
    main()
