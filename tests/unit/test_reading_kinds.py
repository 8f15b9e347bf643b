"""Each kind of measurement that people have gives its F0, or its sentence; so does each that was tampered with."""

import json
import time

import numpy as np
import pytest

from addon.bake import bake, preview, preview_text
from addon.bake.reflected import AT_NORMAL, reflect
from addon.errors import FacetFilmError
from addon.export import json_text, spectrum_csv
from addon.spectra import optical_constants
from addon.spectra.readers import Ambiguous, read_file, read_text
from addon.spectra.readers.glass import FORMULAS
from addon.spectra.readers.quantities import index_of_permittivity
from tests.unit.readings import E1, E2, EV, GOLD, READINGS, REFUSED, K, N, R, W, rows
from tools import compare_database, fuzz_readers, what_we_read

WITHIN = 0.01


def f0_of(constants):
    return reflect(constants).colours[AT_NORMAL]


@pytest.mark.parametrize("name", READINGS)
def test_each_kind_gives_its_f0_or_its_sentence(name, tmp_path):
    reading = READINGS[name]
    path = tmp_path / reading.file
    path.write_bytes(reading.content)
    if reading.f0 == REFUSED:
        with pytest.raises(FacetFilmError) as refused:
            read_file(path)
        said = str(refused.value)
        assert said.startswith(reading.file) and "expected" in said and said.endswith("."), said
        assert said.isprintable() and len(said) < 400
    else:
        assert np.abs(f0_of(read_file(path)) - reading.f0).max() <= WITHIN


# --- pairs ---

PAIRS = [
    ("Au.eta.spd", "Au.k.spd"),
    ("n.txt", "k.txt"),
    ("01_Au_n.csv", "02_Au_k.csv"),
    ("Au_n.dat", "Au_k.dat"),
    ("Au.ior.txt", "Au.kappa.txt"),
]


@pytest.mark.parametrize("names", PAIRS)
def test_half_of_a_pair_is_read_with_its_partner(names, tmp_path):
    for name, values in zip(names, (N, K)):
        (tmp_path / name).write_text(rows(W, values, sep=" "))
    for name, other in (names, names[::-1]):
        constants = read_file(tmp_path / name)
        assert np.abs(f0_of(constants) - GOLD).max() <= WITHIN
        assert any(other in line for line in constants.assumed)


@pytest.mark.parametrize("names", PAIRS)
@pytest.mark.parametrize("half", [0, 1])
def test_half_of_a_pair_alone_is_refused_as_that(names, half, tmp_path):
    (tmp_path / names[half]).write_text(rows(W, (N, K)[half], sep=" "))
    with pytest.raises(FacetFilmError, match="half of a pair"):
        read_file(tmp_path / names[half])


def test_a_coefficient_of_absorption_beside_n(tmp_path):
    (tmp_path / "n.gmat").write_text("#gpvdm\n#title Refractive index\n" + rows(W * 1e-9, N, sep="\t"))
    (tmp_path / "alpha.gmat").write_text("#gpvdm\n# alpha (1/m)\n" + rows(W * 1e-9, 4e9 * np.pi * K / W, sep="\t"))
    constants = read_file(tmp_path / "n.gmat", choose="1/m")
    assert np.abs(f0_of(constants) - GOLD).max() <= WITHIN


# --- what can mean two things ---


