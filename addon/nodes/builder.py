"""Builds a shader node group out of formulas written with addon.operands.

One node an operation, a product and the sum it is in together; products of
colours are Mix nodes (see addon.nodes.facts); equal subexpressions share their
node; constants fold; nodes of one named term stand together in a frame.
"""

import contextlib
import math

import bpy
import numpy as np

from ..models.osl import parameter_of
from . import newcomers, parts
from .curves import set_knots, set_stops
from .facts import OF_A_PLACE, UNKNOWN, Facts, as_mix, of_number, outcome
from .layout import arrange
from .operand import NodeOperand, is_vector
from .osl_compiler import compile_script, text_of

__all__ = ["GroupBuilder"]

SOCKET_TYPES = {
    "FLOAT": "NodeSocketFloat",
    "VECTOR": "NodeSocketVector",
    "COLOR": "NodeSocketColor",
    "SHADER": "NodeSocketShader",
}

# Operation of a formula -> operation of the Math node, and of the Vector Math node.
MATH = {
    "add": "ADD", "subtract": "SUBTRACT", "multiply": "MULTIPLY", "divide": "DIVIDE", "power": "POWER",
    "minimum": "MINIMUM", "maximum": "MAXIMUM", "absolute": "ABSOLUTE", "sin": "SINE", "cos": "COSINE",
    "tan": "TANGENT", "sqrt": "SQRT", "inverse_sqrt": "INVERSE_SQRT", "exp": "EXPONENT", "arccos": "ARCCOSINE",
    "less": "LESS_THAN", "log": "LOGARITHM", "multiply_add": "MULTIPLY_ADD", "fraction": "FRACT",
}
VECTOR_MATH = {name: MATH[name] for name in (
    "add", "subtract", "multiply", "divide", "power", "minimum", "maximum", "absolute", "sin", "cos", "tan",
    "multiply_add")}
VECTOR_TO_FLOAT = {"dot": "DOT_PRODUCT", "length": "LENGTH"}
VECTOR_TO_VECTOR = {"cross": "CROSS_PRODUCT", "normalize": "NORMALIZE"}
COMPONENT = {"x_of": "X", "y_of": "Y", "z_of": "Z"}


