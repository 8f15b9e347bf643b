"""What all tests share: the Blender they ran on, named at the top, and settings for two busy cores."""

import os
import sys
from importlib.metadata import version

import pytest
from hypothesis import settings

# The same examples every run, and no deadline: the machine may be rendering meanwhile.
settings.register_profile("facet_film", deadline=None, derandomize=True)
settings.load_profile("facet_film")


def pytest_report_header(config):
    """Name the versions that decide the results."""
    return f"bpy {version('bpy')}, numpy {version('numpy')}, colour-science {version('colour-science')}"


def pytest_sessionfinish(session, exitstatus):
    """Remember how the run ended."""
    session.config.exit_status = int(exitstatus)


@pytest.hookimpl(trylast=True)
def pytest_unconfigure(config):
    """Leave at once where Blender is loaded: taking it down after USD's and MaterialX's modules can hang for ever."""
    if "bpy" in sys.modules and hasattr(config, "exit_status"):
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(config.exit_status)
