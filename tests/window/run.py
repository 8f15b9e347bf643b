"""Runs the session of a newcomer in a real Blender with a real window, and judges its report.

    python tests/window/run.py --blender COMMAND [--out FOLDER]

COMMAND is a Blender, or a script that starts one and takes the same arguments; FOLDER
(out/window) gets the zip, the report and the pictures, and is Blender's profile.
"""

import argparse
import json
import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from tools.package import build  # noqa: E402

BUDGETS_MS = {"panel draw": 3.0, "change of preset": 50.0, "a keystroke in the search, at most": 30.0}
AT_MOST = 300


def main():
    """Run, print what was seen, and fail where something is not as it should be."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--blender", default="blender", help="command that starts a Blender (blender)")
    parser.add_argument("--out", type=Path, default=ROOT / "out" / "window")
    options = parser.parse_args()
    folder = options.out.resolve()
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "profile").mkdir(parents=True)
    shutil.move(build(folder), folder / "facet_film.zip")
    shutil.copy(Path(__file__).with_name("session.py"), folder)
    command = [*shlex.split(options.blender), "--factory-startup", "--enable-event-simulate", "--python",
               str(folder / "session.py")]
    done = subprocess.run(command, env={**os.environ, "BLENDER_USER_RESOURCES": str(folder / "profile")},
                          capture_output=True, text=True, timeout=AT_MOST, check=False)
    sys.exit(judge(folder / "report.json", done.stdout + done.stderr))


def judge(file, console):
    """Print the report; 1 where a step failed, a budget was missed or the console spoke of us."""
    if not file.exists():
        print(console[-3000:])
        return 1
    report = json.loads(file.read_text(encoding="utf-8"))
    for step in report["steps"]:
        print(f"ok  {step}")
    faults = [report["failure"]] if report["failure"] else []
    for name, took in report["ms"].items():
        budget = BUDGETS_MS.get(name)
        print(f"    {name}: {took:.1f} ms" + (f", budget {budget:.0f} ms" if budget else ""))
        if budget and took > budget:
            faults.append(f"{name} took {took:.1f} ms, budget {budget:.0f} ms")
    spoken = [line for line in console.splitlines() if "facet_film" in line.lower() and "facet_film.zip" not in line]
    faults += [f"the console says: {line}" for line in spoken]
    for fault in faults:
        print(f"FAILED  {fault}")
    return int(bool(faults))


if __name__ == "__main__":
    main()
