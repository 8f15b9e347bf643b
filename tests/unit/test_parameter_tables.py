"""The tables of the models, and what is made of them: checked classes, sockets, the OSL text's signature,
the document.
"""

import re

import numpy as np
import pytest

from addon import models
from addon.errors import FacetFilmError
from addon.models.osl import parameter_of
from addon.models.parameters import read, written
from addon.models.realisations import REALISATIONS
from tools import build_parameters

MODELS = models.all_models()
ROWS = [(model, row) for model in MODELS for row in model.parameters.TABLE]
IDS = [f"{model.name} {row.name}" for model, row in ROWS]
SCRIPTED = [model for model in MODELS if any(REALISATIONS[name].osl for name in model.realisations)]


@pytest.mark.parametrize("model, row", ROWS, ids=IDS)
def test_every_row_says_what_it_is_and_where_it_may_lie(model, row):
    assert row.tip and not row.tip[0].islower() and not row.tip.endswith(".")
    for socket in row.sockets():
        assert socket.tip and socket.name and socket.key.isidentifier()
        if socket.low is not None and socket.default is not None:
            assert np.all(np.asarray(socket.default) >= socket.low)
            assert np.all(np.asarray(socket.default) <= socket.high)
        assert socket.plugged == (socket.default is None)


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.name)
def test_no_socket_of_a_group_stands_twice(model):
    for realisation in model.realisations:
        names = [socket.name for socket in model.sockets(realisation)]
        keys = [socket.key for socket in model.sockets(realisation)]
        assert len(set(names)) == len(names) and len(set(keys)) == len(keys)


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.name)
def test_the_defaults_come_back_from_the_sockets(model):
    parameters = model.parameters()
    values = {socket.name: socket.default
              for realisation in model.realisations for socket in model.sockets(realisation)}
    assert model.read(values, {}) == parameters
    held = {**values, **written(parameters)}
    assert {name: value for name, value in read(model.parameters.TABLE, held).items()} \
        == {name: getattr(parameters, name) for name in read(model.parameters.TABLE, held)}


@pytest.mark.parametrize("model, row", [pair for pair in ROWS if pair[1].is_value],
                         ids=[name for name, pair in zip(IDS, ROWS) if pair[1].is_value])
def test_a_class_refuses_what_its_row_refuses(model, row):
    for value in (object(), float("nan"), "no such thing"):
        with pytest.raises(FacetFilmError, match=row.name.split("_")[0].rstrip("s")):
            model.parameters().changed(**{row.name: value})


def signature(source):
    """{parameter: (type, numbers of its default)} of the shader in an OSL text."""
    inside = re.search(r"^shader \w+\((.*?)\)\n\{", source, re.DOTALL | re.MULTILINE)[1]
    inside = inside.partition("output ")[0]
    found = re.findall(r"(float|int|vector|color) (\w+) = (?:\w+\((.*?)\)|([\d.]+))", inside)
    return {name: (kind, [float(number) for number in (many or one).split(",")]) for kind, name, many, one in found}


@pytest.mark.parametrize("model", SCRIPTED, ids=lambda model: model.name)
def test_the_osl_text_has_the_parameters_of_the_table(model):
    """Names, types, order and defaults; what the scripts clamp is tested by pixels.  Where nodes beside the script look
    its colours up, it has the parameters Seen..., and not those that say where in the image.
    """
    found = signature((model.folder / f"{model.name}.osl").read_text(encoding="utf-8"))
    seen = [found.pop(name) for name in list(found) if name.startswith("Seen")]
    assert bool(seen) == (model.picture is not None) and all(kind == "color" for kind, _ in seen)
    assert "osl_fast" not in model.realisations or found.pop("Exact") == ("int", [1.0])
    sockets = [socket for socket in model.sockets("osl") if not seen or parameter_of(socket.name) in found]
    assert list(found) == [parameter_of(socket.name) for socket in sockets]
    for socket in sockets:
        kind, numbers = found[parameter_of(socket.name)]
        assert kind == {"FLOAT": "float", "VECTOR": "vector", "COLOR": "color"}[socket.kind], socket.name
        default = np.zeros(3) if socket.default is None else np.asarray(socket.default)
        assert np.allclose(numbers[0] if len(numbers) == 1 else numbers, default), socket.name


def test_a_signature_is_read():
    text = ("shader x(\n    float A = 1.5,\n    color B = color(0.8),\n    vector C = vector(1, 2, 3),\n"
            "    int D = 1)\n{")
    assert signature(text) == {"A": ("float", [1.5]), "B": ("color", [0.8]), "C": ("vector", [1.0, 2.0, 3.0]),
                               "D": ("int", [1.0])}


def test_the_document_is_what_its_tool_builds():
    assert build_parameters.FILE.read_text(encoding="utf-8") == build_parameters.text()
