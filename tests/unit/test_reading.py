"""A user's own data in every format that is read, each sample written by hand."""

import pathlib
import time

import numpy as np
import pytest

from addon.bake import bake
from addon.errors import FacetFilmError
from addon.reflectance import fresnel
from addon.spectra import optical_constants
from addon.spectra.readers import read, read_file, read_text

W, N, K = [400.0, 550.0, 700.0], [1.5, 1.25, 1.0], [2.0, 2.5, 3.0]

NK_TABLES = {
    "headings, nm": "wavelength_nm,n,k\n400,1.5,2\n550,1.25,2.5\n700,1,3\n",
    "headings, µm": "Wavelength (µm), n, k\n0.4, 1.5, 2\n0.55, 1.25, 2.5\n0.7, 1, 3\n",
    "the other mu, tabs": "λ [μm]\tn\tk\n0.4\t1.5\t2\n0.55\t1.25\t2.5\n0.7\t1\t3\n",
    "unit in a cell of its own": "Wavelength, nm, n, k\n400,1.5,2\n550,1.25,2.5\n700,1,3\n",
    "headings, Å": "angstrom;n;k\n4000;1.5;2\n5500;1.25;2.5\n7000;1;3\n",
    "words between spaces":
        "Wavelength (nm)  Refractive index  Extinction coefficient\n400 1.5 2\n550 1.25 2.5\n700 1 3",
    "bare, nm": "400,1.5,2\n550,1.25,2.5\n700,1,3\n",
    "bare, µm": "0.4 1.5 2\n0.55 1.25 2.5\n0.7 1 3\n",
    "uneven spaces": "  400   1.5  2\n\n  550   1.25 2.5\n  700   1    3  \n\n",
    "semicolons, decimal comma": "nm;n;k\n400;1,5;2\n550;1,25;2,5\n700;1;3\n",
    "tabs, decimal comma": "0,4\t1,5\t2\n0,55\t1,25\t2,5\n0,7\t1\t3\n",
    "spaces, decimal comma": "0,4 1,5 2\n0,55 1,25 2,5\n0,7 1,0 3\n",
    "comments": "# gold, measured on a Friday\n% in Excel\n400,1.5,2 # blue\n550,1.25,2.5\n700,1,3\n",
    "exponents and signs": "4.0e+2,+1.5,2E0\n5.5e2,1.25,.25e1\n7e2,1.,3\n",
    "quotes and empty cells at the end":
        '"wavelength_nm","n","k",,\n"400","1.5","2",,\n550,1.25,2.5,,\n700,1,3\n',
    "k before n": "nm,k,n\n400,2,1.5\n550,2.5,1.25\n700,3,1\n",
    "returns of old computers": "400,1.5,2\r550,1.25,2.5\r700,1,3\r",
}


@pytest.mark.parametrize("name", NK_TABLES)
def test_a_table_of_n_and_k(name):
    constants = read_text(NK_TABLES[name])
    np.testing.assert_allclose(constants.wavelength_nm, W, rtol=1e-12)
    np.testing.assert_array_equal(constants.n, N)
    np.testing.assert_array_equal(constants.k, K)
    assert constants.has_k and not constants.normal_only and constants.range_nm == (400.0, 700.0)


@pytest.mark.parametrize("text", [
    "400,1.5\n700,1.4\n", "wl,n\n0.4,1.5\n0.7,1.4\n", "nm\tindex\n400\t1.5\n700\t1.4", "0,4 1,5\n0,7 1,4"])
def test_a_table_of_n_alone(text):
    constants = read_text(text)
    assert constants.n.tolist() == [1.5, 1.4] and constants.k.tolist() == [0.0, 0.0] and not constants.has_k


def test_the_two_blocks_that_refractiveindex_info_exports():
    constants = read_text("wl,n\n0.4,1.5\n0.5,1.4\n0.8,1.1\n\nwl,k\n0.38,2\n0.6,3\n0.7,3.5\n", "gold.csv")
    assert constants.wavelength_nm.tolist() == [380.0, 400.0, 500.0, 600.0, 700.0, 800.0]
    n, k = constants.at([400.0, 490.0, 650.0])
    np.testing.assert_allclose(n, [1.5, 1.41, 1.25])
    np.testing.assert_allclose(k, [2 + 2 / 22, 2.5, 3.25])
    assert constants.range_nm == (400.0, 700.0)
    assert constants.dataset == "file:gold.csv" and constants.title == "gold"


@pytest.mark.parametrize("text", [
    "nm,R\n400,0.25\n700,0.36\n", "nm,R (%)\n400,25\n700,36\n", "nm,%R\n400,25\n700,36\n",
    "nm,R\n400,25\n700,36\n", "400,0.25\n700,0.36\n", "400;25\n700;36\n",
    "wavelength (nm);reflectance [%]\n400;25,0\n700;36,0\n"])
