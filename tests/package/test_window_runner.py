"""The window tests' runner says what went wrong: no such Blender, no window, a failed step, a Blender that hangs."""

import importlib.util
import sys
from pathlib import Path

import pytest

RUN = Path(__file__).resolve().parents[1] / "window" / "run.py"
REPORT = '{"steps": ["open the panel", "apply copper"], "skipped": [], "failure": "%s", "clicks": 0}'


@pytest.fixture
def runner():
    """The runner as a module."""
    spec = importlib.util.spec_from_file_location("window_runner", RUN)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def session(runner, tmp_path, monkeypatch):
    """A function that runs one session, once, with a stand-in for Blender that is a shell script."""
    package = tmp_path / "facet_film.zip"
    package.write_bytes(b"")
    monkeypatch.setattr(runner, "RETRY_UNTIL_S", -1e9)

    def run(script):
        blender = tmp_path / "blender"
        blender.write_text(f"#!/bin/sh\ncd $WINDOW_TEST\n{script}\n", encoding="utf-8")
        blender.chmod(0o755)
        return runner.twice("panel", [str(blender)], package, tmp_path / "out")

    return run


def test_a_session_that_passes(session, capsys):
    assert session(f"echo 1 > log.txt; echo '{REPORT % ''}' > report.json") == 0
    assert capsys.readouterr().out.splitlines() == ["panel: ok  open the panel", "panel: ok  apply copper"]


def test_a_failed_step_is_named(session, runner, capsys):
    assert session(f"echo 1 > log.txt; echo '{REPORT % 'No button. '}' > report.json") == runner.FAILED
    said = capsys.readouterr().out
    assert "panel: ok  open the panel" in said
    assert "FAILED at the step: apply copper. No button." in said


def test_a_blender_without_a_window(session, runner, capsys):
    assert session("echo no display; exit 1") == runner.NO_WINDOW
    assert "panel: this Blender opened no window: no display" in capsys.readouterr().out


def test_a_blender_that_hangs_is_ended(session, runner, capsys, monkeypatch):
    monkeypatch.setattr(runner, "AT_MOST_S", 0.5)
    assert session("echo waiting for the panel > log.txt; exec sleep 60") == runner.FAILED
    said = capsys.readouterr().out
    assert "did not end within" in said and "waiting for the panel" in said


def test_no_such_blender(runner, monkeypatch, tmp_path):
    monkeypatch.setattr(sys, "argv", ["run.py", "--blender", str(tmp_path / "none"), "--out", str(tmp_path)])
    with pytest.raises(SystemExit, match="no such program; give the path of a Blender"):
        runner.main()
