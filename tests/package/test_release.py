"""What a release holds: the index that Blender's repositories read, notes, checksums; one can install from it."""

import hashlib
import json
import os
import subprocess
import sys

import pytest

from tools import release

INSTALL = """
import bpy, json, sys
index, written = sys.argv[1:]
bpy.context.preferences.system.use_online_access = True
repo = bpy.context.preferences.extensions.repos.new(name="Facet & Film", module="theirs", remote_url=index)
place = list(bpy.context.preferences.extensions.repos).index(repo)
bpy.ops.extensions.repo_sync(repo_index=place)
done = bpy.ops.extensions.package_install(repo_index=place, pkg_id="facet_film", enable_on_install=True)
from bl_ext.theirs.facet_film.addon import api
open(written, "w").write(json.dumps([sorted(done), api.create_material(preset="gold").name]))
"""


@pytest.fixture(scope="module")
def released(package, tmp_path_factory):
    """The folder of a release with a site of one page."""
    site = tmp_path_factory.mktemp("site")
    (site / "index.html").write_text("<p>Facet and Film</p>", encoding="utf-8")
    (site / "catalogue.json").write_text("{}", encoding="utf-8")
    out = tmp_path_factory.mktemp("release") / "release"
    release.assemble(out, package, site)
    return out


def test_the_index_names_the_zip(released, package):
    listed, = json.loads((released / "extensions" / "index.json").read_text(encoding="utf-8"))["data"]
    assert listed["id"] == "facet_film" and listed["version"] == release.version()
    assert listed["archive_hash"] == "sha256:" + hashlib.sha256(package.read_bytes()).hexdigest()
    assert (released / "extensions" / listed["archive_url"]).is_file()


def test_every_file_has_its_sum(released):
    lines = (released / "SHA256SUMS").read_text(encoding="utf-8").splitlines()
    assert {line.split("  ")[1] for line in lines} == {
        path.relative_to(released).as_posix() for path in released.rglob("*") if path.is_file()} - {"SHA256SUMS"}
    for line in lines:
        digest, name = line.split("  ")
        assert hashlib.sha256((released / name).read_bytes()).hexdigest() == digest


def test_its_notes_are_the_changelogs(released):
    assert (released / "NOTES.md").read_text(encoding="utf-8").startswith("- ")


def test_blender_installs_from_it(released, tmp_path):
    environment = {**os.environ, "BLENDER_USER_RESOURCES": str(tmp_path)}
    environment.pop("PYTHONPATH", None)
    address, written = (released / "extensions" / "index.json").as_uri(), tmp_path / "written.json"
    done = subprocess.run([sys.executable, "-c", INSTALL, address, written], cwd=tmp_path, env=environment,
                          capture_output=True, text=True, timeout=120)
    assert written.exists(), done.stdout + done.stderr
    assert json.loads(written.read_text(encoding="utf-8")) == [["FINISHED"], "Gold"]


def test_a_zip_of_another_version_is_refused(tmp_path):
    with pytest.raises(release.ReleaseError, match="is not the zip of"):
        release.assemble(tmp_path / "out", tmp_path / "facet_film-0.0.1.zip", tmp_path)
    assert not (tmp_path / "out").exists()
