"""The interface's texts in other languages, as Blender takes them."""

from importlib import import_module

import bpy
from bpy.app.handlers import persistent

__all__ = ["LANGUAGES", "attach", "detach", "spoken", "texts_of"]

LANGUAGES = {"de_DE": "german", "zh_HANS": "chinese"}
"""Blender's name of a language -> the module of its texts."""

CONTEXTS = ("*", "Operator")
"""Blender looks texts of buttons up under the second."""


def texts_of(language):
    """{English: translated} of one of LANGUAGES."""
    return import_module(f".{LANGUAGES[language]}", __package__).TEXTS


def spoken(locale):
    """The one of LANGUAGES that Blender's locale is, or "".

    >>> spoken("de_DE"), spoken("de"), spoken("en_US"), spoken("")
    ('de_DE', 'de_DE', '', '')
    """
    return next((name for name in LANGUAGES if locale and locale in (name, name.partition("_")[0])), "")


def attach():
    """Hand Blender the texts of the language that it speaks, now and whenever that is changed."""
    _follow()
    bpy.app.handlers.translation_update_post.append(_follow)


def detach():
    """Take them back."""
    bpy.app.handlers.translation_update_post.remove(_follow)
    bpy.app.translations.unregister(__package__)


@persistent
def _follow(*_):
    bpy.app.translations.unregister(__package__)
    locale = bpy.app.translations.locale
    if language := spoken(locale):
        bpy.app.translations.register(__package__, {
            locale: {(context, text): translated for text, translated in texts_of(language).items()
                     for context in CONTEXTS}})
