"""The functions of an OSL script, called with given arguments and shown as light.

A script's text up to its shader gets another shader, whose one parameter holds
all arguments of all cases as single-precision numbers.  Each pixel of a plane
calls one function with the arguments of one case and shines with what comes
back, so the picture is a list of results.  The numbers that a pixel's case was
called with are known exactly, and so the formula can be given the same.
"""

import math
import re
from types import SimpleNamespace

import bpy
import numpy as np

from addon.nodes.osl_compiler import compile_script
from tests.render import probes

SIZES = {"float": 1, "int": 1, "vector": 3, "color": 3, "point": 3, "normal": 3}


# --- Reading a script ---

def functions_of(source):
    """The functions that a script defines, in its order: key (the signature), name, type and parameters by name.

    A parameter has a type, a count (of an array, else None) and whether it is an output.
    """
    heads = re.findall(r"((?:\bclosure\s+)?\b\w+)\s+(\w+)\s*\(([^()]*)\)\s*\{", without_comments(source))
    return [_function(*head) for head in heads if head[0] != "shader" and head[1] not in ("if", "for", "while")]


def _function(of_type, name, parameters):
    parameters = [_parameter(text) for text in parameters.split(",") if text.strip()]
    return SimpleNamespace(key=f"{name}({', '.join(p.text for p in parameters)})", name=name, type=of_type,
                           parameters=parameters)


def _parameter(text):
    output, of_type, count = re.fullmatch(r"\s*(output\s)?\s*(\w+)\s+\w+(?:\[(\d+)\])?\s*", text).groups()
    shown = f"{'output ' if output else ''}{of_type}{f'[{count}]' if count else ''}"
    return SimpleNamespace(type=of_type, count=int(count) if count else None, output=bool(output), text=shown)


def structs_of(source):
    """The fields of each struct of a script, as (type, name) in their order."""
    found = {}
    for name, body in re.findall(r"^struct (\w+) \{(.*?)\};", without_comments(source), re.MULTILINE | re.DOTALL):
        fields = re.findall(r"(\w+) ([\w, ]+);", body)
        found[name] = [(of_type, field.strip()) for of_type, names in fields for field in names.split(",")]
    return found


def without_comments(source):
    """The script without what follows // on its lines."""
    return re.sub(r"//[^\n]*", "", source)


def before_the_shader(source):
    """The part of a script that defines its functions."""
    return source[:re.search(r"^shader ", source, re.MULTILINE).start()]


# --- Calling its functions ---

def call_all(source, cases):
    """What a script's functions return, by their keys: (cases, numbers), a result's and those of the outputs.

    cases  by the function's key, the arguments for its inputs in their order, each
           an array (cases,) or (cases, n), or a SimpleNamespace of such for a struct
    """
    structs = structs_of(source)
    called = [function for function in functions_of(source) if function.key in cases]
    tables = [flattened(cases[function.key]) for function in called]
    blocks, start, pixel = [], 0, 0
    for function, table in zip(called, tables):
        block = SimpleNamespace(function=function, shown=_shown(function, structs), start=start, cases=len(table),
                                numbers=table.shape[1], pixel=pixel)
        blocks.append(block)
        start += table.size
        pixel += len(table) * _pages(block)
    side = math.ceil(math.sqrt(pixel))
    numbers = np.concatenate([table.ravel() for table in tables])
    branches = [_branch(block, page, structs) for block in blocks for page in range(_pages(block))]
    picture = _picture(_shader(source, numbers, branches, side), side).reshape(-1, 3)
    return {block.function.key: _result(picture, block) for block in blocks}


def flattened(arguments):
    """The arguments of a function as one table of single precision, (cases, numbers)."""
    parts = []
    for argument in arguments:
        fields = vars(argument).values() if isinstance(argument, SimpleNamespace) else [argument]
        parts += [np.reshape(field, (len(field), -1)) for field in fields]
    return np.concatenate(parts, axis=1).astype(np.float32)


def _pages(block):
    """How many pixels a case takes, at three numbers each."""
    return math.ceil(len(block.shown) / 3)


def _result(picture, block):
    end = block.pixel + block.cases * _pages(block)
    pages = picture[block.pixel:end].reshape(_pages(block), block.cases, 3)
    return np.concatenate(list(pages), axis=1)[:, :len(block.shown)]


