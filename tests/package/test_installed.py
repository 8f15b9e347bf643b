"""The real zip in a real Blender with an empty profile: installed, used, disabled, enabled, removed."""

import json
import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

SESSION = Path(__file__).with_name("session_of_a_user.py")


@pytest.fixture(scope="module")
def report(package, tmp_path_factory):
    """What was seen in the user's session; it runs outside the checkout, so that nothing is found by chance."""
    profile, written = tmp_path_factory.mktemp("profile"), tmp_path_factory.mktemp("report") / "report.json"
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    environment["BLENDER_USER_RESOURCES"] = str(profile)
    done = subprocess.run([sys.executable, SESSION, package, written], cwd=profile, env=environment,
                          capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stdout + done.stderr
    return json.loads(written.read_text(encoding="utf-8"))


def test_the_session_goes_through(report):
    assert not report["failure"], report["failure"]


def test_it_installs_and_enables(report, package):
    assert report["enabled"]
    with zipfile.ZipFile(package) as packed:
        assert report["files"] == sorted(packed.namelist())


def test_it_adds_its_operator_and_only_things_that_bear_its_name(report):
    assert "operator facet_film.bake_preset" in report["added"]
    assert not [trace for trace in report["added"]
                if "facet_film" not in trace.lower().replace("facetfilm", "facet_film")]


def test_the_operator_makes_a_copper_material(report):
    assert report["result"] == ["FINISHED"]
    assert report["material"] == "Copper"
    assert report["surface"]["node"] == "ShaderNodeGroup"
    assert "ShaderNodeBsdfMetallic" in report["surface"]["inner"]
    assert report["surface"]["values"]["Refractive Index n"] == pytest.approx(report["conductor"]["n"], abs=1e-6)
    assert report["surface"]["values"]["Extinction k"] == pytest.approx(report["conductor"]["k"], abs=1e-6)


def test_a_second_bake_reuses_the_node_group(report):
    assert report["groups"][0] == report["groups"][1] > 0


def test_using_it_writes_nothing_beside_the_code(report):
    assert report["files_after_use"] == report["files"]


def test_disabling_leaves_nothing_behind(report):
    assert report["left"] == []


def test_materials_outlive_the_extension(report):
    assert report["surface_when_disabled"] == "ShaderNodeGroup"


def test_it_can_be_enabled_again(report):
    assert report["added_again"] == report["added"]


def test_removing_leaves_nothing_behind(report):
    assert report["left_when_removed"] == []
    assert not report["folder_left"]
