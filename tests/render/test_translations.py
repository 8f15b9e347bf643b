"""Every text of the interface is there in every language that is offered."""

import ast
import re
from pathlib import Path

import bpy
import pytest

import addon
from addon.blender import registration
from addon.blender.translations import LANGUAGES

ROOM = Path(__file__).resolve().parents[2] / "addon" / "blender"
MARKED = {"iface_", "rpt_", "tip_", "n_"}
LEFT_AS_THEY_ARE = {"Facet & Film", "n", "k", "F0", "Rec.709", "Rec.2020", "ACEScg", "Cook–Torrance", "Layered RGB",
                    "OSL", "JSON", "MaterialX", "CPU", "GPU", "Linear Rec.2020", "CIE 1931, 2°", "CIE 1964, 10°",
                    "conductor_bsdf and generalized_schlick_bsdf"}
"""Names, units and formats that are the same in every language."""
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
    for file in ROOM.glob("*.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if not isinstance(node, ast.Call):
                continue
            if getattr(node.func, "id", "") in MARKED:
                found |= {arg.value for arg in node.args if isinstance(getattr(arg, "value", None), str)}
            found |= {key.value.value for key in node.keywords if key.arg == "text"
                      and isinstance(getattr(key.value, "value", None), str)}
    return found


@pytest.fixture(scope="module")
def texts():
    addon.register()
    found = texts_of_classes() | texts_in_source()
    addon.unregister()
    return {text for text in found if text and text not in LEFT_AS_THEY_ARE}


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_text_is_translated(texts, language):
    assert len(texts) > 100
    missing = sorted(text for text in texts if text not in LANGUAGES[language])
    assert not missing, "\n".join(map(repr, missing))


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_translation_is_left_over_or_loses_a_value(texts, language):
    assert sorted(set(LANGUAGES[language]) - texts) == []
    for text, translated in LANGUAGES[language].items():
        assert translated.strip(), text
        assert sorted(re.findall(r"\{.*?\}", text)) == sorted(re.findall(r"\{.*?\}", translated)), text
