"""A value inside a node tree, with the arithmetic that the formulas are written in."""

__all__ = ["NodeOperand", "is_vector"]


class NodeOperand:
    """An output of the tree under construction; operators on it add nodes.

    kind is "FLOAT", "VECTOR" (directions and RGB colours) or "SHADER".
    source is an output socket, or the name of a group input, which has an
    output socket in every frame that uses it.
    """

    is_node_operand = True
    __array_ufunc__ = None  # numpy hands mixed arithmetic over to the operators below

    def __init__(self, builder, kind, source):
        self.builder = builder
        self.kind = kind
        self.source = source

    def key(self):
        """What tells this operand from others, for sharing equal subexpressions."""
        if isinstance(self.source, str):
            return ("input", self.source)
        return (self.source.node.name, self.source.identifier)

    def __add__(self, other):
        return self.builder.apply("add", (self, other))

    def __radd__(self, other):
        return self.builder.apply("add", (other, self))

    def __sub__(self, other):
        return self.builder.apply("subtract", (self, other))

    def __rsub__(self, other):
        return self.builder.apply("subtract", (other, self))

    def __mul__(self, other):
        return self.builder.apply("multiply", (self, other))

    def __rmul__(self, other):
        return self.builder.apply("multiply", (other, self))

    def __truediv__(self, other):
        return self.builder.apply("divide", (self, other))

    def __rtruediv__(self, other):
        return self.builder.apply("divide", (other, self))

    def __neg__(self):
        return self.builder.apply("multiply", (self, -1.0))

    def __pow__(self, exponent):
        if exponent == 2:
            return self * self
        return self.builder.apply("power", (self, exponent))

    def __bool__(self):
        raise TypeError("A node has no value while the tree is built: use where(), less(), minimum().")


def is_vector(operand):
    """Whether an operand or constant has three components."""
    return isinstance(operand, tuple) or (isinstance(operand, NodeOperand) and operand.kind == "VECTOR")
