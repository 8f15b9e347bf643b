"""The real zip in places that break other software: odd paths and locales, profiles that cannot be written, no room
on the disk, two at once, and killed in the middle."""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import zipfile
from pathlib import Path

import pytest

SESSION = Path(__file__).with_name("session_in_circumstances.py")
FORMS = ("copper.json", "copper.csv", "copper.mtlx", "spectrum.csv")


def unpacked(package, folder):
    """The extension as Blender unpacks it."""
    folder.mkdir(parents=True)
    with zipfile.ZipFile(package) as packed:
        packed.extractall(folder)
    return folder


@pytest.fixture(scope="module")
def extension(package, tmp_path_factory):
    return unpacked(package, tmp_path_factory.mktemp("plain") / "extension")


def start(extension, out, **environment):
    """The session, running."""
    out.mkdir(parents=True, exist_ok=True)
    inherited = {key: value for key, value in os.environ.items() if key not in ("PYTHONPATH", "LC_ALL", "LANG")}
    return subprocess.Popen([sys.executable, "-P", SESSION, extension, out], cwd=out, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env={**inherited, **environment})


def finished(process, out):
    """(report, exported texts) once the session is through."""
    said, _ = process.communicate(timeout=300)
    assert process.returncode == 0, said[-2000:]
    report = json.loads((out / "report.json").read_text(encoding="utf-8"))
    return report, {form: (out / form).read_text(encoding="utf-8") for form in FORMS}


@pytest.fixture(scope="module")
def plain(extension, tmp_path_factory):
    out = tmp_path_factory.mktemp("plain_out")
    return finished(start(extension, out), out)


def rounded(text):
    """With nine digits a number: sums on several threads differ in the last."""
    return re.sub(r"-?\d+\.\d+(e-?\d+)?", lambda found: f"{float(found.group()):.9g}", text)


def assert_same(found, plain):
    """The same exports to the letter, the same pictures but for rounding."""
    for form in FORMS:
        assert rounded(found[1][form]) == rounded(plain[1][form])
    assert found[0]["exported"]["f0"] == pytest.approx(plain[0]["exported"]["f0"], rel=1e-9)
    for name, colour in plain[0]["rendered"].items():
        assert found[0]["rendered"][name] == pytest.approx(colour, rel=1e-4), name


def test_what_was_exported_bakes_to_the_same(plain):
    assert plain[0]["exported"]["again"] == pytest.approx(plain[0]["exported"]["f0"], rel=1e-9)
    assert all(min(colour) > 0.1 for colour in plain[0]["rendered"].values())


def test_a_path_with_spaces_and_letters_of_every_kind(package, plain, tmp_path):
    folder = tmp_path / "Ä b ø 材料 'x' & y"
    extension = unpacked(package, folder / "facet film")
    out, profile = folder / "aus gabe", folder / "pro fil"
    profile.mkdir()
    found = finished(start(extension, out, BLENDER_USER_RESOURCES=str(profile)), out)
    assert Path(found[0]["profile"]) == profile
    assert_same(found, plain)


def test_a_locale_with_a_decimal_comma(extension, plain, tmp_path):
    if shutil.which("localedef") is None:
        pytest.skip("localedef is not here to make a German locale with")
    made = tmp_path / "locales"
    made.mkdir()
    # It warns, and then ends with 1, where the system's charmap lacks something.
    subprocess.run(["localedef", "-c", "-i", "de_DE", "-f", "UTF-8", made / "de_DE.UTF-8"], capture_output=True)
    found = finished(start(extension, tmp_path / "out", LOCPATH=str(made), LC_ALL="de_DE.UTF-8"), tmp_path / "out")
    assert found[0]["comma"] == ","
    assert_same(found, plain)


def test_a_profile_that_cannot_be_written(extension, plain, tmp_path):
    """Not even by root: the system's folder of processes."""
    profile = "/proc/sys" if sys.platform.startswith("linux") else str(tmp_path / "missing")
    found = finished(start(extension, tmp_path / "out", BLENDER_USER_RESOURCES=profile), tmp_path / "out")
    assert found[0]["profile"] == profile
    assert_same(found, plain)


