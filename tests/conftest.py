"""What all tests share: the Blender they ran on, named at the top, and settings for two busy cores."""

from importlib.metadata import version

from hypothesis import settings

# The same examples every run, and no deadline: the machine may be rendering meanwhile.
settings.register_profile("facet_film", deadline=None, derandomize=True)
settings.load_profile("facet_film")


def pytest_report_header(config):
    """Name the versions that decide the results."""
    return f"bpy {version('bpy')}, numpy {version('numpy')}, colour-science {version('colour-science')}"