@pytest.mark.parametrize(
    "text, choices, chosen, f0",
    [
        ("400, 4.2\n700, 4.2", ("n", "R", "R in %"), "n", 0.3787),
        ("400, 4.2\n700, 4.2", ("n", "R", "R in %"), "R in %", 0.042),
        (rows(np.linspace(0.6, 6.6, 60), np.full(60, 0.5)), ("µm", "eV"), "eV", 0.5),
        ("nm,R (%)\n400,0.5\n700,0.5", ("in %", "a share"), "in %", 0.005),
        ("nm,gold,half\n400,0.5,0.25\n700,0.5,0.25", ("gold", "half"), "half", 0.25),
        (
            '{"a": {"nm": [400, 700], "R": [0.5, 0.5]}, "b": {"nm": [400, 700], "R": [0.25, 0.25]}}',
            ("a", "b"),
            "b",
            0.25,
        ),
        ("MATE A\n0.4 1.5 0\n0.7 1.5 0\nMATE B\n0.4 3 0\n0.7 3 0", ("A", "B"), "B", 0.25),
    ],
)
def test_two_readings_are_named_and_chosen(text, choices, chosen, f0):
    with pytest.raises(Ambiguous) as asked:
        read_text(text)
    assert asked.value.choices == choices and all(choice in str(asked.value) for choice in choices)
    constants = read_text(text, choose=chosen)
    np.testing.assert_allclose(f0_of(constants), f0, atol=5e-4)
    seen = preview_text(text)
    assert seen.choices == choices and seen.trouble == str(asked.value) and not seen.f0
    np.testing.assert_allclose(preview_text(text, choose=chosen).f0, f0, atol=5e-4)


def test_energies_are_told_from_micrometres_by_all_of_the_file():
    x = np.linspace(0.64, 6.6, 50)
    drude_n, drude_k = np.full(50, 0.3), 9.0 / x
    assert read_text(rows(x, drude_n, drude_k, sep=" ")).wavelength_nm[0] == pytest.approx(1239.842 / 6.6, rel=1e-6)
    assert read_text(rows(x, drude_n, drude_k[::-1], sep=" ")).wavelength_nm[0] == pytest.approx(640.0)
    glass = 1.5 + 0.004 / x**2
    assert read_text(rows(x / 3.0, glass, 0.0 * x, sep=" ")).wavelength_nm[0] == pytest.approx(640.0 / 3.0)


# --- what was assumed is said ---


@pytest.mark.parametrize(
    "text, says",
    [
        (rows(EV[::-1], N[::-1], K[::-1], sep=" "), "energy taken in eV"),
        ("nm,n,k\n" + rows(W, N, -K), "n − ik"),
        ("nm,n\n400,1.5\n700,1.4", "no k is given: taken as 0"),
        ("nm,R\n400,0.99\n500,1.001\n700,0.99", "R above 1 at 1 point"),
        ("nm,e1,e2\n" + rows(W, E1, E2), "n and k from the permittivity"),
        ("nm,n\n640,1.5\n900,1.4", "only 640 to 700 nm"),
        ("nm,n,k\n400,1.5,-0.00002\n500,1.5,0.00002\n700,1.5,0\n", "k below 0 at 1 point"),
        ("400,0.25\n700,0.36", "taken as the reflectance R"),
        ("nm,n,k,R\n" + rows(W, N, K, R), "left aside"),
    ],
)
def test_what_was_assumed_is_said_and_kept_by_the_bake(text, says):
    constants = read_text(text)
    assert any(says in line for line in constants.assumed), constants.assumed
    assert all(line.isprintable() for line in constants.assumed)
    assert bake(constants).source.assumed == constants.assumed
    assert (
        says in json.loads(json_text(bake(constants).to_dict()))["source"]["assumed"][-1] or len(constants.assumed) > 1
    )


def test_the_preview_of_a_file(tmp_path):
    path = tmp_path / "Au.csv"
    path.write_text("wavelength_nm,n,k\n" + rows(W, N, K))
    seen = preview(path)
    assert (seen.name, seen.read_as, seen.quantity, seen.covers_visible) == ("Au.csv", "a table", "n and k", True)
    assert np.abs(np.array(seen.f0) - GOLD).max() <= WITHIN and seen.swatch[0] > 0.99 and 0.6 < seen.swatch[2] < 0.75
    assert preview(tmp_path / "none.csv").trouble and preview(tmp_path / "none.csv").constants is None


# --- formats ---


