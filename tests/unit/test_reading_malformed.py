"""Files with something wrong: a clear error and nothing else."""

import time
import warnings

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from addon.bake.reflected import reflect
from addon.errors import FacetFilmError
from addon.export import spectrum_csv
from addon.spectra.optical_constants import OpticalConstants
from addon.spectra.readers import read, read_file, read_text
from tests.unit.malformed import MALFORMED, VALID


def test_there_are_as_many_as_promised():
    assert len(MALFORMED) >= 200
    assert len({(one.file, one.content) for one in MALFORMED.values()}) >= 200


@pytest.mark.parametrize("name", MALFORMED)
def test_each_is_refused_in_one_clear_line(name, tmp_path):
    malformed = MALFORMED[name]
    path = tmp_path / malformed.file
    path.write_bytes(malformed.content)
    with warnings.catch_warnings(), pytest.raises(FacetFilmError) as refused:
        warnings.simplefilter("error")
        read_file(path)
    said = str(refused.value)
    assert said.startswith(malformed.file), said
    assert malformed.says in said
    assert "expected" in said and said.endswith(".")
    assert said.isprintable() and len(said) < 300
    assert str(tmp_path) not in said


@pytest.mark.parametrize("name", VALID)
def test_what_the_faults_were_put_into_is_read(name, tmp_path):
    file, content = VALID[name]
    path = tmp_path / file
    path.write_text(content, encoding="utf-8")
    assert read(path).covers_visible


def assert_reads_or_refuses(reading):
    """Run it: a FacetFilmError of one line, or constants from which finite colours follow."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            constants = reading()
        except FacetFilmError as error:
            assert str(error).isprintable() and str(error)
            return None
        w, n, k = constants.wavelength_nm, constants.n, constants.k
        assert w.shape == n.shape == k.shape and w.size >= 2
        assert (np.diff(w) > 0).all() and (n > 0).all() and (k >= 0).all()
        assert np.isfinite(reflect(constants).colours).all()
    return constants


ALPHABET = "0123456789.,;\t \n\r+-eEnkR%µm#:|()naifλDAT"
CELLS = st.one_of(st.floats(), st.floats(0.1, 900.0), st.integers(-1, 10**6), st.sampled_from(
    ["nan", "inf", "", "n", "k", "R", "nm", "µm", "1,5", "1e400", "wavelength", "%"])).map(str)


@given(st.binary(max_size=400))
@settings(max_examples=300)
def test_any_bytes_in_a_file(tmp_path_factory, content):
    path = tmp_path_factory.getbasetemp() / "any.csv"
    path.write_bytes(content)
    assert_reads_or_refuses(lambda: read_file(path))


@given(st.one_of(st.text(max_size=400), st.text(ALPHABET, max_size=200)),
       st.sampled_from(["a", "a.csv", "a.nk", "a.yml"]))
@settings(max_examples=600)
def test_any_text(content, name):
    assert_reads_or_refuses(lambda: read_text(content, name))


@given(st.lists(st.lists(CELLS, min_size=1, max_size=5), max_size=8), st.sampled_from(",;\t "),
       st.sampled_from(["", "nm,n\n", "um n k\n", "wl,R\n", "; Ag\n", "4 400 700 3\n"]),
       st.sampled_from(["a.csv", "a.nk"]))
@settings(max_examples=500)
def test_any_table(rows, separator, head, name):
    content = head + "\n".join(separator.join(row) for row in rows)
    assert_reads_or_refuses(lambda: read_text(content, name))


@given(st.integers(0, 12), st.lists(st.floats(allow_nan=False, allow_infinity=False), max_size=20),
       st.floats(-1, 2), st.floats(-1, 20))
@settings(max_examples=400)
def test_any_dispersion_formula(formula, coefficients, low, high):
    yaml = (f"DATA:\n  - type: formula {formula}\n    wavelength_range: {low} {high}\n"
            f"    coefficients: {' '.join(map(str, coefficients))}\n")
    assert_reads_or_refuses(lambda: read_text(yaml, "a.yml"))


@given(st.sampled_from(sorted(VALID)), st.data())
@settings(max_examples=600)
def test_any_change_of_a_valid_file(name, data):
    file, content = VALID[name]
    for _ in range(data.draw(st.integers(1, 3))):
        start = data.draw(st.integers(0, len(content)))
        end = data.draw(st.integers(start, min(len(content), start + 12)))
        put = data.draw(st.one_of(st.text(ALPHABET, max_size=6), st.sampled_from(
            ["nan", "\n", "-", "1e308", "1e-308", "\x00", "٣", "9" * 400])))
        content = content[:start] + put + content[end:]
    assert_reads_or_refuses(lambda: read_text(content, file))


@pytest.mark.parametrize("unit", [
    "1", "1 ", "1,", "1\n", "a", "<", ",", ";", " ", "\n", "a in ", "- a:\n", "400,1.5\n", "(", "#",
    "n\n1 1\n", "\t1", "1e9;"])
@pytest.mark.parametrize("name", ["a.csv", "a.nk", "a.yml"])
def test_a_great_deal_of_anything_is_refused_soon(unit, name):
    head = "REFERENCES: " if unit == "<" else "DATA:\n" if name == "a.yml" else ""
    content = head + unit * (200_000 // len(unit))
    start = time.perf_counter()
    assert assert_reads_or_refuses(lambda: read_text(content, name)) is None
    assert time.perf_counter() - start < 2.0


@given(st.lists(st.tuples(st.floats(350.0, 800.0), st.floats(1e-3, 100.0), st.floats(0.0, 100.0)),
                min_size=2, max_size=30), st.booleans())
def test_what_is_written_is_read_as_it_was(points, has_k):
    points = sorted({point[0]: point for point in [*points, (410.0, 1.5, 0.0), (690.0, 1.5, 1.0)]}.values())
    wavelength, n, k = map(np.array, zip(*points))
    n = n if has_k else 1.0 + np.sort(n)[::-1]  # what has no k is clear: n falls towards the red, above 1
    written = OpticalConstants(wavelength, n, k if has_k else 0.0 * k, "x", has_k=has_k)
    again = read_text(spectrum_csv(written))
    for name in ("wavelength_nm", "n", "k"):
        np.testing.assert_array_equal(getattr(again, name), getattr(written, name))
    assert again.has_k == has_k
