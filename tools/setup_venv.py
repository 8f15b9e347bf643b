"""Make the virtual environment that tests, tools and the demo run in; nothing to do costs nothing.

    python tools/setup_venv.py [--venv .venv] [--bpy 5.2 | --site]

The packages are those of requirements/bpy-VERSION.txt, or of requirements/site.txt for the site, which needs no
Blender; all at exact versions. A stamp in the environment
holds the hash of these pins: when it fits, nothing is done. An environment whose packages already fit is
adopted as it is; one of another Python is refused, never deleted.
"""

import argparse
import ctypes
import hashlib
import subprocess
import sys
from pathlib import Path

REQUIREMENTS = Path(__file__).resolve().parent.parent / "requirements"
SITE = REQUIREMENTS / "site.txt"
STAMP = "facet_film_pins"
BLENDER = "bpy=="
"""What the last pin of an environment with Blender begins with."""
DEFAULT_BPY = {"3.11": "4.5.15", "3.13": "5.2.3"}

# What bpy's library is linked against (EGL it opens by itself, for EEVEE), and the Debian package of each.
SYSTEM_LIBRARIES = {
    "libX11.so.6": "libx11-6",
    "libXext.so.6": "libxext6",
    "libXrender.so.1": "libxrender1",
    "libXfixes.so.3": "libxfixes3",
    "libXi.so.6": "libxi6",
    "libxkbcommon.so.0": "libxkbcommon0",
    "libSM.so.6": "libsm6",
    "libICE.so.6": "libice6",
    "libGL.so.1": "libgl1",
    "libEGL.so.1": "libegl1",
}

LIST_INSTALLED = """
from importlib.metadata import distributions
for found in distributions():
    print(found.metadata["Name"].lower().replace("_", "-") + "==" + found.version)
"""


class SetupError(Exception):
    """Why the environment cannot be set up, as one sentence for the person at the terminal."""


def missing_libraries():
    """Debian packages of the system libraries that bpy needs and this Linux lacks.

    >>> set(missing_libraries()) <= set(SYSTEM_LIBRARIES.values())
    True
    """
    if not sys.platform.startswith("linux"):
        return []
    missing = []
    for library, package in SYSTEM_LIBRARIES.items():
        try:
            ctypes.CDLL(library)
        except OSError:
            missing.append(package)
    return missing


def running_python():
    """Version of the running Python as the requirement files name it, like "3.11"."""
    return f"{sys.version_info.major}.{sys.version_info.minor}"


def requirement_file(bpy):
    """The requirement file of a Blender version, "5.2" or "5.2.3"; without one, this Python's default."""
    bpy = bpy or DEFAULT_BPY.get(running_python(), "")
    known = sorted(path.stem.removeprefix("bpy-") for path in REQUIREMENTS.glob("bpy-*.txt"))
    found = [version for version in known if bpy and f"{version}.".startswith(f"{bpy}.")]
    if len(found) != 1:
        raise SetupError(f"bpy {bpy or 'for Python ' + running_python()} is not pinned here; "
                         f"choose one of {', '.join(known)}.")
    return REQUIREMENTS / f"bpy-{found[0]}.txt"


def pins_of(path):
    """The pinned packages ("name==version") of a requirement file and of those that it includes."""
    pins = []
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("-r "):
            pins += pins_of(path.parent / line[3:].strip())
        elif line and not line.startswith("#"):
            pins.append(line.strip())
    return pins


def required_python(path):
    """The Python version that a requirement file is for: the one it includes by name; without one any will do."""
    included = [line for line in path.read_text(encoding="utf-8").splitlines() if line.startswith("-r ")]
    return included[0].removeprefix("-r python-").removesuffix(".txt") if included else running_python()


def answer(python, code):
    """What a Python program prints, or None when it fails."""
    try:
        done = subprocess.run([python, "-c", code], capture_output=True, text=True)
    except OSError:
        return None
    return done.stdout if done.returncode == 0 else None


