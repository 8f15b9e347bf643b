"""Every snippet and command of the documents works as it stands there; a farm needs no extension."""

import re
import shlex
import subprocess
import sys
from pathlib import Path

import bpy
import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "unit"))

from brdf_files import points_text  # noqa: E402

from addon import api  # noqa: E402
from addon.cli import main  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
DOCUMENTS = {path.name: path.read_text(encoding="utf-8") for path in sorted((ROOT / "docs").glob("*.md"))}
HEADLESS = re.findall(r"```python\n(.*?)```", DOCUMENTS["headless.md"], re.S)
WRITTEN = (["copper.png"], ["library.blend"], ["metals.blend", "metals.json"])
GOLD = "wavelength_nm,n,k\n400,1.66,1.96\n550,0.43,2.46\n700,0.13,4.07\n"

MINUTES = "python -m addon verify"
"""Has tests of its own, and takes minutes."""

RENDER = """
import sys, bpy
try:
    import addon
except ImportError:
    pass
else:
    sys.exit("the extension is there")
bpy.ops.wm.open_mainfile(filepath=sys.argv[1])
bpy.context.scene.render.filepath = sys.argv[2]
bpy.ops.render.render(write_still=True)
"""


@pytest.mark.parametrize("snippet, written", list(zip(HEADLESS, WRITTEN, strict=True)))
def test_headless_example_runs(snippet, written, tmp_path, monkeypatch):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    monkeypatch.chdir(tmp_path)
    exec(snippet, {})
    assert [name for name in written if (tmp_path / name).stat().st_size > 100] == written


def test_snippets_on_own_data_run(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "gold.csv").write_text(GOLD, encoding="utf-8")
    snippets = re.findall(r"```python\n(.*?)```", DOCUMENTS["own_data.md"], re.S)
    assert snippets
    for snippet in snippets:
        exec(snippet, {})


@pytest.mark.parametrize("document, found", [
    ("brushed_copper.md", {"Cube": ["Copper"]}), ("anodised_ring.md", {"Torus": ["Anodised titanium"]}),
    ("glass_of_water.md", {"Glass": ["Clear glass, low iron"], "Wall": ["Water against glass"], "Surface": ["Water"]}),
    ("for_pipelines.md", {})])
def test_snippets_of_the_first_pages_and_the_tutorials_run(document, found):
    """In an empty file, one after the other; then these objects have these materials."""
    from demo_blend.tutorials import snippets
    bpy.ops.wm.read_factory_settings(use_empty=True)
    assert snippets(document)
    for snippet in snippets(document):
        exec(snippet, {})
    assert {one.name: [slot.name for slot in one.material_slots] for one in bpy.data.objects} == found


def commands(prefix):
    """Commands of the documents that begin so, indented or in backticks, with nothing left to fill in."""
    found = [command for text in DOCUMENTS.values()
             for command in re.findall(rf"(?:^    |`)(python -m {prefix}[ .][^`\n]+)", text, re.M)]
    return sorted(set(found) - {command for command in found if command.startswith(MINUTES)})


def test_there_are_commands():
    assert commands("addon") and commands("demo_blend")


@pytest.mark.parametrize("command", commands("addon"))
def test_addon_command_runs(command, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "gold.csv").write_text(GOLD, encoding="utf-8")
    words = shlex.split(command.replace("TEXT", "copper").replace("FILE", "gold.csv"))[3:]
    if words[0] == "fit":
        (tmp_path / "gold.csv").write_text(points_text(lambda v, _l: np.full((len(v), 3), 0.1)), encoding="utf-8")
    assert main(words) == 0
    assert capsys.readouterr().out.strip()


@pytest.mark.parametrize("command", commands("demo_blend"))
def test_demo_command_runs(command, tmp_path, monkeypatch):
    from demo_blend import figures
    monkeypatch.chdir(tmp_path)
    assert figures.main(shlex.split(command)[3:]) == 0


@pytest.mark.parametrize("realisation", ["fast", "exact"])
def test_a_saved_file_renders_the_same_without_the_extension(realisation, tmp_path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.mesh.primitive_uv_sphere_add()
    bpy.context.object.data.materials.append(api.create_material(preset="copper", realisation=realisation))
    bpy.ops.object.light_add(type="SUN", rotation=(0.6, 0.4, 0.0))
    bpy.ops.object.camera_add(location=(0.0, 0.0, 6.0))
    scene = bpy.context.scene
    scene.camera = bpy.context.object
    scene.render.engine, scene.cycles.samples = "CYCLES", 4
    scene.render.resolution_x = scene.render.resolution_y = 32
    here, there, file = (str(tmp_path / name) for name in ("here.png", "there.png", "shot.blend"))
    scene.render.filepath = here
    bpy.ops.render.render(write_still=True)
    bpy.ops.wm.save_as_mainfile(filepath=file)
    script = tmp_path / "render.py"
    script.write_text(RENDER, encoding="utf-8")
    subprocess.run([sys.executable, script, file, there], cwd=tmp_path, check=True, capture_output=True)
    from demo_blend.pictures import read
    assert np.ptp(read(here)) > 60
    assert (read(here) == read(there)).all()


def test_make_knows_what_the_documents_tell_to_make():
    text = "\n".join([(ROOT / "README.md").read_text(encoding="utf-8"), *DOCUMENTS.values()])
    targets = set(re.findall(r"(?:^    |`)make ([a-z-]+)", text, re.M))
    assert {"demo", "figures", "test"} <= targets
    for target in targets:
        done = subprocess.run(["make", "-n", target], cwd=ROOT, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
