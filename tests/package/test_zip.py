"""What is in the zip, and that building it refuses what must not be released."""

import fnmatch
import shutil
import tomllib
import zipfile
from pathlib import Path

import pytest

from tools.package import PackageError, build

ROOT = Path(__file__).resolve().parents[2]

# Everything that may be in the zip; a new kind of file has to be allowed here by hand.
ALLOWED = ("__init__.py", "blender_manifest.toml", "LICENSE", "README.md",
           "addon/*.py", "addon/models/*/*.osl", "addon/models/*/presets.json", "addon/spectra/data/*",
           "addon/thumbnails/*.webp", "node_groups/*.blend",
           "node_groups/assets/blender_assets.cats.txt")
NEEDED = ("__init__.py", "blender_manifest.toml", "LICENSE", "addon/__init__.py", "addon/cli.py", "addon/api.py",
          "node_groups/groups/cook_torrance_fast.blend", "node_groups/assets/facet_film_assets.blend")
MOST_BYTES = 10_000_000


@pytest.fixture
def source(tmp_path):
    """A copy of what the zip is made of, to be spoilt."""
    copy = tmp_path / "source"
    copy.mkdir()
    for name in ("__init__.py", "blender_manifest.toml", "LICENSE"):
        shutil.copy(ROOT / name, copy)
    shutil.copytree(ROOT / "addon", copy / "addon")
    return copy


def names_in(path):
    with zipfile.ZipFile(path) as packed:
        return packed.namelist()


def test_it_holds_only_what_users_need(package):
    extra = [name for name in names_in(package) if not any(fnmatch.fnmatch(name, allowed) for allowed in ALLOWED)]
    assert not extra


def test_it_holds_all_of_the_addon(package):
    names = set(names_in(package))
    assert names >= set(NEEDED)
    assert package.stat().st_size <= MOST_BYTES
    modules = {path.relative_to(ROOT).as_posix() for path in (ROOT / "addon").rglob("*.py")}
    data = {path.relative_to(ROOT).as_posix() for path in (ROOT / "addon").rglob("*")
            if path.is_file() and path.suffix != ".pyc"}
    assert modules <= names
    assert data <= names


def test_its_name_is_the_manifests(package):
    manifest = tomllib.loads((ROOT / "blender_manifest.toml").read_text(encoding="utf-8"))
    assert package.name == f"facet_film-{manifest['version']}.zip"
    assert manifest["id"] == "facet_film"
    assert manifest["blender_version_min"] == "4.5.0"
    assert set(manifest["permissions"]) == {"files"}


def test_it_is_the_same_bytes_when_built_again(package, tmp_path):
    assert build(tmp_path).read_bytes() == package.read_bytes()


def test_an_unknown_tag_is_refused(source, tmp_path):
    manifest = source / "blender_manifest.toml"
    manifest.write_text(manifest.read_text(encoding="utf-8").replace('"Node"', '"Nodes"'), encoding="utf-8")
    with pytest.raises(PackageError, match='invalid tag "Nodes"'):
        build(tmp_path / "dist", source)


def test_a_tagline_that_ends_in_a_full_stop_is_refused(source, tmp_path):
    manifest = source / "blender_manifest.toml"
    manifest.write_text(manifest.read_text(encoding="utf-8").replace('Cycles"', 'Cycles."'), encoding="utf-8")
    with pytest.raises(PackageError, match="tagline"):
        build(tmp_path / "dist", source)


def test_a_stray_file_is_refused_by_name(source, tmp_path):
    (source / "notes.txt").write_text("mine")
    with pytest.raises(PackageError, match="notes.txt"):
        build(tmp_path / "dist", source)
    assert not (tmp_path / "dist" / "facet_film-0.1.0.zip").exists()


def test_leftovers_of_work_are_left_out(source, tmp_path):
    for name in ("tests/unit/test_x.py", "docs/models.md", ".venv/bin/python", "out/copper.png", "dist/old.zip",
                 "addon/__pycache__/api.cpython-311.pyc", "addon/spectra/.cache", "facet_film_verification.html"):
        (source / name).parent.mkdir(parents=True, exist_ok=True)
        (source / name).write_text("x")
    before = set(names_in(build(tmp_path / "dist", source)))
    left_out = ("tests", "docs", ".venv", "out", "dist", "facet_film_verification")
    assert not [name for name in before if name.startswith(left_out) or "cache" in name]
