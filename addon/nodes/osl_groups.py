"""The OSL realisations: a Script node in a group with the sockets of the other realisations.

A socket feeds the shader parameter of the same name without its spaces.  The
source travels in the file as a text, and the compiled code in the node, so a
saved file renders where the extension is not installed.
"""

from pathlib import Path
from types import SimpleNamespace

import bpy

from ..layered_parameters import DEFAULT_SAMPLING_WIDTH as LAYERED_WIDTH
from ..parameters import DEFAULT_SAMPLING_WIDTH as COOK_TORRANCE_WIDTH
from .builder import GroupBuilder, socket_of
from .cook_torrance_inputs import cook_torrance_inputs
from .layered_inputs import layered_inputs
from .operand import NodeOperand
from .osl_compiler import compile_script

__all__ = ["COOK_TORRANCE", "COOK_TORRANCE_FAST", "LAYERED_RGB", "LAYERED_RGB_FAST"]

SOURCES = Path(__file__).parent.parent / "osl"
WIDTH_MEANING = ("0: the formula itself, by mirrors that only light which they happen to hit can reach; "
                 "above: narrow lobes, which lamps of any size light")


def _definition(name, source, add_inputs, width=None, most_width=1.0):
    """A group of this name around the shader; exact where it has a width, closures where it has none."""
    def build():
        """The node group, newly built and compiled."""
        builder = GroupBuilder(name)
        add_inputs(builder)
        if width is not None:
            builder.input("Sampling Width", width, minimum=0.0, maximum=most_width, subtype="FACTOR",
                          description=WIDTH_MEANING)
        script = builder.tree.nodes.new("ShaderNodeScript")
        script.mode = "INTERNAL"
        script.script = _text(source)
        compile_script(script)
        for item in builder.tree.interface.items_tree:
            if item.item_type == "SOCKET":
                parameter = socket_of(script.inputs, item.name.replace(" ", ""))
                builder.connect(parameter, NodeOperand(builder, "FLOAT", item.name))
        socket_of(script.inputs, "Exact").default_value = int(width is not None)
        builder.output("BSDF", NodeOperand(builder, "SHADER", socket_of(script.outputs, "BSDF")))
        return builder.finish()
    return SimpleNamespace(NAME=name, VERSION=1, build=build)


def _text(source):
    """The shader's source as a text of the file, the same one for the same source."""
    contents = (SOURCES / source).read_text(encoding="utf-8")
    for text in bpy.data.texts:
        if text.name.startswith(source) and text.as_string() == contents:
            return text
    text = bpy.data.texts.new(source)
    text.write(contents)
    return text


COOK_TORRANCE = _definition("Cook-Torrance OSL", "cook_torrance.osl", cook_torrance_inputs, COOK_TORRANCE_WIDTH)
COOK_TORRANCE_FAST = _definition("Cook-Torrance OSL Fast", "cook_torrance.osl", cook_torrance_inputs)
LAYERED_RGB = _definition("Layered RGB OSL", "layered_rgb.osl", layered_inputs, LAYERED_WIDTH, 0.9)
LAYERED_RGB_FAST = _definition("Layered RGB OSL Fast", "layered_rgb.osl", layered_inputs)
