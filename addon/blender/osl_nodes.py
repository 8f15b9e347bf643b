"""Script nodes with the shaders of addon/osl: the source travels in the file, compiled by Cycles."""

import re
from pathlib import Path

import bpy

from ..errors import FacetFilmError

__all__ = ["new_script_node", "script_id", "script_socket"]

FOLDER = Path(__file__).resolve().parents[1] / "osl"
ID_KEY = "facet_film_id"


def new_script_node(tree, identifier):
    """A Script node in the tree with the shader of this name, compiled, its sockets made.

    Raises FacetFilmError where the shader does not compile: a Blender built without OSL.
    """
    node = tree.nodes.new("ShaderNodeScript")
    node.mode = "INTERNAL"
    node.script = _text(identifier)
    said = []
    try:
        import cycles.osl
        cycles.osl.update_script_node(node, lambda kind, message: said.append(message))
    except ImportError as missing:
        said.append(str(missing))
    if not node.outputs:
        tree.nodes.remove(node)
        raise FacetFilmError(f"The OSL shader {identifier} could not be compiled here ({'; '.join(said)}): "
                             "choose the realisation 'exact' or 'fast', which need no OSL.")
    return node


def script_id(node):
    """The name of our shader that a Script node holds, or None."""
    if node.bl_idname != "ShaderNodeScript" or node.script is None:
        return None
    return node.script.get(ID_KEY)


def script_socket(node, name):
    """The input of a Script node that stands for the group socket of this name.

    >>> script_socket(node, "Refractive Index").name                           # doctest: +SKIP
    'RefractiveIndex'
    """
    return node.inputs[re.sub(r"\W", "", name)]


def _text(identifier):
    """The text block with the shader's source as shipped; one that a user has edited is left alone."""
    source = (FOLDER / f"{identifier}.osl").read_text(encoding="utf-8")
    for text in bpy.data.texts:
        if text.get(ID_KEY) == identifier and text.as_string() == source:
            return text
    text = bpy.data.texts.new(f"{identifier}.osl")
    text.from_string(source)
    text[ID_KEY] = identifier
    return text