def test_a_normal_reflectance(text):
    constants = read_text(text)
    assert constants.normal_only and not constants.has_k and not constants.k.any()
    wavelength = np.array([400.0, 500.0, 700.0])
    f0 = fresnel.conductor(1.0, *constants.at(wavelength))
    np.testing.assert_allclose(f0, 0.25 + 0.11 * (wavelength - 400.0) / 300.0, rtol=1e-9)


def test_a_perfect_mirror_is_a_reflectance():
    assert np.isfinite(bake(read_text("nm,R\n400,1\n700,1\n")).f0).all()
    assert read_text("nm,R\n400,100\n700,100\n").n.min() > 1e5


@pytest.mark.parametrize("head, wavelength", [
    ("1 1.5 3.5 2", 1239.841984 / np.array([3.5, 2.5, 1.5])), ("2 0.4 0.8 2", [400, 600, 800]),
    ("3 12500 27500 2", 1e7 / np.array([27500, 20000, 12500])), ("4 400 800 2", [400, 600, 800])])
def test_sopra(head, wavelength):
    constants = read_text(f"{head}\n1.5 2.0\n1.4 2.5;\n1.3; 3.0\n", "Ag.nk")
    np.testing.assert_allclose(constants.wavelength_nm, wavelength, rtol=1e-9)
    turned = 1 if head[0] in "24" else -1
    assert constants.n.tolist() == [1.5, 1.4, 1.3][::turned]
    assert constants.k.tolist() == [2.0, 2.5, 3.0][::turned]


def test_what_dos_ended_files_with_is_no_fault():
    assert read_text("4 400 700 1\r\n1.5 0\r\n1.4 0.1\r\n\x1a", "Ag.nk").n.tolist() == [1.5, 1.4]


def test_sopra_is_known_by_its_head_too():
    assert read_text("4 400 700 1\n1.5 0\n1.4 0.1\n").k.tolist() == [0.0, 0.1]


@pytest.mark.parametrize("heading", [
    "Wavelength(nm),n", "WL/nm;n", "wavelength_nm\tn", "wavelength nm, n", "Wavelength in nm, n", "λ [nm]  n",
    "Lambda (nm) Index", "lam nm, refractive index", "Wavelengths (nanometers), Index of refraction", "nm n",
    "wvl [NM], N", "'wavelength (nm)', 'n'", "w,nm,n", "Wavelength (nm),n (-)"])
def test_headings_as_people_write_them(heading):
    separator = next((s for s in "\t;," if s in heading), " ")
    assert read_text(f"{heading}\n400{separator}1.5\n700{separator}1.4\n").n.tolist() == [1.5, 1.4]


def test_luxpop():
    text = "; from a book\n;  Angstroms, n, k\n 1000.0 1.1 0.3\n 4000.0 0.17 1.95\n 10000.0  0.04 6.99\n"
    constants = read_text(text, "Ag.nk")
    assert constants.wavelength_nm.tolist() == [100.0, 400.0, 1000.0]
    assert constants.k.tolist() == [0.3, 1.95, 6.99]


YAML = """# this file is part of a database
REFERENCES: "A. Author and B. Author. <a href=\\"x\\">Optical constants</a>,
  <i>J. Phys.</i> <b>6</b>, 4370 (1972)"
COMMENTS: "Room temperature: 20 °C"
DATA:
  - type: {}
CONDITIONS:
  temperature: 293.15
"""


def test_the_databases_yaml_tabulated():
    entry = "tabulated nk\n    data: |\n        0.4 1.5 2\n        0.55 1.25 2.5\n        0.7 1 3"
    constants = read_text(YAML.format(entry), "Johnson.yml")
    np.testing.assert_allclose(constants.wavelength_nm, W)
    assert constants.n.tolist() == N and constants.k.tolist() == K
    assert "Optical constants" in constants.citation and "4370" in constants.citation
    assert "<" not in constants.citation and "Room" not in constants.citation


def test_the_databases_yaml_with_a_formula_and_k():
    entry = ("formula 1\n    wavelength_range: 0.21 6.7\n"
             "    coefficients: 0 0.6961663 0.0684043 0.4079426 0.1162414 0.8974794 9.896161\n"
             "  - type: tabulated k\n    data: |\n        0.3 1e-8\n        0.9 1e-7")
    constants = read_text(YAML.format(entry))
    np.testing.assert_allclose(constants.at(587.6)[0], 1.45846, atol=1e-5)
    np.testing.assert_allclose(constants.at(600.0)[1], 5.5e-8)
    assert constants.has_k