def test_every_formula_of_a_glass_catalogue_is_the_one_of_its_number():
    """Each against coefficients by which another formula gives the same index."""
    w = 0.5
    flat = {
        1: [2.25],
        3: [1.5],
        5: [1.5],
        7: [2.25],
        8: [2.25],
        10: [2.25],
        12: [2.25],
        13: [2.25],
        4: [1.25],
        9: [2.25],
    }
    for number, coefficients in flat.items():
        agf = f"NM X {number} 0 1.5 60 0\nCD {' '.join(map(str, coefficients))}\nLD 0.3 2\n"
        np.testing.assert_allclose(read_text(agf, "x.agf").at(1000.0 * w)[0], 1.5, rtol=1e-12)
    for number in (2, 6, 11):
        agf = f"NM X {number} 0 1.5 60 0\nCD 1 0.01 0.5 0.02\nLD 0.3 2\n"
        np.testing.assert_allclose(
            read_text(agf, "x.agf").at(500.0)[0], np.sqrt(1 + 0.25 / 0.24 + 0.5 * 0.25 / 0.23), rtol=1e-12
        )
    worked = {
        1: 2 + 0.25 + 4 + 16 + 64 + 256,
        3: (1 + 2 / 0.222 + 3 / 0.222**2 + 4 * 0.25 + 5 * 0.0625 + 6 * 0.015625) ** 2,
        5: (1 + 2 / 0.5 + 3 / 0.5**3.5) ** 2,
        7: 3 + 1 / (0.25 - 0.01) - 0.5 * 0.25,
        8: 3 + 0.25 / (0.25 - 0.01) - 0.5 * 0.25,
        4: 2 + 0.25 / (0.25 - 0.01) + 0.5 / (0.25 - 0.04),
        9: 2 + 0.25 / (0.25 - 0.01) + 0.5 * 0.25 / (0.25 - 0.04),
        10: 2 + 0.25 + 4 + 16 + 64 + 256 + 1024 + 4096,
        12: 2 + 0.25 + 4 + 16 + 64 + 256 + 0.0625 + 0.015625,
        13: 2 + 0.25 + 0.0625 + 4 + 16 + 64 + 256 + 1024 + 4096,
    }
    given = {
        3: [1, 2, 3, 4, 5, 6],
        5: [1, 2, 3],
        7: [3, 1, 0.01, 0.5],
        8: [3, 1, 0.01, 0.5],
        4: [1, 1, 0.1, 0.5, 0.2],
        9: [2, 1, 0.01, 0.5, 0.04],
    }
    for number, n2 in worked.items():
        coefficients = given.get(number, [2] + [1] * (FORMULAS[number][1] - 1))
        assert FORMULAS[number][2](0.5, coefficients) == pytest.approx(n2, rel=1e-12), number


def test_a_catalogue_is_a_list_to_choose_from(tmp_path):
    path = tmp_path / "MAKER.AGF"
    coefficients = "1.03961212 6.00069867E-03 2.31792344E-01 2.00179144E-02 1.01046945 1.03560653E+02"
    glass = f"NM {{}} 2 517642 1.5168 64.17 0 1\nCD {coefficients}\nLD 0.31 2.5\n"
    path.write_text(
        "CC\n"
        + glass.format("N-BK7")
        + glass.format("B270").replace("1.0396", "1.1")
        + "IT 0.4 0.9 10\nIT 0.5 0.99 10\nIT 0.7 0.99 10\n"
    )
    with pytest.raises(Ambiguous) as asked:
        read_file(path)
    assert asked.value.choices == ("N-BK7", "B270")
    bk7, other = read_file(path, choose="n-bk7"), read_file(path, choose="B270")
    assert bk7.title == "N-BK7" and not bk7.has_k
    np.testing.assert_allclose(bk7.at(587.6)[0], 1.5168, atol=2e-5)
    np.testing.assert_allclose(other.at(500.0)[1], -np.log(0.99) * 500e-9 / (4 * np.pi * 0.01), rtol=1e-6)