def test_two_blenders_at_once(extension, plain, tmp_path):
    """With one profile and one folder to export to."""
    profile, out = tmp_path / "profile", tmp_path / "out"
    profile.mkdir()
    both = [start(extension, out, BLENDER_USER_RESOURCES=str(profile)) for _ in range(2)]
    for process in both:
        assert_same(finished(process, out), plain)


EXPORT_FOR_EVER = """
import itertools, sys
from pathlib import Path
sys.path.insert(0, sys.argv[1])
from addon import export
from addon.bake import bake
texts = {form: export.json_text(bake(form).to_dict()) * 200 for form in ("copper", "gold", "silver")}
print("ready", flush=True)
for turn in itertools.count():
    for name, text in texts.items():
        export.write_text(Path(sys.argv[2]) / f"{name}.json", text)
"""


@pytest.mark.parametrize("after", [0.0, 0.01, 0.03, 0.07, 0.15, 0.3])
def test_killed_in_the_middle_of_an_export(extension, tmp_path, after):
    """Every file that bears its name is whole; what was being written is a hidden .part beside it."""
    process = subprocess.Popen([sys.executable, "-c", EXPORT_FOR_EVER, extension, tmp_path], stdout=subprocess.PIPE)
    assert process.stdout.readline() == b"ready\n"
    time.sleep(after)
    process.send_signal(signal.SIGKILL)
    process.wait()
    for path in tmp_path.iterdir():
        if path.name.startswith("."):
            assert path.suffix == ".part"
            continue
        text = path.read_text(encoding="utf-8")
        one = text[:len(text) // 200]
        assert text == one * 200 and json.loads(one)["name"] == path.stem


BAKE_ALL = """
import sys
sys.path.insert(0, sys.argv[1])
import bpy
from addon import api
from addon.catalogue.presets import names
for number, name in enumerate(names()):
    api.create_material(preset=name).use_fake_user = True
    if number % 3 == 0:
        path = f"{sys.argv[2]}/{number}.blend"
        bpy.ops.wm.save_as_mainfile(filepath=path, compress=False)
        print("saved", path, flush=True)
"""

OPEN = """
import sys
import bpy
bpy.ops.wm.open_mainfile(filepath=sys.argv[1])
assert len(bpy.data.materials) >= 1
print("materials", len(bpy.data.materials))
"""


@pytest.mark.parametrize("after", [0.0, 0.05])
def test_killed_during_a_bake_of_all(extension, tmp_path, after):
    """The file that was saved before opens, with what was baked until then.

    Each save has a file of its own: Blender takes the older file away before it gives the new one its name, so that
    killed between the two it leaves only the older one, as .blend1.
    """
    process = subprocess.Popen([sys.executable, "-P", "-c", BAKE_ALL, extension, tmp_path], stdout=subprocess.PIPE,
                               stderr=subprocess.DEVNULL, text=True)
    saved = []
    for line in process.stdout:
        saved += re.findall(r"^saved (.*)$", line.rstrip("\n"))
        if len(saved) == 3:
            break
    assert len(saved) == 3
    time.sleep(after)
    process.send_signal(signal.SIGKILL)
    process.wait()
    opened = subprocess.run([sys.executable, "-P", "-c", OPEN, saved[-1]], capture_output=True, text=True)
    assert opened.returncode == 0, opened.stderr[-2000:]
    found = int(re.search(r"^materials (\d+)$", opened.stdout, re.MULTILINE).group(1))
    assert found >= 7


FULL_DISK = """
import resource, signal, sys
from pathlib import Path
sys.path.insert(0, sys.argv[1])
from addon.cli import main
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (500, 500))
sys.exit(main(["bake", "copper", "--json", "-o", sys.argv[2]]))
"""


def test_no_room_on_the_disk(extension, tmp_path):
    """What was there stays, nothing else is left, and one sentence says why."""
    target = tmp_path / "copper.json"
    target.write_text("as it was")
    done = subprocess.run([sys.executable, "-B", "-c", FULL_DISK, extension, target], capture_output=True, text=True)
    assert done.returncode == 2
    assert "cannot be written: file too large" in done.stderr and len(done.stderr.splitlines()) == 1
    assert [path.name for path in tmp_path.iterdir()] == ["copper.json"] and target.read_text() == "as it was"