@pytest.mark.parametrize("entry, at_500", [
    ("formula 2\n    wavelength_range: 0.4 0.7\n    coefficients: 0 1 0.01", np.sqrt(1 + .25 / .24)),
    ("formula 3\n    range: 0.4 0.7\n    coefficients: 2.25 0.01 2", np.sqrt(2.2525)),
    ("formula 5\n    wavelength_range: 0.4 0.7\n    coefficients: 1.5 0.01 -2", 1.54),
    ("formula 6\n    wavelength_range: 0.4 0.7\n    coefficients: 0 0.05 100", 1 + .05 / 96)])
def test_dispersion_formulas(entry, at_500):
    constants = read_text(YAML.format(entry))
    np.testing.assert_allclose(constants.at(500.0)[0], at_500, rtol=1e-12)
    assert not constants.has_k


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-32", "latin-1"])
def test_encodings(encoding, tmp_path):
    path = tmp_path / "µ-metal.csv"
    path.write_text("wavelength (µm),n\n0.4,1.5\n0.7,1.4\n", encoding=encoding)
    constants = read_file(path)
    assert constants.n.tolist() == [1.5, 1.4]
    assert constants.licence == constants.citation == "the user's own data"
    assert constants.dataset == "file:µ-metal.csv"


def test_paths_and_texts_are_told_apart(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text("400,1.5\n700,1.4\n")
    assert read(path).n.tolist() == read(str(path)).n.tolist() == read("400,1.5\n700,1.4\n").n.tolist()
    for wrong in (None, 5, b"400,1.5\n", [1, 2]):
        with pytest.raises(FacetFilmError, match="path or a text"):
            read(wrong)


def test_what_is_no_file_is_said(tmp_path):
    for path, says in ((tmp_path / "none.csv", "none.csv: no such file"), (tmp_path, "is a folder"),
                       ("a\0b", "no path"), ("x" * 5000, "name too long"), ("", "The path: no such file"),
                       (pathlib.Path("/dev/null"), "device")):
        with pytest.raises(FacetFilmError, match=says):
            read_file(path)


def test_a_file_that_may_not_be_read_is_said(tmp_path, monkeypatch):
    path = tmp_path / "a.csv"
    path.write_text("400,1.5\n700,1.4\n")

    def refuse(*_):
        raise PermissionError(13, "Permission denied")
    monkeypatch.setattr("builtins.open", refuse)
    with pytest.raises(FacetFilmError, match="a.csv: permission denied; expected a file that can be read"):
        read_file(path)


def test_a_large_file_is_refused_unread(tmp_path, monkeypatch):
    path = tmp_path / "large.csv"
    with open(path, "wb") as file:
        file.truncate(100_000_000)

    def never(*_):
        raise AssertionError("was opened")
    monkeypatch.setattr("builtins.open", never)
    with pytest.raises(FacetFilmError, match="100.0 MB and is too large"):
        read_file(path)


def test_a_bake_of_ones_own_data_is_that_of_the_database():
    constants = optical_constants.load("main/Au/Babar")
    text = "".join(f"{w!r},{n!r},{k!r}\n" for w, n, k in zip(
        *(column.tolist() for column in (constants.wavelength_nm, constants.n, constants.k))))
    own, theirs = bake(read_text(text)), bake("main/Au/Babar")
    assert own.f0 == theirs.f0 and own.fresnel == theirs.fresnel
    assert own.conductor.formula == theirs.conductor.formula
    cos_theta = np.linspace(0.05, 1.0, 20)[:, None]  # n of a near perfect mirror hangs on the last bit: compare light
    reflected = [fresnel.conductor(cos_theta, np.array(one.conductor.n), np.array(one.conductor.k))
                 for one in (own, theirs)]
    assert reflected[0] == pytest.approx(reflected[1], abs=1e-6)
    assert own.source.licence == "the user's own data"


def test_a_normal_file_takes_milliseconds():
    rows = (f"{w},{1.5 + w * 1e-5:.5f},{w * 1e-4:.5f}\n" for w in range(360, 781))
    text = "wavelength_nm,n,k\n" + "".join(rows)
    best = min(_seconds(lambda: read_text(text)) for _ in range(5))
    assert best < 0.02


def _seconds(call):
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


def test_the_examples_of_the_documentation_are_read():
    page = (pathlib.Path(__file__).resolve().parents[2] / "docs" / "own_data.md").read_text(encoding="utf-8")
    samples = [block.partition("```")[0] for block in page.split("```text\n")[1:]]
    assert [read_text(sample).normal_only for sample in samples] == [False, True]
    with pytest.raises(FacetFilmError) as refused:
        read_text("nm,n\n400,1.5\n550,1.5\n500,1.4\n", "gold.csv")
    assert f"error: {refused.value}\n" in page
