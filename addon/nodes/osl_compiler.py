"""Compiles the shader of a Script node with Cycles' own compiler, which also gives the node its sockets."""

import importlib.util
import sys
from pathlib import Path

import bpy

from ..errors import FacetFilmError

__all__ = ["compile_script", "require_osl", "text_of", "why_no_osl"]


def compile_script(node):
    """Compile a Script node's internal text; its sockets and code are then in the node.

    Raises FacetFilmError with the compiler's words, or where this Blender has no OSL.
    """
    require_osl()
    from cycles import osl
    said = []
    if not osl.update_script_node(node, lambda _level, message: said.append(message)):
        raise FacetFilmError("The shader {shader} does not compile: {why}",
                             shader=node.script.name, why="; ".join(said))


def text_of(file):
    """The source of a script as a text of the open file, the same one for the same source."""
    contents = Path(file).read_text(encoding="utf-8")
    name = Path(file).name
    for text in bpy.data.texts:
        if text.name.startswith(name) and text.as_string() == contents:
            return text
    text = bpy.data.texts.new(name)
    text.write(contents)
    return text


def require_osl():
    """Raise FacetFilmError where this Blender cannot compile OSL."""
    reason = why_no_osl()
    if reason:
        raise FacetFilmError(reason)


def why_no_osl():
    """Why this Blender cannot compile OSL, or an empty text."""
    import _cycles
    if not _cycles.with_osl:
        return "This Blender is built without OSL: take Reference or Standard, which render the same material"
    _find_oslquery()
    if importlib.util.find_spec("oslquery") is None:
        return "This Blender lacks its module oslquery, which OSL scripts need: take Reference or Standard"
    return ""


OF_BLENDER = ("OpenImageIO", "oslquery")
"""The second needs the first."""


def _find_oslquery():
    """Blender as a Python module keeps oslquery in its own folder, which it does not put on the path itself."""
    if importlib.util.find_spec("oslquery") is None:
        version = f"python{sys.version_info.major}.{sys.version_info.minor}"
        folder = Path(bpy.utils.resource_path("LOCAL")) / "python" / "lib" / version / "site-packages"
        if all((folder / name).exists() for name in OF_BLENDER):
            for name in OF_BLENDER:
                _load(name, folder / name / "__init__.py")


def _load(name, file):
    """Load a package of Blender's own under its name, and leave the path that modules are searched on as it is."""
    spec = importlib.util.spec_from_file_location(name, file, submodule_search_locations=[str(file.parent)])
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
