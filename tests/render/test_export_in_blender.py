"""Exports held against what Blender brings: the MaterialX module, its libraries and its code generation."""

import importlib
import re
import shutil
import subprocess
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
    assert len(document.getMaterialNodes()) == 3
    nodes = document.getNodes()
    used = {node.getCategory() for node in nodes}
    assert {"conductor_bsdf", "generalized_schlick_bsdf", "surface", "open_pbr_surface"} <= used
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


FIVE = {"copper": {}, "kapton": {}, "green_glass": {}, "soap_bubble": {}, "anodised_titanium": {"thickness": 40.0},
        "gold": {"anisotropy": 0.5, "rotation": 0.25, "tint": (0.9, 0.8, 0.7), "viewing": {"space": "Rec.2020"}}}
NUMBERS = re.compile(r"uniform (?:float|vec2|vec3) (\w+) = (?:vec\d\()?([^;)]+)\)?;")


@pytest.fixture(scope="module", params=FIVE)
def generated(mx, request):
    """(document, {material's name: the GLSL that MaterialX generates of it}) of a material."""
    shader = importlib.import_module("MaterialX.PyMaterialXGenShader")
    glsl = importlib.import_module("MaterialX.PyMaterialXGenGlsl")
    document = validated(mx, exported(made(preset=request.param, **FIVE[request.param]), "materialx"))
    generator = glsl.GlslShaderGenerator.create()
    context = shader.GenContext(generator)
    context.registerSourceCodeSearchPath(mx.getDefaultDataSearchPath())
    management = shader.DefaultColorManagementSystem.create(generator.getTarget())
    management.loadLibrary(document)
    generator.setColorManagementSystem(management)
    sources = {}
    for element in shader.findRenderableElements(document):
        made_of = generator.generate(element.getName(), element, context)
        sources[element.getName()] = made_of.getSourceCode("pixel")
    return document, sources


def test_materialx_makes_shaders_with_our_numbers(generated):
    """Each number of the document stands in the shader that MaterialX's own code generation makes of it."""
    document, sources = generated
    assert sources
    held = {name: [float(x) for x in values.split(",")] for source in sources.values()
            for name, values in NUMBERS.findall(source)}
    told = {f"{node.getName()}_{one.getName()}": one.getValueString().split(",") for node in document.getNodes()
            for one in node.getInputs() if one.getType() in ("float", "vector2", "color3") and one.getValueString()}
    compared = {name for name in told if name in held} | {
        name for name, values in told.items() if any(
            held_name.endswith(name.split("_surface_")[-1]) and held_values == pytest.approx(list(map(float, values)))
            for held_name, held_values in held.items())}
    assert compared >= {name for name in told if "thin_film" not in name}, set(told) - compared
    for name in told:
        if name in held:
            assert held[name] == pytest.approx([float(x) for x in told[name]], abs=1e-5), name


def test_what_materialx_generates_compiles(generated, tmp_path):
    compiler = shutil.which("glslangValidator")
    if compiler is None:
        pytest.skip("glslangValidator, of the package glslang-tools, is not installed: nothing compiles GLSL here")
    for name, source in generated[1].items():
        file = tmp_path / f"{name}.frag"
        file.write_text(source)
        done = subprocess.run([compiler, str(file)], capture_output=True, text=True)
        assert done.returncode == 0, done.stdout[-800:]