def test_the_address_the_path_and_the_id_find_a_dataset():
    for address in (
        "https://refractiveindex.info/?shelf=main&book=Au&page=Johnson",
        "main/Au/nk/Johnson.yml",
        "main/Au/Johnson",
        "database/data/main/Au/nk/Johnson.yml",
        "http://refractiveindex.info/?shelf=main&book=Au&page=Johnson#x",
        "data-nk/main/Au/Johnson.yml",
    ):
        assert optical_constants.load(address).dataset == "main/Au/Johnson", address
    assert read_text("https://refractiveindex.info/?shelf=main&book=Au&page=Johnson\n").dataset == "main/Au/Johnson"
    assert optical_constants.dataset_of_address("specs/schott/optical/N-BK7.yml") == "specs/SCHOTT-optical/N-BK7"
    for nothing in ("https://refractiveindex.info/", "main/Au/None", "x"):
        assert optical_constants.dataset_of_address(nothing) is None
    with pytest.raises(FacetFilmError, match="shelf, book and page"):
        read_text("https://refractiveindex.info/about")


def test_the_permittivity_of_a_metal_keeps_its_digits():
    n, k = index_of_permittivity(E1, E2)
    np.testing.assert_allclose(n, N, rtol=1e-9)
    np.testing.assert_allclose(k, K, rtol=1e-9)
    assert index_of_permittivity(-1e8, 1e-3)[0] == pytest.approx(5e-8, rel=1e-6)


def test_transmittance_of_a_stated_thickness_gives_k():
    k = 1e-6
    r = ((1.5 - 1) / 2.5) ** 2
    tau = np.exp(-4 * np.pi * k * 2e6 / W)
    t = (1 - r) ** 2 * tau / (1 - r * r * tau * tau)
    constants = read_text("# thickness 2 mm\nnm,n,T\n" + rows(W, 0 * W + 1.5, t))
    np.testing.assert_allclose(constants.at(W)[1], k, rtol=1e-4)
    constants = read_text("nm,n,alpha (1/cm)\n" + rows(W, 0 * W + 1.5, 4e7 * np.pi * k / W))
    np.testing.assert_allclose(constants.at(W)[1], k, rtol=1e-4)


# --- tampered with ---

COLUMNS = {"wavelength_nm": W, "n": N, "k": K}


@pytest.mark.parametrize("order", [(0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)])
@pytest.mark.parametrize(
    "heads, unit",
    [(("wavelength (nm)", "n", "k"), 1.0), (("E (eV)", "n", "k"), 0.0), (("lambda_um", "eta", "kappa"), 1e-3)],
)
@pytest.mark.parametrize("sep", [",", ";", "\t"])
def test_columns_in_any_order(order, heads, unit, sep):
    columns = [W * unit if unit else EV, N, K]
    text = sep.join(heads[at] for at in order) + "\n" + rows(*(columns[at] for at in order), sep=sep)
    assert np.abs(f0_of(read_text(text)) - GOLD).max() <= WITHIN


TAMPERED = [name for name, reading in READINGS.items() if reading.f0 != REFUSED]


def read_or_refused(content, file, tmp_path):
    path = tmp_path / file
    path.write_bytes(content)
    try:
        return read_file(path)
    except FacetFilmError:
        return None


@pytest.mark.parametrize("name", TAMPERED)
def test_a_unit_dropped(name, tmp_path):
    """Read rightly, or refused: the numbers, not the unit, are then what decides."""
    reading = READINGS[name]
    content = reading.content
    for unit in (b"(nm)", b"[nm]", b"_nm", b" nm", b"(eV)", b"(um)", b"(cm-1)", b"(THz)", b"(%)"):
        if unit in content:
            constants = read_or_refused(content.replace(unit, b""), reading.file, tmp_path)
            assert constants is None or np.abs(f0_of(constants) - reading.f0).max() <= WITHIN, constants.assumed


