"""Exports held against what Blender brings: the MaterialX module, the Principled BSDF, the glTF exporter."""

import importlib
import json
import re
import sys

import bpy
import pytest

from addon.bake import bake
from addon.blender.datablocks.principled import principled_material
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


@pytest.fixture
def empty_file():
    bpy.ops.wm.read_factory_settings(use_empty=True)


@pytest.mark.parametrize("name", ["copper", "vinyl", "rubber"])
def test_the_principled_material_has_the_settings(name, empty_file):
    record = made(preset=name)
    material = principled_material(record)
    assert material.name == record.title
    nodes = {node.bl_idname: node for node in material.node_tree.nodes}
    shader = nodes["ShaderNodeBsdfPrincipled"]
    assert nodes["ShaderNodeOutputMaterial"].inputs["Surface"].links[0].from_node == shader
    sockets = {socket.identifier: socket.default_value for socket in shader.inputs}
    for identifier, value in named(record.model).principled(record).items():
        found = tuple(sockets[identifier]) if isinstance(value, tuple) else sockets[identifier]
        assert found == pytest.approx(value, abs=1e-6)
    assert json.loads(material["facet_film"])["baked"]["source"]["dataset"] == bake(name).source.dataset


def test_gltf_takes_it(empty_file, tmp_path):
    import addon_utils
    addon_utils.enable("io_scene_gltf2")
    baked, record = bake("gold"), made(preset="gold")
    bpy.ops.mesh.primitive_cube_add()
    bpy.context.object.data.materials.append(principled_material(record, "Ours"))
    bpy.ops.export_scene.gltf(filepath=str(tmp_path / "a.gltf"), export_format="GLTF_SEPARATE")
    exported = json.loads((tmp_path / "a.gltf").read_text())["materials"][0]
    assert exported["name"] == "Ours"
    metallic = exported["pbrMetallicRoughness"]
    assert metallic["baseColorFactor"][:3] == pytest.approx(baked.f82.f0, abs=1e-5)
    assert metallic.get("metallicFactor", 1.0) == pytest.approx(1.0)
    assert metallic["roughnessFactor"] == pytest.approx(named(record.model).principled(record)["Roughness"], abs=1e-5)
    tint = exported["extensions"]["KHR_materials_specular"]["specularColorFactor"]
    assert tint == pytest.approx(baked.f82.tint, abs=1e-5)


def test_usd_takes_it(empty_file, tmp_path):
    baked, record = bake("gold"), made(preset="gold")
    bpy.ops.mesh.primitive_cube_add()
    bpy.context.object.data.materials.append(principled_material(record, "Ours"))
    path = tmp_path / "a.usda"
    bpy.ops.wm.usd_export(filepath=str(path), generate_preview_surface=True)
    values = dict(re.findall(r"inputs:(\w+) = (.+)", path.read_text()))
    assert float(values["metallic"]) == 1.0
    assert float(values["roughness"]) == pytest.approx(named(record.model).principled(record)["Roughness"], abs=1e-5)
    diffuse = [float(number) for number in values["diffuseColor"].strip("()").split(",")]
    assert diffuse == pytest.approx(baked.f82.f0, abs=1e-5)
