"""What lists show of the presets is what the presets say, and is there without reading them."""

import subprocess
import sys
from pathlib import Path

import pytest

from addon.catalogue import entries, presets
from addon.spectra import tables

ROOT = Path(__file__).resolve().parents[2]


def test_the_tables_are_what_their_tool_builds(tmp_path):
    subprocess.run([sys.executable, ROOT / "tools" / "build_search.py", tmp_path], check=True, capture_output=True)
    for name in ("catalogue.table", "search.table"):
        assert (tmp_path / name).read_bytes() == (tables.DIRECTORY / name).read_bytes(), name


def test_entries_say_what_the_presets_say():
    assert list(entries.entries()) == list(presets.all_presets())
    for name, preset in presets.all_presets().items():
        assert entries.entries()[name][:-1] == entries.stated(preset)[:-1]
        assert tuple(entries.entries()[name].aliases) == preset.aliases


def test_lists_read_no_preset():
    """Nor what makes one; a preset that is asked for by its name reads its own model's file, and makes itself alone."""
    code = ("import sys; from addon.catalogue import entries, search\n"
            "assert entries.in_category('metal') and search.search('gold') and search.search('main/Au/Babar')\n"
            "assert 'addon.catalogue.presets' not in sys.modules\n"
            "from addon.catalogue import presets\n"
            "presets.find('nacre')\n"
            "assert presets._records.cache_info().currsize == presets._preset.cache_info().currsize == 1")
    subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=True)


@pytest.fixture
def other_size(monkeypatch):
    """As if the presets of one model were others than when the table was built."""
    monkeypatch.setattr(entries, "size_of", lambda model: 1 if model == "film" else
                        tables.part("catalogue", "models")[model])
    entries.forget()
    yield
    monkeypatch.undo()
    entries.forget()


def test_presets_that_came_later_are_read_as_they_are(other_size):
    kept = {row[0]: row for row in tables.part("catalogue", "entries")["rows"]}
    for name, entry in entries.entries().items():
        assert list(entry[:-1]) == kept[name][:-1]
    place = list(entries.entries()).index("soap_bubble")
    assert entries.column("lines", lambda preset: preset.name)[place] == "soap_bubble"


def test_a_categorys_variants_come_last():
    for category in {entry.category for entry in entries.entries().values()}:
        variants = [bool(entry.variant_of) for entry in entries.in_category(category)]
        assert variants == sorted(variants)