def _shown(function, structs):
    """The numbers that a call leaves, as expressions of the shader."""
    shown = [] if function.type == "void" else _parts(function.type, "result", None, structs)
    for j, p in enumerate(function.parameters):
        if p.output:
            shown += _parts(p.type, f"argument{j}", p.count, structs)
    return shown


def _parts(of_type, name, count, structs):
    """The numbers in a variable of the shader, one after the other."""
    if count:
        return [part for j in range(count) for part in _parts(of_type, f"{name}[{j}]", None, structs)]
    if of_type in structs:
        fields = structs[of_type]
        return [part for inner, field in fields for part in _parts(inner, f"{name}.{field}", None, structs)]
    return [name] if SIZES[of_type] == 1 else [f"{name}[{j}]" for j in range(3)]


def _branch(block, page, structs):
    """Lines of the shader that show three of the numbers in a pixel for each case."""
    made, names, used = [], [], 0
    for j, p in enumerate(block.function.parameters):
        names.append(f"argument{j}")
        if p.output:
            made.append(f"{p.type} {names[j]}{f'[{p.count}]' if p.count else ''};")
        else:
            lines, used = _argument(p, names[j], structs, used)
            made += lines
    call = f"{block.function.name}({', '.join(names)});"
    if block.function.type != "void":
        call = f"{block.function.type} result = {call}"
    shown = ", ".join((block.shown[3 * page:] + ["0.0", "0.0"])[:3])
    first = block.pixel + page * block.cases
    return "\n        ".join([f"    if (pixel >= {first} && pixel < {first + block.cases}) {{",
                              f"int number = {block.start} + (pixel - {first}) * {block.numbers};",
                              *made, call, f"Shown = color({shown});"]) + "\n    }"


def _argument(p, name, structs, used):
    """Declarations that read one parameter from the numbers, and how many numbers are read by then."""
    if p.type in structs:
        lines = [f"{p.type} {name};"]
        for of_type, field in structs[p.type]:
            lines.append(f"{name}.{field} = {_read(of_type, used)};")
            used += SIZES[of_type]
        return lines, used
    if p.count:
        values = ", ".join(_read(p.type, used + j * SIZES[p.type]) for j in range(p.count))
        return [f"{p.type} {name}[{p.count}] = {{{values}}};"], used + p.count * SIZES[p.type]
    return [f"{p.type} {name} = {_read(p.type, used)};"], used + SIZES[p.type]


def _read(of_type, used):
    if of_type == "int":
        return f"(int)numbers[number + {used}]"
    if of_type == "float":
        return f"numbers[number + {used}]"
    return f"{of_type}(numbers[number + {used}], numbers[number + {used + 1}], numbers[number + {used + 2}])"


def _shader(source, numbers, branches, side):
    """The script with its functions shown in a square of this many pixels a side."""
    listed = ", ".join(f"{number:.9g}" for number in numbers)
    return "\n".join([
        before_the_shader(source),
        f"shader probe(float numbers[{len(numbers)}] = {{{listed}}}, output color Shown = color(0.0))", "{",
        f"    int pixel = (int)floor((P[1] + 1.0) * {0.5 * side}) * {side} + (int)floor((P[0] + 1.0) * {0.5 * side});",
        *branches, "}", ""])


def _picture(text, side):
    """The picture of a plane that shines with what the shader shows, (pixels, pixels, 3)."""
    scene = probes.empty_scene(side, osl=True, pixel_centres=True)
    mesh = bpy.data.meshes.new("Plane")
    mesh.from_pydata([(-2, -2, 0), (2, -2, 0), (2, 2, 0), (-2, 2, 0)], [], [(0, 1, 2, 3)])
    mesh.materials.append(_shining(text))
    scene.collection.objects.link(bpy.data.objects.new("Plane", mesh))
    return probes.render(scene)


def _shining(text):
    material = bpy.data.materials.new("Probe")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    script, emission = nodes.new("ShaderNodeScript"), nodes.new("ShaderNodeEmission")
    script.mode, script.script = "INTERNAL", _text(text)
    compile_script(script)
    links.new(script.outputs["Shown"], emission.inputs["Color"])
    links.new(emission.outputs["Emission"], nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    return material


def _text(contents):
    text = bpy.data.texts.new("probe.osl")
    text.write(contents)
    return text