class GroupBuilder:
    """One shader node group under construction.

    >>> builder = GroupBuilder("Example")                                  # doctest: +SKIP
    >>> m = builder.input(Socket("Slope", "m", "FLOAT", 0.3, "rms slope m"))  # doctest: +SKIP
    >>> builder.output("Twice", 2.0 * m)                                   # doctest: +SKIP
    >>> tree = builder.finish()                                            # doctest: +SKIP
    """

    def __init__(self, name, built=None):
        """An empty group; built are the parts that there are already, where it is one of them itself."""
        self.tree = bpy.data.node_groups.new(name, "ShaderNodeTree")
        self.parts = {} if built is None else built  # what a part depends on -> addon.nodes.parts.Part
        self.frames = []           # labels of the frames that are open
        self.frame_of = {}         # node name -> frame label
        self._shared = {}          # expression -> operand
        self._products = {}        # Multiply node's name -> its two operands
        self._facts = {}           # key of an operand, or name of its node -> addon.nodes.facts.Facts
        self._group_inputs = {}    # frame label -> Group Input node
        self._possible = {}        # name of a part's argument -> its kind
        self._there = set()        # names of those that have a socket
        self._output_node = None

    # --- the group's interface ---

    def input(self, socket):
        """A new input of the group as an :class:`addon.models.parameters.Socket` describes it, as an operand."""
        parent = self._panel(socket.panel) if socket.panel else None
        item = self.tree.interface.new_socket(socket.name, description=socket.tip, in_out="INPUT",
                                              socket_type=SOCKET_TYPES[socket.kind], parent=parent)
        if socket.subtype:
            item.subtype = socket.subtype
        for attribute, value in (("min_value", socket.low), ("max_value", socket.high)):
            if value is not None:
                setattr(item, attribute, value)
        if socket.default is not None:
            item.default_value = (*socket.default, 1.0) if socket.kind == "COLOR" else socket.default
        item.hide_value = socket.plugged
        self._facts["input", socket.name] = Facts(socket.never_zero or socket.plugged, socket.plugged)
        return NodeOperand(self, "VECTOR" if socket.kind == "COLOR" else socket.kind, socket.name)

    def output(self, name, operand, kind=None, description=""):
        """A new output socket of the group, fed by the operand; its identifier."""
        item = self.tree.interface.new_socket(
            name, description=description, in_out="OUTPUT", socket_type=SOCKET_TYPES[kind or operand.kind])
        if self._output_node is None:
            self._output_node = self.tree.nodes.new("NodeGroupOutput")
        self.connect(socket_of(self._output_node.inputs, item.identifier), operand)
        return item.identifier

    def _panel(self, name):
        for item in self.tree.interface.items_tree:
            if item.item_type == "PANEL" and item.name == name:
                return item
        return self.tree.interface.new_panel(name, default_closed=True)

    # --- nodes ---

    def node(self, bl_idname, inputs=None, output=None, label="", **properties):
        """A node of any type as the operand of one of its outputs.

        inputs maps socket identifiers to operands or constants; output is the
        identifier of the output wanted, or None for the first.
        """
        key = (bl_idname, tuple((i, self._key(v)) for i, v in (inputs or {}).items()),
               tuple(sorted(properties.items())))
        node = self._shared.get(key)
        if node is None:
            node = self._shared[key] = self._new_node(bl_idname, properties, label)
            for identifier, operand in (inputs or {}).items():
                self.connect(socket_of(node.inputs, identifier), operand)
            if bl_idname != "ShaderNodeGroup":
                operands = [self.facts(operand) for operand in (inputs or {}).values()]
                self._facts[node.name] = outcome(properties.get("operation", bl_idname), operands)
        socket = socket_of(node.outputs, output) if output else node.outputs[0]
        return NodeOperand(self, kind_of(socket), socket)

    # --- parts: groups inside the group ---

    def part(self, name, formula, gives, operands, options):
        """What a formula gives of operands, its nodes in a group of their own: see :func:`addon.nodes.parts.call`."""
        return parts.call(self, name, formula, gives, operands, options)

    def part_input(self, name, kind, facts):
        """An input that a part gets once something in it needs it, as an operand."""
        self._facts["input", name] = facts
        self._possible[name] = kind
        return NodeOperand(self, kind, name)

    def part_inputs(self):
        """{name: identifier} of the inputs of a part, put into the order of its arguments."""
        found = {item.name: item for item in self.tree.interface.items_tree if item.in_out == "INPUT"}
        for name in reversed([name for name in self._possible if name in found]):
            self.tree.interface.move(found[name], 0)
        return {name: item.identifier for name, item in found.items()}

    def part_output(self, name, operand):
        """The identifier of a new output of a part, fed by the operand."""
        return self.output(name, operand)

    def part_node(self, name, tree, inputs, output, facts):
        """An output of the node of a part, as an operand; one node for equal inputs."""
        operand = self.node("ShaderNodeGroup", inputs, output, name, node_tree=tree)
        self._facts[operand.key()] = facts
        return operand

    # --- nodes of some kinds ---

    def random(self, dimension):
        """A number drawn evenly from [0, 1), another one for every sample of a pixel.

        White noise of the shading position, which no two samples share; each
        dimension is independent of the others.
        """
        position = self.node("ShaderNodeNewGeometry", output="Position")
        return self.node("ShaderNodeTexWhiteNoise", {"Vector": position, "W": float(dimension)},
                         "Value", noise_dimensions="4D")

    def three_randoms(self, dimension):
        """Three such numbers of one White Noise node."""
        from ..operands import x_of, y_of, z_of
        position = self.node("ShaderNodeNewGeometry", output="Position")
        three = self.node("ShaderNodeTexWhiteNoise", {"Vector": position, "W": float(dimension)},
                          "Color", noise_dimensions="4D")
        return x_of(three), y_of(three), z_of(three)

    def normal(self, socket):
        """The Normal socket's direction, or the surface's own where nothing is plugged in."""
        from ..operands import dot, less, normalize, where
        own = self.node("ShaderNodeNewGeometry", output="Normal")
        return where(less(dot(socket, socket), 1e-8), own, normalize(socket))

    def tangent(self, socket):
        """The Tangent socket's direction, or the surface's own around the object's Z where nothing is plugged in."""
        from ..operands import dot, less, where
        own = self.node("ShaderNodeNewGeometry", output="Tangent")
        return where(less(dot(socket, socket), 1e-8), own, socket)

    def incoming(self):
        """V, the unit direction from the surface to the viewer."""
        return self.node("ShaderNodeNewGeometry", output="Incoming")

    def lookup(self, x, knots, values):
        """A Float Curve of straight lines between knots; of a colour an RGB Curves of the same three."""
        if is_vector(x):
            return self._lookup_each(x, knots, values)
        key = ("lookup", self._key(x), tuple(knots), tuple(values))
        if key not in self._shared:
            node = self._new_node("ShaderNodeFloatCurve", {})
            set_knots(node.mapping, 0, knots, values)
            self.connect(socket_of(node.inputs, "Value"), x)
            self._facts[node.name] = outcome(None, [self.facts(x)])
            self._shared[key] = NodeOperand(self, "FLOAT", node.outputs[0])
        return self._shared[key]

    def _lookup_each(self, x, knots, values):
        key = ("lookup", self._key(x), tuple(knots), tuple(values))
        if key not in self._shared:
            node = self._new_node("ShaderNodeRGBCurve", {})
            for channel in range(3):
                set_knots(node.mapping, channel, knots, values)
            self.connect(socket_of(node.inputs, "Color"), x)
            self._facts[node.name] = outcome(None, [self.facts(x)])
            self._shared[key] = NodeOperand(self, "VECTOR", node.outputs[0])
        return self._shared[key]

    def lookup_three(self, x, knots, values):
        """A Color Ramp of straight lines between knots, which renders in half the time of three curves."""
        key = ("lookup_three", self._key(x), tuple(knots), tuple(map(tuple, values)))
        if key not in self._shared:
            node = self._new_node("ShaderNodeValToRGB", {})
            set_stops(node.color_ramp, knots, values)
            self.connect(socket_of(node.inputs, "Fac"), x)
            self._facts[node.name] = outcome(None, [self.facts(x)])
            self._shared[key] = NodeOperand(self, "VECTOR", node.outputs[0])
        return self._shared[key]

    def script(self, file, values, output="BSDF"):
        """An output of an OSL script, whose parameters bear the names of the group's inputs: see
        :func:`addon.models.osl.parameter_of`.

        file    path of the source, which travels in the file as a text
        values  {parameter: number or operand} of those that are no input, or take an input's place

        Inputs that the script has no parameter for are for nodes beside it.
        """
        node = self._new_node("ShaderNodeScript", {"mode": "INTERNAL"})
        node.script = text_of(file)
        compile_script(node)
        self._facts[node.name] = OF_A_PLACE
        parameters = {socket.identifier for socket in node.inputs}
        for item in self.tree.interface.items_tree:
            if item.item_type == "SOCKET" and item.in_out == "INPUT" and parameter_of(item.name) in parameters:
                self.connect(socket_of(node.inputs, parameter_of(item.name)), NodeOperand(self, "FLOAT", item.name))
        for name, value in values.items():
            if isinstance(value, NodeOperand):
                self.connect(socket_of(node.inputs, name), value)
            else:
                socket_of(node.inputs, name).default_value = value
        found = socket_of(node.outputs, output)
        return NodeOperand(self, kind_of(found), found)

    def add_shaders(self, *shaders):
        """Sum of closures."""
        total = shaders[0]
        for shader in shaders[1:]:
            total = self.node("ShaderNodeAddShader", {"Shader": total, "Shader_001": shader})
        return total

    def scale_shader(self, factor, shader):
        """A closure times a factor that is held to [0, 1]."""
        return self.node("ShaderNodeMixShader", {"Fac": factor, "Shader_001": shader})

    def scale_shader_twofold(self, half, shader):
        """A closure times twice a factor that is held to [0, 1].

        Cycles adds the weights of a closure that is linked twice, and evaluates it once.
        """
        return self.scale_shader(half, self.add_shaders(shader, shader))

    def where_native(self, operand):
        """A number in a Blender whose Metallic BSDF has a thin film of its own; 0 in others, whoever wrote the file.

        Its Light Path has an output more, of 0 and above; where another Blender drops the link from that, −1 is left.
        """
        path = self._new_node("ShaderNodeLightPath", {}, "")
        is_there = self._new_node("ShaderNodeMath", {"operation": "GREATER_THAN"}, "In this Blender")
        given, least = is_there.inputs[:2]
        given.default_value, least.default_value = -1.0, -0.5
        newcomers.defer(is_there, given.identifier, path, newcomers.NEW_OUTPUT)
        return operand * NodeOperand(self, "FLOAT", is_there.outputs[0])

    def feed_where_native(self, fed, inputs):
        """Feed inputs of a node, {identifier: operand}, in a Blender whose Metallic BSDF has a thin film of its own."""
        for identifier, operand in inputs.items():
            source = self._socket(operand, fed.source.node)
            self._products.pop(source.node.name, None)  # it stays, whatever it is linked to here
            newcomers.defer(fed.source.node, identifier, source.node, source.identifier)

    @contextlib.contextmanager
    def frame(self, label):
        """Nodes made inside stand in a frame with this label."""
        self.frames.append(label)
        try:
            yield
        finally:
            self.frames.pop()

    def finish(self):
        """Lay the nodes out, less the products that went into sums, and return the tree."""
        for name in self._products:
            if not any(socket.is_linked for socket in self.tree.nodes[name].outputs):
                self.tree.nodes.remove(self.tree.nodes[name])
                self.frame_of.pop(name, None)
        arrange(self.tree, self.frame_of)
        return self.tree

    # --- operations of formulas ---

    def apply(self, name, operands):
        """The operand that an operation of a formula gives."""
        operands = tuple(constant(operand) for operand in operands)
        if name == "widen":
            return operands[0]
        simpler = simplified(name, operands)
        if simpler is not None:
            return simpler
        if name == "clip":
            return self._clip(*operands)
        if name in VECTOR_TO_FLOAT:
            return self._vector_math(VECTOR_TO_FLOAT[name], operands, "Value")
        if name in VECTOR_TO_VECTOR:
            return self._vector_math(VECTOR_TO_VECTOR[name], operands)
        if name in COMPONENT:
            return self.node("ShaderNodeSeparateXYZ", {"Vector": operands[0]}, COMPONENT[name])
        if name == "rotate":
            return self.node("ShaderNodeVectorRotate", dict(zip(("Vector", "Axis", "Angle"), operands)),
                             rotation_type="AXIS_ANGLE")
        if name == "vector":
            return self.node("ShaderNodeCombineXYZ", dict(zip("XYZ", operands)))
        if any(is_vector(operand) for operand in operands):
            return self._on_vectors(name, operands)
        if name == "where":
            return self._mix("FLOAT", "Float", *operands)
        if name in ("add", "subtract"):
            operands, name = self._with_product(name, *operands)
        if name == "log":
            operands = (*operands, math.e)
        identifiers = ("Value", "Value_001", "Value_002")
        result = self.node("ShaderNodeMath", dict(zip(identifiers, operands)), operation=MATH[name])
        if name == "multiply" and all(self.facts(o).lasts for o in operands):
            self._products[result.source.node.name] = operands
        return result

    def _with_product(self, name, a, b):
        """The operands and name of a sum or difference, as "multiply_add" where it has a product that is never 0.

        A product with a socket stays a node of its own, which the renderer
        folds away where the socket is 0.
        """
        for product, other, sign in ((a, b, 1.0), (b, a, -1.0)):
            factors = self._factors(product)
            if not factors:
                continue
            if name == "add":
                return (*factors, other), "multiply_add"
            if sign > 0.0 and isinstance(other, float):
                return (*factors, -other), "multiply_add"
            if sign < 0.0 and isinstance(factors[0], float):
                return (-factors[0], factors[1], other), "multiply_add"
        return (a, b), name

    def _factors(self, operand):
        """The factors of a product, numbers first, or None."""
        if not isinstance(operand, NodeOperand) or isinstance(operand.source, str):
            return None
        factors = self._products.get(operand.source.node.name)
        return factors and sorted(factors, key=lambda o: not isinstance(o, float))

    def facts(self, operand):
        """What is known of an operand or number, see :mod:`addon.nodes.facts`."""
        if not isinstance(operand, NodeOperand):
            return of_number(constant(operand))
        key = operand.key()
        return self._facts.get(key) or self._facts.get(key[0]) or UNKNOWN

    def _on_vectors(self, name, operands):
        if name in VECTOR_MATH:
            if name in ("add", "subtract"):
                operands, name = self._with_colours_product(name, operands)
            facts = [*map(self.facts, operands)]
            blend = as_mix(name, operands, facts)
            if blend is not None:
                return self._mix_in_place_of(name, operands, facts, blend)
            if name == "multiply" and not all(is_vector(operand) for operand in operands):
                direction, factor = sorted(operands, key=is_vector, reverse=True)
                return self.node("ShaderNodeVectorMath", {"Vector": direction, "Scale": factor},
                                 operation="SCALE")
            return self._vector_math(VECTOR_MATH[name], operands)
        if name == "sqrt":
            return self._vector_math("POWER", (operands[0], 0.5))  # which gives 0 below 0
        if name == "exp":
            return self._vector_math("POWER", (math.e, operands[0]))
        if name == "where":
            return self._mix("VECTOR", "Vector", *operands)
        # No Vector Math operation: channel by channel.
        channels = [[self.apply(c, (o,)) if isinstance(o, NodeOperand) and is_vector(o)
                     else o[i] if is_vector(o) else o for o in operands]
                    for i, c in enumerate(("x_of", "y_of", "z_of"))]
        return self.apply("vector", tuple(self.apply(name, tuple(channel)) for channel in channels))

    def _with_colours_product(self, name, operands):
        """As :meth:`_with_product`, where one node takes less time than the two Mix nodes that they are apart."""
        merged, its_name = self._with_product(name, *operands)
        if its_name == "multiply_add":
            first, second, rest = [self.facts(operand).varies for operand in merged]
            if rest or not (first and second):
                return merged, its_name
        return operands, name

    def _mix_in_place_of(self, name, operands, facts, blend):
        """The Mix of :func:`addon.nodes.facts.as_mix`, labelled as what it does."""
        mixed = self._mix("VECTOR", "Vector", *blend, label=name.replace("_", " ").title())
        self._facts[mixed.source.node.name] = outcome(VECTOR_MATH[name], facts)
        if name == "multiply" and all(fact.lasts for fact in facts):
            self._products[mixed.source.node.name] = operands
        return mixed

    def _clip(self, x, low, high):
        """A Clamp node; of colours a Mix whose factor is held."""
        if not is_vector(x):
            return self.node("ShaderNodeClamp", {"Value": x, "Min": low, "Max": high})
        if not (isinstance(low, float) and isinstance(high, float)):
            return self.apply("minimum", (self.apply("maximum", (x, low)), high))
        held = self._mix("VECTOR", "Vector", (x - low) * (1.0 / (high - low)), high, low, "Clamp", clamp_factor=True)
        self._facts[held.source.node.name] = self.facts(x)
        return held

    def _vector_math(self, operation, operands, output="Vector"):
        identifiers = ("Vector", "Vector_001", "Vector_002")
        return self.node("ShaderNodeVectorMath", dict(zip(identifiers, operands)), output, operation=operation)

    def _mix(self, data_type, suffix, condition, if_true, if_false, label="", clamp_factor=False):
        settings = {"data_type": data_type, "clamp_factor": clamp_factor}
        factor = {"Factor_Float": condition}
        if is_vector(condition):  # each channel by its own; the other one is 1 in newer Blenders if nobody says
            settings["factor_mode"], factor = "NON_UNIFORM", {"Factor_Float": 0.5, "Factor_Vector": condition}
        inputs = {**factor, f"A_{suffix}": if_false, f"B_{suffix}": if_true}
        return self.node("ShaderNodeMix", inputs, f"Result_{suffix}", label, **settings)

    # --- plumbing ---

    def _new_node(self, bl_idname, properties, label=""):
        node = self.tree.nodes.new(bl_idname)
        for name, value in properties.items():
            setattr(node, name, value)
        node.label = label
        if self.frames:
            self.frame_of[node.name] = self.frames[-1]
        return node

    def connect(self, socket, operand):
        if isinstance(operand, NodeOperand):
            self.tree.links.new(self._socket(operand, socket.node), socket)
            return
        value = constant(operand)
        if isinstance(value, tuple):
            socket.default_value = (*value, 1.0) if socket.type == "RGBA" else value
        elif socket.type in {"VECTOR", "RGBA"}:
            socket.default_value = (value,) * 3 if socket.type == "VECTOR" else (value, value, value, 1.0)
        else:
            socket.default_value = value

    def _socket(self, operand, consumer):
        """The operand's output socket; a group input has one in every frame that uses it."""
        if not isinstance(operand.source, str):
            return operand.source
        if operand.source in self._possible and operand.source not in self._there:
            self._there.add(operand.source)
            self.tree.interface.new_socket(operand.source, in_out="INPUT",
                                           socket_type=SOCKET_TYPES[self._possible[operand.source]])
        label = self.frame_of.get(consumer.name)
        node = self._group_inputs.get(label)
        if node is None:
            node = self._group_inputs[label] = self.tree.nodes.new("NodeGroupInput")
            if label:
                self.frame_of[node.name] = label
        return node.outputs[operand.source]

    def _key(self, operand):
        return operand.key() if isinstance(operand, NodeOperand) else constant(operand)


