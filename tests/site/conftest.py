"""The site of a few materials, built once, and a browser to read it with."""

import json
import shutil
import sys
from pathlib import Path

import pytest
from selenium import webdriver

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from tools import build_data, build_site  # noqa: E402

MATERIALS = ("copper", "gold", "vinyl", "window_glass", "diamond", "anodised_titanium", "nacre",
             "wrap_sunset")
DRIVER = "chromedriver"


@pytest.fixture(scope="session")
def data():
    """The catalogue of MATERIALS, as its file holds it."""
    return json.loads(json.dumps(build_data.catalogue(MATERIALS)))


@pytest.fixture(scope="session")
def site(data, tmp_path_factory):
    """The folder of the site."""
    return build_site.build(tmp_path_factory.mktemp("built") / "site", data)


@pytest.fixture(scope="session")
def downloads(tmp_path_factory):
    """The folder that the browser loads down into."""
    return tmp_path_factory.mktemp("downloads")


@pytest.fixture(scope="session")
def browser(downloads):
    """Chromium without a window, which may use the clipboard and load down."""
    options = webdriver.ChromeOptions()
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                     "--allow-file-access-from-files"):
        options.add_argument(argument)
    found = webdriver.Chrome(options=options, service=webdriver.ChromeService(shutil.which(DRIVER)))
    found.execute_cdp_cmd("Browser.grantPermissions", {"permissions": ["clipboardReadWrite",
                                                                       "clipboardSanitizedWrite"]})
    found.execute_cdp_cmd("Browser.setDownloadBehavior", {"behavior": "allow", "downloadPath": str(downloads)})
    yield found
    found.quit()
