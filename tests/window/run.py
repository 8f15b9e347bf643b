"""Runs the sessions of this folder in a real Blender with a real window, and says which step of which failed.

    python tests/window/run.py --blender COMMAND [--out FOLDER]

COMMAND starts a Blender with a display, or is a script that does and takes the same arguments. FOLDER (out/window)
gets a folder a session: its log, its pictures, its profile. A session that failed is run once more, within the first
five minutes. Exit status 1: a step failed; 3: that Blender opened no window, so nothing was tested.
"""

import argparse
import json
import os
import shlex
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT))

from tools.package import build  # noqa: E402

TUTORIALS = {"tutorial_copper": "brushed_copper.md", "tutorial_ring": "anodised_ring.md",
             "tutorial_water": "glass_of_water.md"}
"""Sessions of the documents' tutorials, which take their pictures; run by name, or all by "tutorials"."""
SESSIONS = ("newcomer", "picker", "panel", "layers", "shader_editor", "assets", "fitting", "exporting")
AT_MOST_S = 150
RETRY_UNTIL_S = 300
FAILED, NO_WINDOW = 1, 3
started = time.monotonic()


def main():
    """Run every session, print what was seen."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--blender", required=True, help="command that starts a Blender with a window")
    parser.add_argument("--out", type=Path, default=ROOT / "out" / "window")
    parser.add_argument("sessions", nargs="*", default=SESSIONS)
    options = parser.parse_args()
    blender = shlex.split(options.blender)
    if not blender or not shutil.which(blender[0]):
        sys.exit(f"--blender {options.blender!r}: no such program; give the path of a Blender, or a command that "
                 "starts one")
    out = options.out.resolve()
    package = build(out)
    sessions = TUTORIALS if list(options.sessions) == ["tutorials"] else options.sessions
    results = [twice(name, blender, package, out) for name in sessions]
    sys.exit(FAILED if FAILED in results else max(results))


def twice(name, blender, package, out):
    """Run a session, and once more where it failed."""
    for attempt in ("first", "second"):
        if attempt == "second" and time.monotonic() > started + RETRY_UNTIL_S:
            break
        folder = out / name
        shutil.rmtree(folder, ignore_errors=True)
        (folder / "profile").mkdir(parents=True)
        for file in HERE.glob("*.py"):
            shutil.copy(file, folder)
        if name in TUTORIALS:
            shutil.copy(ROOT / "docs" / TUTORIALS[name], folder)
        shutil.copy(package, folder / "facet_film.zip")
        start(blender, folder, name)
        result = judge(folder, name, attempt)
        if result != FAILED:
            return result
    return result


def start(blender, folder, name):
    """One Blender with an empty profile; what it says goes to console.txt. It is ended where it hangs."""
    command = [*blender, "--factory-startup", "--enable-event-simulate", "--python", str(folder / f"{name}.py")]
    environment = {**os.environ, "BLENDER_USER_RESOURCES": str(folder / "profile"), "WINDOW_TEST": str(folder)}
    with (folder / "console.txt").open("w", encoding="utf-8") as console, subprocess.Popen(
            command, env=environment, stdout=console, stderr=subprocess.STDOUT, start_new_session=True) as running:
        try:
            running.wait(AT_MOST_S)
        except subprocess.TimeoutExpired:
            os.killpg(running.pid, signal.SIGTERM)


def judge(folder, name, attempt):
    """Print a session's report."""
    log = folder / "log.txt"
    if not log.exists():
        console = (folder / "console.txt").read_text(encoding="utf-8", errors="replace")
        print(f"{name}: this Blender opened no window: {' | '.join(console.splitlines()[-3:])}")
        return NO_WINDOW
    file = folder / "report.json"
    if not file.exists():
        print(f"{name}, {attempt} attempt: FAILED, did not end within {AT_MOST_S} s. Its log:\n"
              f"{log.read_text(encoding='utf-8')}")
        return FAILED
    report = json.loads(file.read_text(encoding="utf-8"))
    passed = report["steps"][:-1] if report["failure"] else report["steps"]
    for text in passed:
        print(f"{name}: ok  {text}")
    for text in report["skipped"]:
        print(f"{name}: skipped  {text}")
    if report["failure"]:
        print(f"{name}, {attempt} attempt: FAILED at the step: {report['steps'][-1]}. {report['failure']}"
              f"The picture: {folder / 'failure.png'}")
    return FAILED if report["failure"] else 0


if __name__ == "__main__":
    main()