def constant(operand):
    """A number as a float, three numbers as a tuple; a node operand as it is."""
    if isinstance(operand, (NodeOperand, float, tuple)):
        return operand
    values = np.asarray(operand, dtype=float).ravel()
    if values.size == 1:
        return float(values[0])
    if values.size == 3:
        return tuple(map(float, values))
    raise TypeError(f"A node takes one number or three, not {values.size}.")


def simplified(name, operands):
    """The operand that an operation with a neutral or annihilating constant leaves, or None."""
    if len(operands) != 2:
        return None
    a, b = operands
    neutral_left = {"add": 0.0, "multiply": 1.0}
    neutral_right = {"add": 0.0, "subtract": 0.0, "multiply": 1.0, "divide": 1.0, "power": 1.0}
    if isinstance(b, float) and neutral_right.get(name) == b:
        return a
    if isinstance(a, float) and neutral_left.get(name) == a:
        return b
    if name == "multiply" and 0.0 in (x for x in operands if isinstance(x, float)):
        return 0.0
    return None


def kind_of(socket):
    """FLOAT, VECTOR or SHADER of a socket."""
    return {"VALUE": "FLOAT", "SHADER": "SHADER"}.get(socket.type, "VECTOR")


def socket_of(sockets, identifier):
    """The socket with this identifier, which unlike its name is not translated or doubled."""
    for socket in sockets:
        if socket.identifier == identifier:
            return socket
    raise KeyError(f"no socket {identifier!r} among {[s.identifier for s in sockets]}")
