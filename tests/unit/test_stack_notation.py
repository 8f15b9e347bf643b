"""Stacks in one line: what is read, what is written back, and what is refused with the place."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from addon.bake.film_names import DATASETS, constant_index
from addon.bake.film_stack import MOST_FILMS
from addon.bake.stack_notation import parse, written
from addon.catalogue.resolving import is_stack
from addon.errors import FacetFilmError
from addon.spectra import optical_constants
from addon.spectra.optical_constants import load


@pytest.mark.parametrize("text, outside, films, below", [
    ("main/TiO2/Jolivet-anatase 60 nm / main/Ti/Palm", "1", [("main/TiO2/Jolivet-anatase", 60, 60)], "main/Ti/Palm"),
    ("water | MgF2 100 nm / glass", "main/H2O/Hale", [("main/MgF2/Dodge-o", 100, 100)], "popular_glass/BK7/SCHOTT"),
    ("SiO2 0-1000 nm / Si", "1", [("main/SiO2/Malitson", 0, 1000)], "main/Si/Schinke"),
    ("soap 5–1000 nm / air", "1", [("main/H2O/Hale", 5, 1000)], "1"),
    ("glass|1.0 .2µm / 1.5 30 Å / Si", "popular_glass/BK7/SCHOTT",
     [("1", 200, 200), ("1.5", 3, 3)], "main/Si/Schinke"),
    ("(1.68+0.03i 56-104nm / 1.55+.14i 56-104 nm)x2 / 1.56", "1",
     [("1.68+0.03i", 56, 104), ("1.55+0.14i", 56, 104)] * 2, "1.56"),
    ("((SiO2 1 nm / TiO2 2 nm)x2 / 1.517+8800/λ² 3 nm)x2 / Ti", "1",
     ([("main/SiO2/Malitson", 1, 1), ("main/TiO2/Jolivet-anatase", 2, 2)] * 2 + [("1.517+8800/λ²", 3, 3)]) * 2,
     "main/Ti/Palm"),
    ("main/Ti/Palm", "1", [], "main/Ti/Palm")])
def test_what_is_read(text, outside, films, below):
    stack = parse(text, load)
    assert stack.outside_constants.dataset == outside and stack.below_constants.dataset == below
    assert [(film.constants.dataset, film.low, film.high) for film in stack.films] == films


WORDS = ["SiO2", "main/TiO2/Siefke", "1.38", "1.5+0.1i", "1.5+4200/λ²"]
layers = st.builds("{} {}{} nm".format, st.sampled_from(WORDS), st.integers(0, 300),
                   st.sampled_from(["", "-400"]))


@given(st.lists(layers, max_size=5), st.integers(1, 3), st.sampled_from(["", "water | "]))
def test_what_is_written_is_read_back_as_the_same(films, times, outside):
    text = outside + " / ".join([*films * times, "Si"])
    stack = parse(text, load)
    again = parse(written(stack), load)
    assert [(film.word, film.low, film.high) for film in again.films] == \
        [(film.word, film.low, film.high) for film in stack.films]
    assert (again.outside, again.below) == (stack.outside, stack.below)
    assert len(written(stack)) <= len(text) and written(again) == written(stack)


def test_repeats_are_written_in_brackets_with_what_is_around_them():
    text = "1.38 100 nm / (TiO2 58 nm / SiO2 94 nm)x7 / TiO2 58 nm / glass"
    assert written(parse(text, load)) == text


@pytest.mark.parametrize("text, said", [
    ("MgF3 60 nm / glass", "^At 'MgF3 60 nm': 'MgF3' is unknown; did you mean 'MgF2'"),
    ("main/MgF2/Dodge 60 nm / glass", "^At 'main/MgF2/Dodge 60 nm': .* did you mean 'main/MgF2/Dodge-"),
    ("SiO2 60 nm / main/Cu/Jonson", "^At 'main/Cu/Jonson': .* did you mean 'main/Cu/Johnson'"),
    ("SiO2 60 nm / main/Cu2O/Palik", "^At 'main/Cu2O/Palik': "),
    ("SiO2 -60 nm / Si", "^At 'SiO2 -60 nm': a thickness is from 0 nm"),
    ("SiO2 60-20 nm / Si", "^At 'SiO2 60-20 nm': .* lower end of a range first"),
    ("SiO2 / Si", "^At 'SiO2': a film is named with its thickness"),
    ("SiO2 60 / Si", "^At 'SiO2 60': a film is named with its thickness"),
    ("SiO2 60 nm", "^At 'SiO2 60 nm': the last layer is what is below"),
    ("SiO2 60 nm / ", "a layer is missing"),
    ("SiO2 60 nm /  / Si", "a layer is missing"),
    ("(SiO2 60 nm / TiO2 20 nm / Si", "a bracket has no other"),
    ("(SiO2 60 nm / TiO2 20 nm)x0 / Si", "repeat 1 to 50 times, not 0"),
    ("(SiO2 60 nm / TiO2 20 nm)x3", "the last layer is what is below"),
    ("air | water | SiO2 60 nm / Si", "before one bar"),
    ("Ti | SiO2 60 nm / Si", "^'Ti' is outside of the stack and must not absorb"),
    ("1.3-2.5 60 nm / Si", "^At '1.3-2.5 60 nm': The index -1.2 needs n above 0"),
    ("1.3-0.5i 60 nm / Si", "k of at least 0"),
    ("SiO2 0-40 µm / Si", "^The films come to 588.. nm of n times thickness, and interference is calculated to 20000"),
    ("", "^A stack is a text"), (5, "^A stack is a text .* not 5")])
def test_what_is_no_stack_is_refused_with_the_place(text, said):
    with pytest.raises(FacetFilmError, match=said):
        parse(text, load)


def test_the_reason_is_said_in_the_same_language_as_the_place():
    with pytest.raises(FacetFilmError) as error:
        parse("SiO2 60 nm / main/Cu/Jonson", load)
    said = error.value.said(lambda text: text.replace("At ", "Bei ").replace("is unknown", "ist unbekannt"))
    assert said.startswith("Bei 'main/Cu/Jonson': dataset 'main/Cu/Jonson' ist unbekannt")


def test_too_many_films_and_layers_without_data_are_refused():
    with pytest.raises(FacetFilmError, match=f"at most {MOST_FILMS} films; this one has 102"):
        parse("((SiO2 1 nm / TiO2 1 nm)x17)x3 / Si", load)
    infrared = optical_constants.OpticalConstants([680.0, 2000.0], [2.0, 2.0], [0.0, 0.0], "mine.csv")
    with pytest.raises(FacetFilmError, match="'mine' is measured from 680 to 2000 nm, so hardly in the visible"):
        parse("mine 20 nm / Si", lambda word: infrared if word == "mine" else load(word))
    mirror = optical_constants.from_normal_reflectance([400.0, 700.0], [0.5, 0.5], "mine.csv")
    with pytest.raises(FacetFilmError, match="only the normal reflectance"):
        parse("SiO2 20 nm / mine", lambda word: mirror if word == "mine" else load(word))


@pytest.mark.parametrize("word, n, k", [("1.5", 1.5, 0.0), ("1.38+0.1i", 1.38, 0.1), ("1.5+4000/λ^2", 1.516, 0.0),
                                        ("1.5 - 4000/L² + 6e8/lambda⁴+0.2i", 1.4936, 0.2), (".9", 0.9, 0.0)])
def test_indices_that_are_written_out(word, n, k):
    found = constant_index(word)
    assert found.at(500.0)[0] == pytest.approx(n, abs=1e-4) and found.at(500.0)[1] == k
    assert constant_index(found.dataset).at(400.0) == found.at(400.0)


@pytest.mark.parametrize("word", ["SiO2", "1.5x", "0.1i", "x1.5", "1.5+", "1.5/λ³", "1.5 2"])
def test_what_is_no_index(word):
    assert constant_index(word) is None


def test_every_word_means_a_dataset_that_covers_the_visible():
    for word, dataset in DATASETS.items():
        assert load(dataset).covers_visible, word
    assert not is_stack("copper") and not is_stack("main/Cu/Johnson") and is_stack("water|glass")
