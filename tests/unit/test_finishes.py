"""The finishes: their data, what they set, and what a record keeps of them."""

from importlib import import_module

import pytest

from addon import finishes
from addon.errors import FacetFilmError
from addon.finishes import feeding
from addon.finishes.groups import GROUPS
from addon.models import all_models, named
from addon.models.finishing import finished, kept_finish
from addon.models.making import made, rebaked, switched
from addon.models.record import from_dict, from_json

ALL = finishes.all_finishes()
TAKE = [model for model in all_models() if feeding.takes(model)]


def tables():
    return {group.identifier: import_module("addon.finishes." + group.build.partition(".")[0])
            for group in GROUPS}


def test_there_are_the_finishes_that_people_ask_for():
    assert len(ALL) >= 10
    assert {"polished", "satin", "brushed", "brushed_circular", "sandblasted", "hammered", "cast", "scratched",
            "smudged", "worn_edges", "paper_1982"} == set(finishes.names())


@pytest.mark.parametrize("finish", ALL, ids=lambda finish: finish.name)
def test_each_says_what_it_looks_like_and_where_its_slopes_are_from(finish):
    assert finish.title and finish.note and not finish.note.endswith(".")
    assert finish.source.startswith("Chosen by eye") == finish.chosen
    assert sum(w for _, w in finish.slopes) == pytest.approx(1.0) and all(0.0 < m <= 1.0 for m, _ in finish.slopes)
    assert 0.0 <= finish.anisotropy < 1.0
    assert finish.group in {"", *tables()}


@pytest.mark.parametrize("finish", [finish for finish in ALL if finish.anisotropy], ids=lambda finish: finish.name)
def test_anisotropy_gives_the_two_slopes_that_were_measured(finish):
    """Ward's rolled brass: alpha 0.05 along the marks, 0.16 across them, as √(1 − 0.9 a) has them."""
    (m, _), = finish.slopes
    aspect = (1.0 - 0.9 * finish.anisotropy) ** 0.5
    assert (m * aspect, m / aspect) == pytest.approx((0.05, 0.16), rel=0.01)


@pytest.mark.parametrize("finish", [finish for finish in ALL if finish.group], ids=lambda finish: finish.name)
def test_controls_are_inputs_of_the_group(finish):
    marks = tables()[finish.group]
    assert set(finish.controls) <= {socket.name for row in marks.TABLE for socket in row.sockets()}


def test_every_group_is_of_one_finish():
    assert sorted(finish.group for finish in ALL if finish.group) == sorted(tables())


@pytest.mark.parametrize("marks", tables().values(), ids=tables())
def test_every_input_says_what_it_does(marks):
    for row in marks.TABLE:
        assert row.tip and not row.tip[0].islower() and not row.tip.endswith(".")
    names = [socket.name for row in marks.TABLE for socket in row.sockets()]
    assert len(names) == len(set(names)) and {"Roughness", "UV", "Vector", "Normal"} <= set(names)
    assert "Roughness" in marks.DRIVES


def test_a_table_decides_which_models_take_finishes():
    assert {model.name for model in TAKE} == {"cook_torrance", "film", "clear"}
    with pytest.raises(FacetFilmError, match="which Layered RGB has not"):
        made(preset="nacre", finish="brushed")


@pytest.mark.parametrize("name, near", [
    ("bruhsed", "brushed"), ("sandblastet", "sandblasted"), ("hamered", "hammered")])
def test_an_unknown_finish_is_one_sentence_with_the_nearest(name, near):
    with pytest.raises(FacetFilmError, match=f"finish '{name}' is unknown; did you mean '{near}'"):
        made(preset="window_glass", finish=name)
    with pytest.raises(FacetFilmError, match="such as 'brushed'"):
        made(preset="window_glass", finish=3)


@pytest.mark.parametrize("model", TAKE, ids=lambda model: model.name)
@pytest.mark.parametrize("finish", ALL, ids=lambda finish: finish.name)
def test_a_finish_goes_on_any_model_with_a_roughness(model, finish):
    preset = {"cook_torrance": "copper", "film": "anodised_titanium", "clear": "window_glass"}[model.name]
    plain = made(preset=preset)
    done = finished(plain, finish.name)
    assert done.finish == finish.name
    for name, value in feeding.surface(finish, model).items():
        assert getattr(done.parameters, name) == value
    for feed in feeding.feeds(done):
        assert feed.group == finish.group and set(feed.links) <= {socket.name for socket in model.sockets("fast")}
    assert finished(done, "").parameters == plain.parameters


def test_what_one_gives_goes_over_the_finish():
    assert made(preset="copper", finish="satin", slopes=[(0.3, 1.0)]).parameters.slopes == ((0.3, 1.0),)
    assert made(preset="anodised_titanium", finish="satin", roughness=0.2).parameters.roughness == 0.2


def test_the_papers_finish_is_its_figures():
    assert made(preset="copper", finish="paper_1982").parameters.slopes \
        == made(preset="figure_6b").parameters.slopes == ((0.4, 0.4), (0.2, 0.6))


def test_the_finish_stays_with_everything_else_that_changes():
    record = made(preset="copper", finish="hammered").changed(controls={"Scale": 9.0})
    for other in (switched(record, "exact"), rebaked(record), from_dict(record.to_dict()),
                  kept_finish(record, made(preset="gold"))):
        assert (other.finish, other.controls) == ("hammered", {"Scale": 9.0})
    assert finished(record, "cast").controls == {}


def test_what_the_nodes_hold_goes_over_what_was_kept():
    kept = made(preset="copper", finish="hammered").to_json()
    bare = made(preset="copper")
    assert from_json(kept, bare.changed(finish="hammered")).finish == "hammered"
    assert from_json(kept, bare.changed(finish="cast")).finish == "cast"
    assert from_json(kept, bare).finish == ""  # someone took its node away
    assert from_json(made(preset="copper", finish="satin").to_json(), bare).finish == "satin"


def test_a_record_without_a_finish_is_read():
    held = made(preset="copper").to_dict()
    del held["finish"], held["controls"]
    assert from_dict(held).finish == ""


def test_only_changed_controls_are_kept():
    usual = feeding.feeds(made(preset="anodised_titanium", finish="hammered"))[0].values
    assert feeding.changed_controls("finish_hammered", dict(usual), {"Roughness"}) == {}
    assert feeding.changed_controls("finish_hammered", {**usual, "Scale": 9.0}, {"Roughness"}) == {"Scale": 9.0}


def test_models_are_asked_by_their_tables():
    satin = finishes.find("satin")
    assert "slopes" in feeding.surface(satin, named("cook_torrance"))
    assert feeding.surface(satin, named("film"))["roughness"] == pytest.approx(0.13 ** 0.5)
