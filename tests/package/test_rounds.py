"""Two hundred rounds of enabling, using and disabling the real zip leave nothing behind."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

SESSION = Path(__file__).with_name("session_of_rounds.py")
ROUNDS = 200


@pytest.fixture(scope="module")
def report(package, tmp_path_factory):
    profile, written = tmp_path_factory.mktemp("rounds"), tmp_path_factory.mktemp("rounds_report") / "report.json"
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    environment["BLENDER_USER_RESOURCES"] = str(profile)
    done = subprocess.run([sys.executable, SESSION, package, written, str(ROUNDS)], cwd=profile, env=environment,
                          capture_output=True, text=True, timeout=550)
    assert done.returncode == 0, done.stdout + done.stderr
    found = json.loads(written.read_text(encoding="utf-8"))
    assert not found["failure"], found["failure"]
    return found


def test_every_round_goes_through(report):
    assert report["rounds"] == ROUNDS


def test_no_class_operator_entry_handler_property_shortcut_preview_or_library_is_left(report):
    assert report[str(ROUNDS)]["traces"] == []


def test_no_datablock_is_left(report):
    assert report[str(ROUNDS)]["datablocks"] == {}


def test_no_timer_is_left(report):
    assert report[str(ROUNDS)]["timers"] == []


def test_memory_does_not_grow_with_the_rounds(report):
    grown = report[str(ROUNDS)]["memory_mb"] - report["10"]["memory_mb"]
    assert grown < 150.0, f"{grown:.0f} MB"
