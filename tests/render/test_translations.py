"""Every text of the interface is there in every language that is offered."""

import ast
import re
from pathlib import Path
from types import SimpleNamespace

import bpy
import pytest

import addon
from addon import api, export
from addon.bake import spread
from addon.blender import registration, translations
from addon.blender.datablocks import groups, menu
from addon.blender.operators import bake
from addon.blender.translations import LANGUAGES, texts_of
from addon.errors import FacetFilmError
from addon.export.standin import LOST, LOST_THERE
from addon.models import all_models
from addon.spectra.illuminants import TITLES

ADDON = Path(__file__).resolve().parents[2] / "addon"
ROOM = ADDON / "blender"
MARKED = {"iface_", "rpt_", "tip_", "n_"}
ENGLISH_ONLY = {"shell/commands.py", "models/cook_torrance/parameters.py", "models/layered_rgb/parameters.py",
                "spectra/dispersion.py",
                "spectra/readers/reading.py", "spectra/readers/text.py", "export/as_materialx.py",
                "verify/devices.py", "verify/running.py"}
"""Where errors are of scripts, of the shell, or of the lines of a file that someone imports: those stay English."""
NOT_SHOWN = {
    "# A material of Facet & Film, as JSON in a comment of one line.\n#",
    "Thin Film Thickness", "Thin Film IOR",  # sockets of Blender's
    "The Standard realisation, for an EEVEE material output",  # kept in the group, whatever the language
}
"""Sentences of addon/blender that nobody sees in the interface."""
SENTENCE = re.compile(r"[A-Za-z]{2,} +[A-Za-z&]+ +[A-Za-z]{2,}")
LEFT_AS_THEY_ARE = {"Facet & Film", "n", "k", "F0", "Rec.709", "Rec.2020", "ACEScg", "Cook–Torrance", "Layered RGB",
                    "OSL", "UV", "JSON", "MaterialX", "CPU", "GPU", "Linear Rec.2020", "CIE 1931, 2°", "CIE 1964, 10°",
                    "conductor_bsdf, generalized_schlick_bsdf and open_pbr_surface",
                    "open_pbr_surface", "open_pbr_surface and a conductor_bsdf with a thin film"}
"""Names, units and formats that are the same in every language."""
FILES = sorted(file for file in ROOM.rglob("*.py") if file.parent.name != "translations")
NOT_OURS = {"rna_type", "name", "remove_name", "remove_active"}


def texts_of_classes():
    """Labels and descriptions of classes, properties and choices, as Blender shows them."""
    found = set()
    for cls in registration.CLASSES:
        shown = getattr(cls, "bl_description", "") or (cls.__doc__ or "")
        if issubclass(cls, bpy.types.Operator):
            found |= {cls.bl_label, shown}
        elif issubclass(cls, (bpy.types.Panel, bpy.types.Menu)):
            found.add(cls.bl_label)
        rna = cls.bl_rna
        if issubclass(cls, bpy.types.Operator):
            room, name = cls.bl_idname.split(".")
            rna = getattr(getattr(bpy.ops, room), name).get_rna_type()
        for prop in rna.properties:
            if prop.identifier.startswith("bl_") or prop.identifier in NOT_OURS or prop.is_hidden:
                continue
            if prop.identifier in {name for base in cls.__mro__ for name in vars(base).get("__annotations__", ())}:
                found |= {prop.name, prop.description}
                if prop.type == "ENUM":
                    found |= {text for item in prop.enum_items_static for text in (item.name, item.description)}
    return found


def texts_in_source():
    """Literals handed to the marking functions, and `text=` of buttons and labels."""
    found = set()
    for file in FILES:
        for node in ast.walk(tree_of(file)):
            if not isinstance(node, ast.Call):
                continue
            if getattr(node.func, "id", "") in MARKED:
                found |= {arg.value for arg in node.args if isinstance(getattr(arg, "value", None), str)}
            found |= {key.value.value for key in node.keywords if key.arg == "text"
                      and isinstance(getattr(key.value, "value", None), str)}
    return found


def errors_of_artists():
    """The sentences of errors that the panels' operators can meet, and what is said of a Blender without OSL."""
    returned = {node.value.value for node in ast.walk(tree_of(ADDON / "nodes" / "osl_compiler.py"))
                if isinstance(node, ast.Return) and isinstance(node.value, ast.Constant)}
    sentences = {sentence.value for _, sentence in raised() if isinstance(sentence, ast.Constant)}
    return {" or ", "finish", "preset"} | returned | sentences


def tree_of(file):
    return ast.parse(file.read_text(encoding="utf-8"))


def raised():
    """(place, sentence's syntax) of every FacetFilmError of the files that are not English only."""
    for file in ADDON.rglob("*.py"):
        name = file.relative_to(ADDON).as_posix()
        for node in ast.walk(tree_of(file)) if name not in ENGLISH_ONLY else ():
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "FacetFilmError":
                yield f"{name}, line {node.lineno}", node.args[0]


