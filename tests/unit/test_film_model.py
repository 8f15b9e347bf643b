"""The film model without Blender: its picture, its file format, and what a record says of it."""

import struct
import zlib

import numpy as np
import pytest

from addon.bake.film_table import smallest_table
from addon.bake.stack_notation import parse
from addon.errors import FacetFilmError
from addon.models.film import known
from addon.models.film.parameters import Film
from addon.models.film.tables import OF_METALS, picture, stack_of, table_of
from addon.models.making import made, of_other_words, rebaked
from addon.models.record import from_dict
from addon.nodes.exr import LINES, exr_bytes
from addon.spectra.optical_constants import load
from tools import build_film_facts

SOAP = Film(stack="soap 5-1000 nm / air", see_through=1.0)


def read(data, rows, columns):
    """Blue, green, red of a compressed file of one block, from the top, as the format's documents say."""
    at = data.index(b"screenWindowWidth\0float\0") + len(b"screenWindowWidth\0float\0") + 8 + 1
    place, = struct.unpack_from("<Q", data, at)
    start, size = struct.unpack_from("<ii", data, place)
    raw = zlib.decompress(data[place + 8:place + 8 + size])
    halves = np.cumsum(np.frombuffer(raw, np.uint8).astype(int) - np.r_[0, np.full(len(raw) - 1, 128)]) % 256
    middle = (len(raw) + 1) // 2
    plain = np.empty(len(raw), np.uint8)
    plain[::2], plain[1::2] = halves[:middle], halves[middle:]
    assert start == 0 and rows <= LINES
    return plain.tobytes(), np.frombuffer(plain.tobytes(), "<f2").reshape(rows, 3, columns)


def test_a_file_holds_the_pixels_to_half_precision():
    y, x = np.mgrid[0:9, 0:300] / 300.0
    pixels = np.stack([x, y, x * y], axis=-1)
    _, found = read(exr_bytes(pixels), 9, 300)
    np.testing.assert_array_equal(np.moveaxis(found, 1, 2)[::-1, :, ::-1], pixels.astype(np.float16))


def test_a_picture_is_another_for_another_light_stack_or_side():
    first = picture(SOAP, {"space": "Rec.709"})
    others = [picture(SOAP, {"space": "Rec.2020"}), picture(SOAP.changed(see_through=0.0), {"space": "Rec.709"}),
              picture(Film(), {"space": "Rec.709"})]
    assert len({first.key, *(other.key for other in others)}) == 4
    assert picture(SOAP.changed(roughness=0.5, thickness=1.0), {"space": "Rec.709"}).key == first.key


def test_what_is_seen_through_has_what_is_absorbed_above_its_table():
    pixels, values, sockets = picture(SOAP, {}).make()
    rows, columns = table_of(SOAP.stack, {}).size
    assert pixels.shape == (2 * rows, columns, 4) and values == {"stack": SOAP.stack}
    assert sockets["Image Rows"] == 2 * sockets["Rows"] == 2 * rows
    assert not pixels[rows:, :, :3].any()  # soap absorbs nothing
    visor = Film(stack="Au 5-40 nm / 1.585", see_through=1.0)
    pixels = picture(visor, {}).make()[0]
    assert pixels[len(pixels) // 2:, :, :3].max() > 0.3


def test_what_is_known_of_the_presets_is_what_is_found():
    """films.table is of the presets and formulas of today: run tools/build_film_facts.py."""
    found = build_film_facts.found(known.tracks())
    assert list(known.tables()) == [row[0] for row in found["tables"]]
    for stack, size, steps, errors in found["tables"]:
        assert known.tables()[stack][:2] == (tuple(size), steps and tuple(steps)), stack
        assert known.tables()[stack][2] == pytest.approx(errors, abs=2e-3)
    assert list(known.errors()) == [row[:2] for row in found["errors"]]
    for *key, now in found["errors"]:
        before = known.errors()[tuple(key)]
        assert before == {name: pytest.approx(values, abs=2e-3) for name, values in now.items()}


def test_a_preset_takes_what_is_known_and_says_the_same():
    taken = made(preset="heat_blued_steel").baked
    table = smallest_table(parse("Fe3O4 0-120 nm / Fe", load), tolerance=OF_METALS)
    assert taken["table"]["size"] == list(table.size) == [32, 128]
    assert taken["table"]["delta_e_2000_max"] == pytest.approx(table.delta_e_2000_max, abs=1e-4)
    np.testing.assert_allclose(table_of("Fe3O4 0-120 nm / Fe", {}).rgb, table.rgb, atol=1e-6)


def test_other_words_keep_what_they_can():
    film = made(preset="anodised_titanium", roughness=0.5)
    same = of_other_words(film, "Nb2O5 0-300 nm / Nb")
    assert same.parameters == film.parameters.changed(stack="Nb2O5 0-300 nm / Nb")
    assert same.source.name == same.parameters.stack == same.baked["stack"]
    beyond = of_other_words(film, "SiO2 300-400 nm / Si")
    assert (beyond.parameters.thickness, beyond.parameters.thickness_range, beyond.parameters.roughness) == (
        350.0, None, 0.5)
    with pytest.raises(FacetFilmError, match="is not made of what a text says"):
        of_other_words(made(preset="copper"), "SiO2 300-400 nm / Si")
    with pytest.raises(FacetFilmError, match="At 'Foo 3 nm'"):
        of_other_words(film, "Foo 3 nm / Si")


def test_progress_is_told_once_while_a_table_is_made():
    told = []
    film = made(preset="anodised_titanium")
    of_other_words(film, "Nb2O5 0-310 nm / Nb", progress=told.append)
    assert told and told[-1] == pytest.approx(1.0)
    count = len(told)
    of_other_words(film, "Nb2O5 0-311 nm / Nb")
    assert len(told) == count


@pytest.mark.parametrize("viewing, outside", [({"medium": 1.333}, "1.333"), ({}, "air")])
def test_a_medium_is_what_is_outside(viewing, outside):
    assert table_of(Film().stack, viewing).stack.outside == outside


def test_a_record_says_how_far_each_realisation_is_off():
    record = made(preset="TiO2 0-200 nm / Ti")
    assert record.measured and record.source.name == "TiO2 0-200 nm / Ti"
    standard, reference = (record.baked["realisations"][name] for name in ("standard", "reference"))
    assert standard["sphere_mean"] < 0.7 and reference["sphere_mean"] < 0.1
    assert record.baked["table"]["delta_e_2000_max"] < 0.5


def test_a_film_of_ones_own_data_is_baked_where_its_file_is_not(tmp_path):
    file = tmp_path / "my oxide.csv"
    file.write_text("wavelength_nm,n,k\n360,2.5,0.1\n780,2.3,0.0\n", encoding="utf-8")
    record = made(preset=f"{file} 0-100 nm / Ti", thickness=40.0)
    kept = record.to_dict()
    file.unlink()
    stack_of.cache_clear()
    found = from_dict(kept)
    assert found == record and found.source.data == found.parameters.own_layers != ""
    again = rebaked(found, viewing={"illuminant": "A"})
    assert again.parameters == record.parameters and again.viewing["illuminant"] == "A"
    other = of_other_words(found, f"SiO2 50 nm / {file} 0-100 nm / Ti")
    assert len(other.baked["layers"]) == 4
    assert of_other_words(found, "SiO2 0-50 nm / Ti").parameters.own_layers == ""
    with pytest.raises(FacetFilmError, match="At '"):
        made(preset=f"{file} 0-100 nm / Ti")
