"""The zip, built once for all tests of it."""

import pytest

from tools.package import build


@pytest.fixture(scope="session")
def package(tmp_path_factory):
    """Path of the extension's zip, built from this checkout and validated by Blender's own tool."""
    return build(tmp_path_factory.mktemp("dist"))