def names_of_sockets():
    """What the panel calls the parameters, as the groups do, and the closed panels that some of them are in."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    panels = {socket.panel for model in all_models() for row in model.parameters.TABLE for socket in row.sockets()}
    return {name for group in groups.all_groups() if not group.osl
            for name in groups.input_names(groups.node_group(group.identifier))} | panels - {""}


def texts_of_models():
    """What menus and lists show of models, presets' kinds, and forms."""
    of_groups = {text for part in menu.parts() for _, name, summary in part for text in (name, summary)}
    of_forms = {text for model in all_models() for form in model.forms.values() for text in (form.title, form.tip)}
    return of_groups | of_forms | {*LOST.values(), *LOST_THERE.values()}


@pytest.fixture(scope="module")
def texts():
    addon.register()
    found = texts_of_classes() | texts_in_source() | errors_of_artists() | names_of_sockets() | texts_of_models()
    found |= set(TITLES.values())
    addon.unregister()
    return {text for text in found if text and text not in LEFT_AS_THEY_ARE}


def sentences_in(file):
    """(line, text) of what looks like a sentence in a file: literals, and the fixed parts of f-strings; no
    docstrings.
    """
    tree = tree_of(file)
    about = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in about:
            if SENTENCE.search(node.value):
                yield node.lineno, node.value


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.relative_to(ROOM).as_posix())
def test_no_sentence_of_the_interface_is_left_unmarked(texts, file):
    """Each stands as it is in the tables: marked, or a label or description; none is put together by an f-string."""
    known = texts | LEFT_AS_THEY_ARE | NOT_SHOWN
    unmarked = {f"line {line}: {text}" for line, text in sentences_in(file) if text not in known}
    assert not unmarked, "\n".join(sorted(unmarked))


def test_errors_of_artists_are_sentences_that_can_be_looked_up():
    """With {names} and the values beside it, in place of an f-string; errors.py's numbers are of scripts."""
    put_together = [place for place, sentence in raised()
                    if not isinstance(sentence, (ast.Constant, ast.Name)) and not place.startswith("errors.py")]
    assert put_together == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_text_is_translated(texts, language):
    assert len(texts) > 100
    missing = sorted(text for text in texts if text not in texts_of(language))
    assert not missing, "\n".join(map(repr, missing))


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_translation_is_left_over_or_loses_a_value(texts, language):
    assert sorted(set(texts_of(language)) - texts) == []
    for text, translated in texts_of(language).items():
        assert translated.strip(), text
        assert sorted(re.findall(r"\{.*?\}", text)) == sorted(re.findall(r"\{.*?\}", translated)), text


@pytest.mark.parametrize("locale, given", [("de_DE", 1), ("de", 1), ("zh_HANS", 1), ("en_US", 0), ("", 0)])
def test_blender_is_handed_the_language_that_it_speaks_and_takes_it_back(monkeypatch, locale, given):
    held = {}
    told = SimpleNamespace(locale=locale, register=held.__setitem__, unregister=lambda name: held.pop(name, None))
    handlers = SimpleNamespace(translation_update_post=[])
    monkeypatch.setattr(translations, "bpy", SimpleNamespace(app=SimpleNamespace(translations=told, handlers=handlers)))
    translations.attach()
    assert [set(texts) for texts in held.values()] == [{locale}] * given
    told.locale = "zh_HANS"
    handlers.translation_update_post[0](None, None)
    assert held[translations.__name__]["zh_HANS"]["Operator", "Add"] == texts_of("zh_HANS")["Add"]
    translations.detach()
    assert not held and not handlers.translation_update_post


def in_language(language):
    """As Blender's function that looks texts up does in this language, which Blender as a module lacks."""
    return lambda text: texts_of(language).get(text, text)


@pytest.mark.parametrize("language, preset, sentence", [
    ("de_DE", "coper", "Voreinstellung 'coper' ist unbekannt; war 'copper' oder "),
    ("de_DE", "copper gold", "Voreinstellung 'copper gold' ist unbekannt"),
    ("de_DE", "main/Cu/Jonson", "Datensatz 'main/Cu/Jonson' ist unbekannt; war 'main/Cu/Johnson' oder "),
    ("zh_HANS", "coper", "未知预设 'coper'；您是指 'copper' 或 "),
    ("zh_HANS", "main/Cu/Jonson", "未知数据集 'main/Cu/Jonson'")])
def test_operators_report_errors_in_the_interface_language(monkeypatch, language, preset, sentence):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.mesh.primitive_cube_add()
    addon.register()
    monkeypatch.setattr(bake, "rpt_", in_language(language))
    try:
        with pytest.raises(RuntimeError) as error:
            bpy.ops.facet_film.bake_preset(preset=preset)
        assert sentence in str(error.value)
    finally:
        addon.unregister()


@pytest.mark.parametrize("language", LANGUAGES)
def test_an_error_in_another_language_keeps_its_values(language, tmp_path):
    for raising, values in ((lambda: export.write_text(tmp_path, "text"), [str(tmp_path)]),
                            (lambda: export.write_text(tmp_path / "none" / "file.csv", "text"), ["file.csv"]),
                            (lambda: spread("teflon"), ["main/Au/Babar"]), (lambda: api.bake("xyzzy"), ["xyzzy"])):
        with pytest.raises(FacetFilmError) as error:
            raising()
        said = error.value.said(in_language(language))
        assert said != str(error.value) and all(value in said for value in values), said