@pytest.mark.parametrize("name", TAMPERED)
def test_a_line_cut_off(name, tmp_path):
    """A line ends in its middle, or is missing: right within what a point less tells, said, or refused."""
    reading = READINGS[name]
    lines = reading.content.split(b"\n")
    if len(lines) < 12:
        return
    for changed in (lines[:-6] + [lines[-6][: len(lines[-6]) // 2]] + lines[-5:], lines[:8] + lines[9:]):
        constants = read_or_refused(b"\n".join(changed), reading.file, tmp_path)
        assert constants is None or np.abs(f0_of(constants) - reading.f0).max() <= 0.06 or constants.assumed


@pytest.mark.parametrize("name", TAMPERED[::4])
def test_a_byte_flipped(name, tmp_path):
    reading, random = READINGS[name], np.random.default_rng(len(name))
    for _ in range(8):
        content = bytearray(reading.content)
        content[random.integers(len(content))] ^= 1 << random.integers(8)
        constants = read_or_refused(bytes(content), reading.file, tmp_path)
        assert constants is None or np.isfinite(f0_of(constants)).all()


# --- large files ---

BIG = 78_000


@pytest.mark.parametrize(
    "form, head, file",
    [
        ("{:.4f},{:.30f},{:.50f}\n", "nm,n,k\n", "a.csv"),
        ("{:.4f} {:.30f} {:.50f}\n", "", "a.txt"),
        ("{:.4f};{:.30f};{:.50f}\n", "nm;n;k\n", "a.csv"),
        ('"{:.4f}","{:.30f}","{:.50f}"\n', "nm,n,k\n", "a.csv"),
        ("<tr><td>{:.4f}<td>{:.20f}<td>{:.50f}\n", "", "a.html"),
        ("[{:.4f}, {:.30f}, {:.50f}],\n", "", "a.txt"),
    ],
)
def test_the_slowest_of_8_mb(form, head, file):
    w = np.linspace(300.0, 900.0, BIG)
    text = head + "".join(form.format(*row) for row in zip(w, 1.5 + 0.0 * w, 0.1 + 0.0 * w))
    start = time.process_time()
    try:
        assert read_text(text[:7_999_990].rpartition("\n")[0], file).n[0] == 1.5
    except FacetFilmError:
        pass
    assert time.process_time() - start < 2.0


def test_the_page_of_what_we_read_is_that_of_the_tables():
    assert what_we_read.PAGE.read_text(encoding="utf-8") == what_we_read.page(), "run tools/what_we_read.py"


@pytest.mark.parametrize("name", TAMPERED[::3])
def test_what_a_file_gave_is_kept_as_csv_under_its_name(name, tmp_path):
    """A material keeps its measurement so, and reads it again without the file, whatever the name says."""
    reading = READINGS[name]
    path = tmp_path / reading.file
    path.write_bytes(reading.content)
    constants = read_file(path)
    again = read_text(spectrum_csv(constants), reading.file)
    np.testing.assert_allclose(f0_of(again), f0_of(constants), atol=1e-6)


@pytest.mark.parametrize("name", ["x.yml", "absorb.txt", "Au.eta.spd", "k.txt", "x.json", "x.agf", "x.mat", "x.nk"])
def test_our_own_csv_is_read_under_any_name(name):
    for dataset in ("main/Au/Johnson", "main/SiO2/Malitson"):
        theirs = optical_constants.load(dataset)
        np.testing.assert_allclose(f0_of(read_text(spectrum_csv(theirs), name)), f0_of(theirs), atol=1e-9)


def test_a_number_that_stands_far_from_its_neighbours_is_asked_about():
    for at, values in ((12, N), (12, K), (14, R)):
        wrong = values.copy()
        wrong[at] *= 0.1
        columns = (W, wrong, K) if values is N else (W, N, wrong) if values is K else (W, wrong)
        text = ("nm,R\n" if values is R else "nm,n,k\n") + rows(*columns)
        assert any(f"in line {at + 2}, stands far" in line for line in read_text(text).assumed)
    assert not any("stands far" in line for line in read_text("nm,n,k\n" + rows(W, N, K)).assumed)


# --- the database by its files ---


def test_datasets_by_file_are_those_of_the_bundle():
    """Every 30th; tools/compare_database.py compares all."""
    outcomes, different, _ = compare_database.compared(compare_database.files_of_the_package(30))
    assert outcomes["equal"] > 80 and different == []


def test_files_that_were_tampered_with_are_read_or_refused(tmp_path):
    outcomes, failures, slowest = fuzz_readers.run(600, 3, tmp_path)
    assert failures == [] and outcomes["read"] > 20 and slowest < 2.0