def make_environment(venv, version):
    """Make the environment unless a sound one of the right Python is there; return its Python."""
    python = venv / "bin" / "python"
    if venv.is_dir() and any(venv.iterdir()) and not (venv / "pyvenv.cfg").exists():
        raise SetupError(f"{venv} is there and is no virtual environment; choose another with VENV=.")
    if answer(python, "import pip") is None:
        print(f"Making {venv} with Python {version} …", flush=True)
        if subprocess.run([sys.executable, "-m", "venv", venv]).returncode != 0:
            raise SetupError(f"{sys.executable} -m venv {venv} failed; on Debian install python{version}-venv.")
    there = (answer(python, "import sys; print('%d.%d' % sys.version_info[:2])") or "none").strip()
    if there != version:
        raise SetupError(f"{venv} holds Python {there} where {version} is asked for; "
                         "delete it or choose another with VENV=.")
    return python


def install(python, requirements, pins):
    """Install what differs from the pins, and see that nothing unpinned is wanted by any of them."""
    installed = set((answer(python, LIST_INSTALLED) or "").split())
    if set(pins) <= installed:
        return
    size = " (about 1 GB with Blender)" if pins[-1].startswith(BLENDER) else ""
    print(f"Installing the packages of {requirements.name}{size} …", flush=True)
    pip = [python, "-m", "pip", "--disable-pip-version-check"]
    if subprocess.run([*pip, "install", "--quiet", "--no-deps", "-r", requirements]).returncode != 0:
        raise SetupError(f"{pins[-1]} and its companions could not be installed: pip's message is above.")
    if subprocess.run([*pip, "check"], stdout=subprocess.DEVNULL).returncode != 0:
        raise SetupError(f"The pins of {requirements.name} do not fit together: run {python} -m pip check.")


def see_that_blender_starts(python, bpy):
    """Import bpy once; where it does not start, name the system libraries that it misses."""
    done = subprocess.run([python, "-c", "import bpy"], capture_output=True, text=True)
    if done.returncode != 0:
        missing = missing_libraries()
        way_out = f"; on Debian: apt-get install {' '.join(missing)}" if missing else ""
        reason = (done.stderr.strip().splitlines() or [f"exit status {done.returncode}"])[-1]
        raise SetupError(f"{bpy} is installed and does not start ({reason}){way_out}.")


def set_up(venv, requirements):
    """Bring the environment to the pins of a requirement file, doing only what is still to do."""
    version = required_python(requirements)
    if running_python() != version:
        raise SetupError(f"{requirements.stem} is for Python {version}, and this is {running_python()}: "
                         f"name a Python {version} with PYTHON=.")
    pins = pins_of(requirements)
    stamp = venv / STAMP
    fingerprint = hashlib.sha256("\n".join([version, *pins]).encode()).hexdigest()
    if stamp.exists() and stamp.read_text().strip() == fingerprint:
        return
    python = make_environment(venv, version)
    install(python, requirements, pins)
    if pins[-1].startswith(BLENDER):
        see_that_blender_starts(python, pins[-1])
    stamp.write_text(fingerprint + "\n")
    print(f"{venv} is ready: {pins[-1]} on Python {version}.", flush=True)


def main():
    """Read the command line, set up, and say in one sentence what went wrong if something did."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--venv", type=Path, default=Path(".venv"), help="where the environment is (.venv)")
    parser.add_argument("--bpy", default="", help="Blender version, such as 5.2 (default: by Python)")
    parser.add_argument("--site", action="store_true", help="what the site is built and tested with, without Blender")
    parser.add_argument("--missing-libraries", action="store_true",
                        help="only print the Debian packages of system libraries that bpy misses here")
    arguments = parser.parse_args()
    if arguments.missing_libraries:
        print(*missing_libraries())
        return
    try:
        set_up(arguments.venv, SITE if arguments.site else requirement_file(arguments.bpy))
    except SetupError as error:
        sys.exit(f"Set-up failed: {error}")


if __name__ == "__main__":
    main()
