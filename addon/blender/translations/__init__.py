"""The interface's texts in other languages, as Blender takes them."""

import bpy

from . import chinese, german

__all__ = ["LANGUAGES", "attach", "detach"]

LANGUAGES = {"de_DE": german.TEXTS, "zh_HANS": chinese.TEXTS}
"""Blender's name of a language -> {English: translated}."""

CONTEXTS = ("*", "Operator")
"""Blender looks texts of buttons up under the second."""


def attach():
    """Hand the texts to Blender."""
    bpy.app.translations.register(__package__, {
        language: {(context, text): translated for text, translated in texts.items() for context in CONTEXTS}
        for language, texts in LANGUAGES.items()})


def detach():
    """Take them back."""
    bpy.app.translations.unregister(__package__)
