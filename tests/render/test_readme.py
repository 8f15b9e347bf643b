"""What README shows works as it stands there."""

import re
import shlex
from pathlib import Path

import bpy
import pytest

from addon.cli import main

README = (Path(__file__).resolve().parents[2] / "README.md").read_text(encoding="utf-8")
SNIPPETS = re.findall(r"```python\n(.*?)```", README, re.S)
COMMANDS = re.findall(r"^    python -m addon (.*)$", README, re.M)


def test_there_is_something_to_run():
    assert SNIPPETS and len(COMMANDS) >= 5


@pytest.mark.parametrize("snippet", SNIPPETS)
def test_snippet_runs(snippet, capsys):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    names = {}
    exec(snippet, names)
    assert "0.93" in capsys.readouterr().out
    assert names["copper"] in set(bpy.data.materials)


@pytest.mark.parametrize("command", COMMANDS)
def test_command_runs(command, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(shlex.split(command)) == 0
    assert capsys.readouterr().out.strip()
