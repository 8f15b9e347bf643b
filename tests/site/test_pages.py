"""The site as a reader uses it, in Chromium: search, categories, copy, download, keyboard, a phone, contrast."""

import json
import time

import pytest
from axe_core_python.selenium import Axe
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

PAGES = ("index.html", "for_artists.html", "for_pipelines.html", "for_students.html", "for_contributors.html",
         "glass_of_water.html", "materials.html", "material/gold.html", "films.html")


def titles_shown(browser):
    return [item.find_element(By.TAG_NAME, "span").text for item in browser.find_elements(By.CSS_SELECTOR, ".shelf li")
            if item.is_displayed()]


def click(browser, what):
    """By mouse, once it is in sight and has stopped moving."""
    browser.execute_script("arguments[0].scrollIntoView({block: 'center', behavior: 'instant'})", what)
    what.click()


@pytest.fixture
def catalogue(site, browser):
    browser.get((site / "materials.html").as_uri())
    return browser


def type_in(browser, words):
    field = browser.find_element(By.ID, "words")
    field.clear()
    field.send_keys(words)


@pytest.mark.parametrize("words, title", [
    ("gold", "Gold"), ("Kupfer", "Copper"), ("anodized tita", "Anodised titanium"), ("铜", "Copper"),
    ("window", "Window glass")])
def test_the_search_finds_by_every_name(catalogue, words, title):
    type_in(catalogue, words)
    assert title in titles_shown(catalogue) and len(titles_shown(catalogue)) < 3


def test_what_is_not_there_is_said(catalogue):
    type_in(catalogue, "unobtainium")
    assert not titles_shown(catalogue)
    assert catalogue.find_element(By.ID, "nothing").is_displayed()


def test_categories(site, catalogue):
    catalogue.find_element(By.CSS_SELECTOR, "button[data-category=glass]").click()
    assert set(titles_shown(catalogue)) == {"Window glass", "Diamond"}
    assert catalogue.current_url.endswith("#glass")
    type_in(catalogue, "diamond")
    assert titles_shown(catalogue) == ["Diamond"]


def test_an_address_opens_a_category(site, browser):
    browser.get("about:blank")
    browser.get((site / "materials.html").as_uri() + "#iridescent")
    assert "Anodised titanium" in titles_shown(browser) and "Gold" not in titles_shown(browser)


def test_copy(site, browser):
    browser.get((site / "material" / "gold.html").as_uri())
    click(browser, browser.find_element(By.CSS_SELECTOR, '[aria-label="Copy sRGB"]'))
    time.sleep(0.3)
    said = browser.find_element(By.ID, "copied").text
    assert said.startswith("Copied: #")
    pasted = browser.execute_async_script("navigator.clipboard.readText().then(arguments[0], arguments[0])")
    assert pasted == said.removeprefix("Copied: ")


def test_download(site, browser, downloads):
    browser.get((site / "material" / "copper.html").as_uri())
    links = browser.find_elements(By.CSS_SELECTOR, ".downloads a")
    assert [link.text for link in links] == ["JSON", "MaterialX"]
    click(browser, links[0])
    target = downloads / "copper.json"
    for _ in range(50):
        if target.exists():
            break
        time.sleep(0.1)
    assert json.loads(target.read_text(encoding="utf-8"))["name"] == "copper"


def test_by_keyboard_alone(catalogue):
    """Tab to the search, type, Tab to the picture, Enter."""
    active = catalogue.switch_to
    for _ in range(60):
        if active.active_element.get_attribute("id") == "words":
            break
        active.active_element.send_keys(Keys.TAB)
    active.active_element.send_keys("diamond")
    for _ in range(20):
        active.active_element.send_keys(Keys.TAB)
        if active.active_element.get_attribute("href"):
            break
    active.active_element.send_keys(Keys.ENTER)
    assert catalogue.title.startswith("Diamond")


@pytest.mark.parametrize("page", PAGES)
def test_a_phone_scrolls_one_way_only(site, browser, page):
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                            {"width": 390, "height": 844, "deviceScaleFactor": 2, "mobile": True})
    try:
        browser.get((site / page).as_uri())
        wide, seen = browser.execute_script(
            "return [document.scrollingElement.scrollWidth, document.documentElement.clientWidth]")
        assert wide <= seen
    finally:
        browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("page", PAGES)
def test_everyone_can_read_it(site, browser, page, theme):
    """axe-core's rules of WCAG 2 A and AA: contrast, names, order."""
    browser.get((site / page).as_uri())
    browser.execute_script("document.body.dataset.theme = arguments[0]", theme)
    found = Axe().run(browser, options={"runOnly": ["wcag2a", "wcag2aa"]})["violations"]
    assert not [(one["id"], node["target"], node["failureSummary"]) for one in found for node in one["nodes"]]
