"""Exports held against what Blender brings: the MaterialX module, the Principled BSDF, the glTF exporter."""

import importlib
import sys

import bpy
import pytest

from addon.catalogue import presets
from addon.models import named
from addon.models.making import exported, made

PYTHON = f"python{sys.version_info.major}.{sys.version_info.minor}"


@pytest.fixture(scope="module")
def mx():
    """The MaterialX module in Blender's own folder."""
    sys.path.append(f"{bpy.utils.resource_path('LOCAL')}/python/lib/{PYTHON}/site-packages")
    yield importlib.import_module("MaterialX")
    sys.path.pop()


def validated(mx, text):
    """The document of a text, with MaterialX's own libraries, that says it is valid."""
    document, library = mx.createDocument(), mx.createDocument()
    mx.readFromXmlString(document, text)
    mx.loadLibraries(mx.getDefaultDataLibraryFolders(), mx.getDefaultDataSearchPath(), library)
    document.importLibrary(library)
    valid, message = document.validate()
    assert valid, message
    return document


@pytest.mark.parametrize("name", ["copper", "figure_6a", "figure_6b", "vinyl", "rubber"])
@pytest.mark.parametrize("space", ["Rec.709", "Rec.2020", "ACEScg"])
def test_materialx_validates(mx, name, space):
    document = validated(mx, exported(made(preset=name, viewing={"space": space}), "materialx"))
    assert len(document.getMaterialNodes()) == 2
    nodes = document.getNodes()
    assert {"conductor_bsdf", "generalized_schlick_bsdf", "surface"} <= {node.getCategory() for node in nodes}
    for node in nodes:
        definition = node.getNodeDef()
        assert definition is not None, f"{node.getName()} is no node that MaterialX knows"
        known = {one.getName(): one.getType() for one in definition.getActiveInputs()}
        for one in node.getInputs():
            assert known[one.getName()] == one.getType()


def test_every_preset_validates(mx):
    offered = [preset for preset in presets.all_presets().values()
               if preset.measured and "materialx" in named(preset.model).forms]
    for preset in offered[::10]:
        validated(mx, exported(made(preset=preset.name), "materialx"))


def test_a_faulty_document_does_not_validate(mx):
    faulty = exported(made(preset="copper"), "materialx").replace('type="color3"', 'type="vector4"', 1)
    with pytest.raises(AssertionError):
        validated(mx, faulty)
