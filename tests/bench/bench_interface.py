"""How long the interface lets one wait: enabling, drawing, a preset, a keystroke; each in fresh Blenders.

    python tests/bench/bench_interface.py [--runs 5] [--json]

The real zip is installed into an empty profile and everything done once, so that its modules are compiled as they are
for everyone from the second start on. Each figure is the median over the runs, in processor time. "First" is the first
time in a session, with everything that is loaded for it, of presets and search after the panel has been drawn once, as
there is nothing to click before, and of presets after what a window loads while it is idle; "later" is the slowest
after that, of drawing the median. Drawing is of every panel of the Properties editor, opened, without what Blender
does then with its layout.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from tools.package import build  # noqa: E402  (the checkout has to be on the path first)

SESSION = Path(__file__).with_name("session_of_interface.py")
BARS_MS = {"enable": 50, "draw": 3, "preset": 50, "search": 30}
SHOWN = {"enable": "enable the extension", "draw": "draw every panel", "preset": "change a preset",
         "search": "a keystroke in the search over the whole database"}
HELD = {"enable": ("later",), "draw": ("later",), "preset": ("first", "later"), "search": ("first", "later")}
"""What has to keep to the bar: of drawing every redraw, as the first one loads the lists of presets."""
INSTALL = """
import bpy, sys
bpy.ops.extensions.package_install_files(filepath=sys.argv[1], repo="user_default", enable_on_install=False)
"""


def measure(runs):
    """{what: {"first": ms, "later": ms}}, medians of that many fresh Blenders each.

    Of enabling, which is done once a session, "first" is the time right after installing.
    """
    with tempfile.TemporaryDirectory() as folder:
        profile = Path(folder) / "profile"
        profile.mkdir()
        environment = {**os.environ, "BLENDER_USER_RESOURCES": str(profile)}
        environment.pop("PYTHONDONTWRITEBYTECODE", None)  # Blender itself keeps what it compiled

        def blender(*arguments):
            done = subprocess.run([sys.executable, *arguments], cwd=folder, env=environment, capture_output=True,
                                  text=True)
            if done.returncode:
                raise SystemExit(done.stdout + done.stderr)
            return done.stdout

        def session(what):
            return json.loads(blender(str(SESSION), what).split("took")[1].splitlines()[0])

        blender("-c", INSTALL, str(build(folder)))
        cold = session("enable")["first"]
        for what in BARS_MS:
            session(what)  # compiles what enabling leaves for later
        found = {what: _medians([session(what) for _ in range(runs)]) for what in BARS_MS}
        found["enable"]["first"] = cold
        return found


def _medians(taken):
    return {name: statistics.median(one[name] for one in taken) for name in taken[0]}


def exceeded(found):
    """What takes longer than its bar."""
    return [what for what, bar in BARS_MS.items() if max(found[what][name] for name in HELD[what]) > bar]


def table(found):
    """The figures as lines of Markdown."""
    lines = ["| | first | later | at most |", "|---|---|---|---|"]
    for what, bar in BARS_MS.items():
        figures = " | ".join(f"{found[what][name]:.1f} ms" for name in ("first", "later"))
        lines.append(f"| {SHOWN[what]} | {figures} | {bar} ms |" + (" EXCEEDED" if what in exceeded(found) else ""))
    return "\n".join(lines)


def main():
    """Measure, print, and fail above a bar."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--json", action="store_true",
                        help="for machines: one line, after what building the zip says")
    options = parser.parse_args()
    found = measure(options.runs)
    print(f"measured {json.dumps(found)}" if options.json else table(found))
    sys.exit(bool(exceeded(found)) and not options.json)


if __name__ == "__main__":
    main()
